//! Subsegments that wait for their split, and what is known of it.

use crate::geometry::Point;
use crate::half_edge::{HalfEdgeId, VertexId};

/// A subsegment that waits to be split, lower vertex first.
#[derive(Clone, Copy, Debug)]
pub(super) struct Encroached {
    pub(super) ends: [VertexId; 2],
    /// Split it even if nothing encroaches upon it: it stood in the way of a point.
    pub(super) forced: bool,
    /// What was found when it was queued: it needed the split, and had room.
    pub(super) plan: SplitPlan,
}

/// What is found about the split of a subsegment; it holds as long as the two triangles beside it stay.
#[derive(Clone, Copy, Debug)]
pub(super) struct SplitPlan {
    pub(super) half_edge: HalfEdgeId,
    pub(super) apexes: [VertexId; 2],
    /// Whether at its ends other segments join.
    pub(super) acute: [bool; 2],
    pub(super) place: SplitPlace,
}

/// Where a subsegment is split.
#[derive(Clone, Copy, Debug)]
pub(super) struct SplitPlace {
    pub(super) point: Point,
    /// The circle that it lies on around an end, as its number, and whether that end is `dest`.
    pub(super) shell: Option<(i16, bool)>,
}
