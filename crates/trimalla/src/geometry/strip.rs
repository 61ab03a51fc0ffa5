//! What counts as lying on a segment, rounding allowed for: one exact rule for the whole library.
//!
//! # The rule
//! A vertex that is computed, the middle of a subsegment or a crossing, has rounded coordinates and lies beside its
//! segment. How far it may lie beside is measured coordinate by coordinate. Let `X` be the largest `|x|` of the two
//! ends of the segment, `Y` the largest `|y|`, and let the *last place* of a magnitude `M` be `2^-52 M`, or `2^-1074`
//! where that is larger. A point lies *in the strip* of `k` last places if some point of the line through the ends
//! differs from it by no more than `k` last places of `X` in x and no more than `k` last places of `Y` in y:
//!
//! ```text
//!                         . ' b         w = k last places of X, h = k last places of Y;
//!         ┌─────┐   . '                 p is in the strip if the line meets the box around p, that is if
//!         │  p  │2h                     |cross(b - a, p - a)| <= w |b.y - a.y| + h |b.x - a.x|
//!         └──.─'┘
//!       . ' 2w
//!     a
//! ```
//!
//! In the mesh of a drawing, each input segment is a chain of edges from its one end to its other:
//!
//! 1. every vertex of the chain is in the strip of [`Strip::LAST_PLACES`] last places;
//! 2. the chain is monotone: the feet of its vertices on the line strictly advance, see [`Strip::order`];
//! 3. input vertices exactly on the segment are vertices of the chain;
//! 4. other input vertices are not, and the chain has each on the side where the segment has it. But in a drawing whose
//!    segments cross and are split, an edge may be split at an input vertex within [`Strip::PARTING_PLACES`], as the
//!    hot-pixel rule of snap rounding has it, and an input vertex in the strip may be on either side.
//!
//! # Why constructed vertices keep the rule
//! Write `u = 2^-53` for the relative error of one rounding, so that a last place of `M` is `2 u M`.
//!
//! *A point at a parameter* is `a (1 - t) + b t` in each coordinate. The difference costs a relative `u`, each product
//! another, the sum a third: in all `(3 u + O(u²)) M`, less than 1.6 last places of `M`, as `|a| (1 - t) + |b| t <= M`.
//! Each product may lose `2^-1075` to underflow: one smallest number in all. So it differs from a point of the segment
//! by less than 3 last places. Confining it to the box of two points, between which the exact point lies, brings it no
//! farther.
//!
//! *A crossing* of two segments is the point at the parameter `t` of one of them, where `t` is the exact ratio of two
//! distances, rounded: their quotient has the error `3 u`, `1 / (1 + quotient)` that times `1 - t`, and `2 u` more.
//! This moves the point along the segment by at most `t (3 (1 - t) + 2) u < 2.1 u` of its extent, which is at most
//! `2 M`: by 2.1 last places of `M`. With the 1.6 of the point itself this is less than 4 last places of each
//! coordinate of that segment. To be as near to the other segment, whose coordinates may be smaller, each coordinate is
//! taken from the segment on which it is smaller, unless the point of one segment is in the strip of the other already:
//! see [`Segment::crossing_point`].
//!
//! *A point between two points in the strip* of a segment is in the strip, which is convex, so an edge of a chain is,
//! and a vertex inserted exactly on it.
//!
//! *Everything else* is proved where it is made, by [`Strip::contains`] itself: a vertex through which a segment is
//! led, a crossing of pieces that were bent before, a split point of a bent piece or of overlapping segments. A point
//! that fails is never taken. So errors never add up, however often pieces are split.
//!
//! *An input vertex keeps its side* where an edge is split: the triangles that the split makes are proved
//! counter-clockwise. Where a released segment is recovered, a place for a split is taken only if no input vertex lies
//! in the triangle between the piece and its two parts, and pieces that rounding made cross meet at no input vertex.
//!
//! *At both ends of the range* nothing changes: the last place is at least the smallest number, which is what an
//! underflow costs, and the strip is compared in sums of exact products, which do not overflow.

use core::cmp::Ordering;

use super::predicates::{Difference, ExactSum, TWO_PRODUCTS_BOUND, UNDERFLOW_GUARD};
use super::{Point, Segment, last_places, math};

