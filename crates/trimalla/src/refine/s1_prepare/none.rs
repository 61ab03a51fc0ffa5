//! `none`: segments are left as they are.

use crate::half_edge::HalfEdgeId;
use crate::refine::steps::{PrepareStep, View};

/// Step 1, `none`.
#[derive(Clone, Copy, Debug)]
pub(super) struct LeaveSegments;

impl PrepareStep for LeaveSegments {
    fn needs_split(&self, _: View<'_>, _: HalfEdgeId) -> bool {
        false
    }
}
