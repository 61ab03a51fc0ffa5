//! What two segments, or a segment and a point, have in common.

use super::super::{Point, lexicographically_less};
use super::orient::{Orientation, collinear, orient2d};

/// What two closed segments have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SegmentContact {
    /// Nothing.
    Apart,
    /// One point in the interior of both.
    Crossing,
    /// One point that is an end of at least one of them.
    Touching,
    /// More than one point: they lie on one line.
    Overlapping,
}

/// Tells whether `p` lies on the closed segment `ab`. Exact.
#[must_use]
#[inline]
pub fn on_segment(a: Point, b: Point, p: Point) -> bool {
    collinear(a, b, p) && within(a, b, p)
}

/// Tells whether `p` lies on the segment `ab` and is neither of its ends. Exact.
#[doc(alias = "between")]
#[must_use]
#[inline]
pub fn strictly_between(a: Point, b: Point, p: Point) -> bool {
    let less = lexicographically_less;
    collinear(a, b, p) && ((less(a, p) && less(p, b)) || (less(b, p) && less(p, a)))
}

/// Tells whether the segments `ab` and `cd` cross in a point that is inside both. Exact.
///
/// # Source
/// `[Valenzuela09]`, `intersectProp`.
#[doc(alias = "intersectProp")]
#[must_use]
#[inline]
pub fn segments_cross_properly(a: Point, b: Point, c: Point, d: Point) -> bool {
    separates(a, b, c, d) && separates(c, d, a, b)
}

/// Tells what the closed segments `ab` and `cd` have in common. Exact; segments of one point are allowed.
#[doc(alias = "segment intersection")]
#[doc(alias = "intersección")]
#[must_use]
pub fn segment_contact(a: Point, b: Point, c: Point, d: Point) -> SegmentContact {
    if segments_cross_properly(a, b, c, d) {
        return SegmentContact::Crossing;
    }
    let mut shared =
        [(c, on_segment(a, b, c)), (d, on_segment(a, b, d)), (a, on_segment(c, d, a)), (b, on_segment(c, d, b))]
            .into_iter()
            .filter_map(|(point, on)| on.then_some(point));
    match shared.next() {
        None => SegmentContact::Apart,
        Some(first) if shared.all(|other| other == first) => SegmentContact::Touching,
        Some(_) => SegmentContact::Overlapping,
    }
}

/// Tells whether the line through `a` and `b` has `c` and `d` strictly on different sides.
#[inline]
fn separates(a: Point, b: Point, c: Point, d: Point) -> bool {
    let side = orient2d(a, b, c);
    side != Orientation::Collinear && orient2d(a, b, d) == side.reversed()
}

/// Tells whether a point of the line through `a` and `b` lies between them, ends included.
#[inline]
fn within(a: Point, b: Point, p: Point) -> bool {
    let less = lexicographically_less;
    !((less(p, a) && less(p, b)) || (less(a, p) && less(b, p)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contact(points: [(f64, f64); 4]) -> SegmentContact {
        let [a, b, c, d] = points.map(|(x, y)| Point::new(x, y));
        let found = segment_contact(a, b, c, d);
        assert_eq!(found, segment_contact(d, c, a, b));
        assert_eq!(found, segment_contact(b, a, c, d));
        found
    }

    #[test]
    fn every_kind_of_contact_is_told_apart() {
        use SegmentContact::{Apart, Crossing, Overlapping, Touching};
        let cases = [
            ([(0.0, 0.0), (2.0, 2.0), (0.0, 2.0), (2.0, 0.0)], Crossing),
            ([(0.0, 0.0), (2.0, 2.0), (1.0, 1.0), (2.0, 0.0)], Touching),
            ([(0.0, 0.0), (2.0, 2.0), (2.0, 2.0), (2.0, 0.0)], Touching),
            ([(0.0, 0.0), (2.0, 2.0), (2.0, 2.0), (3.0, 3.0)], Touching),
            ([(0.0, 0.0), (2.0, 2.0), (1.0, 1.0), (3.0, 3.0)], Overlapping),
            ([(0.0, 0.0), (0.0, 3.0), (0.0, 1.0), (0.0, 2.0)], Overlapping),
            ([(0.0, 0.0), (0.0, 3.0), (0.0, 0.0), (0.0, 3.0)], Overlapping),
            ([(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0)], Apart),
            ([(0.0, 0.0), (1.0, 0.0), (2.0, 1.0), (2.0, -1.0)], Apart),
            ([(1.0, 1.0), (1.0, 1.0), (0.0, 0.0), (3.0, 3.0)], Touching),
            ([(1.0, 1.0), (1.0, 1.0), (1.0, 1.0), (1.0, 1.0)], Touching),
        ];
        for (points, expected) in cases {
            assert_eq!(contact(points), expected, "{points:?}");
        }
    }

    #[test]
    fn a_rounded_midpoint_is_mostly_beside_its_segment() {
        let (a, b) = (Point::new(0.0, 0.0), Point::new(1.0, 3.0));
        assert!(strictly_between(a, b, Point::new(0.5, 1.5)));
        assert!(!on_segment(a, b, Point::new(0.1, 0.3)));
        assert!(on_segment(a, b, b) && !strictly_between(a, b, b));
        assert!(on_segment(a, a, a) && !on_segment(a, a, b));
    }
}
