//! The bound on angles.

use crate::geometry::{Angle, Point, math, triangle_angles_at_least};

/// A smallest angle that every triangle must have.
///
/// Its cotangent and the square of its cosine are kept a little below the true ones, by more than their rounding: a
/// triangle that is proved to meet them has no smaller angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AngleBound {
    degrees: f64,
    cotangent: f64,
    cos_sq: f64,
}

/// Rounding of sine and cosine, of their quotient and of a square, with room to spare.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

impl AngleBound {
    /// A bound in degrees, above 0 and at most 60; `None` for others.
    #[must_use]
    pub fn new(degrees: f64) -> Option<Self> {
        let is_possible = degrees > 0.0 && degrees <= 60.0;
        let angle = degrees.to_radians();
        let cotangent = math::cos(angle) / math::sin(angle) * (1.0 - ROUNDING);
        let cos_sq = Angle::from_degrees(degrees).cos_sq() * (1.0 - ROUNDING);
        (is_possible && cotangent.is_finite()).then_some(Self { degrees, cotangent, cos_sq })
    }

    /// In degrees.
    #[must_use]
    pub const fn degrees(self) -> f64 {
        self.degrees
    }

    /// The greatest cotangent that is allowed.
    #[must_use]
    pub const fn cotangent(self) -> f64 {
        self.cotangent
    }

    /// Whether every angle of a triangle is proved to be at least the bound, by
    /// [exact signs](triangle_angles_at_least): a triangle within the last places of the bound may fail it.
    #[must_use]
    pub fn is_met_by(self, [a, b, c]: [Point; 3]) -> bool {
        triangle_angles_at_least(a, b, c, self.cos_sq)
    }
}
