//! `whole-edge`: segments are edges that nothing removes; there is nothing to recover.
//!
//! # Source
//! `[Vigo97]` section 4.

use crate::refine::steps::RecoverStep;

/// Step 5, `whole-edge`.
#[derive(Clone, Copy, Debug)]
pub(super) struct WholeEdge;

impl RecoverStep for WholeEdge {
    fn locks_segments(&self) -> bool {
        true
    }
}
