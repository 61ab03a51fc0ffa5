//! Boxes with sides along the axes.

use super::Point;

/// The closed box between two corners.
///
/// # Guarantees
/// Nothing here overflows for corners at ±1e308 except [`width`](Self::width) and [`height`](Self::height), which say
/// so.
#[doc(alias = "AABB")]
#[doc(alias = "bbox")]
#[doc(alias = "rectángulo")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BoundingBox {
    /// The corner with the smallest coordinates.
    pub min: Point,
    /// The corner with the largest coordinates.
    pub max: Point,
}

impl BoundingBox {
    /// The box that holds one point only.
    #[must_use]
    #[inline]
    pub const fn around(point: Point) -> Self {
        Self { min: point, max: point }
    }

    /// The smallest box around some points; `None` for no points.
    #[must_use]
    #[inline]
    pub fn of(points: impl IntoIterator<Item = Point>) -> Option<Self> {
        let mut points = points.into_iter();
        let first = Self::around(points.next()?);
        Some(points.fold(first, Self::including))
    }

    /// The smallest box around many finite points; faster than [`of`](Self::of), which handles NaN.
    #[inline]
    pub(crate) fn of_finite(points: impl IntoIterator<Item = Point>) -> Option<Self> {
        let mut points = points.into_iter();
        let first = Self::around(points.next()?);
        let least = |a: f64, b: f64| if b < a { b } else { a };
        let greatest = |a: f64, b: f64| if b > a { b } else { a };
        let including = |Self { min, max }, p: Point| Self {
            min: Point::new(least(min.x, p.x), least(min.y, p.y)),
            max: Point::new(greatest(max.x, p.x), greatest(max.y, p.y)),
        };
        // Four boxes at a time: one would be a chain of operations that wait for each other.
        let mut boxes = [first; 4];
        'all: loop {
            for b in &mut boxes {
                let Some(p) = points.next() else { break 'all };
                *b = including(*b, p);
            }
        }
        Some(boxes.into_iter().fold(first, Self::united))
    }

    /// The smallest box that holds this one and a point.
    #[must_use]
    #[inline]
    pub const fn including(self, point: Point) -> Self {
        Self {
            min: Point::new(self.min.x.min(point.x), self.min.y.min(point.y)),
            max: Point::new(self.max.x.max(point.x), self.max.y.max(point.y)),
        }
    }

    /// Grows to hold a point.
    #[inline]
    pub const fn include(&mut self, point: Point) {
        *self = self.including(point);
    }

    /// The smallest box that holds two boxes.
    #[must_use]
    #[inline]
    pub const fn united(self, other: Self) -> Self {
        self.including(other.min).including(other.max)
    }

    /// The extent along x, infinite where it passes `f64::MAX`.
    #[must_use]
    #[inline]
    pub const fn width(self) -> f64 {
        self.max.x - self.min.x
    }

    /// The extent along y, infinite where it passes `f64::MAX`.
    #[must_use]
    #[inline]
    pub const fn height(self) -> f64 {
        self.max.y - self.min.y
    }

    /// Half the extent along x, always finite.
    #[must_use]
    #[inline]
    pub const fn half_width(self) -> f64 {
        self.max.x / 2.0 - self.min.x / 2.0
    }

    /// Half the extent along y, always finite.
    #[must_use]
    #[inline]
    pub const fn half_height(self) -> f64 {
        self.max.y / 2.0 - self.min.y / 2.0
    }

    /// The largest absolute value of a coordinate of its points.
    #[must_use]
    pub const fn largest_coordinate(self) -> f64 {
        self.min.x.abs().max(self.min.y.abs()).max(self.max.x.abs()).max(self.max.y.abs())
    }

    /// The point in the middle, rounded.
    #[must_use]
    #[inline]
    pub fn center(self) -> Point {
        Point::midpoint(self.min, self.max)
    }

    /// Tells whether a point lies in the closed box. Exact.
    #[must_use]
    #[inline]
    pub const fn contains(self, p: Point) -> bool {
        self.min.x <= p.x && p.x <= self.max.x && self.min.y <= p.y && p.y <= self.max.y
    }

