//! Signs of determinants, three times: by rationals, by scaled integers, and by a filter before the
//! integers.
//!
//! 1. `…_rational` is the definition, written down: every double is a rational, and rationals do
//!    not round.
//! 2. `…_scaled` multiplies all coordinates by one power of two that makes them integers: the same
//!    sign, faster.
//! 3. the plain names first try doubles, inside a range of exponents where nothing can overflow or
//!    vanish, and trust the result only far from zero. The tests compare the three on every
//!    generator.

use core::cmp::Ordering;

use dashu_int::IBig;
use dashu_ratio::RBig;
use trimalla::geometry::Point;

/// Relative distance from zero below which the filter gives up; about nine times the proven error
/// of the longer of the two determinants, `(10 + 96 ε) ε` (Shewchuk 1997), so that the tests do not depend
/// on the last bit of the proof.
const FILTER: f64 = 1e-14;

/// The sign of twice the area of `abc`: 1 counter-clockwise, −1 clockwise, 0 collinear.
///
/// # Guarantees
/// Exact for all finite coordinates.
#[must_use]
pub fn orient(a: Point, b: Point, c: Point) -> i32 {
    let (acx, acy, bcx, bcy) = (a.x - c.x, a.y - c.y, b.x - c.x, b.y - c.y);
    if [acx, acy, bcx, bcy].into_iter().all(is_tame) {
        let (left, right) = (acx * bcy, acy * bcx);
        if let Some(sign) = certain_sign(left - right, left.abs() + right.abs()) {
            return sign;
        }
    }
    if a == b || b == c || c == a {
        return 0;
    }
    orient_scaled(a, b, c)
}

/// The sign of the in-circle determinant: 1 where `d` is inside the circle through the
/// counter-clockwise `abc`, −1 outside, 0 on it; the reverse where `abc` is clockwise.
///
/// # Guarantees
/// Exact for all finite coordinates.
#[must_use]
pub fn in_circle(a: Point, b: Point, c: Point, d: Point) -> i32 {
    let (adx, ady, bdx, bdy) = (a.x - d.x, a.y - d.y, b.x - d.x, b.y - d.y);
    let (cdx, cdy) = (c.x - d.x, c.y - d.y);
    if [adx, ady, bdx, bdy, cdx, cdy].into_iter().all(is_tame) {
        let lift = |x: f64, y: f64| x * x + y * y;
        let (al, bl, cl) = (lift(adx, ady), lift(bdx, bdy), lift(cdx, cdy));
        let (bc, cb) = (bdx * cdy, cdx * bdy);
        let (ca, ac) = (cdx * ady, adx * cdy);
        let (ab, ba) = (adx * bdy, bdx * ady);
        let det = al * (bc - cb) + bl * (ca - ac) + cl * (ab - ba);
        let size = al * (bc.abs() + cb.abs()) + bl * (ca.abs() + ac.abs()) + cl * (ab.abs() + ba.abs());
        if let Some(sign) = certain_sign(det, size) {
            return sign;
        }
    }
    in_circle_scaled(a, b, c, d)
}

/// [`orient`] by integers, without a filter.
#[must_use]
pub fn orient_scaled(a: Point, b: Point, c: Point) -> i32 {
    orient_of([a, b, c].map(|p| [p.x, p.y]).as_flattened(), scaled)
}

/// [`in_circle`] by integers, without a filter.
#[must_use]
pub fn in_circle_scaled(a: Point, b: Point, c: Point, d: Point) -> i32 {
    in_circle_of([a, b, c, d].map(|p| [p.x, p.y]).as_flattened(), scaled)
}

/// [`orient`] by rationals: the definition.
#[must_use]
pub fn orient_rational(a: Point, b: Point, c: Point) -> i32 {
    let (a, b, c) = (rational(a), rational(b), rational(c));
    sign_of(orient_det(&a, &b, &c).cmp(&RBig::ZERO))
}

/// [`in_circle`] by rationals: the definition.
#[must_use]
pub fn in_circle_rational(a: Point, b: Point, c: Point, d: Point) -> i32 {
    let d = rational(d);
    let [a, b, c] = [a, b, c].map(|p| {
        let [x, y] = rational(p);
        let (x, y) = (x - &d[0], y - &d[1]);
        let lift = &x * &x + &y * &y;
        [x, y, lift]
    });
    let det = &a[2] * (&b[0] * &c[1] - &b[1] * &c[0])
        + &b[2] * (&c[0] * &a[1] - &c[1] * &a[0])
        + &c[2] * (&a[0] * &b[1] - &a[1] * &b[0]);
    sign_of(det.cmp(&RBig::ZERO))
}

