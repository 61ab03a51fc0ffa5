//! Rounded sums of lengths, with bounds of what rounding does to them.
//!
//! A *weight* holds a sum twice: as an interval of doubles, and as the sum of two doubles, which is as good as 100
//! binary digits. The interval decides most comparisons and the second form nearly all others; equal sums are left.

use std::cmp::Ordering;

use crate::geometry::{Point, Vector};
use crate::optimal::twofold::Twofold;

/// A relative error that one operation on intervals does not pass.
const OUT: f64 = 2.0 * f64::EPSILON;
/// A relative error that a squared length or a length in doubles does not pass.
pub(super) const LENGTH_ERROR: f64 = 8.0 * f64::EPSILON;
/// A relative error that sums of up to a million lengths in two doubles do not pass: each operation adds less than
/// 2^-100.
const TWOFOLD_ERROR: f64 = f64::from_bits((1023 - 79) << 52);

/// A sum of lengths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Weight {
    low: f64,
    high: f64,
    fine: Twofold,
}

impl Weight {
    /// The weight of nothing.
    pub(super) const ZERO: Self = Self { low: 0.0, high: 0.0, fine: Twofold { head: 0.0, tail: 0.0 } };

    /// A weight of which nothing is known: every comparison is left open.
    pub(super) const UNKNOWN: Self =
        Self { low: 0.0, high: f64::INFINITY, fine: Twofold { head: f64::NAN, tail: f64::NAN } };

    /// The distance of two points whose coordinates are of ordinary size.
    pub(super) fn of(a: Point, b: Point) -> Self {
        let length = (b - a).length_sq().sqrt();
        Self {
            low: length * (1.0 - LENGTH_ERROR),
            high: length * (1.0 + LENGTH_ERROR),
            fine: Twofold::distance_sq(a, b).root(),
        }
    }

    /// The sum. Each bound is rounded twice, by a relative 2^-53, and moved outward by more than that.
    pub(super) fn plus(self, other: Self) -> Self {
        Self {
            low: (self.low + other.low) * (1.0 - OUT),
            high: (self.high + other.high) * (1.0 + OUT),
            fine: self.fine.plus(other.fine),
        }
    }

    /// Which of two sums is less, if rounding leaves no doubt.
    #[inline]
    pub(super) fn order(self, other: Self) -> Option<Ordering> {
        if self.high < other.low {
            return Some(Ordering::Less);
        }
        if self.low > other.high {
            return Some(Ordering::Greater);
        }
        let apart = (self.fine.head - other.fine.head) + (self.fine.tail - other.fine.tail);
        let error = TWOFOLD_ERROR * (self.fine.head + other.fine.head);
        if apart < -error {
            Some(Ordering::Less)
        } else if apart > error {
            Some(Ordering::Greater)
        } else {
            None
        }
    }
}

/// Compares two squared lengths, if rounding leaves no doubt.
#[inline]
pub(super) fn order_of_ways(one: Vector, two: Vector) -> Option<Ordering> {
    let (a, b) = (one.length_sq(), two.length_sq());
    if a < b * (1.0 - LENGTH_ERROR) {
        Some(Ordering::Less)
    } else if b < a * (1.0 - LENGTH_ERROR) {
        Some(Ordering::Greater)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_told_apart_beyond_the_digits_of_a_double() {
        let point = |x: f64, y: f64| Point::new(x, y);
        let (o, far) = (point(0.0, 0.0), Weight::of(point(0.0, 0.0), point(1.0, 1.0)));
        // √(1 + t²) is 1 + t² / 2 nearly: it differs from 1 in the 22nd decimal.
        let (one, more) = (Weight::of(o, point(1.0, 0.0)), Weight::of(o, point(1.0, 1e-11)));
        assert_eq!(
            (one.order(more), more.order(one), one.order(one)),
            (Some(Ordering::Less), Some(Ordering::Greater), None)
        );
        assert_eq!(one.plus(far).order(far.plus(more)), Some(Ordering::Less));
        assert_eq!(one.plus(far).order(far.plus(one)), None);
        assert_eq!(Weight::UNKNOWN.order(one).or(one.order(Weight::UNKNOWN)), None);
        assert_eq!(Weight::ZERO.order(one), Some(Ordering::Less));
        // A difference of coordinates that a double does not hold: 1 + 2^-60 and 1.
        let (tiny, unit) = (point(-f64::from_bits((1023 - 60) << 52), 0.0), point(1.0, 0.0));
        assert_eq!(Weight::of(tiny, unit).order(Weight::of(o, unit)), Some(Ordering::Greater));
    }
}
