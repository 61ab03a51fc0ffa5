//! Whether a point sees a segment under more or less than a right angle.

use super::super::Point;
use super::UNDERFLOW_GUARD;
use super::circle::CircleSide;
use super::exact::{Difference, ExactSum};
use super::integers::common_integers;
use super::orient::TWO_PRODUCTS_BOUND;
use core::cmp::Ordering;

/// Tells on which side of the circle with diameter `ab` the point `p` lies: the test of encroachment.
///
/// # Guarantees
/// Exact for every finite input: the sign of `(a - p) . (b - p)`, negative inside. The ends themselves are `On`.
/// For `a == b` every other point is `Outside`.
///
/// # Source
/// The error analysis is that of orientation: two products of rounded differences and one sum.
#[doc(alias = "encroached")]
#[doc(alias = "circunferencia diametral")]
#[must_use]
#[inline]
pub fn in_diametral_disk(a: Point, b: Point, p: Point) -> CircleSide {
    let along_x = (a.x - p.x) * (b.x - p.x);
    let along_y = (a.y - p.y) * (b.y - p.y);
    let dot = along_x + along_y;
    let bound = TWO_PRODUCTS_BOUND * (along_x.abs() + along_y.abs()) + UNDERFLOW_GUARD;
    if dot.abs() > bound {
        if dot > 0.0 { CircleSide::Outside } else { CircleSide::Inside }
    } else {
        in_diametral_disk_exact(a, b, p)
    }
}

/// Decides what the filter left open.
#[cold]
#[inline(never)]
fn in_diametral_disk_exact(a: Point, b: Point, p: Point) -> CircleSide {
    let sign = integer_sign(a, b, p).unwrap_or_else(|| summed_sign(a, b, p));
    CircleSide::from_sign(sign.reverse())
}

/// The sign of the scalar product in integers.
fn integer_sign(a: Point, b: Point, p: Point) -> Option<Ordering> {
    let [ax, ay, bx, by, px, py] = common_integers([a.x, a.y, b.x, b.y, p.x, p.y])?;
    let along_x = i128::from(ax - px) * i128::from(bx - px);
    let along_y = i128::from(ay - py) * i128::from(by - py);
    Some((along_x + along_y).cmp(&0))
}

/// The sign of the scalar product by summing exact products.
pub(super) fn summed_sign(a: Point, b: Point, p: Point) -> Ordering {
    let mut sum = ExactSum::new();
    sum.add([Difference::new(a.x, p.x), Difference::new(b.x, p.x)]);
    sum.add([Difference::new(a.y, p.y), Difference::new(b.y, p.y)]);
    sum.sign()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_right_angle_is_on_the_disk_at_every_size() {
        for s in [5e-324, 1e-300, 1.0, 0.1, 1e300, f64::MAX / 4.0] {
            let (a, b) = (Point::new(-s, 0.0), Point::new(s, 0.0));
            assert_eq!(in_diametral_disk(a, b, Point::new(0.0, s)), CircleSide::On);
            assert_eq!(in_diametral_disk(a, b, Point::new(0.0, 2.0 * s)), CircleSide::Outside);
            assert_eq!(in_diametral_disk(a, b, Point::new(0.0, 0.0)), CircleSide::Inside);
            assert_eq!(in_diametral_disk(a, b, a), CircleSide::On);
            assert_eq!(in_diametral_disk(a, a, b), CircleSide::Outside);
        }
    }
}