/// The order of points by `x`, then by `y`; `-0.0` equals `0.0`.
#[must_use]
pub fn lexicographic(a: Point, b: Point) -> Ordering {
    a.x.partial_cmp(&b.x).unwrap().then(a.y.partial_cmp(&b.y).unwrap())
}

/// Whether `p` lies on the segment `ab`, at neither of its ends; exact.
#[must_use]
pub fn on_open_segment(p: Point, a: Point, b: Point) -> bool {
    let (low, high) = if lexicographic(a, b) == Ordering::Greater { (b, a) } else { (a, b) };
    lexicographic(low, p) == Ordering::Less && lexicographic(p, high) == Ordering::Less && orient(a, b, p) == 0
}

/// Which of `p` and `q` comes first along the way from `a` to `b`: `Less` where the foot of `p` on the line does.
///
/// # Guarantees
/// Exact for all finite coordinates: the sign of a scalar product.
pub(super) fn order_along([a, b]: [Point; 2], p: Point, q: Point) -> Ordering {
    let (dx, dy, px, py) = (b.x - a.x, b.y - a.y, p.x - q.x, p.y - q.y);
    if [dx, dy, px, py].into_iter().all(is_tame) {
        let (one, other) = (dx * px, dy * py);
        if let Some(sign) = certain_sign(one + other, one.abs() + other.abs()) {
            return sign.cmp(&0);
        }
    }
    let v = scaled([a, b, p, q].map(|p| [p.x, p.y]).as_flattened());
    let dot = (&v[2] - &v[0]) * (&v[4] - &v[6]) + (&v[3] - &v[1]) * (&v[5] - &v[7]);
    dot.cmp(&IBig::ZERO)
}

/// Whether `p` is no farther than `reach` from the line through `a` and `b`, which are not equal.
///
/// # Guarantees
/// Exact for all finite numbers: squares are compared.
pub(super) fn is_within([a, b]: [Point; 2], p: Point, reach: f64) -> bool {
    /// Relative distance from the limit below which doubles give up: about four times their error.
    const FILTER: f64 = 2e-15;
    let (dx, dy, px, py) = (b.x - a.x, b.y - a.y, p.x - a.x, p.y - a.y);
    if [dx, dy, px, py, reach].into_iter().all(is_tame) {
        let (left, right) = (dx * py, dy * px);
        let (off, limit) = ((left - right).abs(), reach * (dx * dx + dy * dy).sqrt());
        if (off - limit).abs() > FILTER * (left.abs() + right.abs() + limit) {
            return off < limit;
        }
    }
    let v = scaled(&[a.x, a.y, b.x, b.y, p.x, p.y, reach]);
    let (dx, dy) = (&v[2] - &v[0], &v[3] - &v[1]);
    let cross = &dx * (&v[5] - &v[1]) - &dy * (&v[4] - &v[0]);
    &cross * &cross <= &v[6] * &v[6] * (&dx * &dx + &dy * &dy)
}

/// A point with rational coordinates.
pub(super) type RPoint = [RBig; 2];

/// The exact value of a point.
pub(super) fn rational(p: Point) -> RPoint {
    [p.x, p.y].map(|v| RBig::try_from(v).unwrap())
}

/// Twice the signed area of `abc`.
pub(super) fn orient_det(a: &RPoint, b: &RPoint, c: &RPoint) -> RBig {
    (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0])
}

/// −1, 0 or 1.
pub(super) const fn sign_of(order: Ordering) -> i32 {
    match order {
        Ordering::Less => -1,
        Ordering::Equal => 0,
        Ordering::Greater => 1,
    }
}

/// Whether a difference is zero (then it is exact) or so far from both ends of the range that a
/// product of four of its kind neither overflows nor loses bits below.
fn is_tame(difference: f64) -> bool {
    difference == 0.0 || (1e-60..1e60).contains(&difference.abs())
}

/// The sign of a rounded sum, where the size of its terms leaves no doubt.
fn certain_sign(sum: f64, size: f64) -> Option<i32> {
    (sum.abs() > FILTER * size).then_some(if sum > 0.0 { 1 } else { -1 })
}

