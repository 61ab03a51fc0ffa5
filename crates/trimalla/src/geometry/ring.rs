//! A closed polygonal line.

use super::frame::Frame;
use super::predicates::{Difference, ExactSum, Orientation, orient2d};
use super::{BoundingBox, Containment, Point};

/// A closed polygonal line given by its points; the last one joins the first one.
///
/// Repeated points, collinear points, spikes and rings that touch themselves are all allowed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ring<'a> {
    /// The points in order, the first one not repeated at the end (though it may be).
    pub points: &'a [Point],
}

impl<'a> Ring<'a> {
    /// The ring through the given points.
    #[must_use]
    #[inline]
    pub const fn new(points: &'a [Point]) -> Self {
        Self { points }
    }

    /// The first of some rings that runs counter-clockwise: the outline, among the rings of a connected area that all
    /// have it on their left.
    ///
    /// # Shape
    /// Each ring lists indices of points.
    pub(crate) fn outline_of(rings: &[Vec<u32>], points: &[Point]) -> Option<usize> {
        rings.iter().position(|ring| {
            let corners: Vec<Point> = ring.iter().map(|&v| points[v as usize]).collect();
            Ring::new(&corners).orientation() == Orientation::CounterClockwise
        })
    }

    /// The sides: pairs of successive points, the last point with the first.
    pub fn sides(self) -> impl ExactSizeIterator<Item = (Point, Point)> + DoubleEndedIterator + Clone {
        let points = self.points;
        let next = move |i: usize| points[if i + 1 == points.len() { 0 } else { i + 1 }];
        points.iter().enumerate().map(move |(i, &p)| (p, next(i)))
    }

    /// The direction in which the ring runs: the exact sign of its signed area.
    ///
    /// For a simple polygon this is the turn at its lexicographically smallest corner; unlike that turn it is also
    /// right where points repeat, where a spike ends in the smallest point, and where the ring touches itself there.
    ///
    /// # Guarantees
    /// Exact for every finite input. `Collinear` if the signed area is zero: for fewer than three distinct points, for
    /// points on one line, and for rings whose windings cancel.
    ///
    /// # Complexity
    /// Linear; one pass of plain arithmetic wherever its error bound decides.
    #[must_use]
    pub fn orientation(self) -> Orientation {
        let Some(&origin) = self.points.first() else {
            return Orientation::Collinear;
        };
        let (mut area, mut magnitude) = (0.0, 0.0);
        for (p, q) in self.sides() {
            let (p, q) = (p - origin, q - origin);
            let (left, right) = (p.x * q.y, p.y * q.x);
            area += left - right;
            magnitude += left.abs() + right.abs();
        }
        // Each side carries at most 3 roundings of its magnitude, the sum n - 1 of all of it; underflow loses 2^-1074
        // a side, which the smallest normal number outweighs for every ring that fits into memory.
        let roundings = self.points.len() as f64 + 8.0;
        let bound = roundings * f64::EPSILON / 2.0 * magnitude + f64::MIN_POSITIVE;
        if area > bound {
            Orientation::CounterClockwise
        } else if area < -bound {
            Orientation::Clockwise
        } else {
            self.exact_orientation()
        }
    }

    /// The enclosed area, positive where the ring runs counter-clockwise, rounded.
    #[must_use]
    pub fn signed_area(self) -> f64 {
        let Some(bounds) = BoundingBox::of(self.points.iter().copied()) else {
            return 0.0;
        };
        let frame = Frame::new(bounds.min, [bounds.max]);
        let twice: f64 = self.sides().map(|(p, q)| frame.local(p).cross(frame.local(q))).sum();
        frame.area(0.5 * twice)
    }

    /// Tells where a point lies: `Inside` where the ring winds round it a number of times other than zero.
    ///
    /// # Guarantees
    /// Exact for every finite input, whichever way the ring runs.
    ///
    /// # Complexity
    /// Linear.
    #[must_use]
    pub fn locate(self, p: Point) -> Containment {
        match self.winding_number(p) {
            None => Containment::On,
            Some(0) => Containment::Outside,
            Some(_) => Containment::Inside,
        }
    }