/// The points that lie along a segment within some last places of its coordinates: the rule above, decided exactly.
///
/// # Examples
/// ```
/// use trimalla::geometry::{Point, Segment, Strip};
///
/// let segment = Segment::new(Point::new(0.0, 0.0), Point::new(3.0, 1.0));
/// let strip = Strip::new(segment, Strip::LAST_PLACES);
/// assert!(strip.contains(segment.at(0.3)) && strip.contains(segment.midpoint()));
/// assert!(!strip.contains(Point::new(1.5, 0.5 + 1e-14)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strip {
    segment: Segment,
    /// How far a point may be off the line in x, and in y.
    reach: [f64; 2],
}

impl Strip {
    /// How far a vertex of a segment's chain may be off the segment, in last places of each coordinate.
    pub const LAST_PLACES: f64 = last_places::CHAIN;

    /// How far from its segments a vertex may be at which an edge is split, in last places: what is left to
    /// [`LAST_PLACES`](Self::LAST_PLACES) is for later splits.
    pub const PARTING_PLACES: f64 = last_places::PARTING;

    /// The strip of so many last places of the largest magnitudes of x and of y at the ends of a segment.
    #[must_use]
    #[inline]
    pub fn new(segment: Segment, last_places: f64) -> Self {
        let Segment { start: a, end: b } = segment;
        let reach = |p: f64, q: f64| last_places * math::last_place(p.abs().max(q.abs()));
        Self { segment, reach: [reach(a.x, b.x), reach(a.y, b.y)] }
    }

    /// How far a point of the strip may be off the line in x, and in y.
    #[must_use]
    #[inline]
    pub const fn reach(&self) -> [f64; 2] {
        self.reach
    }

    /// Whether a point lies in the strip, beyond the ends too. Exact for all finite numbers.
    #[must_use]
    #[inline]
    pub fn contains(&self, p: Point) -> bool {
        let Segment { start: a, end: b } = self.segment;
        let [w, h] = self.reach;
        let (dx, dy) = (b.x - a.x, b.y - a.y);
        // Differences of doubles are 0 where they are equal, and nowhere else. Near an axis the limit is too small for
        // the filter.
        if dx == 0.0 && p.x == a.x || dy == 0.0 && p.y == a.y {
            return true;
        }
        let (left, right) = (dx * (p.y - a.y), dy * (p.x - a.x));
        let off = (left - right).abs();
        let limit = w * dy.abs() + h * dx.abs();
        // Twice what two products and their difference may cost, and the four roundings of the limit.
        let slack = 2.0 * TWO_PRODUCTS_BOUND * (left.abs() + right.abs() + limit) + UNDERFLOW_GUARD;
        if off + slack < limit {
            true
        } else if off - slack > limit {
            false
        } else {
            self.contains_exactly(p)
        }
    }

    /// Whether `q` comes after `p` along the segment: `Less` where its foot on the line is farther from the start.
    ///
    /// # Guarantees
    /// Exact for all finite points: the sign of the scalar product of `p - q` with the segment.
    #[must_use]
    #[inline]
    pub fn order(&self, p: Point, q: Point) -> Ordering {
        let Segment { start: a, end: b } = self.segment;
        let (along_x, along_y) = ((p.x - q.x) * (b.x - a.x), (p.y - q.y) * (b.y - a.y));
        let dot = along_x + along_y;
        let bound = TWO_PRODUCTS_BOUND * (along_x.abs() + along_y.abs()) + UNDERFLOW_GUARD;
        if dot > bound {
            Ordering::Greater
        } else if dot < -bound {
            Ordering::Less
        } else {
            self.order_exactly(p, q)
        }
    }

    /// Whether the foot of `p` lies strictly between those of two points, whichever of these comes first. Exact.
    #[must_use]
    #[inline]
    pub fn is_between(&self, one: Point, p: Point, other: Point) -> bool {
        let order = self.order(one, p);
        order != Ordering::Equal && order == self.order(p, other)
    }

