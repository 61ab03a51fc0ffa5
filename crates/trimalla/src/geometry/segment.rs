//! A straight segment.

use std::cmp::Ordering;

use super::frame::Frame;
use super::math;
use super::predicates::{SegmentContact, crossing_parameter, on_segment, segment_contact};
use super::{BoundingBox, Point, Strip, Vector, last_places, lexicographically_less};

/// A straight segment between two points, which may coincide.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Segment {
    /// The end it starts from.
    pub start: Point,
    /// The end it goes to.
    pub end: Point,
}

impl Segment {
    /// The segment from `start` to `end`.
    #[must_use]
    #[inline]
    pub const fn new(start: Point, end: Point) -> Self {
        Self { start, end }
    }

    /// Both ends, start first.
    #[must_use]
    #[inline]
    pub const fn ends(self) -> [Point; 2] {
        [self.start, self.end]
    }

    /// The same segment from its other end.
    #[must_use]
    #[inline]
    pub const fn reversed(self) -> Self {
        Self::new(self.end, self.start)
    }

    /// The point halfway, rounded: see [`Point::midpoint`].
    #[must_use]
    #[inline]
    pub fn midpoint(self) -> Point {
        Point::midpoint(self.start, self.end)
    }

    /// The point at parameter `t`, rounded: see [`Point::lerp`].
    #[must_use]
    #[inline]
    pub fn at(self, t: f64) -> Point {
        Point::lerp(self.start, self.end, t)
    }

    /// The squared length `dx * dx + dy * dy`, rounded, unscaled: see [`Point::distance_sq`].
    #[must_use]
    #[inline]
    pub fn length_sq(self) -> f64 {
        Point::distance_sq(self.start, self.end)
    }

    /// The length, rounded.
    ///
    /// # Guarantees
    /// Infinite only if the length itself passes `f64::MAX`, zero only if the ends coincide.
    #[must_use]
    #[inline]
    pub fn length(self) -> f64 {
        let frame = Frame::new(self.start, [self.end]);
        frame.length(frame.local(self.end).length_sq().sqrt())
    }

    /// The smallest box around the segment.
    #[must_use]
    #[inline]
    pub fn bounding_box(self) -> BoundingBox {
        BoundingBox::around(self.start).including(self.end)
    }

    /// The parameter of the point nearest to `p`, rounded: 0 at the start, 1 at the end, 0 for a segment of one point.
    #[must_use]
    pub fn nearest_parameter(self, p: Point) -> f64 {
        let frame = Frame::new(p, self.ends());
        let (a, b) = (frame.local(self.start), frame.local(self.end));
        let t = -(a.dot(b - a)) / (b - a).length_sq();
        if t.is_nan() { 0.0 } else { t.clamp(0.0, 1.0) }
    }

    /// The parameter that stands for `p`, a rounded point of the segment: that of the nearest point, or the one with
    /// the fewest bits among those that rounding cannot tell from it, if [`at`](Self::at) gives back `p` for that.
    ///
    /// So the parameter depends on the point only, and is still a half or a quarter if the point was computed from one.
    #[must_use]
    pub fn parameter_of(self, p: Point) -> f64 {
        let nearest = self.nearest_parameter(p);
        let rounding = 2.0 * (math::last_place(self.largest_coordinate()) / self.length() + f64::EPSILON * nearest);
        let (low, high) = ((nearest - rounding).max(0.0), (nearest + rounding).min(1.0));
        let simple = math::roundest_between(low, high);
        if self.at(simple) == p { simple } else { nearest }
    }

    /// The distance from `p` to the nearest point of the segment, rounded.
    ///
    /// # Guarantees
    /// Infinite only if the distance itself passes `f64::MAX`. The error is a few last places of the distance from `p`
    /// to the nearer end.
    #[must_use]
    pub fn distance(self, p: Point) -> f64 {
        let frame = Frame::new(p, self.ends());
        let (a, b) = (frame.local(self.start), frame.local(self.end));
        let ab = b - a;
        let nearest = if a.dot(ab) >= 0.0 {
            a.length_sq().sqrt()
        } else if b.dot(ab) <= 0.0 {
            b.length_sq().sqrt()
        } else {
            a.cross(b).abs() / ab.length_sq().sqrt()
        };
        frame.length(nearest)
    }

