//! Step 4: how the new vertex goes in.

use std::sync::Arc;

use super::recipe::{Insert, Recipe};
use super::steps::InsertStep;
use crate::constrained::{ConstrainedDelaunay, Provenance, SplitError};
use crate::geometry::Point;
use crate::locate::Locus;
use crate::mesh::{HalfEdgeId, UndoLog, VertexId};

/// `flip`: the face or edge is split, then Lawson's flips restore the circle test.
///
/// # Source
/// `[Lawson77]`, `[Vigo97]`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flip;

impl InsertStep for Flip {
    fn insert(&self, cdt: &mut ConstrainedDelaunay, p: Point, locus: Locus, log: &mut UndoLog) -> Option<VertexId> {
        Some(cdt.insert_vertex_at(p, locus, log))
    }

    fn split(
        &self,
        cdt: &mut ConstrainedDelaunay,
        h: HalfEdgeId,
        p: Point,
        provenance: Provenance,
        log: &mut UndoLog,
    ) -> Result<VertexId, SplitError> {
        cdt.split_subsegment(h, p, provenance, log)
    }
}

/// `cavity`: every face whose circle holds the point away, a fan in their place.
///
/// # Source
/// `[Bowyer81]`, `[Watson81]`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cavity;

impl InsertStep for Cavity {
    fn insert(&self, cdt: &mut ConstrainedDelaunay, p: Point, locus: Locus, log: &mut UndoLog) -> Option<VertexId> {
        cdt.insert_by_cavity(p, locus, log)
    }

    fn split(
        &self,
        cdt: &mut ConstrainedDelaunay,
        h: HalfEdgeId,
        p: Point,
        provenance: Provenance,
        log: &mut UndoLog,
    ) -> Result<VertexId, SplitError> {
        cdt.split_by_cavity(h, p, provenance, log)
    }
}

/// `partition`: the face or edge is split and nothing else; what is not Delaunay stays so.
///
/// # Source
/// `[Rivara97]`: longest-edge bisection.
#[derive(Clone, Copy, Debug)]
pub(super) struct Partition;

impl InsertStep for Partition {
    fn insert(&self, cdt: &mut ConstrainedDelaunay, p: Point, locus: Locus, log: &mut UndoLog) -> Option<VertexId> {
        cdt.place_vertex_at(p, locus, log)
    }

    fn split(
        &self,
        cdt: &mut ConstrainedDelaunay,
        h: HalfEdgeId,
        p: Point,
        provenance: Provenance,
        log: &mut UndoLog,
    ) -> Result<VertexId, SplitError> {
        cdt.cut_subsegment(h, p, provenance, log)
    }

    fn keeps_delaunay(&self) -> bool {
        false
    }
}

/// The step of a recipe.
pub(super) fn step(recipe: &Recipe) -> Arc<dyn InsertStep + Send + Sync> {
    match recipe.insert {
        Insert::Flip => Arc::new(Flip),
        Insert::Cavity => Arc::new(Cavity),
        Insert::Partition => Arc::new(Partition),
    }
}
