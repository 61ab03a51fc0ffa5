//! A sum of exact products on the stack: the last resort of every predicate.
//!
//! A finite `f64` is an integer times a power of two not below 2^-1074 and is smaller than 2^1024. A product of up to
//! five of them is therefore an integer multiple of 2^-5370 below 2^5120, and a fixed array of limbs holds it.
//! Positive and negative products are summed apart, so carries stay short; the sign is one comparison at the end.

use core::cmp::Ordering;

/// The most factors that one product may have.
const MAX_FACTORS: usize = 5;
/// The smallest positive `f64` is two to the power of minus this.
const UNIT_EXPONENT: i32 = 1074;
/// Weight of the lowest bit of a sum: two to the power of minus this.
const LOWEST: i32 = UNIT_EXPONENT * MAX_FACTORS as i32;
/// Limbs of a sum: 5370 + 5120 bits, and 70 more for carries.
const LIMBS: usize = 165;
/// Limbs of the product of five 53-bit significands.
const PRODUCT_LIMBS: usize = 5;
/// Below this magnitude the difference of two numbers and its rounding error cannot overflow.
const SPLITTABLE: f64 = f64::from_bits((1023 + 1000) << 52); // 2^1000

/// The exact difference of two finite numbers as the sum of two `f64`.
#[derive(Clone, Copy, Debug)]
pub(in crate::geometry) struct Difference {
    head: f64,
    tail: f64,
}

impl Difference {
    /// The difference `a - b`: rounded value and rounding error, or the two numbers themselves where that could
    /// overflow.
    #[inline]
    pub(in crate::geometry) fn new(a: f64, b: f64) -> Self {
        if a.abs().max(b.abs()) > SPLITTABLE {
            return Self { head: a, tail: -b };
        }
        let head = a - b;
        let b_seen = a - head;
        let a_seen = head + b_seen;
        Self { head, tail: (a - a_seen) + (b_seen - b) }
    }

    /// A single number as a difference.
    #[inline]
    pub(in crate::geometry) const fn number(value: f64) -> Self {
        Self { head: value, tail: 0.0 }
    }
}

/// An exact sum of products of at most five differences of finite numbers each.
#[derive(Debug)]
pub(in crate::geometry) struct ExactSum {
    positive: [u64; LIMBS],
    negative: [u64; LIMBS],
}

impl ExactSum {
    /// The empty sum.
    pub(in crate::geometry) const fn new() -> Self {
        Self { positive: [0; LIMBS], negative: [0; LIMBS] }
    }

    /// Adds the product of the given differences, multiplied out.
    pub(in crate::geometry) fn add<const N: usize>(&mut self, factors: [Difference; N]) {
        self.add_signed(factors, false);
    }

    /// Subtracts the product of the given differences, multiplied out.
    pub(in crate::geometry) fn subtract<const N: usize>(&mut self, factors: [Difference; N]) {
        self.add_signed(factors, true);
    }

    /// The sign of the sum: `Less` is negative.
    pub(in crate::geometry) fn sign(&self) -> Ordering {
        self.positive.iter().rev().cmp(self.negative.iter().rev())
    }

    /// The magnitude of the sum, rounded: a number in [1, 2) and the power of two that it is multiplied by; 0 for 0.
    pub(in crate::geometry) fn magnitude(&self) -> (f64, i32) {
        let (more, less) = match self.sign() {
            Ordering::Less => (&self.negative, &self.positive),
            _ => (&self.positive, &self.negative),
        };
        let mut limbs = *more;
        let mut borrow = false;
        for (limb, taken) in limbs.iter_mut().zip(less) {
            let (first, under) = limb.overflowing_sub(*taken);
            let (second, under_again) = first.overflowing_sub(u64::from(borrow));
            (*limb, borrow) = (second, under || under_again);
        }
        let Some(top) = limbs.iter().rposition(|&limb| limb != 0) else { return (0.0, 0) };
        let below = top.checked_sub(1).map_or(0, |k| limbs[k]);
        let zeros = limbs[top].leading_zeros();
        let wide = (u128::from(limbs[top]) << 64 | u128::from(below)) << zeros;
        // The leading bit of `wide` is set: its upper 64 bits are more than a number holds.
        let mantissa = (wide >> 64) as u64 as f64 / (1_u64 << 63) as f64;
        (mantissa, 64 * top as i32 + 63 - zeros as i32 - LOWEST)
    }

    fn add_signed<const N: usize>(&mut self, factors: [Difference; N], negative: bool) {
        const { assert!(N <= MAX_FACTORS) };
        for choice in 0..1_u32 << N {
            let terms = core::array::from_fn(|i| {
                let Difference { head, tail } = factors[i];
                if choice >> i & 1 == 0 { head } else { tail }
            });
            self.add_term::<N>(terms, negative);
        }
    }

