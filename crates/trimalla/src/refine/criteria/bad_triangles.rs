//! Which triangles are bad, and why.
//!
//! [`Criterion::badness`] decides for one triangle. Two faster tests decide for most triangles without it:
//!
//! * [`UniformBounds`]: bounds on angle and area that hold for all triangles alike. A triangle that misses one is bad;
//!   one that keeps all is good, unless more is required.
//! * [`SufficientBounds`]: a triangle that keeps them is good, whatever its region.

use std::sync::Arc;

use super::badness::Badness;
use crate::constrained::ConstrainedTriangulation;
use crate::geometry::{Point, Triangle, Vector, angles_of_two, sides_angle_excess, triangle_angles_at_least};
use crate::half_edge::FaceId;
use crate::quality::aspect_ratio;
use crate::refine::recipe::options::Criteria;
use crate::size::{AreaBound, SizeBounds, SizeField, TriangleInRegion};

/// Sufficient bounds: a triangle that keeps them is good, whatever its region.
#[derive(Clone, Copy, Debug)]
pub(in crate::refine) struct SufficientBounds {
    /// The squared sine of the smallest angle is above this.
    pub(in crate::refine) sine_sq: f64,
    /// Twice the area is at most this.
    pub(in crate::refine) doubled_area: f64,
}

/// A side of a triangle, from its first corner.
#[derive(Clone, Copy, Debug)]
pub(in crate::refine) struct Side {
    along: Vector,
    length_sq: f64,
}

impl Side {
    #[inline(always)]
    pub(in crate::refine) fn new(from: Point, to: Point) -> Self {
        let along = to - from;
        Self { along, length_sq: along.length_sq() }
    }
}

/// Bounds on angle and area that hold in all regions.
#[derive(Clone, Copy, Debug)]
pub(in crate::refine) struct UniformBounds {
    /// The squared sine of the smallest angle.
    sine_sq: f64,
    doubled_area: f64,
    /// Whether a triangle that keeps both bounds is good.
    are_all: bool,
}

impl UniformBounds {
    /// These bounds, marked so that they decide for no triangle alone.
    pub(in crate::refine) fn undecided(self) -> Self {
        Self { are_all: false, ..self }
    }

    /// Whether a triangle is bad; `None` where [`Criterion::badness`] must decide: where more than these bounds is
    /// required, or rounding leaves the result open.
    ///
    /// The two sides lead from the first corner to the second and to the third.
    #[inline(always)] // In the loop over the triangles around a new vertex.
    pub(in crate::refine) fn is_bad(self, [_, b, c]: [Point; 3], [u, v]: [Side; 2]) -> Option<bool> {
        let doubled_area = u.along.cross(v.along);
        let squares = [u.length_sq, v.length_sq, (c - b).length_sq()];
        let excess = sides_angle_excess(doubled_area, squares, self.sine_sq);
        let is_known = self.are_all && excess != 0.0;
        // Branch-free: which triangles are bad is unpredictable.
        is_known.then_some((excess < 0.0) | (doubled_area > self.doubled_area))
    }

    /// Whether each of two triangles with these corners is bad; `None` where [`Criterion::badness`] must decide, as
    /// always under an area bound.
    #[inline(always)] // In the loop over all triangles.
    pub(in crate::refine) fn are_bad(self, [a, b, c]: [[Point; 2]; 3]) -> [Option<bool>; 2] {
        let are_all = self.are_all && self.doubled_area == f64::INFINITY;
        let excess = angles_of_two(a, b, c, self.sine_sq);
        excess.map(|excess| (are_all && excess != 0.0).then_some(excess < 0.0))
    }
}

/// A test of the caller's own: whether a triangle must be refined.
pub type UserTest = dyn Fn(TriangleInRegion) -> bool + Send + Sync;

/// The test for bad triangles.
#[derive(Clone)]
pub(in crate::refine) struct Criterion {
    /// The squared cosine of the angle bound; `None` where no angle is required.
    cos_sq: Option<f64>,
    size: SizeBounds,
    /// Infinite where there is no bound.
    max_aspect_ratio: f64,
    user_test: Option<Arc<UserTest>>,
}

