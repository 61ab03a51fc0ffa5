//! Integers of any size: for polynomials of a degree that a fixed-width sum does not hold.

use core::cmp::Ordering;

/// An integer. Its limbs are the magnitude, the lowest first, and the last one is not zero; zero is not negative.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct BigInteger {
    negative: bool,
    limbs: Vec<u64>,
}

impl BigInteger {
    /// Zero.
    pub(super) const ZERO: Self = Self { negative: false, limbs: Vec::new() };

    /// Integers such that each value is exactly one of them times one common power of two.
    ///
    /// # Shape
    /// Values must be finite. Numbers of one order of magnitude fit into two limbs; 35 are the most.
    pub(super) fn scaled<const N: usize>(values: [f64; N]) -> [Self; N] {
        let lowest = Self::exponent(values);
        values.map(|value| {
            let (significand, exponent) = decompose(value);
            let magnitude = Self { negative: false, limbs: vec![significand] }.trimmed();
            let shifted = if significand == 0 { magnitude } else { magnitude.shifted((exponent - lowest) as usize) };
            Self { negative: value < 0.0, ..shifted }
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
        let top = self.limbs.len().saturating_sub(3);
        for &limb in self.limbs[top..].iter().rev() {
            value = value * 18_446_744_073_709_551_616.0 + limb as f64; // 2^64
        }
        (value, 64 * top as i32)
    }

    /// The sum.
    pub(super) fn plus(&self, other: &Self) -> Self {
        if self.negative == other.negative {
            return Self { negative: self.negative, limbs: sum(&self.limbs, &other.limbs) };
        }
        let (more, less) = match magnitude_order(&self.limbs, &other.limbs) {
            Ordering::Less => (other, self),
            _ => (self, other),
        };
        Self { negative: more.negative, limbs: difference(&more.limbs, &less.limbs) }.trimmed()
    }

    /// The difference.
    pub(super) fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    /// The integer with the other sign.
    pub(super) fn negated(&self) -> Self {
        Self { negative: !self.negative && !self.limbs.is_empty(), limbs: self.limbs.clone() }
    }

    /// The product.
    pub(super) fn times(&self, other: &Self) -> Self {
        let mut limbs = vec![0; self.limbs.len() + other.limbs.len()];
        for (i, &a) in self.limbs.iter().enumerate() {
            let mut carry = 0_u128;
            for (j, &b) in other.limbs.iter().enumerate() {
                carry += u128::from(a) * u128::from(b) + u128::from(limbs[i + j]);
                limbs[i + j] = low_limb(carry);
                carry >>= 64;
            }
            limbs[i + other.limbs.len()] = low_limb(carry);
        }
        Self { negative: self.negative != other.negative, limbs }.trimmed()
    }

    /// The square.
    pub(super) fn squared(&self) -> Self {
        self.times(self)
    }

    /// The order of two integers.
    pub(super) fn compare(&self, other: &Self) -> Ordering {
        match (self.negative, other.negative) {
            (false, false) => magnitude_order(&self.limbs, &other.limbs),
            (true, true) => magnitude_order(&other.limbs, &self.limbs),
            (negative, _) => {
                if negative {
                    Ordering::Less
                } else {
                    Ordering::Greater
                }
            }
        }
    }

    /// Without leading zeros.
    fn trimmed(mut self) -> Self {
        while self.limbs.last() == Some(&0) {
            self.limbs.pop();
        }
        self.negative &= !self.limbs.is_empty();
        self
    }

    /// Times two to a power.
    fn shifted(&self, bits: usize) -> Self {
        let shift = bits % 64;
        let mut limbs = vec![0; bits / 64];
        let mut carry = 0;
        for &limb in &self.limbs {
            limbs.push(limb << shift | carry);
            carry = if shift == 0 { 0 } else { limb >> (64 - shift) };
        }
        limbs.push(carry);
        Self { negative: self.negative, limbs }.trimmed()
    }
}

fn sum(a: &[u64], b: &[u64]) -> Vec<u64> {
    let (long, short) = if a.len() < b.len() { (b, a) } else { (a, b) };
    let mut limbs = Vec::with_capacity(long.len() + 1);
    let mut carry = 0_u128;
    for (i, &limb) in long.iter().enumerate() {
        carry += u128::from(limb) + u128::from(short.get(i).copied().unwrap_or(0));
        limbs.push(low_limb(carry));
        carry >>= 64;
    }
    if carry != 0 {
        limbs.push(low_limb(carry));
    }
    limbs
}

/// The difference of magnitudes, the first of which is not the smaller one.
fn difference(more: &[u64], less: &[u64]) -> Vec<u64> {
    let mut borrow = false;
    let each = more.iter().enumerate().map(|(i, &limb)| {
        let (first, under) = limb.overflowing_sub(less.get(i).copied().unwrap_or(0));
        let (second, under_again) = first.overflowing_sub(u64::from(borrow));
        borrow = under || under_again;
        second
    });
    each.collect()
}

fn magnitude_order(a: &[u64], b: &[u64]) -> Ordering {
    a.len().cmp(&b.len()).then_with(|| a.iter().rev().cmp(b.iter().rev()))
}

#[expect(clippy::cast_possible_truncation, reason = "the lower limb is meant")]
const fn low_limb(wide: u128) -> u64 {
    wide as u64
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
        assert_eq!(small, BigInteger { negative: false, limbs: vec![1] });
        assert_eq!(large.limbs.len(), 33);
        assert!(none.limbs.is_empty());
        let square = large.squared();
        assert_eq!(square.minus(&square.plus(&small)).compare(&none), Ordering::Less);
        assert_eq!(square.plus(&small).minus(&square), small);
    }
}