    /// Tells whether two closed boxes have a point in common. Exact.
    #[must_use]
    #[inline]
    pub const fn meets(self, other: Self) -> bool {
        self.min.x <= other.max.x && other.min.x <= self.max.x && self.min.y <= other.max.y && other.min.y <= self.max.y
    }

    /// The point of the box nearest to a point.
    #[must_use]
    #[inline]
    pub const fn clamp(self, p: Point) -> Point {
        Point::new(p.x.max(self.min.x).min(self.max.x), p.y.max(self.min.y).min(self.max.y))
    }

    /// The position of a point relative to the box: `[0, 0]` at its smallest corner, `[1, 1]` at its largest.
    ///
    /// # Guarantees
    /// Both coordinates within `[0, 1]`, also for points outside and for boxes of any finite size; monotone in each
    /// coordinate. Zero along an axis on which the box has no extent, and for coordinates that are not numbers.
    #[must_use]
    #[inline]
    pub fn normalise(self, p: Point) -> [f64; 2] {
        [fraction(p.x, self.min.x, self.max.x), fraction(p.y, self.min.y, self.max.y)]
    }
}

/// The position of `value` between `low` and `high` as a number in `[0, 1]`.
#[inline]
fn fraction(value: f64, low: f64, high: f64) -> f64 {
    let extent = high - low;
    let fraction =
        if extent < f64::MAX { (value - low) / extent } else { (value / 2.0 - low / 2.0) / (high / 2.0 - low / 2.0) };
    // `max` first, because it turns the undefined 0 / 0 into 0.
    fraction.max(0.0).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(points: &[(f64, f64)]) -> Option<BoundingBox> {
        BoundingBox::of(points.iter().map(|&(x, y)| Point::new(x, y)))
    }

    #[test]
    fn the_largest_box_still_normalises() {
        let all = of(&[(-f64::MAX, f64::MAX), (f64::MAX, -f64::MAX)]).unwrap();
        assert_eq!(all.width(), f64::INFINITY);
        assert_eq!((all.half_width(), all.half_height()), (f64::MAX, f64::MAX));
        assert_eq!(all.normalise(Point::new(0.0, f64::MAX)), [0.5, 1.0]);
        assert_eq!(all.normalise(all.min), [0.0, 0.0]);
        assert_eq!(all.center(), Point::new(0.0, 0.0));
    }

    #[test]
    fn the_smallest_box_still_normalises() {
        let tiny = of(&[(0.0, 0.0), (1e-323, 5e-324)]).unwrap();
        assert_eq!(tiny.normalise(Point::new(5e-324, 5e-324)), [0.5, 1.0]);
        let flat = of(&[(3.0, 0.0), (3.0, 4.0)]).unwrap();
        assert_eq!(flat.normalise(Point::new(3.0, 1.0)), [0.0, 0.25]);
        assert_eq!(flat.normalise(Point::new(9.0, 9.0)), [1.0, 1.0]);
        assert_eq!(flat.normalise(Point::new(f64::NAN, -1.0)), [0.0, 0.0]);
    }

    #[test]
    fn the_box_of_finite_points_is_the_box() {
        let points: Vec<Point> =
            (0..40_u16).map(|i| Point::new(f64::from(i * 7 % 11), -f64::from(i * 5 % 13))).collect();
        for start in 0..20 {
            for end in start..points.len() {
                let some = points[start..end].iter().copied();
                assert_eq!(BoundingBox::of_finite(some.clone()), BoundingBox::of(some));
            }
        }
    }

    #[test]
    fn boxes_grow_and_meet() {
        assert_eq!(of(&[]), None);
        let mut one = BoundingBox::around(Point::new(1.0, 1.0));
        one.include(Point::new(0.0, 3.0));
        let two = BoundingBox::around(Point::new(1.0, 2.0));
        assert!(one.meets(two) && one.contains(two.min));
        assert_eq!(one.united(two), one);
        assert_eq!(one.clamp(Point::new(9.0, -9.0)), Point::new(1.0, 1.0));
    }
}
