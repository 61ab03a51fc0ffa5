//! `flip-or-centroid`: where the terminal edge fails the circle test it is flipped; else the new vertex parts the two
//! faces at it into four. The terminal edge is the longest of the face in which the point lies.
//!
//! # Source
//! `[Sanhueza]`, the slide of the algorithm. (Slide 4 puts it the other way round: flips where the pair *is* Delaunay.)

use crate::constrained::{Edit, Provenance, SplitError};
use crate::geometry::{BoundingBox, Point};
use crate::half_edge::{HalfEdgeId, UndoLog, VertexId};
use crate::locate::Locus;
use crate::refine::lepp::longest_edge;
use crate::refine::ruler::Ruler;
use crate::refine::steps::{InsertStep, Proposal, View};
use crate::triangulation::Triangulation;

/// Step 4, `flip-or-centroid`.
#[derive(Clone, Copy, Debug)]
pub(super) struct FlipOrCentroid;

impl FlipOrCentroid {
    fn edge_of(t: &Triangulation, ruler: Ruler, locus: Locus) -> Option<HalfEdgeId> {
        match locus {
            Locus::Face(f) => Some(longest_edge(t, ruler, f)),
            Locus::Edge(h) => Some(h),
            _ => None,
        }
    }
}

impl InsertStep for FlipOrCentroid {
    fn flip_instead(&self, view: View<'_>, place: Proposal) -> Option<HalfEdgeId> {
        let edge = match place {
            Proposal::Free { locus, .. } => Self::edge_of(view.cdt, view.ruler, locus)?,
            Proposal::OnEdge { edge, .. } => edge,
            Proposal::Split(_) => return None,
        };
        view.cdt.fails_circle_test(edge).then_some(edge)
    }

    fn insert(&self, edit: &mut Edit<'_, UndoLog>, p: Point, locus: Locus) -> Option<VertexId> {
        // The scale is a power of two: that of the face itself orders its edges as that of the drawing does.
        let corners = match locus {
            Locus::Face(f) => BoundingBox::of(edit.face_points(f)),
            _ => None,
        };
        let in_pair = Self::edge_of(edit, Ruler::for_box(corners), locus).and_then(|h| edit.insert_in_pair(p, h));
        in_pair.or_else(|| edit.place_vertex_at(p, locus))
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

    fn keeps_delaunay(&self) -> bool {
        false
    }
}
