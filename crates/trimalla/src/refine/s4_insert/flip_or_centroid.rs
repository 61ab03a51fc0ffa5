//! `flip-or-centroid`: if the terminal edge fails the circle test, it is flipped; else the new vertex splits its two
//! faces into four. The terminal edge is the longest edge of the face in which the point lies.
//!
//! # Source
//! `[Sanhueza]`, the slide of the algorithm. (Slide 4 puts it the other way round: flips where the pair *is* Delaunay.)

use crate::half_edge::FaceId;
use crate::locate::Locus;
use crate::refine::measure::lepp::longest_edge;
use crate::refine::steps::{InsertStep, InsertTraits, Plan, Proposal, View};

/// Step 4, `flip-or-centroid`.
#[derive(Clone, Copy, Debug)]
pub(super) struct FlipOrCentroid;

impl InsertStep for FlipOrCentroid {
    fn plan(&self, view: View<'_>, place: Proposal, _: &mut Vec<FaceId>) -> Plan {
        let edge = match place {
            Proposal::Free { locus: Locus::Face(f), .. } => longest_edge(view.cdt, view.ruler, f),
            Proposal::Free { locus: Locus::Edge(edge), .. } | Proposal::OnEdge { edge, .. } => edge,
            Proposal::Free { .. } | Proposal::Split(_) => return Plan::Parts,
        };
        if view.cdt.fails_circle_test(edge) { Plan::Flip(edge) } else { Plan::Pair(edge) }
    }

    fn traits(&self) -> InsertTraits {
        InsertTraits { keeps_delaunay: false, keeps_small_angles: false }
    }
}