    /// How many times the ring winds counter-clockwise round a point; `None` if the point lies on the ring. Exact.
    #[must_use]
    pub fn winding_number(self, p: Point) -> Option<i64> {
        let mut turns = 0;
        for (a, b) in self.sides() {
            let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
            if p.y < low.y || high.y < p.y || a.x.max(b.x) < p.x {
                continue;
            }
            let side = orient2d(low, high, p);
            if side == Orientation::Collinear && a.x.min(b.x) <= p.x {
                return None;
            }
            // The ray from p towards larger x meets the side, whose lower end counts and upper end does not.
            if side == Orientation::CounterClockwise && low.y <= p.y && p.y < high.y {
                turns += if a.y <= b.y { 1 } else { -1 };
            }
        }
        Some(turns)
    }

    /// The sign of the signed area by summing exact products.
    #[cold]
    fn exact_orientation(self) -> Orientation {
        let mut sum = ExactSum::new();
        for (p, q) in self.sides() {
            sum.add([p.x, q.y].map(Difference::number));
            sum.subtract([p.y, q.x].map(Difference::number));
        }
        Orientation::from_sign(sum.sign())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(coordinates: &[(f64, f64)]) -> Vec<Point> {
        coordinates.iter().map(|&(x, y)| Point::new(x, y)).collect()
    }

    #[test]
    fn squares_of_any_size_run_as_they_are_drawn() {
        for s in [5e-324, 1e-300, 0.1, 1.0, 1e300, f64::MAX] {
            let mut square = points(&[(-s, -s), (s, -s), (s, s), (-s, s)]);
            assert_eq!(Ring::new(&square).orientation(), Orientation::CounterClockwise);
            assert_eq!(Ring::new(&square).locate(Point::default()), Containment::Inside);
            assert_eq!(Ring::new(&square).locate(Point::new(s, 0.0)), Containment::On);
            square.reverse();
            assert_eq!(Ring::new(&square).orientation(), Orientation::Clockwise);
            assert_eq!(Ring::new(&square).winding_number(Point::default()), Some(-1));
        }
        let square = points(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]);
        assert_eq!(Ring::new(&square).signed_area(), 4.0);
    }

    #[test]
    fn repeated_and_collinear_points_and_spikes_do_not_matter() {
        let ring = points(&[
            (0.0, 0.0),
            (-1.0, 0.0),
            (-1.0, 0.0),
            (0.0, 0.0),
            (1.0, 0.0),
            (2.0, 0.0),
            (2.0, 2.0),
            (0.0, 2.0),
            (0.0, 1.0),
        ]);
        assert_eq!(Ring::new(&ring).orientation(), Orientation::CounterClockwise);
        assert_eq!(Ring::new(&ring).locate(Point::new(-0.5, 0.0)), Containment::On);
        assert_eq!(Ring::new(&ring).locate(Point::new(-2.0, 0.0)), Containment::Outside);
        assert_eq!(Ring::new(&ring).locate(Point::new(1.0, 2.0)), Containment::On);
        for flat in [&ring[..0], &ring[..1], &ring[..6]] {
            assert_eq!(Ring::new(flat).orientation(), Orientation::Collinear);
            assert_eq!(Ring::new(flat).signed_area(), 0.0);
        }
    }

    #[test]
    fn a_ray_through_corners_counts_once() {
        let ring = points(&[(0.0, 0.0), (4.0, 0.0), (3.0, 1.0), (4.0, 2.0), (5.0, 1.0), (6.0, 3.0), (0.0, 3.0)]);
        let expected = [(1.0, 1.0, true), (3.5, 1.0, false), (-1.0, 1.0, false), (-1.0, 3.0, false), (4.5, 2.0, true)];
        for (x, y, inside) in expected {
            let found = Ring::new(&ring).locate(Point::new(x, y));
            assert_eq!(found == Containment::Inside, inside, "({x}, {y})");
        }
    }
}
