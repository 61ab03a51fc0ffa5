//! Lengths that neither overflow nor underflow.

use crate::geometry::{BoundingBox, Point, Vector, math};

/// Measures lengths in units of a power of two that fits the input, so that squares of them are ordinary numbers.
///
/// Rounded, but the same for both directions of an edge and on every platform.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ruler {
    scale: f64,
}

impl Ruler {
    /// A ruler for points in a box.
    #[must_use]
    pub fn for_box(bounds: Option<BoundingBox>) -> Self {
        let largest = bounds.map_or(1.0, BoundingBox::largest_coordinate);
        Self { scale: math::power_of_two_scale(largest) }
    }

    /// Units of the ruler in a unit of the coordinates.
    #[must_use]
    pub const fn scale(self) -> f64 {
        self.scale
    }

    /// The vector from `a` to `b`, in the ruler's units.
    #[must_use]
    #[inline]
    pub fn vector(self, a: Point, b: Point) -> Vector {
        Vector::new(b.x * self.scale - a.x * self.scale, b.y * self.scale - a.y * self.scale)
    }

    /// The squared distance, in the ruler's squared units.
    #[must_use]
    #[inline]
    pub fn length_sq(self, a: Point, b: Point) -> f64 {
        self.vector(a, b).length_sq()
    }
}
