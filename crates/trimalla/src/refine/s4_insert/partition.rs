//! `partition`: the face or edge is split and nothing else; what is not Delaunay stays so.
//!
//! # Source
//! `[Rivara97]`: longest-edge bisection.

use crate::constrained::{ConstrainedDelaunay, Provenance, SplitError};
use crate::geometry::Point;
use crate::locate::Locus;
use crate::mesh::{HalfEdgeId, UndoLog, VertexId};
use crate::refine::steps::InsertStep;

/// Step 4, `partition`.
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

    fn keeps_small_angles(&self) -> bool {
        true
    }

    fn keeps_delaunay(&self) -> bool {
        false
    }
}
