//! Coordinates as integers up to a common power of two.

/// Magnitudes stay below two to this power, so differences fit into `i64` and products of two differences into `i128`.
const BITS: u32 = 61;
/// Digits of the significand of an `f64`, the implied one included.
const SIGNIFICAND_BITS: u32 = 53;
/// The biased exponent of what is not finite.
const NOT_FINITE: u64 = 0x7ff;

/// Integers `n` below 2^61 in magnitude such that every value is exactly `n` times one common power of two.
///
/// # Guarantees
/// Any exponents are allowed, the power of two need not be an `f64`. `None` where the values are spread over more than
/// 61 binary digits, or are not finite.
#[inline]
pub(super) fn common_integers<const N: usize>(values: [f64; N]) -> Option<[i64; N]> {
    let largest = values.iter().fold(1, |m, v| m.max(biased_exponent(*v)));
    let integers = values.map(|value| significand(value) << (BITS - SIGNIFICAND_BITS));
    let shifts = values.map(|value| (largest - biased_exponent(value).max(1)).min(63));
    let lost = (0..N).fold(0, |lost, i| lost | (integers[i] & ((1 << shifts[i]) - 1)));
    if lost != 0 || largest == NOT_FINITE {
        return None;
    }
    Some(core::array::from_fn(|i| {
        let magnitude = (integers[i] >> shifts[i]) as i64;
        let negative = (values[i].to_bits() as i64) >> 63; // 0 or -1
        (magnitude ^ negative) - negative
    }))
}

/// Digits of a small integer.
const SMALL_BITS: u64 = 12;
/// The sum with this number leaves no digits for a fraction: 1.5 * 2^52.
const ROUND_TO_INTEGER: f64 = 6_755_399_441_055_744.0;
/// Biased exponents for which a scale factor and its inverse are normal numbers.
const SCALABLE: core::ops::RangeInclusive<u64> = 1023 - 900..=1023 + 900;

/// The differences `a - b` as integers below 2^12 in magnitude, up to a common power of two.
///
/// Polynomials of degree four with up to sixteen terms have no rounding errors in them: sixteen products of 48 bits
/// make 52. Points of a grid that are near each other have such differences, and this test costs less than
/// [`common_integers`].
///
/// # Guarantees
/// `None` where a difference is rounded or has too many digits, or where all are zero or any is not finite.
#[inline]
pub(super) fn small_differences<const N: usize>(pairs: [(f64, f64); N]) -> Option<[f64; N]> {
    let differences = pairs.map(|(a, b)| a - b);
    let largest = differences.iter().fold(0, |m, d| biased_exponent(*d).max(m));
    if !SCALABLE.contains(&largest) {
        return None;
    }
    let scale = f64::from_bits((2 * 1023 + SMALL_BITS - 1 - largest) << 52);
    let unit = f64::from_bits((largest - (SMALL_BITS - 1)) << 52);
    let small = differences.map(|d| (d * scale + ROUND_TO_INTEGER) - ROUND_TO_INTEGER);
    let exact = (0..N).fold(true, |exact, i| {
        let ((a, b), difference) = (pairs[i], differences[i]);
        exact & (a - difference == b) & (difference + b == a) & (small[i] * unit == difference)
    });
    exact.then_some(small)
}

/// The exponent field: zero for subnormal numbers and zero.
#[inline]
const fn biased_exponent(value: f64) -> u64 {
    (value.to_bits() >> 52) & 0x7ff
}

/// The digits of a number as an integer of at most 53 bits.
#[inline]
const fn significand(value: f64) -> u64 {
    let implied = (biased_exponent(value) != 0) as u64;
    value.to_bits() & ((1 << 52) - 1) | implied << 52
}

#[cfg(test)]
mod tests {
    use super::{common_integers, small_differences};

    #[test]
    fn integers_keep_their_ratios() {
        let unit = 1_i64 << 59;
        let expected = Some([3 * unit, -unit, 0, unit / 2]);
        for scale in [2.0_f64.powi(-1020), 1.0, 2.0_f64.powi(1022)] {
            let values = [3.0, -1.0, 0.0, 0.5].map(|v| v * scale);
            assert_eq!(common_integers(values), expected);
        }
        assert_eq!(common_integers([5e-324, -1e-323]), Some([256, -512]));
        assert_eq!(common_integers([0.0, -0.0]), Some([0, 0]));
    }

    #[test]
    fn small_differences_are_exact_or_refused() {
        let found = small_differences([(1e6, 1e6 - 3.0), (0.5, 1.0), (7.0, 7.0)]);
        assert_eq!(found, Some([3072.0, -512.0, 0.0]));
        assert_eq!(small_differences([(0.3, 0.1)]), None);
        assert_eq!(small_differences([(1.0, 0.0), (1e-4, 0.0)]), None);
        assert_eq!(small_differences([(2.0_f64.powi(890), 0.0), (5e-324, 0.0)]), None);
        assert_eq!(small_differences([(1.0, 1.0)]), None);
        assert_eq!(small_differences([(f64::MAX, -f64::MAX)]), None);
        assert_eq!(small_differences([(f64::NAN, 1.0)]), None);
    }

    #[test]
    fn the_last_digit_decides() {
        let small = 2.0_f64.powi(-60);
        assert_eq!(common_integers([1.0, small]), Some([1 << 60, 1]));
        assert_eq!(common_integers([1.0, small / 2.0]), None);
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        assert_eq!(common_integers([1.0, 1e-30]), None);
        assert_eq!(common_integers([1.0, 5e-324]), None);
        assert_eq!(common_integers([1e308, 1.0]), None);
        assert_eq!(common_integers([f64::NAN, 1.0]), None);
        assert_eq!(common_integers([f64::INFINITY, 1.0]), None);
    }
}
