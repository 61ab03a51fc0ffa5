//! `by-splitting`: what was let go is split until it is edges again.
//!
//! # Source
//! `[MeshSuite]` 2.6.1.

use crate::refine::steps::RecoverStep;

/// Step 5, `by-splitting`.
#[derive(Clone, Copy, Debug)]
pub(super) struct BySplitting;

impl RecoverStep for BySplitting {
    fn locks_segments(&self) -> bool {
        false
    }

    fn splits_back(&self) -> bool {
        true
    }
}
