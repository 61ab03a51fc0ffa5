//! `manual`: the triangles that the caller picks, one after the other, bad or not; it ends when none is left.

use crate::half_edge::FaceId;
use crate::refine::steps::{SelectStep, View};

/// Step 2, `manual`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Manual;

impl SelectStep for Manual {
    fn patience(&self, _: View<'_>, _: FaceId, _: u64) -> f64 {
        0.0
    }

    fn is_manual(&self) -> bool {
        true
    }
}
