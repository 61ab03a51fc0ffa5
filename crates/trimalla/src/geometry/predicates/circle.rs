//! On which side of the circle through three points a fourth one lies.

use super::super::lanes::{Number, Two};
use super::super::{Point, lexicographically_less};
use super::ROUNDING;
use super::exact::{Difference, ExactSum};
use super::integers::{common_integers, small_differences};
use super::orient::{Orientation, orient2d};
use super::safe_range::{self, all_within, coord};
use super::wide::Wide;
use core::cmp::Ordering;

/// The side of a circle on which a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(i8)]
pub enum CircleSide {
    /// Strictly outside.
    Outside = -1,
    /// Exactly on the circle.
    On = 0,
    /// Strictly inside.
    Inside = 1,
}

impl CircleSide {
    /// The side that belongs to the sign of an in-circle determinant.
    #[inline]
    pub(super) const fn from_sign(sign: Ordering) -> Self {
        match sign {
            Ordering::Less => Self::Outside,
            Ordering::Equal => Self::On,
            Ordering::Greater => Self::Inside,
        }
    }

    /// The side towards which raising a lifted point tips the determinant whose cofactor has this sign.
    #[inline]
    const fn from_orientation(orientation: Orientation) -> Self {
        match orientation {
            Orientation::Clockwise => Self::Outside,
            Orientation::Collinear => Self::On,
            Orientation::CounterClockwise => Self::Inside,
        }
    }
}

/// Relative error bound of the rounded sine of the sum of two angles.
const CIRCLE_BOUND: f64 = 12.0 * ROUNDING;
/// Next to this, what a sum of two products can lose to underflow is nothing.
const CIRCLE_GUARD: f64 = f64::from_bits((1023 - 500) << 52); // 2^-500

/// Tells on which side of the circle through `a`, `b`, `c` the point `d` lies.
///
/// # Guarantees
/// Exact for every finite input. `a`, `b`, `c` are counter-clockwise; for clockwise points the answer is reversed, and
/// for collinear ones it tells on which side of their line `d` lies (`On` where it is on the line, too).
///
/// # Complexity
/// Constant; about 5 ns where the filter decides.
///
/// # Source
/// `[Shewchuk97]`, INCIRCLE.
#[doc(alias = "incircle")]
#[doc(alias = "circumcircle test")]
#[doc(alias = "test del círculo")]
#[must_use]
#[inline]
pub fn in_circle(a: Point, b: Point, c: Point, d: Point) -> CircleSide {
    match filtered_sign(a, b, c, d) {
        Some(side) => side,
        None => in_circle_exact(a, b, c, d),
    }
}

/// Tells on which side of the circle through `a`, `b`, `c` the point `d` lies, where nothing lies on a circle.
///
/// Ties are broken as if the height of every point on the lifting paraboloid were raised by an infinitesimal amount,
/// the amount of a lexicographically smaller point outweighing that of every larger one; x and y stay as they are.
/// Of four cocircular points the smallest one is then outside the circle of the others, hence never on the diagonal.
///
/// # Guarantees
/// Never `On` for four distinct points of which `a`, `b`, `c` are not collinear. Odd permutations of the four points
/// reverse the answer, even ones keep it. Where [`in_circle`] is not `On`, the answer is the same.
///
/// # Source
/// The tie rule is this library's own; the derivative of the determinant with respect to one
/// height is the cofactor of that entry, which is an orientation of the three other points.
#[must_use]
#[inline]
pub fn in_circle_perturbed(a: Point, b: Point, c: Point, d: Point) -> CircleSide {
    match filtered_sign(a, b, c, d) {
        Some(side) => side,
        None => in_circle_perturbed_exact(a, b, c, d),
    }
}

