//! Step 5: what becomes of interior segments.
//!
//! | key | while points are inserted | at the end |
//! |---|---|---|
//! | `whole-edge` | segments are locked edges | nothing to recover |
//! | `by-splitting` | segments inside are released | missing ones are halved until they are chains of edges |
//! | `complete` | segments inside are released | missing ones are inserted as whole edges |
//! | `none` | segments inside are released | missing ones are reported |

mod by_splitting;
mod complete;
mod none;
mod whole_edge;

use std::sync::Arc;

use super::recipe::{Recipe, Recover};
use super::steps::RecoverStep;
use by_splitting::BySplitting;
use complete::Complete;
use none::Nothing;
use whole_edge::WholeEdge;

/// The step of a recipe.
pub(super) fn step(recipe: &Recipe) -> Arc<dyn RecoverStep + Send + Sync> {
    match recipe.recover {
        Recover::WholeEdge => Arc::new(WholeEdge),
        Recover::BySplitting => Arc::new(BySplitting),
        Recover::Complete => Arc::new(Complete),
        Recover::None => Arc::new(Nothing),
    }
}

#[cfg(test)]
super::conformance::conforms!(recover, recover: Recover {
    none => None,
    by_splitting => BySplitting,
    complete => Complete,
    whole_edge => WholeEdge,
});
