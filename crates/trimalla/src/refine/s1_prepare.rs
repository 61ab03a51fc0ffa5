//! Step 1: segments before points.

use std::sync::Arc;

use super::encroachment::Region;
use super::recipe::{Prepare, PrepareWhen, Recipe};
use super::steps::{PrepareStep, View};
use crate::mesh::HalfEdgeId;

/// `none`: segments are left as they are.
#[derive(Clone, Copy, Debug)]
pub(super) struct LeaveSegments;

impl PrepareStep for LeaveSegments {
    fn needs_split(&self, _: View<'_>, _: HalfEdgeId) -> bool {
        false
    }
}

/// `split-encroached`: subsegments with a visible vertex in their protecting region are split.
///
/// Only the apexes of the two triangles at a subsegment are looked at: in a constrained Delaunay triangulation, if any
/// visible vertex is in the region, one of them is.
#[derive(Clone, Copy, Debug)]
pub(super) struct SplitEncroached {
    region: Region,
    when: PrepareWhen,
}

impl PrepareStep for SplitEncroached {
    fn is_lasting(&self) -> bool {
        self.when == PrepareWhen::Always
    }

    fn needs_split(&self, view: View<'_>, h: HalfEdgeId) -> bool {
        let cdt = view.cdt;
        let [a, b] = cdt.edge_points(h);
        [h, cdt.twin(h)]
            .into_iter()
            .map(|s| cdt.apex(s))
            .any(|apex| apex.is_finite() && self.region.holds(a, b, cdt.point(apex), view.ruler))
    }
}

/// The step of a recipe.
pub(super) fn step(recipe: &Recipe, region: Region) -> Arc<dyn PrepareStep + Send + Sync> {
    match recipe.prepare {
        Prepare::None => Arc::new(LeaveSegments),
        Prepare::SplitEncroached => Arc::new(SplitEncroached { region, when: recipe.prepare_when }),
    }
}