/// The side of `d` if rounded arithmetic can prove it.
///
/// ```text
///        c
///      /   \        ab is seen from c under the angle C, from d under D. The point d is inside if C + D is more than
///     a ─── b       two right angles, that is, sin C cos D + cos C sin D is negative. Times the lengths of the four sides
///      \   /        this is the in-circle determinant, term by term a polynomial in the coordinates: true for every
///        d          figure, also where d lies on the side of c.
/// ```
///
/// Why angles: fewer operations than the determinant of lifted points, and the filter fails only for angles whose sum
/// is within 24 u of a multiple of two right angles, however large and thin the figure is; u is [`ROUNDING`].
///
/// Errors: let P = |ac| |bc| and Q = |ad| |bd|. Products of two rounded differences err by 3 u each and their sum by u
/// more: sine and cosine at c, times P, err by at most 4 u P, those at d by 4 u Q. With A = |sin C| + |cos C| and B the
/// same of D, both at least one, this moves the result by at most 4 u P Q (A + B), which is at most 8 u P A Q B; its
/// own rounding adds 2 u P A Q B. The bound is 12 u P A Q B: 2 u are left for terms of second order and the rounding of
/// the bound.
///
/// Underflow: sine and cosine lose at most 2^-1074, which moves the result by 2^-1074 (P A + Q B + 1) or so. The guard
/// added to both factors of the bound raises it by 2^-550 (P A + Q B) and 2^-1050, which is more. Where anything
/// overflows, the bound is infinite or the comparison undefined.
#[inline(always)]
fn filtered_sign(a: Point, b: Point, c: Point, d: Point) -> Option<CircleSide> {
    let [a, b, c, d] = [a, b, c, d].map(|p| [p.x, p.y]);
    let (sine, bound) = sine_and_bound(a, b, c, d);
    let is_proved = sine.abs() > bound;
    // A proved value is not zero, so that the sign bit is its sign; reading it is faster than a comparison.
    #[allow(clippy::cast_possible_wrap, reason = "the sign bit is asked for")]
    let is_negative = (sine.to_bits() as i64) < 0;
    is_proved.then_some(if is_negative { CircleSide::Inside } else { CircleSide::Outside })
}

/// Whether `d` lies inside the circle through `a[i]`, `b[i]`, `c[i]`, for two of them, where [`filtered_sign`] can
/// prove both.
#[inline(always)]
pub(crate) fn inside_two_circles(a: [Point; 2], b: [Point; 2], c: [Point; 2], d: Point) -> Option<[bool; 2]> {
    let [a, b, c, d] = [a, b, c, [d; 2]].map(Two::coordinates);
    let (Two(sine), Two(bound)) = sine_and_bound(a, b, c, d);
    let is_proved = sine[0].abs() > bound[0] && sine[1].abs() > bound[1];
    is_proved.then(|| sine.map(|sine| sine < 0.0))
}

/// The sine of the sum of the two angles, times the four lengths, and the bound of its error.
#[inline(always)]
fn sine_and_bound<N: Number>([ax, ay]: [N; 2], [bx, by]: [N; 2], [cx, cy]: [N; 2], [dx, dy]: [N; 2]) -> (N, N) {
    let (cax, cay, cbx, cby) = (ax - cx, ay - cy, bx - cx, by - cy);
    let (dax, day, dbx, dby) = (ax - dx, ay - dy, bx - dx, by - dy);
    let (sine_c, cosine_c) = (cax * cby - cay * cbx, cax * cbx + cay * cby);
    let (sine_d, cosine_d) = (dbx * day - dby * dax, dbx * dax + dby * day);
    let [size_c, size_d] =
        [(sine_c, cosine_c), (sine_d, cosine_d)].map(|(s, c)| s.abs() + c.abs() + N::of(CIRCLE_GUARD));
    (sine_c * cosine_d + cosine_c * sine_d, N::of(CIRCLE_BOUND) * (size_c * size_d))
}

/// Decides what the filter left open.
#[cold]
#[inline(never)]
fn in_circle_exact(a: Point, b: Point, c: Point, d: Point) -> CircleSide {
    CircleSide::from_sign(
        small_sign(a, b, c, d)
            .or_else(|| integer_sign(a, b, c, d))
            .or_else(|| adaptive_sign(a, b, c, d))
            .unwrap_or_else(|| summed_sign(a, b, c, d)),
    )
}

/// Decides what the filter left open, and breaks ties.
#[cold]
#[inline(never)]
fn in_circle_perturbed_exact(a: Point, b: Point, c: Point, d: Point) -> CircleSide {
    match in_circle_exact(a, b, c, d) {
        CircleSide::On => tie_side(a, b, c, d),
        side => side,
    }
}

/// The side of `d` when the lexicographically smallest of four cocircular points is raised.
fn tie_side(a: Point, b: Point, c: Point, d: Point) -> CircleSide {
    let less = lexicographically_less;
    let (ab, cd) = (less(a, b), less(c, d));
    let first_pair = if ab { a } else { b };
    let second_pair = if cd { c } else { d };
    let cofactor = match (less(first_pair, second_pair), ab, cd) {
        (true, true, _) => orient2d(d, b, c),
        (true, false, _) => orient2d(d, c, a),
        (false, _, true) => orient2d(d, a, b),
        (false, _, false) => orient2d(a, c, b),
    };
    CircleSide::from_orientation(cofactor)
}

