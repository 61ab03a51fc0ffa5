//! `cavity`: every face whose circle holds the point away, a fan in their place.
//!
//! # Source
//! `[Bowyer81]`, `[Watson81]`.

use crate::constrained::{ConstrainedDelaunay, Provenance, SplitError};
use crate::geometry::Point;
use crate::locate::Locus;
use crate::mesh::{HalfEdgeId, UndoLog, VertexId};
use crate::refine::steps::InsertStep;

/// Step 4, `cavity`.
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

    fn by_cavity(&self) -> bool {
        true
    }
}
