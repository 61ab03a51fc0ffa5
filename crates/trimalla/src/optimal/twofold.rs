//! Numbers with about 100 binary places: sums of two doubles.
//!
//! # Source
//! `[Dekker71]`

use crate::geometry::Point;

/// Twice 2^26 plus 1, which splits a number into two halves of its digits.
const SPLITTER: f64 = 134_217_729.0;

/// The sum of two numbers, the second of which is at most half a last place of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Twofold {
    pub(crate) head: f64,
    pub(crate) tail: f64,
}

impl Twofold {
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

    /// The squared distance of two points.
    pub(crate) fn distance_sq(a: Point, b: Point) -> Self {
        let (x, y) = (Self::difference(b.x, a.x), Self::difference(b.y, a.y));
        x.squared().plus(y.squared())
    }

    fn squared(self) -> Self {
        let square = Self::square(self.head);
        Self::sum(square.head, square.tail + 2.0 * self.head * self.tail)
    }

    pub(crate) fn plus(self, other: Self) -> Self {
        let (heads, tails) = (Self::sum(self.head, other.head), Self::sum(self.tail, other.tail));
        let first = Self::sum(heads.head, heads.tail + tails.head);
        Self::sum(first.head, first.tail + tails.tail)
    }

    pub(crate) fn negated(self) -> Self {
        Self { head: -self.head, tail: -self.tail }
    }

    /// The root: that of the head, corrected by one step of Newton's method.
    pub(crate) fn root(self) -> Self {
        if self.head <= 0.0 {
            return Self { head: 0.0, tail: 0.0 };
        }
        let root = self.head.sqrt();
        let square = Self::square(root);
        let rest = (self.head - square.head) - square.tail + self.tail;
        Self::sum(root, rest / (2.0 * root))
    }

    /// A number that is the same for the same number.
    pub(crate) fn hash(self) -> u64 {
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
            let root = Twofold { head: value, tail: 0.0 }.root();
            let back = root.squared().plus(Twofold { head: -value, tail: 0.0 });
            assert!(back.head.abs() < value * 2.0_f64.powi(-99), "{value}: {back:?}");
        }
    }
}