/// The sign in plain arithmetic, where the differences are integers so small that nothing is rounded.
#[inline]
fn small_sign(a: Point, b: Point, c: Point, d: Point) -> Option<Ordering> {
    let pairs = [a, b, c].map(|p| [(p.x, d.x), (p.y, d.y)]);
    let [[a0, a1], [b0, b1], [c0, c1]] = pairs;
    let [ax, ay, bx, by, cx, cy] = small_differences([a0, a1, b0, b1, c0, c1])?;
    let determinant = (ax * ax + ay * ay) * (bx * cy - cx * by)
        + (bx * bx + by * by) * (cx * ay - ax * cy)
        + (cx * cx + cy * cy) * (ax * by - bx * ay);
    determinant.partial_cmp(&0.0)
}

/// The sign in integers.
fn integer_sign(a: Point, b: Point, c: Point, d: Point) -> Option<Ordering> {
    let [ax, ay, bx, by, cx, cy, dx, dy] = common_integers([a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y])?;
    let differences = [ax - dx, ay - dy, bx - dx, by - dy, cx - dx, cy - dy];
    let digits = differences.iter().fold(0, |digits, d| digits | d.unsigned_abs());
    if digits == 0 {
        return Some(Ordering::Equal);
    }
    let shift = digits.trailing_zeros();
    if digits >> shift < 1 << 30 {
        Some(narrow_sign(differences.map(|d| d >> shift)))
    } else {
        Some(wide_sign(differences))
    }
}

/// The sign for differences below 2^30: 61-bit lifts and cross products, 125-bit determinant.
#[inline]
fn narrow_sign([ax, ay, bx, by, cx, cy]: [i64; 6]) -> Ordering {
    let term = |lift: i64, cross: i64| i128::from(lift) * i128::from(cross);
    let determinant = term(ax * ax + ay * ay, bx * cy - cx * by)
        + term(bx * bx + by * by, cx * ay - ax * cy)
        + term(cx * cx + cy * cy, ax * by - bx * ay);
    determinant.cmp(&0)
}

/// The sign for differences below 2^62: 125-bit lifts and cross products, 252-bit determinant.
fn wide_sign(differences: [i64; 6]) -> Ordering {
    let [ax, ay, bx, by, cx, cy] = differences.map(i128::from);
    Wide::product(ax * ax + ay * ay, bx * cy - cx * by)
        .plus(Wide::product(bx * bx + by * by, cx * ay - ax * cy))
        .plus(Wide::product(cx * cx + cy * cy, ax * by - bx * ay))
        .sign()
}

/// The sign by adaptive expansions, where they are exact.
fn adaptive_sign(a: Point, b: Point, c: Point, d: Point) -> Option<Ordering> {
    if !all_within([a, b, c, d], safe_range::CIRCLE) {
        return None;
    }
    robust::incircle(coord(a), coord(b), coord(c), coord(d)).partial_cmp(&0.0)
}

