//! On which side of the circle through three points a fourth one lies.

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

/// Relative error bound of the rounded in-circle determinant against its sum of magnitudes.
const CIRCLE_BOUND: f64 = (10.0 + 96.0 * ROUNDING) * ROUNDING;
/// More than the filter can lose to underflow while the lifts add up to less than [`CIRCLE_LIFTS`].
const CIRCLE_GUARD: f64 = f64::from_bits((1023 - 560) << 52); // 2^-560
/// The largest sum of lifts for which the filter decides.
const CIRCLE_LIFTS: f64 = f64::from_bits((1023 + 500) << 52); // 2^500

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
/// Underflow: with M the largest difference, the twelve inner products lose at most 2^-1075 each, multiplied by at most
/// 2 M^2, and the three outer ones at most 2^-1075: together less than 2^-1069 (M^2 + 1). The lifts add up to M^2 or
/// more; while their sum is below 2^500, that loss and its rounding are below the guard of 2^-560. Larger figures are
/// left to the exact routes. So is everything that overflows.
#[inline(always)]
fn filtered_sign(a: Point, b: Point, c: Point, d: Point) -> Option<CircleSide> {
    let (a, b, c) = (a - d, b - d, c - d);
    let (a_lift, b_lift, c_lift) = (a.length_sq(), b.length_sq(), c.length_sq());
    let (bc, cb) = (b.x * c.y, c.x * b.y);
    let (ca, ac) = (c.x * a.y, a.x * c.y);
    let (ab, ba) = (a.x * b.y, b.x * a.y);
    let determinant = a_lift * (bc - cb) + b_lift * (ca - ac) + c_lift * (ab - ba);
    let magnitude = a_lift * (bc.abs() + cb.abs()) + b_lift * (ca.abs() + ac.abs()) + c_lift * (ab.abs() + ba.abs());
    let bound = CIRCLE_BOUND * magnitude + CIRCLE_GUARD;
    // The first branch is nearly always taken; the second, which cannot be predicted, then waits for the sign alone.
    if (determinant.abs() > bound) & (a_lift + b_lift + c_lift < CIRCLE_LIFTS) {
        Some(if determinant > 0.0 { CircleSide::Inside } else { CircleSide::Outside })
    } else {
        None
    }
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

/// The sign in plain arithmetic, where differences are so small integers that nothing is rounded.
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
