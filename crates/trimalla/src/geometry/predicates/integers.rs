//! Coordinates as integers up to a common power of two.

/// Magnitudes stay below two to this power, so differences fit into `i64` and products of two differences into `i128`.
const BITS: u64 = 61;
/// Exponents (biased) of the largest magnitude for which the scale factor and its inverse are normal numbers.
const EXPONENTS: core::ops::RangeInclusive<u64> = 1023 - 900..=1023 + 900;

/// Integers `n` below 2^61 in magnitude such that every value is exactly `n` times one common power of two.
///
/// # Guarantees
/// `None` where the values are spread over too many binary digits, or are all zero, or not finite.
#[inline]
pub(super) fn common_integers<const N: usize>(values: [f64; N]) -> Option<[i64; N]> {
    let largest = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let exponent = largest.to_bits() >> 52;
    if !EXPONENTS.contains(&exponent) {
        return None;
    }
    let scale = f64::from_bits((2 * 1023 + BITS - 1 - exponent) << 52);
    let unit = f64::from_bits((exponent - (BITS - 1)) << 52);
    let integers = values.map(|value| (value * scale) as i64);
    let exact = (0..N).all(|i| integers[i] as f64 * unit == values[i]);
    exact.then_some(integers)
}

#[cfg(test)]
mod tests {
    use super::common_integers;

    #[test]
    fn integers_keep_their_ratios() {
        let found = common_integers([3.0, -1.0, 0.0, 0.5]);
        let unit = 1_i64 << 59;
        assert_eq!(found, Some([3 * unit, -unit, 0, unit / 2]));
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        assert_eq!(common_integers([1.0, 1e-30]), None);
        assert_eq!(common_integers([1.0, 5e-324]), None);
        assert_eq!(common_integers([1e308, 1.0]), None);
        assert_eq!(common_integers([5e-324, 5e-324]), None);
        assert_eq!(common_integers([f64::NAN, 1.0]), None);
        assert_eq!(common_integers([f64::INFINITY, 1.0]), None);
        assert_eq!(common_integers([0.0, 0.0]), None);
    }
}
