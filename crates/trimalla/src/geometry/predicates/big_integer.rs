//! Integers of any size: for polynomials of a degree that a fixed-width sum does not hold.

use core::cmp::Ordering;

use super::natural::Natural;

/// An integer. Zero is not negative.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct BigInteger {
    negative: bool,
    magnitude: Natural,
}

impl BigInteger {
    /// Zero.
    pub(super) const ZERO: Self = Self { negative: false, magnitude: Natural::ZERO };

    /// The integer of a sign and a magnitude.
    fn signed(negative: bool, magnitude: Natural) -> Self {
        Self { negative: negative && !magnitude.is_zero(), magnitude }
    }

    /// Integers such that each value is exactly one of them times one common power of two.
    ///
    /// # Shape
    /// Values must be finite. Numbers of one order of magnitude fit into two digits; 35 are the most.
    pub(super) fn scaled<const N: usize>(values: [f64; N]) -> [Self; N] {
        let lowest = Self::exponent(values);
        values.map(|value| {
            let (significand, exponent) = decompose(value);
            let shift = if significand == 0 { 0 } else { (exponent - lowest) as usize };
            Self::signed(value < 0.0, Natural::shifted(u128::from(significand), shift))
        })
    }

    /// The exponent of the power of two of [`scaled`](Self::scaled).
    pub(super) fn exponent<const N: usize>(values: [f64; N]) -> i32 {
        values.iter().filter(|v| **v != 0.0).map(|v| decompose(*v).1).min().unwrap_or(0)
    }

    /// The root of a quotient of magnitudes times a power of two, rounded: off by a few last places. The divisor must
    /// not be zero.
    pub(super) fn root_of_quotient(&self, divisor: &Self, exponent: i32) -> f64 {
        let ((m, e), (n, f)) = (self.leading(), divisor.leading());
        let odd = (e - f).rem_euclid(2);
        let root = (m / n * f64::from(1 + odd)).sqrt();
        times_power_of_two(root, (e - f - odd) / 2 + exponent)
    }

    /// The magnitude, rounded, as a number below 2^64 and the exponent of the power of two that it is multiplied by.
    fn leading(&self) -> (f64, i32) {
        let mut value = 0.0;
        let digits = self.magnitude.digits();
        let top = digits.len().saturating_sub(3);
        for &digit in digits[top..].iter().rev() {
            value = value * 18_446_744_073_709_551_616.0 + digit as f64; // 2^64
        }
        (value, 64 * top as i32)
    }

    /// The sum.
    pub(super) fn plus(&self, other: &Self) -> Self {
        let mut magnitude = self.magnitude.clone();
        if self.negative == other.negative {
            magnitude.add(&other.magnitude);
            return Self { negative: self.negative, magnitude };
        }
        let is_of_other = self.magnitude < other.magnitude;
        let negative = if is_of_other { other.negative } else { self.negative };
        Self::signed(negative, Natural::distance(magnitude, other.magnitude.clone()))
    }

    /// The difference.
    pub(super) fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    /// The integer with the other sign.
    pub(super) fn negated(&self) -> Self {
        Self::signed(!self.negative, self.magnitude.clone())
    }

    /// The product.
    pub(super) fn times(&self, other: &Self) -> Self {
        Self::signed(self.negative != other.negative, self.magnitude.times(&other.magnitude))
    }

    /// The square.
    pub(super) fn squared(&self) -> Self {
        self.times(self)
    }

    /// The order of two integers.
    pub(super) fn compare(&self, other: &Self) -> Ordering {
        match (self.negative, other.negative) {
            (false, false) => self.magnitude.cmp(&other.magnitude),
            (true, true) => other.magnitude.cmp(&self.magnitude),
            (true, false) => Ordering::Less,
            (false, true) => Ordering::Greater,
        }
    }
}

/// A number times a power of two; infinite or zero where that is out of range.
fn times_power_of_two(mut value: f64, mut exponent: i32) -> f64 {
    while exponent != 0 && value != 0.0 && value.is_finite() {
        let step = exponent.clamp(-900, 900);
        value *= f64::from_bits(((1023 + step) as u64) << 52);
        exponent -= step;
    }
    value
}

/// The magnitude of a finite number as an integer and the power of two that it is multiplied by.
const fn decompose(value: f64) -> (u64, i32) {
    let bits = value.to_bits();
    let exponent = (bits >> 52 & 0x7ff) as i32;
    let fraction = bits & ((1 << 52) - 1);
    if exponent == 0 { (fraction, -1074) } else { (fraction | 1 << 52, exponent - 1075) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_and_products_are_those_of_small_integers() {
        let values = [0.0, 1.0, -1.0, 3.0, -7.0, 4_294_967_296.0, -4_503_599_627_370_495.0, 1e15];
        for a in values {
            for b in values {
                let [one, two, sum, difference] = BigInteger::scaled([a, b, a + b, a - b]);
                assert_eq!(one.plus(&two), sum, "{a} + {b}");
                assert_eq!(one.minus(&two), difference, "{a} - {b}");
                assert_eq!(one.compare(&two), a.total_cmp(&b), "{a} and {b}");
                let twice = one.times(&two).plus(&two.times(&one));
                assert_eq!(sum.squared().minus(&difference.squared()), twice.plus(&twice), "{a} and {b}");
            }
        }
    }

    #[test]
    fn roots_of_quotients_are_of_any_size() {
        for (a, b, exponent, root) in [(9.0, 4.0, 0, 1.5), (2.0, 1.0, 3, 128.0_f64.sqrt()), (0.0, 7.0, 9, 0.0)] {
            let [a, b] = BigInteger::scaled([a, b]);
            assert_eq!(a.root_of_quotient(&b, exponent), root);
            let power = BigInteger::scaled([1.0, 1e-300]).into_iter().next().unwrap();
            assert_eq!(a.times(&power).root_of_quotient(&b.times(&power), exponent), root);
            assert_eq!(a.root_of_quotient(&b, 5000) == 0.0, root == 0.0);
        }
    }

    #[test]
    fn far_exponents_share_one_power_of_two() {
        let [large, small, none] = BigInteger::scaled([f64::MAX, 5e-324, 0.0]);
        assert_eq!(small, BigInteger::signed(false, Natural::shifted(1, 0)));
        assert_eq!(large.magnitude.digits().len(), 33);
        assert!(none.magnitude.is_zero());
        let square = large.squared();
        assert_eq!(square.minus(&square.plus(&small)).compare(&none), Ordering::Less);
        assert_eq!(square.plus(&small).minus(&square), small);
    }
}
