//! The bounds of regions.

use super::{AreaBound, SizeField, TriangleInRegion};
use crate::constrained::{ConstrainedTriangulation, RegionRule};

/// The bound of the region in which a triangle lies; none outside all regions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByRegion {
    /// The least bound of a region.
    least: AreaBound,
}

impl ByRegion {
    /// No region, or none that is bounded.
    pub(super) const NONE: Self = Self { least: AreaBound::NONE };

    /// The bounds of the regions of a triangulation.
    ///
    /// # Complexity
    /// Linear in the regions.
    #[must_use]
    pub fn of(cdt: &ConstrainedTriangulation) -> Self {
        let bounds = cdt.regions().rules().iter().map(|&rule| bound_of(Some(rule)));
        Self { least: bounds.fold(AreaBound::NONE, AreaBound::least) }
    }
}

impl SizeField for ByRegion {
    fn bound(&self, at: &TriangleInRegion) -> AreaBound {
        bound_of(at.region())
    }

    fn sure_bound(&self) -> AreaBound {
        self.least
    }

    fn in_region(&self, region: Option<RegionRule>) -> AreaBound {
        bound_of(region)
    }
}

fn bound_of(region: Option<RegionRule>) -> AreaBound {
    AreaBound::of_max_area(region.and_then(|rule| rule.max_area))
}