impl Criterion {
    pub(in crate::refine) fn new(criteria: &Criteria, size: SizeBounds) -> Self {
        let is_bounded = criteria.min_angle.radians() > 0.0;
        Self {
            cos_sq: is_bounded.then(|| criteria.min_angle.cos_sq()),
            size,
            max_aspect_ratio: criteria.max_aspect_ratio.unwrap_or(f64::INFINITY),
            user_test: None,
        }
    }

    /// Whether a triangle can be bad for its shape.
    pub(in crate::refine) fn bounds_shape(&self) -> bool {
        self.cos_sq.is_some() || self.max_aspect_ratio < f64::INFINITY
    }

    /// How large a triangle may be where.
    pub(in crate::refine) fn size(&self) -> &SizeBounds {
        &self.size
    }

    /// The caller's own test, if any.
    pub(in crate::refine) fn user_test(&self) -> Option<Arc<UserTest>> {
        self.user_test.clone()
    }

    /// The criterion with this test of the caller's own, if there is one, in place of the one before.
    pub(in crate::refine) fn with_user_test(self, user_test: Option<Arc<UserTest>>) -> Self {
        Self { user_test, ..self }
    }

    /// What is wrong with a face that has these corners, if anything; tests the size first. Angles are certified
    /// exactly.
    #[inline(never)]
    pub(in crate::refine) fn badness(
        &self,
        cdt: &ConstrainedTriangulation,
        f: FaceId,
        corners: [Point; 3],
    ) -> Option<Badness> {
        let [a, b, c] = corners;
        if self.size.refuse((b - a).cross(c - a), cdt, f, corners) {
            Some(Badness::Area)
        } else if self.user_test.is_some() && self.fails_user_test(cdt, f, corners) {
            Some(Badness::UserTest)
        } else if self.cos_sq.is_some_and(|cos_sq| !triangle_angles_at_least(a, b, c, cos_sq)) {
            Some(Badness::Angle)
        } else if self.max_aspect_ratio < f64::INFINITY && self.is_too_slender(corners) {
            Some(Badness::AspectRatio)
        } else {
            None
        }
    }

    /// Whether a triangle is bad for its shape, whatever its size is.
    pub(in crate::refine) fn is_misshapen(&self, corners: [Point; 3]) -> bool {
        let [a, b, c] = corners;
        self.cos_sq.is_some_and(|cos_sq| !triangle_angles_at_least(a, b, c, cos_sq))
            || self.max_aspect_ratio < f64::INFINITY && self.is_too_slender(corners)
    }

    /// The bounds that hold for all triangles alike.
    #[inline]
    pub(in crate::refine) fn uniform_bounds(&self) -> UniformBounds {
        let asks_more = self.user_test.is_some() || self.max_aspect_ratio < f64::INFINITY;
        // Without a bound on angles a triangle must only have a positive area.
        let sine_sq = 1.0 - self.cos_sq.unwrap_or(1.0);
        let are_all = !asks_more && self.size.are_uniform();
        UniformBounds { sine_sq, doubled_area: self.size.everywhere().doubled(), are_all }
    }

    /// Sufficient bounds; no triangle keeps them if there is a user test or a bound on the aspect ratio.
    pub(in crate::refine) fn sufficient_bounds(&self) -> SufficientBounds {
        let is_sure = self.user_test.is_none() && self.max_aspect_ratio == f64::INFINITY;
        SufficientBounds {
            sine_sq: self.cos_sq.map_or(0.0, |cos_sq| 1.0 - cos_sq),
            doubled_area: if is_sure { self.size.sure_bound().doubled() } else { f64::NEG_INFINITY },
        }
    }

    /// The area bound by which a face is filled, and its number of triangles estimated.
    pub(in crate::refine) fn expected_bound(&self, cdt: &ConstrainedTriangulation, f: FaceId) -> AreaBound {
        if self.size.are_uniform() {
            self.size.everywhere()
        } else {
            self.size.expected_within(&TriangleInRegion::of(cdt, f))
        }
    }

    /// Whether the caller's own test refuses a face with these corners.
    #[inline(never)]
    fn fails_user_test(&self, cdt: &ConstrainedTriangulation, f: FaceId, corners: [Point; 3]) -> bool {
        self.user_test.as_ref().is_some_and(|test| test(TriangleInRegion::of_face(cdt, f, corners)))
    }

    #[inline(never)]
    fn is_too_slender(&self, [a, b, c]: [Point; 3]) -> bool {
        aspect_ratio(&Triangle::new(a, b, c)) > self.max_aspect_ratio
    }
}
