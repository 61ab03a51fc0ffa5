//! Signed integers of 256 bits: just what the in-circle determinant of 61-bit coordinates needs.

use core::cmp::Ordering;

/// A signed 256-bit integer in two's complement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Wide {
    high: i128,
    low: u128,
}

impl Wide {
    /// The exact product of two integers.
    #[inline]
    pub(super) fn product(a: i128, b: i128) -> Self {
        let (high, low) = unsigned_product(a.unsigned_abs(), b.unsigned_abs());
        let magnitude = Self { high: high as i128, low };
        if (a < 0) == (b < 0) { magnitude } else { magnitude.negated() }
    }

    /// The sum, which must fit.
    #[inline]
    pub(super) const fn plus(self, other: Self) -> Self {
        let (low, carry) = self.low.overflowing_add(other.low);
        let high = self.high.wrapping_add(other.high).wrapping_add(carry as i128);
        Self { high, low }
    }

    /// The sign: `Less` is negative.
    #[inline]
    pub(super) fn sign(self) -> Ordering {
        self.high.cmp(&0).then(self.low.cmp(&0))
    }

    const fn negated(self) -> Self {
        let (low, carry) = (!self.low).overflowing_add(1);
        Self { high: (!self.high).wrapping_add(carry as i128), low }
    }
}

/// The exact product of two magnitudes as its upper and lower half.
#[inline]
const fn unsigned_product(a: u128, b: u128) -> (u128, u128) {
    const LOW: u128 = u64::MAX as u128;
    let (a1, a0, b1, b0) = (a >> 64, a & LOW, b >> 64, b & LOW);
    let low = a0 * b0;
    let middle = a1 * b0 + (low >> 64); // at most (2^64 - 1)^2 + 2^64 - 1: no overflow
    let other = a0 * b1 + (middle & LOW);
    let high = a1 * b1 + (middle >> 64) + (other >> 64);
    (high, other << 64 | low & LOW)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_are_exact_and_cancel() {
        let (a, b) = ((1_i128 << 125) - 12345, (1_i128 << 124) - 777);
        let positive = Wide::product(a, b);
        assert_eq!(positive.sign(), Ordering::Greater);
        assert_eq!(Wide::product(-a, b).sign(), Ordering::Less);
        assert_eq!(Wide::product(-a, b).plus(Wide::product(-b, -a)).sign(), Ordering::Equal);
        // (a + 1)(b - 1) = ab - a + b - 1
        let shifted = Wide::product(a + 1, b - 1);
        let rest = Wide::product(b - a - 1, 1);
        assert_eq!(shifted, positive.plus(rest));
        assert_eq!(Wide::product(-1, 1).sign(), Ordering::Less);
        assert_eq!(Wide::product(0, -5).sign(), Ordering::Equal);
    }
}