    /// Whether a point is on the segment, or off it by no more than so many last places of its largest coordinate.
    ///
    /// The distance is rounded; [`Strip`] decides exactly.
    #[must_use]
    pub(crate) fn passes_within(self, last_places: f64, p: Point) -> bool {
        on_segment(self.start, self.end, p)
            || self.distance(p) <= last_places * math::last_place(self.largest_coordinate())
    }

    /// The only point that two segments share: rounded where they cross, exact where an end lies on the other segment.
    ///
    /// # Guarantees
    /// `None` exactly if the segments share no point or more than one; that decision is exact. The result has the same
    /// bits whichever way the segments are directed and whichever of them comes first, and lies in the boxes of both.
    /// It is within 8 last places of both, coordinate by coordinate, as [`Strip`] measures it.
    ///
    /// # Source
    /// The parameter is the exact ratio of the distances of the ends from the other line, rounded once.
    #[must_use]
    pub fn crossing_point(self, other: Self) -> Option<Point> {
        match segment_contact(self.start, self.end, other.start, other.end) {
            SegmentContact::Crossing => Some(self.proper_crossing(other)),
            SegmentContact::Touching => self.shared_end(other),
            SegmentContact::Apart | SegmentContact::Overlapping => None,
        }
    }

    /// The crossing of two segments that cross in a point inside both.
    ///
    /// The point is first taken on the segment with the smaller coordinates, whose last places are finer. Where that is
    /// too far off the other segment, as one segment may have the finer x and the other the finer y, each coordinate is
    /// taken from the segment on which it is finer.
    fn proper_crossing(self, other: Self) -> Point {
        let [one, two] = Self::finer_first(self.sorted(), other.sorted(), Self::largest_coordinate);
        let on = |line: Self, across: Self| line.at(crossing_parameter(across.ends(), line.ends()));
        let confined = |p: Point| two.bounding_box().clamp(one.bounding_box().clamp(p));
        let point = confined(on(one, two));
        if Strip::new(two, last_places::CROSSING).contains(point) {
            return point;
        }
        let [by_x, across_x] = Self::finer_first(one, two, |s| s.start.x.abs().max(s.end.x.abs()));
        let [by_y, across_y] = Self::finer_first(one, two, |s| s.start.y.abs().max(s.end.y.abs()));
        confined(Point::new(on(by_x, across_x).x, on(by_y, across_y).y))
    }

    /// Two sorted segments, that with the smaller magnitude first; of equal ones that with the lower start.
    fn finer_first(one: Self, two: Self, magnitude: impl Fn(Self) -> f64) -> [Self; 2] {
        let two_is_finer = match magnitude(two).total_cmp(&magnitude(one)) {
            Ordering::Less => true,
            Ordering::Equal => lexicographically_less(two.start, one.start),
            Ordering::Greater => false,
        };
        if two_is_finer { [two, one] } else { [one, two] }
    }

    /// The end that lies on the other segment, of two segments that touch.
    fn shared_end(self, other: Self) -> Option<Point> {
        let of_other = other.ends().into_iter().find(|p| on_segment(self.start, self.end, *p));
        of_other.or_else(|| self.ends().into_iter().find(|p| on_segment(other.start, other.end, *p)))
    }

    /// The segment directed from its lexicographically smaller end.
    fn sorted(self) -> Self {
        if lexicographically_less(self.end, self.start) { self.reversed() } else { self }
    }

    /// The largest magnitude of a coordinate of its ends: what the rounding of its points is in proportion to.
    #[must_use]
    pub fn largest_coordinate(self) -> f64 {
        let [a, b] = self.ends();
        a.x.abs().max(a.y.abs()).max(b.x.abs()).max(b.y.abs())
    }

