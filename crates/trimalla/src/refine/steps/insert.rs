//! Step 4 as a trait: it makes a plan, which the loop executes.
//!
//! An insertion replaces some faces by a fan around the new vertex, and may flip edges after that. The step only plans
//! the insertion. The loop finds the faces, proves that every triangle of the fan is counter-clockwise, keeps the
//! length floor, tests whether the vertex encroaches upon subsegments, and only then commits the change, under the
//! journal. So no step 4 can break the triangulation, lose a segment or exceed the budget.
//!
//! ```text
//!   Parts              Flips                  Fan                   Pair                  Faces
//!      c                  c                  e ── d                   c                  e ── d
//!     /│\               / │ \               / \  / \                / │ \               / \  / \    any faces that
//!    / v \       then  a─ v ─b  flips      f ── v ── c             a ─ v ─ b           f ── v ── c   form a disk and
//!   / ╱ ╲ \             \ │ /               \  / \  /               \ │ /               \  / \  /    see the point
//!  a ───── b              d                  a ── b                   d                  a ── b
//! ```

use super::proposal::Proposal;
use super::view::View;
use crate::half_edge::{FaceId, HalfEdgeId};

/// How a vertex is inserted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plan {
    /// Every face whose circumcircle holds the point is removed, and a fan replaces these faces `[Bowyer81]`.
    Fan,
    /// The face or edge is split, and Lawson's flips restore the circle test around the vertex.
    Flips,
    /// The face or edge is split.
    Parts,
    /// The two faces at this unconstrained edge are replaced by four; where the point does not see all of their sides,
    /// the face or edge that it lies on is split. A subsegment is split as with [`Parts`](Self::Parts).
    Pair(HalfEdgeId),
    /// The faces that the step has listed are replaced by a fan. They must be connected by unconstrained edges, have no
    /// vertex between them, and hold the point; the place is refused if they are not, or if the point does not see all
    /// of their sides. A subsegment is split as with [`Parts`](Self::Parts).
    Faces,
    /// No vertex is inserted: this edge is flipped, if its two faces form a convex quadrilateral; else the place is
    /// refused. For a subsegment it means [`Parts`](Self::Parts).
    Flip(HalfEdgeId),
}

/// The traits of a step 4, which are constant during a refinement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InsertTraits {
    /// The circle test holds after every insertion. If a plan does not restore it, the loop flips edges around the new
    /// vertex until it holds.
    pub keeps_delaunay: bool,
    /// The smallest angle at a vertex never gets larger: then bisection stops where it is useless.
    pub keeps_small_angles: bool,
}

impl Default for InsertTraits {
    fn default() -> Self {
        Self { keeps_delaunay: true, keeps_small_angles: false }
    }
}

/// Step 4: how a vertex is inserted.
pub trait InsertStep {
    /// Plans the insertion at a place, or the split of a subsegment. `faces` is empty; with [`Plan::Faces`] the step
    /// lists its faces there.
    fn plan(&self, view: View<'_>, place: Proposal, faces: &mut Vec<FaceId>) -> Plan;

    /// The traits of the step.
    fn traits(&self) -> InsertTraits {
        InsertTraits::default()
    }
}
