//! `lepp-midpoint`: the middle of the terminal edge.
//!
//! # Source
//! `[Rivara97]`; `selectPoint` of `[Valenzuela09]`, section 6.1.1, which is this step with
//! `constrained-second = always` and
//! `lepp-stop = boundary`.

use super::terminal::{second_to_split, unsplit_terminal_edge};
use crate::half_edge::FaceId;
use crate::refine::measure::lepp::{LeppRule, edge_midpoint};
use crate::refine::recipe::ConstrainedSecond;
use crate::refine::steps::{Places, PointStep, PointTraits, Proposal, View};

/// Step 3, `lepp-midpoint`.
#[derive(Clone, Copy, Debug)]
pub(super) struct LeppMidpoint {
    pub(super) rule: LeppRule,
    pub(super) second: ConstrainedSecond,
}

impl PointStep for LeppMidpoint {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places) {
        let Some(h) = unsplit_terminal_edge(view, face, self.rule, places) else { return };
        let point = edge_midpoint(view.cdt, h);
        places.push(match second_to_split(self.second, view, h, point) {
            Some(s) => Proposal::Split(s),
            None => Proposal::OnEdge { edge: h, point },
        });
    }

    fn traits(&self) -> PointTraits {
        PointTraits::ON_PATH
    }
}
