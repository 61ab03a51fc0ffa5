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
/// Any exponents are allowed, the power of two need not be an `f64`. `None` where the values are spread over more than 61
/// binary digits, or are not finite.
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
    use super::common_integers;

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
