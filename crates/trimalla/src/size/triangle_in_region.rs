//! What a size field is asked about.

use crate::constrained::{ConstrainedTriangulation, RegionRule};
use crate::geometry::{Point, Triangle};
use crate::half_edge::FaceId;

/// A triangle, and the region in which it lies.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct TriangleInRegion {
    /// The triangle, counter-clockwise. Its area is [`Triangle::area`].
    pub triangle: Triangle,
    /// The attribute of its region; 0 where it lies in none.
    pub region_attribute: f64,
    rule: Option<RegionRule>,
    /// The region, from 1 on; 0 for none.
    number: u32,
}

impl TriangleInRegion {
    /// A triangle that lies in no region.
    #[must_use]
    pub const fn in_none(triangle: Triangle) -> Self {
        Self { triangle, region_attribute: 0.0, rule: None, number: 0 }
    }

    /// A face of a triangulation, with its newest vertex first.
    #[must_use]
    pub fn of(cdt: &ConstrainedTriangulation, f: FaceId) -> Self {
        Self::of_face(cdt, f, cdt.corners_from_newest(f))
    }

    /// A face of a triangulation that has these corners.
    pub(crate) fn of_face(cdt: &ConstrainedTriangulation, f: FaceId, [a, b, c]: [Point; 3]) -> Self {
        let rule = cdt.region_rule(f);
        let region_attribute = rule.map_or(0.0, |rule| rule.attribute);
        Self { triangle: Triangle::new(a, b, c), region_attribute, rule, number: cdt.region(f) }
    }

    /// What holds in its region; `None` where it lies in none.
    #[must_use]
    pub const fn region(&self) -> Option<RegionRule> {
        self.rule
    }

    /// The number of its region, counted from 0.
    pub(super) fn region_index(&self) -> Option<u32> {
        self.number.checked_sub(1)
    }
}
