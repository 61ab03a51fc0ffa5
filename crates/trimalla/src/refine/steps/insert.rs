//! Step 4 as a trait: a plan, which the loop carries out.
//!
//! An insertion replaces some faces by a fan around the new vertex, and may flip edges after that. The step only plans
//! it; the loop finds the faces, proves that every triangle of the fan is counter-clockwise, keeps the length floor,
//! looks for subsegments that the vertex encroaches upon, and only then commits to it, through the journal. So no step
//! 4 can spoil the triangulation, lose a segment or exceed the budget.
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

/// How a vertex goes in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plan {
    /// Every face whose circle holds the point goes, and a fan takes their place `[Bowyer81]`.
    Fan,
    /// The face or edge is split, and Lawson's flips restore the circle test around the vertex.
    Flips,
    /// The face or edge is split.
    Parts,
    /// The two faces at this unconstrained edge are replaced by four; where the point does not see all of their sides,
    /// the face or edge that it lies on is split. A subsegment is split as with [`Parts`](Self::Parts).
    Pair(HalfEdgeId),
    /// The faces that the step has listed are replaced by a fan. They must be joined by unconstrained edges, have no
    /// vertex between them, and hold the point; the place is refused where they are not, or where the point does not
    /// see all of their sides. A subsegment is split as with [`Parts`](Self::Parts).
    Faces,
    /// No vertex goes in: this edge is flipped, if its two faces form a convex quadrilateral; else the place is
    /// refused. For a subsegment it stands for [`Parts`](Self::Parts).
    Flip(HalfEdgeId),
}

/// What a step 4 says of itself, once for a whole refinement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InsertTraits {
    /// The circle test holds after every insertion. Where a plan does not see to it, the loop flips edges around the
    /// new vertex until it holds.
    pub keeps_delaunay: bool,
    /// The smallest angle at a vertex never gets larger: then splitting goes no further than it can help.
    pub keeps_small_angles: bool,
}

impl Default for InsertTraits {
    fn default() -> Self {
        Self { keeps_delaunay: true, keeps_small_angles: false }
    }
}

/// Step 4: how a vertex goes in.
pub trait InsertStep {
    /// Plans the insertion at a place, or the split of a subsegment. `faces` is empty, and is for the faces of
    /// [`Plan::Faces`].
    fn plan(&self, view: View<'_>, place: Proposal, faces: &mut Vec<FaceId>) -> Plan;

    /// What the step says of itself.
    fn traits(&self) -> InsertTraits {
        InsertTraits::default()
    }
}
