//! `manual`: the triangles that the caller picks, in that order, bad or not; it ends when no picked triangle is left.

use crate::half_edge::FaceId;
use crate::refine::steps::{SelectStep, SelectTraits, View};

/// Step 2, `manual`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Manual;

impl SelectStep for Manual {
    fn priority(&self, _: View<'_>, _: FaceId, _: u64) -> f64 {
        0.0
    }

    fn traits(&self) -> SelectTraits {
        SelectTraits { is_manual: true, ..SelectTraits::default() }
    }
}
