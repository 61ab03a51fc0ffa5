//! `whole-edge`: segments are locked edges throughout, so there is nothing to recover.
//!
//! # Source
//! `[Vigo97]` section 4.

use crate::refine::steps::{RecoverStep, RecoverTraits};

/// Step 5, `whole-edge`.
#[derive(Clone, Copy, Debug)]
pub(super) struct WholeEdge;

impl RecoverStep for WholeEdge {
    fn traits(&self) -> RecoverTraits {
        RecoverTraits { locks_segments: true, restores_segments: true }
    }
}
