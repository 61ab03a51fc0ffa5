//! `flip`: the face or edge is split, then Lawson's flips restore the circle test.
//!
//! # Source
//! `[Lawson77]`, `[Vigo97]`.

use crate::constrained::{ConstrainedDelaunay, Provenance, SplitError};
use crate::geometry::Point;
use crate::locate::Locus;
use crate::mesh::{HalfEdgeId, UndoLog, VertexId};
use crate::refine::steps::InsertStep;

/// Step 4, `flip`.
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
