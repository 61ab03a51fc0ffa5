//! `by-splitting`: released segments are split until they are chains of edges again.
//!
//! # Source
//! `[MeshSuite]` 2.6.1.

use crate::refine::steps::{Bring, RecoverStep, RecoverTraits, StepEdit};

/// Step 5, `by-splitting`.
#[derive(Clone, Copy, Debug)]
pub(super) struct BySplitting;

impl RecoverStep for BySplitting {
    fn traits(&self) -> RecoverTraits {
        RecoverTraits { locks_segments: false, restores_segments: true }
    }

    fn recover(&self, edit: &mut dyn StepEdit) {
        edit.bring_all_back(Bring::BySplitting);
    }
}
