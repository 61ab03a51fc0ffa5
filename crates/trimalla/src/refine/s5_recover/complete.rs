//! `complete`: segments that were let go go in again as whole edges when no triangle is bad any more.
//!
//! # Source
//! `[MeshSuite]` 2.6.2, by the edge insertion of `[Vigo97]`.

use crate::refine::steps::{Bring, RecoverStep, StepEdit};

/// Step 5, `complete`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Complete;

impl RecoverStep for Complete {
    fn locks_segments(&self) -> bool {
        false
    }

    fn recover(&self, edit: &mut dyn StepEdit) {
        edit.bring_all_back(Bring::AsWholeEdges);
    }
}
