//! Which of two points touches a sweep line with the smaller circle.

use super::super::Point;
use super::exact::{Difference, ExactSum};
use super::{ROUNDING, UNDERFLOW_GUARD};
use core::cmp::Ordering;

/// Relative error of the two rounded sides, more than their operations can add up to.
const BOUND: f64 = 16.0 * ROUNDING;

/// Compares the radii of the circles that touch the vertical line through `s` in `s` and pass through `a` and through
/// `b`, which are not to the right of that line.
///
/// ```text
///                   │          The circle through a that touches the line in s has its center at the distance r to the
///        a .─────.  │          left of s, where (r - (sx - ax))² + (sy - ay)² = r²: the radius is
///         /       \ │          |as|² / 2 (sx - ax). It is infinite for a on the line.
///        │    ·────·s
///         \       / │
///          `─────´  │
/// ```
///
/// # Guarantees
/// Exact for every finite input: the sign of a sum of products of three differences. Equal for two points on the line.
///
/// # Source
/// The test that finds an arc of the beach line in `[Fortune87]`, without its square root.
#[must_use]
pub(crate) fn tangent_radii(a: Point, b: Point, s: Point) -> Ordering {
    let side = |p: Point, q: Point| {
        let way = s - p;
        way.length_sq() * (s.x - q.x)
    };
    let (left, right) = (side(a, b), side(b, a));
    if (left - right).abs() > BOUND * (left + right) + UNDERFLOW_GUARD {
        return if left < right { Ordering::Less } else { Ordering::Greater };
    }
    tangent_radii_exact(a, b, s)
}

#[cold]
#[inline(never)]
fn tangent_radii_exact(a: Point, b: Point, s: Point) -> Ordering {
    let mut sum = ExactSum::new();
    let from = |p: Point| [Difference::new(s.x, p.x), Difference::new(s.y, p.y)];
    let ([ax, ay], [bx, by]) = (from(a), from(b));
    for d in [ax, ay] {
        sum.add([d, d, bx]);
    }
    for d in [bx, by] {
        sum.subtract([d, d, ax]);
    }
    sum.sign()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn radii_are_compared_at_every_size() {
        // The circle about (-5, 0) of radius 5 touches the line x = 0 in the origin.
        let s = Point::new(0.0, 0.0);
        let on_circle = [[-2.0, 4.0], [-8.0, 4.0], [-10.0, 0.0], [-2.0, -4.0], [-1.0, 3.0]].map(Point::from);
        for scale in [-1000, -500, 0, 300, 1000].map(|exponent| 2_f64.powi(exponent)) {
            let at = |p: Point| Point::new(p.x * scale, p.y * scale);
            for a in on_circle {
                for b in on_circle {
                    assert_eq!(tangent_radii(at(a), at(b), s), Ordering::Equal, "{a} {b} {scale}");
                }
                let beyond = at(Point::new(a.x, a.y * 1.000_001 - 0.001));
                let (one, other) = (tangent_radii(at(a), beyond, s), tangent_radii(beyond, at(a), s));
                assert_eq!(one, other.reverse());
                assert_ne!(one, Ordering::Equal);
            }
        }
        let on_line = Point::new(0.0, 7.0);
        assert_eq!(tangent_radii(on_line, on_circle[0], s), Ordering::Greater);
        assert_eq!(tangent_radii(on_line, Point::new(0.0, -1.0), s), Ordering::Equal);
    }
}
