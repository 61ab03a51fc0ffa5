//! Elementary functions with the same bits on every platform, and exact scaling by powers of two.
//!
//! The functions of the platform's own library differ in the last bit from one system to the next. These come from the
//! crate `libm`, compiled from the same source everywhere. `f64::sqrt` is exact and needs no stand-in. The test
//! `elementary` of the laws holds their bits: a release of `libm` that changes one is noticed.

/// The sine of an angle in radians.
#[must_use]
#[inline]
pub fn sin(angle: f64) -> f64 {
    libm::sin(angle)
}

/// The cosine of an angle in radians.
#[must_use]
#[inline]
pub fn cos(angle: f64) -> f64 {
    libm::cos(angle)
}

/// The tangent of an angle in radians.
#[must_use]
#[inline]
pub fn tan(angle: f64) -> f64 {
    libm::tan(angle)
}

/// The angle in radians whose sine is given.
#[must_use]
#[inline]
pub fn asin(sine: f64) -> f64 {
    libm::asin(sine)
}

/// The angle in radians whose cosine is given.
#[must_use]
#[inline]
pub fn acos(cosine: f64) -> f64 {
    libm::acos(cosine)
}

/// The angle in radians whose tangent is given.
#[must_use]
#[inline]
pub fn atan(tangent: f64) -> f64 {
    libm::atan(tangent)
}

/// The angle in radians, within `[-pi, pi]`, of the direction `(x, y)`.
#[must_use]
#[inline]
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// The length of `(x, y)` without undue overflow or underflow.
#[must_use]
#[inline]
pub fn hypot(x: f64, y: f64) -> f64 {
    libm::hypot(x, y)
}

/// The exponential function.
#[must_use]
#[inline]
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// The natural logarithm.
#[must_use]
#[inline]
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// The logarithm to the base 10.
#[must_use]
#[inline]
pub fn log10(x: f64) -> f64 {
    libm::log10(x)
}

/// The power of `base` to `exponent`.
#[must_use]
#[inline]
pub fn pow(base: f64, exponent: f64) -> f64 {
    libm::pow(base, exponent)
}

/// The cube root.
#[must_use]
#[inline]
pub fn cbrt(x: f64) -> f64 {
    libm::cbrt(x)
}

/// A power of two that brings a magnitude near one.
///
/// # Guarantees
/// A normal number whose inverse is exact. The product with `largest` is in `[1, 4)`; for a subnormal `largest` it may
/// be as small as 2^-51. One for zero and for what is not finite.
#[must_use]
#[inline]
pub fn power_of_two_scale(largest: f64) -> f64 {
    if largest == 0.0 || !largest.is_finite() {
        return 1.0;
    }
    let biased = (largest.abs().to_bits() >> 52).min(2045);
    f64::from_bits((2046 - biased) << 52)
}

/// The distance from a number to the next, at most: relative for normal numbers, the least positive number for others.
#[must_use]
pub fn last_place(largest: f64) -> f64 {
    (f64::EPSILON * largest.abs()).max(f64::from_bits(1))
}

/// A number with the fewest significant bits from `low` to `high`, both at least 0 and `low` at most `high`.
#[must_use]
pub fn roundest_between(low: f64, high: f64) -> f64 {
    let differing = low.to_bits() ^ high.to_bits();
    // Below the highest bit that differs, which only `high` has, everything may go; where it is one of the exponent,
    // all but that.
    let below = (1_u64 << (63 - differing.max(1).leading_zeros()).min(52)) - 1;
    f64::from_bits(high.to_bits() & !below)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_roundest_number_lies_between_and_is_short() {
        let next = |x: f64, n: i64| f64::from_bits(x.to_bits().wrapping_add_signed(n));
        for short in [0.5, 0.375, 1.0, 3.0, 0.25] {
            assert_eq!(roundest_between(next(short, -3), next(short, 5)), short);
            assert_eq!(roundest_between(short, short), short);
        }
        assert_eq!(roundest_between(0.3, 0.6), 0.5);
        assert_eq!(roundest_between(0.0, 1.0), 1.0);
        assert_eq!(roundest_between(0.0, 0.0), 0.0);
    }

    #[test]
    fn scales_are_powers_of_two_that_bring_numbers_near_one() {
        for value in [5e-324, 1e-310, f64::MIN_POSITIVE, 0.3, 1.0, 7.5e200, f64::MAX] {
            let scale = power_of_two_scale(value);
            assert!(scale.is_normal() && scale.to_bits() << 12 == 0);
            assert_eq!(value * scale / scale, value);
            let scaled = value * scale;
            assert!((1.0..4.0).contains(&scaled) || (!value.is_normal() && scaled >= 4e-16));
        }
        assert_eq!(power_of_two_scale(0.0), 1.0);
        assert_eq!(power_of_two_scale(f64::NAN), 1.0);
    }
}
