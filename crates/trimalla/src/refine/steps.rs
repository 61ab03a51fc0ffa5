//! The five steps as traits.
//!
//! A new strategy is one file that implements one of these, and one row in `recipe.rs`; one from outside the library
//! goes into [`Steps`].

use std::fmt;
use std::sync::Arc;

use super::encroachment::Region;
use super::options::{Criteria, RefineOptions};
use super::ruler::Ruler;
use super::{s1_prepare, s2_select, s3_point, s4_insert, s5_recover};
use crate::constrained::{ConstrainedTriangulation, Edit, Provenance, SplitError};
use crate::geometry::{Orientation, Point, on_segment};
use crate::half_edge::{FaceId, HalfEdgeId, UndoLog, VertexId};
use crate::locate::{Locus, Walk};
use crate::size::SizeBounds;

/// The five steps of a refinement.
///
/// # Examples
/// ```
/// use std::sync::Arc;
/// use trimalla::geometry::Triangle;
/// use trimalla::half_edge::FaceId;
/// use trimalla::refine::RefineOptions;
/// use trimalla::refine::steps::{PointStep, Proposal, Steps, View};
///
/// /// The middle of the triangle.
/// struct Barycenter;
///
/// impl PointStep for Barycenter {
///     fn propose(&self, view: View<'_>, face: FaceId, places: &mut Vec<Proposal>) {
///         let [a, b, c] = view.cdt.corners(face);
///         places.extend(Proposal::towards(view, face, Triangle::new(a, b, c).centroid()));
///     }
/// }
///
/// let steps = Steps { point: Arc::new(Barycenter), ..Steps::of(&RefineOptions::default()) };
/// ```
#[derive(Clone)]
pub struct Steps {
    /// Step 1.
    pub prepare: Arc<dyn PrepareStep + Send + Sync>,
    /// Step 2.
    pub select: Arc<dyn SelectStep + Send + Sync>,
    /// Step 3.
    pub point: Arc<dyn PointStep + Send + Sync>,
    /// Step 4.
    pub insert: Arc<dyn InsertStep + Send + Sync>,
    /// Step 5.
    pub recover: Arc<dyn RecoverStep + Send + Sync>,
}

impl Steps {
    /// Those of the recipe.
    #[must_use]
    pub fn of(options: &RefineOptions) -> Self {
        let recipe = &options.recipe;
        Self {
            prepare: s1_prepare::step(recipe, Region::new(recipe.encroachment, &options.criteria)),
            select: s2_select::step(recipe),
            point: s3_point::step(recipe, options.criteria.effective_min_angle().radians()),
            insert: s4_insert::step(recipe),
            recover: s5_recover::step(recipe),
        }
    }
}

impl fmt::Debug for Steps {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Steps").finish_non_exhaustive()
    }
}

/// What steps say of themselves, asked for once: the loop needs it for each triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct StepFacts {
    /// See [`SelectStep::takes_oldest`].
    pub(super) takes_oldest: bool,
    /// See [`PointStep::follows_path`].
    pub(super) follows_path: bool,
    /// See [`PointStep::minds_encroachment`].
    pub(super) minds_encroachment: bool,
    /// See [`InsertStep::by_cavity`].
    pub(super) by_cavity: bool,
    /// See [`InsertStep::keeps_delaunay`].
    pub(super) keeps_delaunay: bool,
}

impl StepFacts {
    pub(super) fn of(select: &dyn SelectStep, point: &dyn PointStep, insert: &dyn InsertStep) -> Self {
        Self {
            takes_oldest: select.takes_oldest(),
            follows_path: point.follows_path(),
            minds_encroachment: point.minds_encroachment(),
            by_cavity: insert.by_cavity(),
            keeps_delaunay: insert.keeps_delaunay(),
        }
    }
}

/// What a step may look at.
#[derive(Clone, Copy, Debug)]
pub struct View<'a> {
    /// The triangulation.
    pub cdt: &'a ConstrainedTriangulation,
    /// What makes a triangle bad.
    pub criteria: &'a Criteria,
    /// How large a triangle may be where.
    pub size: &'a SizeBounds,
    /// How lengths are measured.
    pub ruler: Ruler,
    /// A walk to a place for a new vertex crosses no more triangles than this.
    pub(super) longest_walk: usize,
}