    /// Adds one product of plain numbers.
    fn add_term<const N: usize>(&mut self, terms: [f64; N], negative: bool) {
        if terms.contains(&0.0) {
            return;
        }
        let mut product = Product::one(negative);
        for term in terms {
            product.multiply(term);
        }
        let side = if product.negative { &mut self.negative } else { &mut self.positive };
        product.add_to(side);
    }
}

/// A signed product: `significand * 2^exponent`.
struct Product {
    negative: bool,
    exponent: i32,
    significand: [u64; PRODUCT_LIMBS],
}

impl Product {
    const fn one(negative: bool) -> Self {
        Self { negative, exponent: 0, significand: [1, 0, 0, 0, 0] }
    }

    /// Multiplies by a finite number that is not zero.
    fn multiply(&mut self, factor: f64) {
        let (significand, exponent) = decompose(factor);
        self.negative ^= factor.is_sign_negative();
        self.exponent += exponent;
        let mut carry = 0_u128;
        for limb in &mut self.significand {
            carry += u128::from(*limb) * u128::from(significand);
            *limb = low_limb(carry);
            carry >>= 64;
        }
    }

    /// Adds the magnitude to a sum whose lowest bit weighs 2^-[`LOWEST`].
    fn add_to(&self, sum: &mut [u64; LIMBS]) {
        let position = (self.exponent + LOWEST).unsigned_abs();
        let (first, shift) = ((position / 64) as usize, position % 64);
        let mut carry = 0_u128;
        for (i, limb) in sum.iter_mut().skip(first).enumerate() {
            let Some(part) = self.significand.get(i) else {
                if carry == 0 {
                    break;
                }
                carry += u128::from(*limb);
                *limb = low_limb(carry);
                carry >>= 64;
                continue;
            };
            carry += (u128::from(*part) << shift) + u128::from(*limb);
            *limb = low_limb(carry);
            carry >>= 64;
        }
    }
}

/// The magnitude of a finite number as an integer and the exponent of its unit.
fn decompose(value: f64) -> (u64, i32) {
    let bits = value.to_bits();
    let fraction = bits & ((1 << 52) - 1);
    match (bits >> 52) & 0x7ff {
        0 => (fraction, -UNIT_EXPONENT),
        biased => (fraction | 1 << 52, biased as i32 - 1 - UNIT_EXPONENT),
    }
}

/// The lower half of a double limb.
#[inline]
const fn low_limb(wide: u128) -> u64 {
    (wide & u64::MAX as u128) as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sign(terms: &[[f64; 5]]) -> Ordering {
        let mut sum = ExactSum::new();
        for term in terms {
            sum.add(term.map(Difference::number));
        }
        sum.sign()
    }

    #[test]
    fn the_whole_range_cancels_to_the_last_bit() {
        let (huge, tiny) = ([f64::MAX; 5], [5e-324; 5]);
        let minus_huge = [-f64::MAX, f64::MAX, f64::MAX, f64::MAX, f64::MAX];
        let minus_tiny = [-5e-324, 5e-324, 5e-324, 5e-324, 5e-324];
        assert_eq!(sign(&[huge, minus_huge]), Ordering::Equal);
        assert_eq!(sign(&[huge, tiny, minus_huge]), Ordering::Greater);
        assert_eq!(sign(&[huge, tiny, minus_huge, minus_tiny, minus_tiny]), Ordering::Less);
        assert_eq!(sign(&[huge; 1000]), Ordering::Greater);
    }

    #[test]
    fn magnitudes_are_those_of_the_sum() {
        let mut sum = ExactSum::new();
        assert_eq!(sum.magnitude(), (0.0, 0));
        sum.add([Difference::new(1e300, 1.0)]);
        sum.subtract([Difference::number(1e300)]);
        assert_eq!(sum.magnitude(), (1.0, 0));
        sum.subtract([Difference::number(11.0)]);
        assert_eq!(sum.magnitude(), (1.5, 3));
        sum.add([Difference::number(12.0)]);
        sum.add([Difference::number(5e-324), Difference::number(5e-324)]);
        assert_eq!(sum.magnitude(), (1.0, -2148));
    }

    #[test]
    fn differences_are_exact_at_both_ends_of_the_range() {
        let mut sum = ExactSum::new();
        sum.add([Difference::new(f64::MAX, -f64::MAX)]);
        sum.subtract([Difference::number(f64::MAX)]);
        sum.subtract([Difference::number(f64::MAX)]);
        assert_eq!(sum.sign(), Ordering::Equal);
        sum.add([Difference::new(1e300, 1.0), Difference::new(1.0, -5e-324)]);
        sum.subtract([Difference::number(1e300)]);
        sum.add([Difference::number(1.0)]);
        // 1e300 * 2^-1074 - 2^-1074 is left.
        assert_eq!(sum.sign(), Ordering::Greater);
    }
}
