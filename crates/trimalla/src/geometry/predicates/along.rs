//! Which of two points is further along a direction.

use super::super::{Point, Vector};
use super::UNDERFLOW_GUARD;
use super::exact::{Difference, ExactSum};
use super::orient::TWO_PRODUCTS_BOUND;
use core::cmp::Ordering;

/// Compares two points along a direction: `Less` where the step from `a` to `b` has a positive part in the direction.
///
/// # Guarantees
/// Exact for every finite input: the sign of `(b - a) . direction`. A total order of points up to ties.
///
/// # Source
/// The error analysis is that of orientation: two products, each with one rounded difference, and one sum.
#[must_use]
#[inline]
pub fn along(direction: Vector, a: Point, b: Point) -> Ordering {
    let along_x = (b.x - a.x) * direction.x;
    let along_y = (b.y - a.y) * direction.y;
    let dot = along_x + along_y;
    let bound = TWO_PRODUCTS_BOUND * (along_x.abs() + along_y.abs()) + UNDERFLOW_GUARD;
    if dot.abs() > bound {
        if dot > 0.0 { Ordering::Less } else { Ordering::Greater }
    } else {
        along_exact(direction, a, b)
    }
}

/// Decides what the filter left open.
#[cold]
#[inline(never)]
fn along_exact(direction: Vector, a: Point, b: Point) -> Ordering {
    let mut sum = ExactSum::new();
    sum.add([Difference::new(b.x, a.x), Difference::number(direction.x)]);
    sum.add([Difference::new(b.y, a.y), Difference::number(direction.y)]);
    sum.sign().reverse()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rounded_product_does_not_decide() {
        for s in [5e-324, 1e-300, 1.0, 1e300] {
            let (a, b) = (Point::new(0.0, 0.0), Point::new(s, -s));
            assert_eq!(along(Vector { x: 1.0, y: 1.0 }, a, b), Ordering::Equal);
            assert_eq!(along(Vector { x: 1.0 + f64::EPSILON, y: 1.0 }, a, b), Ordering::Less);
            assert_eq!(along(Vector { x: 1.0 + f64::EPSILON, y: 1.0 }, b, a), Ordering::Greater);
            assert_eq!(along(Vector { x: 1.0, y: 1.0 + f64::EPSILON }, a, b), Ordering::Greater);
        }
    }
}
