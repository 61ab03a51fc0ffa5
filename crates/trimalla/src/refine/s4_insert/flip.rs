//! `flip`: the face or edge is split, then Lawson's flips restore the circle test.
//!
//! # Source
//! `[Lawson77]`, `[Vigo97]`.

use crate::constrained::{Edit, Provenance, SplitError};
use crate::geometry::Point;
use crate::half_edge::{HalfEdgeId, UndoLog, VertexId};
use crate::locate::Locus;
use crate::refine::steps::InsertStep;

/// Step 4, `flip`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flip;

impl InsertStep for Flip {
    fn insert(&self, edit: &mut Edit<'_, UndoLog>, p: Point, locus: Locus) -> Option<VertexId> {
        Some(edit.insert_vertex_at(p, locus))
    }

    fn split(
        &self,
        edit: &mut Edit<'_, UndoLog>,
        h: HalfEdgeId,
        p: Point,
        provenance: Provenance,
    ) -> Result<VertexId, SplitError> {
        edit.split_subsegment(h, p, provenance)
    }
}
