//! `partition`: the face or edge is split and nothing else; what is not Delaunay stays so.
//!
//! # Source
//! `[Rivara97]`: longest-edge bisection.

use crate::constrained::{Edit, Provenance, SplitError};
use crate::geometry::Point;
use crate::half_edge::{HalfEdgeId, UndoLog, VertexId};
use crate::locate::Locus;
use crate::refine::steps::InsertStep;

/// Step 4, `partition`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Partition;

impl InsertStep for Partition {
    fn insert(&self, edit: &mut Edit<'_, UndoLog>, p: Point, locus: Locus) -> Option<VertexId> {
        edit.place_vertex_at(p, locus)
    }

    fn split(
        &self,
        edit: &mut Edit<'_, UndoLog>,
        h: HalfEdgeId,
        p: Point,
        provenance: Provenance,
    ) -> Result<VertexId, SplitError> {
        edit.cut_subsegment(h, p, provenance)
    }

    fn keeps_small_angles(&self) -> bool {
        true
    }

    fn keeps_delaunay(&self) -> bool {
        false
    }
}
