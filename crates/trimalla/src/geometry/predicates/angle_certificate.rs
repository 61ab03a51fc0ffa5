//! The final proof that an angle is not below a bound.
//!
//! With `u`, `v` the edges at the apex and `c = cos²(alpha)`, `alpha` in (0°, 90°]: the angle is below `alpha` exactly
//! if `u.v > 0` and `(u.v)² > c |u|² |v|²`. All of it is a polynomial of degree five in the input, whose sign is exact.

use super::super::lanes::{Number, Two};
use super::super::{Point, Vector};
use super::ROUNDING;
use super::disk;
use super::exact::{Difference, ExactSum};
use core::cmp::Ordering;

/// Error bound of the rounded polynomial against `|u|² |v|²`.
///
/// In roundings: each squared length carries 4, their product 9, times `c <= 1` makes 10. The scalar product is off by
/// at most 4 times `|ux vx| + |uy vy| <= |u| |v|`, hence its square by 8 + 1. The subtraction adds 2. That is 21; 32
/// leaves room for the terms of second order and for the rounding of the bound itself.
const ANGLE_BOUND: f64 = 32.0 * ROUNDING;
/// Squared lengths between these bounds keep every product of the filter a normal number (2^-400, 2^400).
const SQUARES: core::ops::RangeInclusive<f64> = f64::from_bits((1023 - 400) << 52)..=f64::from_bits((1023 + 400) << 52);

/// Tells whether the angle at `apex` between the rays to `u` and `v` is at least the one whose squared cosine is
/// `cos_sq`.
///
/// # Units
/// `cos_sq` is taken as the exact number that it is, in `[0, 1]`; it stands for an angle of at most 90 degrees.
///
/// # Guarantees
/// Exact for every finite input. Symmetric in `u` and `v`. `false` if `u` or `v` coincides with `apex`.
#[must_use]
#[inline]
pub fn angle_at_least(apex: Point, u: Point, v: Point, cos_sq: f64) -> bool {
    let (to_u, to_v) = (u - apex, v - apex);
    let (u_sq, v_sq) = (to_u.length_sq(), to_v.length_sq());
    if SQUARES.contains(&u_sq) && SQUARES.contains(&v_sq) {
        let lengths = u_sq * v_sq;
        let dot = to_u.dot(to_v);
        let excess = dot * dot - cos_sq * lengths;
        let bound = ANGLE_BOUND * lengths;
        if excess < -bound {
            return true;
        }
        if excess > bound {
            // |dot| exceeds 2^-24 |u| |v| by far more than its error: its sign is right.
            return dot < 0.0;
        }
    }
    angle_at_least_exact(apex, u, v, cos_sq)
}

/// Tells whether all angles of the triangle `abc` are at least the one whose squared cosine is `cos_sq`.
///
/// # Guarantees
/// Exact for every finite input; the order of the points does not matter.
#[must_use]
#[inline]
pub fn triangle_angles_at_least(a: Point, b: Point, c: Point, cos_sq: f64) -> bool {
    smallest_angle_at_least(a, b, c, cos_sq).unwrap_or_else(|| all_angles_at_least(a, b, c, cos_sq))
}

/// One angle after the other.
#[cold]
#[inline(never)]
fn all_angles_at_least(a: Point, b: Point, c: Point, cos_sq: f64) -> bool {
    angle_at_least(a, b, c, cos_sq) && angle_at_least(b, c, a, cos_sq) && angle_at_least(c, a, b, cos_sq)
}

/// The answer for all three angles by the smallest alone, where the filter decides.
#[inline]
fn smallest_angle_at_least(a: Point, b: Point, c: Point, cos_sq: f64) -> Option<bool> {
    let (u, v, w) = (b - a, c - b, a - c);
    let excess = sides_angle_excess(u.cross(v), [u, v, w].map(Vector::length_sq), 1.0 - cos_sq);
    (excess != 0.0).then_some(excess > 0.0)
}

/// The filter of [`triangle_angles_at_least`]. It takes the rounded squares of a triangle's sides and twice its area,
/// the rounded cross product of any two of them: positive where the bound is met, negative where it is not, zero where
/// rounding leaves that open. `sine_sq` is `1 - cos_sq`, rounded.
///
/// The smallest angle lies between the two longest edges and is at most 60 degrees, where the sine rises with the
/// angle: with `d` twice the area and `P` the product of the two longest squared lengths, it is below the bound exactly
/// if `d² < (1 - c) P`. In roundings, against `P`: each product of two squared lengths carries 9, and the largest of
/// the three computed ones no more; `1 - c` and its product make 11. The cross product is off by at most 4 `|u| |v|`,
/// hence its square by 9. The subtraction adds 1. That is 21, as for [`ANGLE_BOUND`]. Of the two longest edges neither
/// is more than twice as long as the other, so that the range of `P` is theirs, and what the shortest one loses to
/// underflow does not matter.
#[inline(always)]
pub(crate) fn sides_angle_excess<N: Number>(doubled_area: N, [u_sq, v_sq, w_sq]: [N; 3], sine_sq: f64) -> N {
    let longest = (u_sq * v_sq).greater(v_sq * w_sq).greater(w_sq * u_sq);
    let excess = doubled_area * doubled_area - N::of(sine_sq) * longest;
    excess.if_above(N::of(ANGLE_BOUND) * longest).if_within(longest, [*SQUARES.start(), *SQUARES.end()])
}

