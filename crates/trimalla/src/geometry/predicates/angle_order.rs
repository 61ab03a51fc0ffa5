//! Which of two angles is larger.

use super::super::Point;
use super::exact::{Difference, ExactSum};
use super::integers::small_differences;
use super::{ROUNDING, UNDERFLOW_GUARD};
use core::cmp::Ordering;

/// Relative error of the rounded difference, more than its operations can add up to.
const BOUND: f64 = 32.0 * ROUNDING;

/// Compares two angles between 0 and 180 degrees, each given by its apex and a point on either leg, counter-clockwise.
/// Exact for every finite input.
///
/// With scalar products s, t and cross products x, y, which are positive, the cotangents are s / x and t / y: the first
/// angle is larger if s y is less than t x.
#[must_use]
pub(crate) fn compare_angles(one: [Point; 3], other: [Point; 3]) -> Ordering {
    let rounded = |[apex, p, q]: [Point; 3]| {
        let (u, v) = (p - apex, q - apex);
        (u.dot(v), u.cross(v), (u.x.abs() + u.y.abs()) * (v.x.abs() + v.y.abs()))
    };
    let ((s, x, size), (t, y, other_size)) = (rounded(one), rounded(other));
    let (left, right) = (s * y, t * x);
    if (left - right).abs() > BOUND * (size * other_size) + UNDERFLOW_GUARD {
        return if left < right { Ordering::Greater } else { Ordering::Less };
    }
    compare_exactly(one, other)
}

#[cold]
#[inline(never)]
fn compare_exactly(one: [Point; 3], other: [Point; 3]) -> Ordering {
    let legs = |[apex, p, q]: [Point; 3]| [(p.x, apex.x), (p.y, apex.y), (q.x, apex.x), (q.y, apex.y)];
    let ([a, b, c, d], [e, f, g, h]) = (legs(one), legs(other));
    if let Some([ux, uy, vx, vy, wx, wy, zx, zy]) = small_differences([a, b, c, d, e, f, g, h]) {
        let left = (ux * vx + uy * vy) * (wx * zy - wy * zx);
        let right = (wx * zx + wy * zy) * (ux * vy - uy * vx);
        return right.total_cmp(&left);
    }
    let exact = |pairs: [(f64, f64); 4]| pairs.map(|(p, q)| Difference::new(p, q));
    let ([ux, uy, vx, vy], [wx, wy, zx, zy]) = (exact([a, b, c, d]), exact([e, f, g, h]));
    let mut sum = ExactSum::new();
    for [u, v] in [[ux, vx], [uy, vy]] {
        sum.subtract([u, v, wx, zy]);
        sum.add([u, v, wy, zx]);
    }
    for [w, z] in [[wx, zx], [wy, zy]] {
        sum.add([w, z, ux, vy]);
        sum.subtract([w, z, uy, vx]);
    }
    sum.sign()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_compared_at_every_size() {
        for scale in [-1070, -500, 0, 300, 1000].map(|exponent| 2_f64.powi(exponent)) {
            let at = |x: f64, y: f64| Point::new(x * scale, y * scale);
            let corner = [at(0.0, 0.0), at(3.0, 0.0), at(0.0, 2.0)];
            let turned = [at(1.0, 1.0), at(2.0, 3.0), at(-3.0, 3.0)];
            assert_eq!(compare_angles(corner, turned), Ordering::Equal);
            let [apex, p, q] = turned;
            let wider = [apex, p, Point::new(q.x, f64::from_bits(q.y.to_bits() - 1))];
            assert_eq!(compare_angles(corner, wider), Ordering::Less);
            assert_eq!(compare_angles(wider, corner), Ordering::Greater);
        }
    }
}
