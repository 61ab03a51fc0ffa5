//! Every bound on sizes that a refinement has.

use std::fmt;
use std::sync::Arc;

use super::{AreaBound, ByRegion, SizeField, TriangleInRegion, Uniform};
use crate::constrained::{ConstrainedTriangulation, RegionRule};
use crate::geometry::Point;
use crate::half_edge::FaceId;

/// The least of a bound for all triangles, those of regions, and further fields.
///
/// Two numbers decide for nearly all triangles, without a call: the [`sure_bound`](SizeField::sure_bound) and the one
/// [`everywhere`](SizeField::everywhere). They are the same where neither regions nor further fields bound anything.
#[derive(Clone)]
pub struct SizeBounds {
    sure: AreaBound,
    everywhere: AreaBound,
    uniform: Uniform,
    by_region: ByRegion,
    fields: Vec<Arc<dyn SizeField>>,
}

impl SizeBounds {
    /// No bound.
    pub(crate) const NONE: Self = Self {
        sure: AreaBound::NONE,
        everywhere: AreaBound::NONE,
        uniform: Uniform(AreaBound::NONE),
        by_region: ByRegion::NONE,
        fields: Vec::new(),
    };

    /// A bound for all triangles, if there is one, those of the regions of a triangulation, and these fields.
    #[must_use]
    pub fn new(max_area: Option<f64>, cdt: &ConstrainedTriangulation, fields: Vec<Arc<dyn SizeField>>) -> Self {
        let (uniform, by_region) = (Uniform(AreaBound::of_max_area(max_area)), ByRegion::of(cdt));
        let mut bounds = Self { uniform, by_region, fields, ..Self::NONE };
        bounds.sure = bounds.least(|field| field.sure_bound());
        bounds.everywhere = bounds.least(|field| field.everywhere());
        bounds
    }

    /// The fields beside the bound for all triangles and those of regions.
    #[must_use]
    pub fn fields(&self) -> &[Arc<dyn SizeField>] {
        &self.fields
    }

    /// Whether no triangle is ever too large.
    #[must_use]
    #[inline]
    pub const fn are_none(&self) -> bool {
        self.sure.is_none()
    }

    /// Whether one number is the bound for all triangles.
    pub(crate) fn are_uniform(&self) -> bool {
        self.sure == self.everywhere
    }

    /// The least of what all fields say.
    fn least(&self, say: impl Fn(&dyn SizeField) -> AreaBound) -> AreaBound {
        let of_options = say(&self.uniform).least(say(&self.by_region));
        self.fields.iter().map(|field| say(field.as_ref())).fold(of_options, AreaBound::least)
    }

    /// Whether a face is small enough.
    #[must_use]
    pub fn admit(&self, cdt: &ConstrainedTriangulation, f: FaceId) -> bool {
        let corners @ [a, b, c] = cdt.corners_from_newest(f);
        !self.refuse((b - a).cross(c - a), cdt, f, corners)
    }

    /// Whether a face with these corners and this doubled area is too large.
    #[inline(always)] // For each triangle that is tested.
    pub(crate) fn refuse(
        &self,
        doubled_area: f64,
        cdt: &ConstrainedTriangulation,
        f: FaceId,
        corners: [Point; 3],
    ) -> bool {
        doubled_area > self.sure.doubled()
            && (doubled_area > self.everywhere.doubled() || self.refuse_in_place(doubled_area, cdt, f, corners))
    }

    #[inline(never)]
    fn refuse_in_place(
        &self,
        doubled_area: f64,
        cdt: &ConstrainedTriangulation,
        f: FaceId,
        corners: [Point; 3],
    ) -> bool {
        let (at, area) = (TriangleInRegion::of_face(cdt, f, corners), 0.5 * doubled_area);
        !(self.by_region.admits(&at, area) && self.fields.iter().all(|field| field.admits(&at, area)))
    }
}

impl SizeField for SizeBounds {
    fn bound(&self, at: &TriangleInRegion) -> AreaBound {
        self.least(|field| field.bound(at))
    }

    fn sure_bound(&self) -> AreaBound {
        self.sure
    }

    fn everywhere(&self) -> AreaBound {
        self.everywhere
    }

    fn in_region(&self, region: Option<RegionRule>) -> AreaBound {
        self.least(|field| field.in_region(region))
    }

    fn expected_within(&self, at: &TriangleInRegion) -> AreaBound {
        self.least(|field| field.expected_within(at))
    }
}

impl fmt::Debug for SizeBounds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SizeBounds")
            .field("sure", &self.sure)
            .field("everywhere", &self.everywhere)
            .field("fields", &self.fields.len())
            .finish_non_exhaustive()
    }
}