/// The sign by summing exact products: three lifts of two squares times a cross product of two terms.
fn summed_sign(a: Point, b: Point, c: Point, d: Point) -> Ordering {
    let from_d = |p: Point| (Difference::new(p.x, d.x), Difference::new(p.y, d.y));
    let (a, b, c) = (from_d(a), from_d(b), from_d(c));
    let mut sum = ExactSum::new();
    for (lifted, left, right) in [(a, b, c), (b, c, a), (c, a, b)] {
        for side in [lifted.0, lifted.1] {
            sum.add([side, side, left.0, right.1]);
            sum.subtract([side, side, right.0, left.1]);
        }
    }
    sum.sign()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(s: f64) -> [Point; 4] {
        [(-s, -s), (s, -s), (s, s), (-s, s)].map(|(x, y)| Point::new(x, y))
    }

    #[test]
    fn the_corners_of_a_square_are_cocircular_at_every_size() {
        for s in [5e-324, 1e-308, 1e-300, 1e-100, 0.1, 1.0, 1e100, 1e300, f64::MAX] {
            let [a, b, c, d] = square(s);
            assert_eq!(in_circle(a, b, c, d), CircleSide::On);
            let origin = Point::new(0.0, 0.0);
            assert_eq!(in_circle(a, b, c, origin), CircleSide::Inside);
            assert_eq!(in_circle(a, c, b, origin), CircleSide::Outside);
            let inner = Point::new(-f64::from_bits(s.to_bits() - 1), s);
            assert_eq!(in_circle(a, b, c, inner), CircleSide::Inside);
        }
    }

    #[test]
    fn all_exact_routes_agree() {
        let quadruples = [
            [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)],
            [(0.1, 0.1), (0.4, 0.1), (0.4, 0.4), (0.1, 0.4)],
            [(0.1, 0.1), (0.7, 0.2), (0.3, 0.9), (0.2, 0.7)],
            [(3.0, 4.0), (-5.0, 0.0), (4.0, -3.0), (0.0, 5.0)],
            [(0.0, 0.0), (1e9, 1.0), (1.0, 1e9), (1e9, 1e9)],
        ];
        for quadruple in quadruples {
            let [a, b, c, d] = quadruple.map(|(x, y)| Point::new(x, y));
            let expected = summed_sign(a, b, c, d);
            assert_eq!(integer_sign(a, b, c, d), Some(expected));
            assert!(small_sign(a, b, c, d).is_none_or(|sign| sign == expected));
            assert_eq!(adaptive_sign(a, b, c, d), Some(expected));
            assert_eq!(in_circle(a, b, c, d), CircleSide::from_sign(expected));
        }
    }

    /// Random numbers: of any exponent, or near one another.
    fn wild_numbers() -> impl FnMut(bool) -> f64 {
        let mut state = 1_u64;
        move |tame| {
            state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
            let bits = state ^ state >> 31;
            let exponent = if tame { 1020 + bits % 8 } else { bits % 2047 };
            f64::from_bits(bits & 0x800f_ffff_ffff_ffff | exponent << 52)
        }
    }

    #[test]
    fn the_filter_never_lies() {
        let mut number = wild_numbers();
        let mut decided = 0;
        for i in 0..40_000 {
            // Every choice of coordinates that are tame, the others of any size.
            let tame = |k: u32| i >> k & 1 == 0;
            let [a, b, c, d] = [0, 2, 4, 6].map(|k| Point::new(number(tame(k)), number(tame(k + 1))));
            if let Some(side) = filtered_sign(a, b, c, d) {
                assert_eq!(side, CircleSide::from_sign(summed_sign(a, b, c, d)), "{a} {b} {c} {d}");
                decided += 1;
            }
        }
        assert!(decided > 10_000);
    }

    #[test]
    fn two_circles_are_told_as_one_after_the_other() {
        let mut number = wild_numbers();
        let mut proved = 0;
        for i in 0..40_000 {
            let mut pair = || [0, 1].map(|k| Point::new(number(i >> k & 1 == 0), number(true)));
            let (a, b, c, [d, _]) = (pair(), pair(), pair(), pair());
            let one_by_one = [0, 1].map(|k| filtered_sign(a[k], b[k], c[k], d));
            let Some(inside) = inside_two_circles(a, b, c, d) else {
                assert!(one_by_one.contains(&None), "both can be proved");
                continue;
            };
            assert_eq!(inside.map(Some), one_by_one.map(|side| side.map(|side| side == CircleSide::Inside)));
            proved += 1;
        }
        assert!(proved > 10_000);
    }

    #[test]
    fn what_underflows_beside_large_numbers_is_not_decided_by_the_filter() {
        let (a, d) = (Point::new(1e-310, 3e-310), Point::new(2e-310, 1e-310));
        for (b, c) in [(1.0, 1e12), (1e-12, 1e40), (1e100, 1e150)] {
            let (b, c) = (Point::new(b, 0.3 * b), Point::new(0.7 * c, c));
            let expected = CircleSide::from_sign(summed_sign(a, b, c, d));
            assert!(filtered_sign(a, b, c, d).is_none_or(|side| side == expected));
            assert_eq!(in_circle(a, b, c, d), expected);
        }
    }

    #[test]
    fn the_smallest_corner_is_never_on_the_diagonal() {
        let [a, b, c, d] = square(1.0);
        // a is the smallest: the diagonal must be bd, so d is inside abc and a outside bcd.
        assert_eq!(in_circle_perturbed(a, b, c, d), CircleSide::Inside);
        assert_eq!(in_circle_perturbed(b, c, d, a), CircleSide::Outside);
        assert_eq!(in_circle_perturbed(c, a, b, d), CircleSide::Inside);
        assert_eq!(in_circle_perturbed(a, c, b, d), CircleSide::Outside);
    }
}
