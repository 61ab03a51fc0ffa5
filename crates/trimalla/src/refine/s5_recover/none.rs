//! `none`: released segments are not recovered; the report names those that are missing.
//!
//! # Source
//! `[MeshSuite]` 4.2, its LEPP algorithms.

use crate::refine::steps::{RecoverStep, RecoverTraits};

/// Step 5, `none`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nothing;

impl RecoverStep for Nothing {
    fn traits(&self) -> RecoverTraits {
        RecoverTraits { locks_segments: false, restores_segments: false }
    }
}
