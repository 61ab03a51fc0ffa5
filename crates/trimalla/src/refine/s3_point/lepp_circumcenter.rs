//! `lepp-circumcenter`: the circumcenter of a terminal triangle; where there is no room for it, the middle of the
//! terminal edge.
//!
//! # Source
//! `[MeshSuite]` 4.2.

use super::circumcenter::center_of;
use super::terminal::{chosen_terminal, unsplit_terminal_edge};
use crate::half_edge::FaceId;
use crate::refine::measure::lepp::{LeppRule, edge_midpoint};
use crate::refine::recipe::Terminal;
use crate::refine::steps::{Places, PointStep, PointTraits, Proposal, View};

/// Step 3, `lepp-circumcenter`.
#[derive(Clone, Copy, Debug)]
pub(super) struct LeppCircumcenter {
    pub(super) terminal: Terminal,
    pub(super) rule: LeppRule,
}

impl PointStep for LeppCircumcenter {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places) {
        let Some(h) = unsplit_terminal_edge(view, face, self.rule, places) else { return };
        let Some(from) = chosen_terminal(view, h, self.terminal) else { return };
        let point = center_of(view, from);
        places.extend(point.and_then(|point| Proposal::towards(view, from, point)));
        places.push(Proposal::OnEdge { edge: h, point: edge_midpoint(view.cdt, h) });
    }

    fn traits(&self) -> PointTraits {
        PointTraits { shells_at_every_joint: false, follows_path: true, ..PointTraits::default() }
    }
}
