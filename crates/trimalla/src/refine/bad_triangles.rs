//! Bad triangles: the test.

use std::sync::Arc;

use super::options::Criteria;
use crate::constrained::ConstrainedTriangulation;
use crate::geometry::{Point, Triangle, Vector, angles_of_two, sides_angle_excess, triangle_angles_at_least};
use crate::half_edge::{FaceId, VertexId};
use crate::quality::aspect_ratio;
use crate::size::{AreaBound, SizeBounds, SizeField, TriangleInRegion};

/// What is wrong with a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Badness {
    /// An angle is below the bound.
    Angle,
    /// The aspect ratio is above the bound.
    AspectRatio,
    /// The area is above the bound.
    Area,
    /// The caller's own test refuses it.
    Asked,
}

impl Badness {
    /// Whether splitting the triangle into smaller ones of its shape is no help.
    pub(super) fn is_of_shape(self) -> bool {
        matches!(self, Self::Angle | Self::AspectRatio)
    }
}

/// Bounds within which no triangle is bad, whatever its region.
#[derive(Clone, Copy, Debug)]
pub(super) struct SureBounds {
    /// The squared sine of the smallest angle is above this.
    pub(super) sine_sq: f64,
    /// Twice the area is no more than this.
    pub(super) doubled_area: f64,
}

/// A side of a triangle, from its first corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side {
    along: Vector,
    length_sq: f64,
}

impl Side {
    #[inline(always)]
    pub(super) fn new(from: Point, to: Point) -> Self {
        let along = to - from;
        Self { along, length_sq: along.length_sq() }
    }
}

/// Bounds on angle and area that hold in all regions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Everywhere {
    /// The squared sine of the smallest angle.
    sine_sq: f64,
    doubled_area: f64,
    /// Whether nothing more is asked of any triangle.
    is_all: bool,
}

impl Everywhere {
    /// The same where more is asked of some triangles.
    pub(super) fn with_more(self) -> Self {
        Self { is_all: false, ..self }
    }

    /// Whether a triangle is bad, where the sides from its first corner are known, and no more is asked than this;
    /// `None` where it is, or rounding leaves the answer open.
    #[inline(always)] // In the loop over the triangles around a new vertex.
    pub(super) fn is_bad(self, [_, b, c]: [Point; 3], [u, v]: [Side; 2]) -> Option<bool> {
        let doubled_area = u.along.cross(v.along);
        let squares = [u.length_sq, v.length_sq, (c - b).length_sq()];
        let excess = sides_angle_excess(doubled_area, squares, self.sine_sq);
        let is_known = self.is_all && excess != 0.0;
        // No branch: which of them are bad nobody can guess.
        is_known.then_some((excess < 0.0) | (doubled_area > self.doubled_area))
    }

    /// The same of two triangles with these corners, where the area is not bounded.
    #[inline(always)] // In the loop over all triangles.
    pub(super) fn are_bad(self, [a, b, c]: [[Point; 2]; 3]) -> [Option<bool>; 2] {
        let is_all = self.is_all && self.doubled_area == f64::INFINITY;
        let excess = angles_of_two(a, b, c, self.sine_sq);
        excess.map(|excess| (is_all && excess != 0.0).then_some(excess < 0.0))
    }
}

/// A test of the caller's own: whether a triangle must be refined.
pub type UserTest = dyn Fn(TriangleInRegion) -> bool + Send + Sync;

/// The criteria, ready to be tested.
#[derive(Clone)]
pub(super) struct Test {
    /// Squared cosine of the angle bound; `None` where no bound is asked for.
    cos_sq: Option<f64>,
    size: SizeBounds,
    max_aspect_ratio: f64,
    asked: Option<Arc<UserTest>>,
}

impl Test {
    pub(super) fn new(criteria: &Criteria, size: SizeBounds) -> Self {
        let bounded = criteria.min_angle.radians() > 0.0;
        Self {
            cos_sq: bounded.then(|| criteria.min_angle.cos_sq()),
            size,
            max_aspect_ratio: criteria.max_aspect_ratio.unwrap_or(f64::INFINITY),
            asked: None,
        }
    }