/// The filter of [`triangle_angles_at_least`] for two triangles `a[i] b[i] c[i]` at once.
#[inline(always)] // In the loop over all triangles.
pub(crate) fn angles_of_two(a: [Point; 2], b: [Point; 2], c: [Point; 2], sine_sq: f64) -> [f64; 2] {
    let [[ax, ay], [bx, by], [cx, cy]] = [a, b, c].map(Two::coordinates);
    let (ux, uy, vx, vy, wx, wy) = (bx - ax, by - ay, cx - ax, cy - ay, cx - bx, cy - by);
    let squares = [ux * ux + uy * uy, vx * vx + vy * vy, wx * wx + wy * wy];
    let Two(excess) = sides_angle_excess(ux * vy - uy * vx, squares, sine_sq);
    excess
}

/// Decides what the filter left open.
#[cold]
#[inline(never)]
fn angle_at_least_exact(apex: Point, u: Point, v: Point, cos_sq: f64) -> bool {
    if u == apex || v == apex {
        return false;
    }
    disk::summed_sign(u, v, apex) != Ordering::Greater || excess_sign(apex, u, v, cos_sq) != Ordering::Greater
}

/// The sign of `(u.v)² - c |u|² |v|²`.
fn excess_sign(apex: Point, u: Point, v: Point, cos_sq: f64) -> Ordering {
    let from_apex = |p: Point| [Difference::new(p.x, apex.x), Difference::new(p.y, apex.y)];
    let (u, v) = (from_apex(u), from_apex(v));
    let cos_sq = Difference::number(cos_sq);
    let mut sum = ExactSum::new();
    for i in 0..2 {
        for j in 0..2 {
            sum.add([u[i], v[i], u[j], v[j]]);
            sum.subtract([cos_sq, u[i], u[i], v[j], v[j]]);
        }
    }
    sum.sign()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_that_are_met_exactly_hold() {
        // 45 degrees: cos² is exactly one half.
        for s in [5e-324, 1e-300, 0.1, 1.0, 3.0, 1e300, f64::MAX] {
            let (apex, u, v) = (Point::new(0.0, 0.0), Point::new(s, 0.0), Point::new(s, s));
            assert!(angle_at_least(apex, u, v, 0.5));
            assert!(angle_at_least(apex, v, u, 0.5));
            assert!(!angle_at_least(apex, u, v, 0.5 - f64::EPSILON / 4.0));
            assert!(triangle_angles_at_least(apex, u, v, 0.5));
            assert!(!triangle_angles_at_least(apex, u, v, 0.49));
            assert!(angle_at_least(u, apex, v, 0.0));
        }
    }

    #[test]
    fn degenerate_triangles_have_no_angle_to_certify() {
        let (a, b) = (Point::new(0.0, 0.0), Point::new(1.0, 1.0));
        assert!(!triangle_angles_at_least(a, a, b, 0.99));
        assert!(!triangle_angles_at_least(a, b, Point::new(2.0, 2.0), 0.99));
        assert!(angle_at_least(b, a, Point::new(2.0, 2.0), 0.75));
    }

    #[test]
    fn two_triangles_are_told_as_one_after_the_other() {
        let mut state = 7_u64;
        let mut number = || {
            state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(1);
            let unit = (state >> 11) as f64 / (1_u64 << 53) as f64;
            // Few numbers, so that flat triangles and equal points occur, some of them out of the filter's range.
            (unit * 16.0).floor() * if state >> 5 & 7 == 0 { 1e-70 } else { 1.0 }
        };
        let mut open = 0;
        for i in 0..20_000 {
            let mut pair = || [0, 1].map(|_| Point::new(number(), number()));
            let (a, b, c) = (pair(), pair(), pair());
            let cos_sq = [0.5, 0.75, 0.883][i % 3];
            let told = angles_of_two(a, b, c, 1.0 - cos_sq);
            for k in [0, 1] {
                let (u, v, w) = (b[k] - a[k], c[k] - a[k], c[k] - b[k]);
                let alone = sides_angle_excess(u.cross(v), [u, v, w].map(Vector::length_sq), 1.0 - cos_sq);
                assert_eq!(told[k].to_bits(), alone.to_bits());
                let expected = all_angles_at_least(a[k], b[k], c[k], cos_sq);
                assert!(told[k] == 0.0 || (told[k] > 0.0) == expected);
                open += usize::from(told[k] == 0.0);
            }
        }
        assert!((100..20_000).contains(&open), "{open}");
    }
}
