//! `first`: the oldest triangle in the queue first.

use crate::half_edge::FaceId;
use crate::refine::steps::{SelectStep, SelectTraits, View};

/// Step 2, `first`.
#[derive(Clone, Copy, Debug)]
pub(super) struct First;

impl SelectStep for First {
    #[allow(clippy::cast_precision_loss, reason = "fewer than 2^53 triangles ever wait")]
    fn priority(&self, _: View<'_>, _: FaceId, sequence: u64) -> f64 {
        sequence as f64
    }

    fn traits(&self) -> SelectTraits {
        SelectTraits { takes_oldest: true, ..SelectTraits::default() }
    }
}
