//! Step 1: segments before points.

mod none;
mod split_encroached;

use std::sync::Arc;

use super::criteria::encroachment::Region;
use super::recipe::{Prepare, Recipe};
use super::steps::PrepareStep;
use none::LeaveSegments;
use split_encroached::SplitEncroached;

/// The step of a recipe.
pub(super) fn step(recipe: &Recipe, region: Region) -> Arc<dyn PrepareStep + Send + Sync> {
    match recipe.prepare {
        Prepare::None => Arc::new(LeaveSegments),
        Prepare::SplitEncroached => Arc::new(SplitEncroached { region, when: recipe.prepare_when }),
    }
}

#[cfg(test)]
super::conformance::conforms!(prepare, prepare: Prepare { none => None, split_encroached => SplitEncroached, });
