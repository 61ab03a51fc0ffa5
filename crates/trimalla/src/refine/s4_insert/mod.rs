//! Step 4: how the new vertex is inserted.

mod cavity;
mod flip;
mod flip_or_centroid;
mod partition;

use std::sync::Arc;

use super::recipe::{Insert, Recipe};
use super::steps::InsertStep;
use cavity::Cavity;
use flip::Flip;
use flip_or_centroid::FlipOrCentroid;
use partition::Partition;

/// The step of a recipe.
pub(super) fn step(recipe: &Recipe) -> Arc<dyn InsertStep + Send + Sync> {
    match recipe.insert {
        Insert::Flip => Arc::new(Flip),
        Insert::Cavity => Arc::new(Cavity),
        Insert::FlipOrCentroid => Arc::new(FlipOrCentroid),
        Insert::Partition => Arc::new(Partition),
    }
}

#[cfg(test)]
super::conformance::conforms!(insert, insert: Insert {
    flip => Flip,
    cavity => Cavity,
    flip_or_centroid => FlipOrCentroid,
    partition => Partition,
});