    /// Decides what the filter left open.
    #[cold]
    #[inline(never)]
    fn contains_exactly(&self, p: Point) -> bool {
        let Segment { start: a, end: b } = self.segment;
        let (dx, dy) = (Difference::new(b.x, a.x), Difference::new(b.y, a.y));
        let (px, py) = (Difference::new(p.x, a.x), Difference::new(p.y, a.y));
        let cross = |sign: Ordering| {
            let mut sum = ExactSum::new();
            let (plus, minus) = if sign == Ordering::Less { ([dy, px], [dx, py]) } else { ([dx, py], [dy, px]) };
            sum.add(plus);
            sum.subtract(minus);
            sum
        };
        let mut excess = cross(cross(Ordering::Greater).sign());
        let length = |p: f64, q: f64| Difference::new(p.max(q), p.min(q));
        let [w, h] = self.reach.map(Difference::number);
        excess.subtract([w, length(a.y, b.y)]);
        excess.subtract([h, length(a.x, b.x)]);
        excess.sign() != Ordering::Greater
    }

    #[cold]
    #[inline(never)]
    fn order_exactly(&self, p: Point, q: Point) -> Ordering {
        let Segment { start: a, end: b } = self.segment;
        let mut dot = ExactSum::new();
        dot.add([Difference::new(p.x, q.x), Difference::new(b.x, a.x)]);
        dot.add([Difference::new(p.y, q.y), Difference::new(b.y, a.y)]);
        dot.sign()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strip(a: [f64; 2], b: [f64; 2], places: f64) -> Strip {
        Strip::new(Segment::new(Point::from(a), Point::from(b)), places)
    }

    #[test]
    fn the_strip_ends_where_the_rule_says_at_every_size() {
        // Horizontal: only the reach in y counts, to the last bit.
        for s in [-900, 0, 900, 1023].map(|exponent| 2.0_f64.powi(exponent)) {
            let flat = strip([-s, s], [s, s], 16.0);
            let edge = 16.0 * f64::EPSILON * s;
            assert!(flat.contains(Point::new(0.0, s + edge)) && flat.contains(Point::new(s / 3.0, s - edge)));
            assert!(!flat.contains(Point::new(0.0, s + edge + f64::EPSILON * s)));
            assert!(!flat.contains(Point::new(0.0, -s)));
        }
        let tiny = strip([0.0, 0.0], [5e-324, 0.0], 1.0);
        assert!(tiny.contains(Point::new(0.0, 5e-324)) && !tiny.contains(Point::new(0.0, 1e-323)));
    }

    #[test]
    fn each_coordinate_is_measured_by_its_own_magnitude() {
        let wide = strip([0.0, 1.0], [1e12, 2.0], 16.0);
        assert!(wide.contains(Point::new(5e11, 1.5)));
        assert!(!wide.contains(Point::new(5e11, 1.5 + 1e-12)), "a last place of 1e12 in y is not granted");
        let decades = strip([-1e61, -1e61], [0.0, 1e241], 16.0);
        assert!(decades.contains(Point::new(-1e61, 1e70)) && !decades.contains(Point::new(-0.9e61, 1e70)));
    }

    #[test]
    fn points_at_parameters_are_in_a_narrow_strip() {
        let mut x = 0.3_f64;
        let mut next = || {
            x = (x * 3.9) * (1.0 - x);
            x
        };
        for scale in [1e-310, 1e-160, 1.0, 1e160, 1e308] {
            for _ in 0..200 {
                let [a, b, c, d] = std::array::from_fn(|_| (next() - 0.5) * scale);
                let segment = Segment::new(Point::new(a, b), Point::new(c, d));
                assert!(Strip::new(segment, 3.0).contains(segment.at(next())), "{segment:?}");
            }
        }
    }

    #[test]
    fn order_is_that_of_the_feet() {
        let slope = strip([0.0, 0.0], [1.0, 3.0], 1.0);
        let [p, q] = [[0.1, 0.3], [0.1, 0.300_000_000_000_000_04]].map(Point::from);
        assert_eq!(
            (slope.order(p, q), slope.order(q, p), slope.order(p, p)),
            (Ordering::Less, Ordering::Greater, Ordering::Equal)
        );
        assert_eq!(slope.order(Point::new(3.0, 0.0), Point::new(0.0, 1.0)), Ordering::Equal);
        assert!(!slope.is_between(q, Point::new(0.5, 0.1), p));
        let whole = strip([-f64::MAX, 0.0], [f64::MAX, 5e-324], 1.0);
        assert_eq!(whole.order(Point::new(0.0, 0.0), Point::new(0.0, 5e-324)), Ordering::Less);
    }
}
