//! `complete`: released segments are inserted again as whole edges when no bad triangle is left.
//!
//! # Source
//! `[MeshSuite]` 2.6.2, by the edge insertion of `[Vigo97]`.

use crate::refine::steps::{Bring, RecoverStep, RecoverTraits, StepEdit};

/// Step 5, `complete`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Complete;

impl RecoverStep for Complete {
    fn traits(&self) -> RecoverTraits {
        RecoverTraits { locks_segments: false, restores_segments: true }
    }

    fn recover(&self, edit: &mut dyn StepEdit) {
        edit.bring_all_back(Bring::AsWholeEdges);
    }
}