    /// The displacement from start to end, which overflows for ends too far apart.
    #[must_use]
    #[inline]
    pub fn direction(self) -> Vector {
        self.end - self.start
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn segment(x0: f64, y0: f64, x1: f64, y1: f64) -> Segment {
        Segment::new(Point::new(x0, y0), Point::new(x1, y1))
    }

    #[test]
    fn diagonals_cross_in_the_middle_at_every_size() {
        for s in [5e-324, 1e-300, 1.0, 1e300, f64::MAX] {
            let (one, two) = (segment(-s, -s, s, s), segment(-s, s, s, -s));
            assert_eq!(one.crossing_point(two), Some(Point::new(0.0, 0.0)));
        }
    }

    #[test]
    fn a_crossing_does_not_depend_on_directions_or_order() {
        let (one, two) = (segment(0.1, 0.2, 7.3, 5.9), segment(0.3, 6.1, 6.7, 0.4));
        let expected = one.crossing_point(two);
        assert!(expected.is_some());
        for (a, b) in [(one, two.reversed()), (two, one), (two.reversed(), one.reversed())] {
            assert_eq!(a.crossing_point(b), expected);
        }
    }

    #[test]
    fn touching_segments_share_an_end_exactly() {
        let (one, two) = (segment(0.0, 0.0, 1.0, 0.0), segment(0.3, 0.0, 0.3, 1.0));
        assert_eq!(one.crossing_point(two), Some(two.start));
        assert_eq!(two.crossing_point(one), Some(two.start));
        assert_eq!(one.crossing_point(one), None);
        assert_eq!(one.crossing_point(segment(0.0, 1.0, 1.0, 1.0)), None);
    }

    #[test]
    fn the_nearest_point_is_inside_or_an_end_at_every_size() {
        for s in [1e-300, 1.0, 1e300] {
            let base = segment(0.0, 0.0, 4.0 * s, 0.0);
            for (x, y, t, distance) in [(1.0, 3.0, 0.25, 3.0), (-3.0, 4.0, 0.0, 5.0), (7.0, -4.0, 1.0, 5.0)] {
                let p = Point::new(x * s, y * s);
                assert_eq!(base.nearest_parameter(p), t);
                assert!((base.distance(p) / s - distance).abs() < 1e-14);
            }
        }
        let point = segment(1.0, 1.0, 1.0, 1.0);
        assert_eq!((point.nearest_parameter(point.start), point.distance(Point::new(4.0, 5.0))), (0.0, 5.0));
    }

    #[test]
    fn a_parameter_is_told_by_its_point_and_stays_short() {
        let skew = segment(0.1, 1e6, 0.7, 1e6 + 0.3);
        for base in [segment(0.0, 0.0, 0.3, 0.0), segment(0.1, 0.2, 7.3, 5.9), skew, segment(-3.0, 1.0, 1e-9, 1e9)] {
            for t in [0.5, 0.25, 0.375, 0.9375] {
                assert_eq!(base.parameter_of(base.at(t)), t);
            }
            for t in [0.3, 1e-3, 0.777_777] {
                let p = base.at(t);
                assert!((base.parameter_of(p) - t).abs() < 1e-8);
                assert!(
                    Point::distance_sq(p, base.at(base.parameter_of(p))).sqrt()
                        <= 2.0 * math::last_place(base.largest_coordinate())
                );
            }
        }
    }

    #[test]
    fn lengths_neither_overflow_nor_vanish() {
        let big = 2.0_f64.powi(1000);
        assert_eq!(segment(0.0, 0.0, 3.0 * big, 4.0 * big).length(), 5.0 * big);
        let s = 5e-324;
        assert_eq!(segment(0.0, 0.0, 3.0 * s, 4.0 * s).length(), 5.0 * s);
        assert_eq!(segment(-f64::MAX, 0.0, f64::MAX, 0.0).length(), f64::INFINITY);
        assert_eq!(segment(2.0, 2.0, 2.0, 2.0).length(), 0.0);
    }
}
