//! `split-encroached`: subsegments with a visible vertex in their protecting region are split.
//!
//! Only the apexes of the two triangles at a subsegment are tested: in a constrained Delaunay triangulation, if any
//! visible vertex is in the region, one of them is.
//!
//! Under an area bound, subsegments too long for any good triangle are split, too: else the triangles beside them would
//! be refined first, and their vertices deleted when the subsegment is split after all.

use crate::half_edge::HalfEdgeId;
use crate::refine::criteria::encroachment::Region;
use crate::refine::recipe::PrepareWhen;
use crate::refine::steps::{PrepareStep, View};
use crate::size::{AreaBound, SizeField};

/// Step 1, `split-encroached`.
#[derive(Clone, Copy, Debug)]
pub(super) struct SplitEncroached {
    pub(super) region: Region,
    pub(super) when: PrepareWhen,
}

impl PrepareStep for SplitEncroached {
    fn is_lasting(&self) -> bool {
        self.when == PrepareWhen::Always
    }

    fn needs_split(&self, view: View<'_>, h: HalfEdgeId) -> bool {
        let cdt = view.cdt;
        let [a, b] = cdt.edge_points(h);
        let is_encroached = [h, cdt.twin(h)]
            .into_iter()
            .map(|s| cdt.apex(s))
            .any(|apex| apex.is_finite() && self.region.holds(a, b, cdt.point(apex), view.ruler));
        is_encroached || Self::is_too_long(view, h)
    }
}

impl SplitEncroached {
    /// Whether, on a side of the subsegment, the smallest triangle that meets the angle bound is above the area bound:
    /// that is the triangle with the bound as its angle at both ends.
    fn is_too_long(view: View<'_>, h: HalfEdgeId) -> bool {
        if view.size.are_none() {
            return false;
        }
        let sides = [h, view.cdt.twin(h)].map(HalfEdgeId::face).into_iter().filter(|&f| view.cdt.is_real(f));
        let bounds = sides.map(|f| view.size.in_region(view.cdt.region_rule(f)));
        let bound = bounds.fold(view.size.everywhere(), AreaBound::least);
        if bound.is_none() {
            return false;
        }
        let [a, b] = view.cdt.edge_points(h);
        0.25 * (b - a).length_sq() * view.criteria.effective_min_angle().tan() > bound.area()
    }
}
