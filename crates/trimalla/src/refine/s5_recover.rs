//! Step 5: what becomes of interior segments.

use std::sync::Arc;

use super::recipe::{Recipe, Recover};
use super::steps::RecoverStep;

/// `whole-edge`: segments are edges that nothing removes; there is nothing to recover.
///
/// # Source
/// `[Vigo97]` section 4.
#[derive(Clone, Copy, Debug)]
pub(super) struct WholeEdge;

impl RecoverStep for WholeEdge {
    fn locks_segments(&self) -> bool {
        true
    }
}

/// The step of a recipe.
pub(super) fn step(recipe: &Recipe) -> Arc<dyn RecoverStep + Send + Sync> {
    match recipe.recover {
        Recover::WholeEdge => Arc::new(WholeEdge),
    }
}