impl View<'_> {
    /// Triangles that a walk may cross where step 4 does not keep the circle test.
    ///
    /// Vertices may have any degree there: walks across their slivers get longer with the mesh, and what lies so far
    /// off is no help for the triangle that the walk began at.
    const LONGEST_WALK: usize = 1 << 10;

    /// How many triangles a walk may cross with that step 4.
    pub(super) fn longest_walk(insert: &dyn InsertStep) -> usize {
        if insert.keeps_delaunay() { usize::MAX } else { Self::LONGEST_WALK }
    }
}

/// Step 1: which subsegments need a split.
pub trait PrepareStep {
    /// Whether subsegments are looked at before every insertion, not once before the first.
    fn is_lasting(&self) -> bool {
        true
    }

    /// Whether subsegment `h` is to be split before (and while) points go in.
    ///
    /// A subsegment that is queued is asked about again only if one of the two triangles beside it has changed by its
    /// turn.
    fn needs_split(&self, view: View<'_>, h: HalfEdgeId) -> bool;
}

/// Step 2: the order of bad triangles.
pub trait SelectStep {
    /// How long a bad triangle can wait, not negative: the one of lowest value is treated first, to within a 128th;
    /// of equal ones that which came last, unless [`takes_oldest`](Self::takes_oldest).
    ///
    /// `joined` counts the triangles that were bad before it.
    fn patience(&self, view: View<'_>, face: FaceId, joined: u64) -> f64;

    /// [`patience`](Self::patience) where the corners of the triangle are at hand, in some order: the same number.
    fn patience_of_corners(&self, view: View<'_>, face: FaceId, corners: [Point; 3], joined: u64) -> f64 {
        let _ = corners;
        self.patience(view, face, joined)
    }

    /// Whether of equally patient triangles that which came first is treated first.
    fn takes_oldest(&self) -> bool {
        false
    }

    /// Whether a large drawing may be treated in patches of some thousand triangles, one after the other, the order
    /// holding within each of them.
    fn works_by_patches(&self) -> bool {
        false
    }

    /// Whether only triangles that the caller picks are treated.
    fn is_manual(&self) -> bool {
        false
    }
}

/// A place that a point strategy proposes for a new vertex, with its locus: nobody asks rounded numbers again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Proposal {
    /// A free point that lies exactly there: inside a face, or on an unconstrained edge.
    Free {
        /// The point.
        point: Point,
        /// Where it lies.
        locus: Locus,
    },
    /// A point on this unconstrained edge, or off it by no more than its rounding.
    OnEdge {
        /// The edge.
        edge: HalfEdgeId,
        /// The point.
        point: Point,
    },
    /// The split of this subsegment.
    Split(HalfEdgeId),
}

impl Proposal {
    /// The proposal of a point somewhere near a face: the walk to it, which ends at the point, or at a segment in its
    /// way that is to be split instead. `None` where a vertex is there already, for a point that is not finite, or
    /// where the point is too far off in a mesh that does not keep the circle test.
    #[must_use]
    pub fn towards(view: View<'_>, from: FaceId, point: Point) -> Option<Self> {
        if !point.is_finite() {
            return None;
        }
        // Most walks meet no segment, and rounding leaves nothing open.
        if let Some(f) = view.cdt.walk_within_by_sight(from, point) {
            return Some(Self::Free { point, locus: Locus::Face(f) });
        }
        Self::towards_exactly(view, from, point)
    }

    /// [`towards`](Self::towards) a finite point where rounding leaves the way open, or a segment is in it.
    #[inline(never)]
    fn towards_exactly(view: View<'_>, from: FaceId, point: Point) -> Option<Self> {
        match view.cdt.walk_within_exactly(from, point, view.longest_walk)? {
            Walk::Blocked(h) => Some(Self::Split(h)),
            Walk::Arrived(Locus::Edge(h)) if view.cdt.is_marked(h) => Some(Self::Split(h)),
            Walk::Arrived(locus @ (Locus::Face(_) | Locus::Edge(_))) => Some(Self::Free { point, locus }),
            Walk::Arrived(_) => None,
        }
    }
}

impl Proposal {
    /// Whether the proposal is what it says: an edge that is there, a finite point exactly at its locus.
    ///
    /// The loop asks this of every proposal, whoever made it, before it uses one.
    #[must_use]
    pub fn is_true(self, cdt: &ConstrainedTriangulation) -> bool {
        self.is_there(cdt) && self.is_in_its_face(cdt)
    }

    /// Whether a point inside a face lies left of its three sides; true for other places.
    fn is_in_its_face(self, cdt: &ConstrainedTriangulation) -> bool {
        let Self::Free { point, locus: Locus::Face(f) } = self else { return true };
        f.half_edges().into_iter().all(|h| cdt.side_of(h, point) == Orientation::CounterClockwise)
    }

