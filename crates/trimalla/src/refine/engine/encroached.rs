//! Queued splits of subsegments.

use crate::geometry::Point;
use crate::half_edge::{EdgeKey, HalfEdgeId, VertexId};

/// A subsegment queued for its split.
#[derive(Clone, Copy, Debug)]
pub(super) struct Encroached {
    pub(super) edge: EdgeKey,
    /// Whether it is split even if no vertex encroaches upon it, since it was in the way of a point.
    pub(super) forced: bool,
    /// The plan made when it was queued: it needed the split, and there was room.
    pub(super) plan: SplitPlan,
}

/// How a subsegment is split; valid as long as its two triangles do not change.
#[derive(Clone, Copy, Debug)]
pub(super) struct SplitPlan {
    pub(super) half_edge: HalfEdgeId,
    pub(super) apexes: [VertexId; 2],
    /// Whether other segments meet its origin and its dest, in this order.
    pub(super) acute: [bool; 2],
    pub(super) place: SplitPlace,
}

/// Where a subsegment is split.
#[derive(Clone, Copy, Debug)]
pub(super) struct SplitPlace {
    pub(super) point: Point,
    /// The exponent of its circle around an end, if it lies on one, and whether that end is `dest`.
    pub(super) shell: Option<(i16, bool)>,
}
