//! The bound on angles, and its proof for a triangle.

use crate::geometry::{Point, math};

/// A smallest angle that every triangle must have.
///
/// It is kept as a cotangent that is not greater than the true one: a triangle whose cotangents are proved to be at
/// most that has no smaller angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AngleBound {
    degrees: f64,
    cotangent: f64,
}

/// Rounding of the sine, the cosine and their quotient, with room to spare.
const ROUNDING_OF_COTANGENT: f64 = 16.0 * f64::EPSILON;
/// Sums of two products of rounded differences, times a rounded factor, are off by less than this part of the sum of
/// their magnitudes: five roundings of half an epsilon each, and as much to spare.
const ROUNDING_OF_SUM: f64 = 5.0 * f64::EPSILON;

impl AngleBound {
    /// A bound in degrees, above 0 and at most 60; `None` for others.
    #[must_use]
    pub fn new(degrees: f64) -> Option<Self> {
        let is_possible = degrees > 0.0 && degrees <= 60.0;
        let angle = degrees.to_radians();
        let cotangent = math::cos(angle) / math::sin(angle) * (1.0 - ROUNDING_OF_COTANGENT);
        (is_possible && cotangent.is_finite()).then_some(Self { degrees, cotangent })
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

    /// Whether every angle of a triangle is proved to be at least the bound. The proof is by an enclosure of the
    /// rounding of its own arithmetic: a triangle within the last places of the bound may fail it.
    #[must_use]
    pub fn is_met_by(self, [a, b, c]: [Point; 3]) -> bool {
        [[a, b, c], [b, c, a], [c, a, b]].into_iter().all(|corner| self.is_met_at(corner))
    }

    /// Whether the angle at the first corner is at least the bound: its cotangent is the dot product of the sides there
    /// over their cross product.
    fn is_met_at(self, [a, b, c]: [Point; 3]) -> bool {
        let (u, v) = ([b.x - a.x, b.y - a.y], [c.x - a.x, c.y - a.y]);
        let (cross, dot) = ([u[0] * v[1], -(u[1] * v[0])], [u[0] * v[0], u[1] * v[1]]);
        let spare = self.cotangent * (cross[0] + cross[1]) - (dot[0] + dot[1]);
        let magnitude = self.cotangent * (cross[0].abs() + cross[1].abs()) + dot[0].abs() + dot[1].abs();
        // Products that vanish, or nearly, prove nothing.
        spare > ROUNDING_OF_SUM * magnitude && magnitude > f64::MIN_POSITIVE / f64::EPSILON && magnitude.is_finite()
    }
}
