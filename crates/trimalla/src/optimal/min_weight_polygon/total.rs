//! Sums of lengths with about 100 binary places.

use std::cell::Cell;
use std::cmp::Ordering;

use crate::geometry::Point;
use crate::geometry::math::power_of_two_scale;
use crate::optimal::decompose::Objective;

/// Sums that differ by less than this part of themselves count as equal: 2^-88. A length is off by less than 2^-100 of
/// itself, and so is an addition.
const EQUAL: f64 = f64::from_bits((1023 - 88) << 52);

/// Twice 2^26 plus 1, which splits a number into two halves of its digits.
const SPLITTER: f64 = 134_217_729.0;

/// The sum of lengths is minimised.
pub(super) struct TotalLength {
    /// The points, scaled by a power of two so that nothing overflows.
    points: Vec<Point>,
    /// Whether two sums could not be told apart.
    is_open: Cell<bool>,
}

/// A sum of lengths.
#[derive(Clone, Copy, Debug)]
pub(super) struct Total {
    length: Double,
    /// Equal for sums of the same lengths: the sum of hashes of their squares.
    fingerprint: u64,
}

impl TotalLength {
    /// The lengths between points.
    pub(super) fn new(points: &[Point]) -> Self {
        let largest = points.iter().fold(0.0_f64, |m, p| m.max(p.x.abs()).max(p.y.abs()));
        let scale = power_of_two_scale(largest);
        let points = points.iter().map(|p| Point::new(p.x * scale, p.y * scale)).collect();
        Self { points, is_open: Cell::new(false) }
    }

    /// Whether two different sums could not be told apart.
    pub(super) fn was_open(&self) -> bool {
        self.is_open.get()
    }
}

impl Objective for TotalLength {
    type Value = Total;

    fn edge(&self, [a, b]: [u32; 2]) -> Total {
        let [p, q] = [self.points[a as usize], self.points[b as usize]];
        let (x, y) = (Double::difference(q.x, p.x), Double::difference(q.y, p.y));
        let square = x.squared().plus(y.squared());
        Total { length: square.root(), fingerprint: square.hash() }
    }

    fn join(&self, a: &Total, b: &Total) -> Total {
        let fingerprint = a.fingerprint.wrapping_add(b.fingerprint);
        Total { length: a.length.plus(b.length), fingerprint }
    }

    fn compare(&self, a: &Total, b: &Total) -> Ordering {
        let excess = a.length.plus(b.length.negated()).head;
        if excess.abs() > EQUAL * (a.length.head + b.length.head) {
            return excess.total_cmp(&0.0);
        }
        if a.fingerprint != b.fingerprint {
            self.is_open.set(true);
        }
        Ordering::Equal
    }
}

/// The sum of two numbers, the second of which is at most half a last place of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Double {
    head: f64,
    tail: f64,
}

impl Double {
    /// The sum of two numbers. Exact.
    fn sum(a: f64, b: f64) -> Self {
        let head = a + b;
        let b_seen = head - a;
        Self { head, tail: (a - (head - b_seen)) + (b - b_seen) }
    }

    /// The difference of two numbers. Exact.
    fn difference(a: f64, b: f64) -> Self {
        Self::sum(a, -b)
    }

    /// The square of a number. Exact, unless it underflows.
    fn square(a: f64) -> Self {
        let head = a * a;
        let high = SPLITTER * a - (SPLITTER * a - a);
        let low = a - high;
        Self { head, tail: low * low - ((head - high * high) - 2.0 * high * low) }
    }

    fn squared(self) -> Self {
        let square = Self::square(self.head);
        Self::sum(square.head, square.tail + 2.0 * self.head * self.tail)
    }

    fn plus(self, other: Self) -> Self {
        let (heads, tails) = (Self::sum(self.head, other.head), Self::sum(self.tail, other.tail));
        let first = Self::sum(heads.head, heads.tail + tails.head);
        Self::sum(first.head, first.tail + tails.tail)
    }

    fn negated(self) -> Self {
        Self { head: -self.head, tail: -self.tail }
    }

    /// The root: that of the head, corrected by one step of Newton's method.
    fn root(self) -> Self {
        if self.head <= 0.0 {
            return Self { head: 0.0, tail: 0.0 };
        }
        let root = self.head.sqrt();
        let square = Self::square(root);
        let rest = (self.head - square.head) - square.tail + self.tail;
        Self::sum(root, rest / (2.0 * root))
    }

    /// A number that is the same for the same number.
    fn hash(self) -> u64 {
        let mixed = (self.head.to_bits() ^ self.tail.to_bits().rotate_left(32)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mixed = (mixed ^ mixed >> 29).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed ^ mixed >> 32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_have_a_hundred_places() {
        for value in [2.0, 3.0, 0.1, 1e10 + 1.0] {
            let root = Double { head: value, tail: 0.0 }.root();
            let back = root.squared().plus(Double { head: -value, tail: 0.0 });
            assert!(back.head.abs() < value * 2.0_f64.powi(-99), "{value}: {back:?}");
        }
    }

    #[test]
    fn sums_of_the_same_lengths_are_equal() {
        let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from);
        let total = TotalLength::new(&points);
        let [one, two] = [[0, 2], [1, 3]].map(|edge| total.edge(edge));
        assert_eq!(total.compare(&one, &two), Ordering::Equal);
        assert!(!total.was_open());
        let side = total.edge([0, 1]);
        assert_eq!(total.compare(&side, &one), Ordering::Less);
        // √2 + √2 = √8, which only its root shows.
        let points = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]].map(Point::from);
        let total = TotalLength::new(&points);
        let twice = total.join(&total.edge([0, 1]), &total.edge([1, 2]));
        assert_eq!(total.compare(&twice, &total.edge([0, 2])), Ordering::Equal);
        assert!(total.was_open());
    }
}