/// The orientation sign of three points given as `x y x y x y`, after `exactly` made them integers.
fn orient_of(v: &[f64], exactly: impl Fn(&[f64]) -> Vec<IBig>) -> i32 {
    if let Some(v) = small_integers::<6>(v, 62) {
        return sign_of(((v[2] - v[0]) * (v[5] - v[1])).cmp(&((v[3] - v[1]) * (v[4] - v[0]))));
    }
    let v = exactly(v);
    let left = (&v[2] - &v[0]) * (&v[5] - &v[1]);
    let right = (&v[3] - &v[1]) * (&v[4] - &v[0]);
    sign_of(left.cmp(&right))
}

/// The in-circle sign of four points given as `x y x y x y x y`, after `exactly` made them
/// integers.
fn in_circle_of(v: &[f64], exactly: impl Fn(&[f64]) -> Vec<IBig>) -> i32 {
    if let Some(v) = small_integers::<8>(v, 28) {
        let [a, b, c] = [0, 2, 4].map(|i| [v[i] - v[6], v[i + 1] - v[7]]);
        let lift = |p: [i128; 2]| p[0] * p[0] + p[1] * p[1];
        let cross = |p: [i128; 2], q: [i128; 2]| p[0] * q[1] - p[1] * q[0];
        return sign_of((lift(a) * cross(b, c) + lift(b) * cross(c, a) + lift(c) * cross(a, b)).cmp(&0));
    }
    let v = exactly(v);
    let [a, b, c] = [0, 2, 4].map(|i| {
        let (x, y) = (&v[i] - &v[6], &v[i + 1] - &v[7]);
        let lift = &x * &x + &y * &y;
        [x, y, lift]
    });
    let det = &a[2] * (&b[0] * &c[1] - &b[1] * &c[0])
        + &b[2] * (&c[0] * &a[1] - &c[1] * &a[0])
        + &c[2] * (&a[0] * &b[1] - &a[1] * &b[0]);
    sign_of(det.cmp(&IBig::ZERO))
}

/// The values times one common power of two that makes all of them integers, if none then has more than `bits` bits.
fn small_integers<const N: usize>(values: &[f64], bits: i32) -> Option<[i128; N]> {
    let mut parts = [(0, 0); N];
    for (part, &value) in parts.iter_mut().zip(values) {
        let (m, e) = decompose(value);
        // Without the zeros at the end of its bits.
        let zeros = m.trailing_zeros();
        *part = if m == 0 { (0, 0) } else { (m >> zeros, e + i32::try_from(zeros).unwrap()) };
    }
    let lowest = parts.iter().filter(|p| p.0 != 0).map(|p| p.1).min().unwrap_or(0);
    let length = |m: i64| 64 - i32::try_from(m.unsigned_abs().leading_zeros()).unwrap();
    let fits = parts.iter().all(|&(m, e)| m == 0 || length(m) + e - lowest <= bits);
    fits.then(|| parts.map(|(m, e)| if m == 0 { 0 } else { i128::from(m) << (e - lowest) }))
}

/// The values times one common power of two that makes all of them integers.
fn scaled(values: &[f64]) -> Vec<IBig> {
    let parts: Vec<(i64, i32)> = values.iter().map(|&v| decompose(v)).collect();
    let lowest = parts.iter().filter(|(m, _)| *m != 0).map(|&(_, e)| e).min().unwrap_or(0);
    let shift = |e: i32| usize::try_from(e - lowest).unwrap();
    parts.into_iter().map(|(m, e)| if m == 0 { IBig::ZERO } else { IBig::from(m) << shift(e) }).collect()
}

