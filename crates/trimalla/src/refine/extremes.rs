//! Which triangles of a mesh have the extreme angles, and which can be bad: nearly all are passed over at a glance.
//!
//! The glance takes few products and no quotient, in the units of the drawing, from any corner on. It is sure of what it
//! says by a margin that is far above rounding; what it is not sure of, [`Extremes`] decides, and the test of the criteria.

use super::bad_triangles::SureBounds;
use super::ruler::Ruler;
use crate::geometry::{Point, Vector};
use crate::mesh::FaceId;

/// More than any sum or quotient of products is off by rounding, relatively.
const SLACK: f64 = 1e-12;
/// Products of four lengths from here on have lost nothing to underflow.
const ORDINARY: f64 = 1e-280;

/// Squares of the sides of a triangle, sorted, and twice its area. Rounded.
struct Sides {
    short: f64,
    middle: f64,
    long: f64,
    doubled_area: f64,
}

impl Sides {
    #[inline]
    fn of([a, b, c]: [Point; 3]) -> Self {
        let (u, v, w) = (b - a, c - b, a - c);
        let [p, q, r] = [u, v, w].map(Vector::length_sq);
        let lesser = |x: f64, y: f64| if x < y { x } else { y };
        let greater = |x: f64, y: f64| if x > y { x } else { y };
        let (low, high) = (lesser(p, q), greater(p, q));
        Self {
            short: lesser(low, r),
            middle: greater(low, lesser(high, r)),
            long: greater(high, r),
            doubled_area: u.cross(v),
        }
    }

    /// The squared sine of the smallest angle, which lies between the two longer sides.
    fn sine_sq(&self) -> f64 {
        (self.doubled_area / self.long) * (self.doubled_area / self.middle)
    }

    /// Four times the squared cosine of the largest angle, which lies between the two shorter sides, with the cosine's sign.
    fn cosine_sq(&self) -> f64 {
        let excess = self.excess();
        excess * excess.abs() / (self.short * self.middle)
    }

    #[inline]
    fn excess(&self) -> f64 {
        self.short + self.middle - self.long
    }
}

/// The triangles of the smallest and of the largest angle among those seen so far.
pub(super) struct Extremes {
    scale: f64,
    pub(super) sharpest: Option<FaceId>,
    pub(super) bluntest: Option<FaceId>,
    /// The squared sine of the one, four times the squared cosine of the other.
    least_sine: f64,
    least_cosine: f64,
    /// No triangle within these is bad.
    sure: SureBounds,
    glance: Glance,
}

/// What a triangle must surpass so that a glance is enough.
struct Glance {
    /// The square of twice the area.
    area_sq: f64,
    sine_sq: f64,
    cosine_sq: f64,
}

impl Extremes {
    /// No triangles so far.
    pub(super) fn new(ruler: Ruler, sure: SureBounds) -> Self {
        let scale = ruler.scale();
        let unit = (scale * scale) * (scale * scale);
        // Ordinary in the units of the ruler, too.
        let area_sq = ORDINARY.max(ORDINARY / unit);
        Self {
            scale,
            sharpest: None,
            bluntest: None,
            least_sine: f64::INFINITY,
            least_cosine: f64::INFINITY,
            sure,
            glance: Glance { area_sq, sine_sq: f64::INFINITY, cosine_sq: f64::INFINITY },
        }
    }

    /// Whether a glance tells that a triangle is not bad, and that neither of its extreme angles is one of the mesh so far.
    ///
    /// Twice the area is off by some last places of the longest side's square, wherever it is measured from. The squares
    /// of the sides are the same from every corner, and in other units.
    #[inline]
    pub(super) fn is_plain(&self, corners: [Point; 3]) -> bool {
        let sides = Sides::of(corners);
        let margin = SLACK * sides.long;
        let least_area = sides.doubled_area - margin;
        let (area_sq, excess) = (least_area * least_area, sides.excess());
        least_area > 0.0
            && area_sq > self.glance.area_sq
            && area_sq > self.glance.sine_sq * (sides.long * sides.middle)
            && excess * excess.abs() > self.glance.cosine_sq * (sides.short * sides.middle)
            && sides.doubled_area + margin <= self.sure.doubled_area
    }

    /// Looks at a triangle with these corners, the newest first.
    pub(super) fn see(&mut self, f: FaceId, corners: [Point; 3]) {
        let sides = Sides::of(corners.map(|p| Point::new(p.x * self.scale, p.y * self.scale)));
        let (sine_sq, cosine_sq) = (sides.sine_sq(), sides.cosine_sq());
        if sine_sq < self.least_sine {
            (self.least_sine, self.sharpest) = (sine_sq, Some(f));
            self.glance.sine_sq = sine_sq.max(self.sure.sine_sq) * (1.0 + SLACK);
        }
        if cosine_sq < self.least_cosine {
            (self.least_cosine, self.bluntest) = (cosine_sq, Some(f));
            self.glance.cosine_sq = cosine_sq + SLACK;
        }
    }
}