    /// Whether a triangle can be bad for its shape.
    pub(super) fn minds_shape(&self) -> bool {
        self.cos_sq.is_some() || self.max_aspect_ratio < f64::INFINITY
    }

    /// How large a triangle may be where.
    pub(super) fn size(&self) -> &SizeBounds {
        &self.size
    }

    /// The caller's own test, if there is one.
    pub(super) fn asked(&self) -> Option<Arc<UserTest>> {
        self.asked.clone()
    }

    /// The same with a test of the caller's own.
    pub(super) fn with_asked(self, asked: Arc<UserTest>) -> Self {
        Self { asked: Some(asked), ..self }
    }

    /// What is wrong with a face that has these corners; the size first. Angles are certified exactly.
    #[inline(never)]
    pub(super) fn badness(&self, cdt: &ConstrainedTriangulation, f: FaceId, corners: [Point; 3]) -> Option<Badness> {
        let [a, b, c] = corners;
        if self.size.refuse((b - a).cross(c - a), cdt, f, corners) {
            Some(Badness::Area)
        } else if self.asked.is_some() && self.is_refused(cdt, f, corners) {
            Some(Badness::Asked)
        } else if self.cos_sq.is_some_and(|cos_sq| !triangle_angles_at_least(a, b, c, cos_sq)) {
            Some(Badness::Angle)
        } else if self.max_aspect_ratio < f64::INFINITY && self.is_too_slender(corners) {
            Some(Badness::AspectRatio)
        } else {
            None
        }
    }

    /// Whether a triangle is bad for its shape, whatever its size is.
    pub(super) fn is_misshapen(&self, corners: [Point; 3]) -> bool {
        let [a, b, c] = corners;
        self.cos_sq.is_some_and(|cos_sq| !triangle_angles_at_least(a, b, c, cos_sq))
            || self.max_aspect_ratio < f64::INFINITY && self.is_too_slender(corners)
    }

    /// What is asked of every triangle, and whether that is all.
    #[inline]
    pub(super) fn everywhere(&self) -> Everywhere {
        let asks_more = self.asked.is_some() || self.max_aspect_ratio < f64::INFINITY;
        // Without a bound on angles a triangle need only be more than flat.
        let sine_sq = 1.0 - self.cos_sq.unwrap_or(1.0);
        let is_all = !asks_more && self.size.are_uniform();
        Everywhere { sine_sq, doubled_area: self.size.everywhere().doubled(), is_all }
    }

    /// Bounds that imply the test.
    pub(super) fn sure_bounds(&self) -> SureBounds {
        let is_sure = self.asked.is_none() && self.max_aspect_ratio == f64::INFINITY;
        SureBounds {
            sine_sq: self.cos_sq.map_or(0.0, |cos_sq| 1.0 - cos_sq),
            doubled_area: if is_sure { self.size.sure_bound().doubled() } else { f64::NEG_INFINITY },
        }
    }

    /// The area bound by which a face is filled and its share of the mesh estimated.
    pub(super) fn expected_bound(&self, cdt: &ConstrainedTriangulation, f: FaceId) -> AreaBound {
        if self.size.are_uniform() {
            self.size.everywhere()
        } else {
            self.size.expected_within(&TriangleInRegion::of(cdt, f))
        }
    }

    /// Whether the caller's own test refuses a face with these corners.
    #[inline(never)]
    fn is_refused(&self, cdt: &ConstrainedTriangulation, f: FaceId, corners: [Point; 3]) -> bool {
        self.asked.as_ref().is_some_and(|test| test(TriangleInRegion::of_face(cdt, f, corners)))
    }

    #[inline(never)]
    fn is_too_slender(&self, [a, b, c]: [Point; 3]) -> bool {
        aspect_ratio(&Triangle::new(a, b, c)) > self.max_aspect_ratio
    }
}

/// Three ids in order: the name of a triangle.
#[inline]
pub(super) fn sorted([a, b, c]: [VertexId; 3]) -> [VertexId; 3] {
    let (low, high) = (a.min(b), a.max(b));
    [low.min(c), low.max(high.min(c)), high.max(c)]
}