/// The integers `m`, `e` with `value = m · 2^e`, from the bits of the double.
fn decompose(value: f64) -> (i64, i32) {
    assert!(value.is_finite(), "an exact sign needs finite coordinates, not {value}");
    let bits = value.to_bits();
    let biased = i32::try_from((bits >> 52) & 0x7ff).unwrap();
    let fraction = i64::try_from(bits & ((1 << 52) - 1)).unwrap();
    let magnitude = if biased == 0 { fraction } else { fraction | (1 << 52) };
    let exponent = biased.max(1) - 1075;
    (if value.is_sign_negative() { -magnitude } else { magnitude }, exponent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generators::{PointSetKind, SplitMix64, next_up, point_set};

    fn p(x: f64, y: f64) -> Point {
        Point::new(x, y)
    }

    #[test]
    fn hand_worked_signs() {
        assert_eq!(orient(p(0.0, 0.0), p(1.0, 0.0), p(0.0, 1.0)), 1);
        assert_eq!(orient(p(0.0, 0.0), p(0.0, 1.0), p(1.0, 0.0)), -1);
        assert_eq!(orient(p(0.0, 0.0), p(1.0, 1.0), p(3.0, 3.0)), 0);
        // 0.1 + 0.2 is not 0.3: the three points are not collinear in doubles.
        assert_eq!(orient_rational(p(0.1, 0.1), p(0.2, 0.2), p(0.3, 0.1 + 0.2)), 1);
        let square = [p(0.0, 0.0), p(1.0, 0.0), p(1.0, 1.0), p(0.0, 1.0)];
        assert_eq!(in_circle(square[0], square[1], square[2], square[3]), 0);
        assert_eq!(in_circle(square[0], square[1], square[2], p(0.5, 0.5)), 1);
        assert_eq!(in_circle(square[0], square[1], square[2], p(0.0, 1.0 + f64::EPSILON)), -1);
        assert_eq!(in_circle(square[2], square[1], square[0], p(0.5, 0.5)), -1);
    }

    #[test]
    fn extremes_of_the_range() {
        let tiny = f64::from_bits(1);
        assert_eq!(orient(p(0.0, 0.0), p(tiny, 0.0), p(0.0, tiny)), 1);
        assert_eq!(in_circle(p(0.0, 0.0), p(tiny, 0.0), p(0.0, tiny), p(tiny, tiny)), 0);
        assert_eq!(orient(p(-1e308, -1e308), p(1e308, -1e308), p(1e308, 1e308)), 1);
        assert_eq!(in_circle(p(-1e308, -1e308), p(1e308, -1e308), p(1e308, 1e308), p(-1e308, 1e308)), 0);
    }

    #[test]
    fn three_ways_agree_on_every_generator() {
        for kind in PointSetKind::ALL {
            let points = point_set(kind, 60, 7);
            if points.is_empty() {
                continue;
            }
            let mut rng = SplitMix64::new(11);
            for _ in 0..60 {
                let [a, b, c, d] = [(); 4].map(|()| points[rng.below(points.len())]);
                let sign = orient_rational(a, b, c);
                assert_eq!(orient(a, b, c), sign, "{kind:?} {a:?} {b:?} {c:?}");
                assert_eq!(orient_scaled(a, b, c), sign, "{kind:?} {a:?} {b:?} {c:?}");
                let sign = in_circle_rational(a, b, c, d);
                assert_eq!(in_circle(a, b, c, d), sign, "{kind:?} {a:?} {b:?} {c:?} {d:?}");
                assert_eq!(in_circle_scaled(a, b, c, d), sign, "{kind:?} {a:?} {b:?} {c:?} {d:?}");
            }
        }
    }

    #[test]
    fn order_and_distance_along_a_line_at_every_size() {
        for scale in [5e-324, 1e-300, 1e-160, 1.0, 1e160, 1e300] {
            let line = [p(0.0, 0.0), p(4.0 * scale, 0.0)];
            let (one, other) = (p(scale, scale), p(2.0 * scale, 0.0));
            assert_eq!(order_along(line, one, other), Ordering::Less);
            assert_eq!(order_along(line, other, one), Ordering::Greater);
            assert_eq!(order_along(line, one, p(scale, -scale)), Ordering::Equal);
            assert!(is_within(line, one, scale) && !is_within(line, p(scale, 2.0 * scale), scale));
            assert!(is_within(line, other, 0.0) && !is_within(line, one, 0.0));
        }
        // The square of the length is below every double that is not zero.
        let short = [p(0.0, 1.0), p(1e-216, 1.0)];
        assert_eq!(order_along(short, p(5e-217, 1.0), p(6e-217, 1.0)), Ordering::Less);
        assert!(is_within(short, p(5e-217, 1.0 + f64::EPSILON), f64::EPSILON));
    }

    #[test]
    fn open_segment_excludes_its_ends() {
        let (a, b) = (p(0.0, 0.0), p(4.0, 2.0));
        assert!(on_open_segment(p(2.0, 1.0), a, b));
        assert!(on_open_segment(p(2.0, 1.0), b, a));
        assert!(!on_open_segment(a, a, b));
        assert!(!on_open_segment(p(6.0, 3.0), a, b));
        assert!(!on_open_segment(p(2.0, next_up(1.0)), a, b));
        assert!(on_open_segment(p(0.0, 1.0), p(0.0, 2.0), p(-0.0, 0.0)));
    }
}
