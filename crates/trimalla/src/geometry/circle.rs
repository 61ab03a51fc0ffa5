//! A circle, for measuring and drawing; decisions belong to [`in_circle`](super::in_circle).

use super::{BoundingBox, Point, Segment};

/// A circle with rounded center and radius.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Circle {
    /// The center.
    pub center: Point,
    /// The radius, in coordinate units.
    pub radius: f64,
}

impl Circle {
    /// The circle around a center.
    #[must_use]
    #[inline]
    pub const fn new(center: Point, radius: f64) -> Self {
        Self { center, radius }
    }

    /// The circle whose diameter is the given segment, rounded.
    #[must_use]
    #[inline]
    pub fn diametral(diameter: Segment) -> Self {
        let center = diameter.midpoint();
        Self::new(center, Segment::new(center, diameter.end).length())
    }

    /// The smallest box around the circle, rounded.
    #[must_use]
    #[inline]
    pub fn bounding_box(self) -> BoundingBox {
        let Self { center: Point { x, y }, radius: r } = self;
        BoundingBox::around(Point::new(x - r, y - r)).including(Point::new(x + r, y + r))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_diametral_circle_is_centered_on_its_segment() {
        let circle = Circle::diametral(Segment::new(Point::new(1.0, 1.0), Point::new(7.0, 9.0)));
        assert_eq!(circle, Circle::new(Point::new(4.0, 5.0), 5.0));
        assert_eq!(circle.bounding_box().min, Point::new(-1.0, 0.0));
    }
}
