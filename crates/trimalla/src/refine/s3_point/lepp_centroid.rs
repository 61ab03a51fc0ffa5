//! `lepp-centroid`: the centroid of the two terminal triangles; where there is no room for it, the middle of the
//! terminal edge.
//!
//! # Source
//! `[RivaraCalderon10]`; `selectPointCentroid` of `[Valenzuela09]`, section 6.1.2. What that does beside a constrained
//! second-longest edge,
//! `SelectConstrainedQuad`, is not printed there; the split of that edge, as in `selectPoint`, is our choice.

use super::terminal::{second_to_split, unsplit_terminal_edge};
use crate::half_edge::FaceId;
use crate::refine::measure::lepp::{Centroid, LeppRule, edge_midpoint, quadrilateral_centroid};
use crate::refine::recipe::ConstrainedSecond;
use crate::refine::steps::{Places, PointStep, PointTraits, Proposal, View};

/// Step 3, `lepp-centroid`.
#[derive(Clone, Copy, Debug)]
pub(super) struct LeppCentroid {
    pub(super) kind: Centroid,
    pub(super) rule: LeppRule,
    pub(super) second: ConstrainedSecond,
}

impl PointStep for LeppCentroid {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places) {
        let Some(h) = unsplit_terminal_edge(view, face, self.rule, places) else { return };
        let point = quadrilateral_centroid(view.cdt, view.ruler, h, self.kind);
        if let Some(s) = second_to_split(self.second, view, h, point) {
            places.push(Proposal::Split(s));
            return;
        }
        places.extend(Proposal::towards(view, h.face(), point));
        places.push(Proposal::OnEdge { edge: h, point: edge_midpoint(view.cdt, h) });
    }

    fn traits(&self) -> PointTraits {
        PointTraits::ON_PATH
    }
}
