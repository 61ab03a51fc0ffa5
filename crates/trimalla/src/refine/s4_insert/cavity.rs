//! `cavity`: every face whose circle holds the point away, a fan in their place.
//!
//! # Source
//! `[Bowyer81]`, `[Watson81]`.

use crate::constrained::{Edit, Provenance, SplitError};
use crate::geometry::Point;
use crate::half_edge::{HalfEdgeId, UndoLog, VertexId};
use crate::locate::Locus;
use crate::refine::steps::InsertStep;

/// Step 4, `cavity`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cavity;

impl InsertStep for Cavity {
    fn insert(&self, edit: &mut Edit<'_, UndoLog>, p: Point, locus: Locus) -> Option<VertexId> {
        edit.insert_by_cavity(p, locus)
    }

    fn split(
        &self,
        edit: &mut Edit<'_, UndoLog>,
        h: HalfEdgeId,
        p: Point,
        provenance: Provenance,
    ) -> Result<VertexId, SplitError> {
        edit.split_by_cavity(h, p, provenance)
    }

    fn by_cavity(&self) -> bool {
        true
    }
}