    /// [`is_true`](Self::is_true), where a step of the library proposes the place: a point inside a face is not asked
    /// about, since it was proved by the walk that found the face.
    #[inline(always)] // Before each insertion.
    pub(super) fn is_true_after_walk(self, cdt: &ConstrainedTriangulation) -> bool {
        let is_walked_to = matches!(self, Self::Free { locus: Locus::Face(_), .. });
        debug_assert!(!is_walked_to || self.is_true(cdt), "a walk ends where the point is");
        is_walked_to || self.is_there(cdt)
    }

    /// What [`is_true`](Self::is_true) asks, but not whether a point lies left of the sides of its face.
    #[inline(never)]
    fn is_there(self, cdt: &ConstrainedTriangulation) -> bool {
        let is_free_edge = |h: HalfEdgeId| {
            let faces = [h.face(), cdt.twin(h).face()];
            faces.into_iter().all(|f| cdt.is_real(f)) && !cdt.is_marked(h)
        };
        match self {
            Self::Free { point, locus: Locus::Face(f) } => point.is_finite() && cdt.is_alive(f) && cdt.is_real(f),
            Self::Free { point, locus: Locus::Edge(h) } => {
                let is_on = |[a, b]: [Point; 2]| on_segment(a, b, point) && point != a && point != b;
                point.is_finite() && cdt.is_alive(h.face()) && is_free_edge(h) && is_on(cdt.edge_points(h))
            }
            Self::Free { .. } => false,
            Self::OnEdge { edge, point } => point.is_finite() && cdt.is_alive(edge.face()) && is_free_edge(edge),
            Self::Split(h) => cdt.is_alive(h.face()) && (cdt.is_boundary_edge(h) || cdt.is_marked(h)),
        }
    }
}

/// Step 3: where a new vertex goes.
pub trait PointStep {
    /// Adds places for a new vertex that helps `face`, the best first; the next is tried where the one before cannot be
    /// had for rounding or the length floor, or is not [true](Proposal::is_true).
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Vec<Proposal>);

    /// Whether it follows longest-edge propagation paths, whose lengths are counted then.
    fn follows_path(&self) -> bool {
        false
    }

    /// Whether a free point that encroaches upon a subsegment is taken back and the subsegment split instead.
    fn minds_encroachment(&self) -> bool {
        true
    }

    /// Whether subsegments are cut on circles around every end where another segment joins, not only where the angle
    /// there is below 60 degrees.
    fn shells_at_every_joint(&self) -> bool {
        true
    }
}

/// Step 4: how a vertex goes in.
pub trait InsertStep {
    /// The edge to flip instead of inserting at this place: the next place is asked for then.
    fn flip_instead(&self, view: View<'_>, place: Proposal) -> Option<HalfEdgeId> {
        let _ = (view, place);
        None
    }

    /// Inserts a vertex at `p`, whose place is known, through the journal; `None`, and nothing changed, where rounding
    /// leaves no room.
    fn insert(&self, edit: &mut Edit<'_, UndoLog>, p: Point, locus: Locus) -> Option<VertexId>;

    /// Splits an edge by a vertex at `p`, through the journal.
    ///
    /// # Errors
    /// [`SplitError`] where rounding leaves no room; nothing has changed then.
    fn split(
        &self,
        edit: &mut Edit<'_, UndoLog>,
        h: HalfEdgeId,
        p: Point,
        provenance: Provenance,
    ) -> Result<VertexId, SplitError>;

    /// Whether vertices go in by replacing the faces whose circle holds them: then the loop finds that cavity itself,
    /// sees before anything changes what will be around the new vertex, and asks neither for [`insert`](Self::insert)
    /// of a free point nor for [`split`](Self::split) of a subsegment.
    fn by_cavity(&self) -> bool {
        false
    }

    /// Whether the smallest angle at a vertex never gets larger: then splitting goes no further than it can help.
    fn keeps_small_angles(&self) -> bool {
        false
    }

    /// Whether the circle test holds afterwards.
    fn keeps_delaunay(&self) -> bool {
        true
    }
}

/// Step 5: what becomes of interior segments.
///
/// The boundary of the domain, and segments that part two regions, are always locked.
pub trait RecoverStep {
    /// Whether interior segments are locked while points go in.
    fn locks_segments(&self) -> bool;

    /// Whether segments that were not locked are brought back by splitting when no triangle is bad any more; the loop
    /// then goes on with them locked.
    fn splits_back(&self) -> bool {
        false
    }
}
