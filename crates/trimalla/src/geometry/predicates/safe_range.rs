//! Where the adaptive stages of the `robust` crate are exact.
//!
//! Those stages multiply differences of coordinates and rounding errors of such differences, and compare with an error
//! bound that is about 2^-103 times a sum of magnitudes. Their answers may be wrong as soon as one of these numbers
//! underflows or overflows.
//!
//! Let every coordinate be zero or at least 2^-L. It is then a multiple of 2^(-L-52); so is every difference, rounded
//! or exact, and every rounding error. A term of degree k is a multiple of 2^(-k(L+52)), and so is the sum of
//! magnitudes: where it is not zero, the bound is at least 2^(-k(L+52)-103). This is a normal number, and so is all the
//! rest, if
//! `k (L + 52) + 103 <= 1022`: L <= 407 for orientation (k = 2), L <= 177 for the circle (k = 4). If every coordinate
//! is at most 2^U, terms stay below 2^(k(U+1)+6), which must not pass 2^996, from where the splitting of factors
//! overflows.

use super::super::Point;

/// Magnitudes of coordinates, zero aside, for which orientation is exact in the adaptive stages: 2^-400 to 2^400.
pub(super) const ORIENTATION: (f64, f64) = (power_of_two(-400), power_of_two(400));
/// Magnitudes of coordinates, zero aside, for which the circle test is exact in the adaptive stages: 2^-170 to 2^200.
pub(super) const CIRCLE: (f64, f64) = (power_of_two(-170), power_of_two(200));

/// Tells whether each coordinate is zero or has a magnitude within the given bounds.
#[inline]
pub(super) fn all_within<const N: usize>(points: [Point; N], (least, most): (f64, f64)) -> bool {
    let fits = |value: f64| value == 0.0 || (least..=most).contains(&value.abs());
    points.iter().all(|p| fits(p.x) && fits(p.y))
}

/// The form in which the `robust` crate takes a point.
#[inline]
pub(super) const fn coord(point: Point) -> robust::Coord<f64> {
    robust::Coord { x: point.x, y: point.y }
}

const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}
