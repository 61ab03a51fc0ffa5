//! Step 4: how the new vertex goes in.

use std::sync::Arc;

use super::recipe::{Insert, Recipe};
use super::steps::InsertStep;
use crate::constrained::ConstrainedDelaunay;
use crate::geometry::Point;
use crate::locate::Locus;
use crate::mesh::{UndoLog, VertexId};

/// `flip`: the face or edge is split, then Lawson's flips restore the circle test.
///
/// # Source
/// `[Lawson77]`, `[Vigo97]`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flip;

impl InsertStep for Flip {
    fn insert(&self, cdt: &mut ConstrainedDelaunay, p: Point, locus: Locus, log: &mut UndoLog) -> VertexId {
        cdt.insert_vertex_at(p, locus, log)
    }
}

/// The step of a recipe.
pub(super) fn step(recipe: &Recipe) -> Arc<dyn InsertStep + Send + Sync> {
    match recipe.insert {
        Insert::Flip => Arc::new(Flip),
    }
}
