//! Which of two segments is longer.

use super::super::Point;
use super::exact::{Difference, ExactSum};
use super::integers::small_differences;
use super::{ROUNDING, UNDERFLOW_GUARD};
use core::cmp::Ordering;

/// Relative error of a rounded squared length, more than its operations can add up to.
const BOUND: f64 = 8.0 * ROUNDING;

/// Compares the lengths of two segments. Exact for every finite input.
///
/// # Complexity
/// Constant; two squared lengths where rounded arithmetic decides.
#[must_use]
#[inline]
pub(crate) fn compare_lengths([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Ordering {
    order_if_clear(Point::distance_sq(a, b), Point::distance_sq(c, d))
        .unwrap_or_else(|| compare_exactly([a, b], [c, d]))
}

/// The order of two squared lengths, each rounded by [`Point::distance_sq`], where rounding leaves no doubt.
#[inline]
pub(crate) fn order_if_clear(one: f64, other: f64) -> Option<Ordering> {
    let is_clear = (one - other).abs() > BOUND * (one + other) + UNDERFLOW_GUARD;
    is_clear.then_some(if one < other { Ordering::Less } else { Ordering::Greater })
}

#[cold]
#[inline(never)]
fn compare_exactly([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Ordering {
    if let Some([x, y, u, v]) = small_differences([(a.x, b.x), (a.y, b.y), (c.x, d.x), (c.y, d.y)]) {
        return (x * x + y * y).total_cmp(&(u * u + v * v));
    }
    let mut sum = ExactSum::new();
    for d in [Difference::new(a.x, b.x), Difference::new(a.y, b.y)] {
        sum.add([d, d]);
    }
    for d in [Difference::new(c.x, d.x), Difference::new(c.y, d.y)] {
        sum.subtract([d, d]);
    }
    sum.sign()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_compared_at_every_size() {
        for scale in [-1070, -500, 0, 300, 1010].map(|exponent| 2_f64.powi(exponent)) {
            let at = |x: f64, y: f64| Point::new(x * scale, y * scale);
            let five = [at(1.0, 1.0), at(4.0, 5.0)];
            assert_eq!(compare_lengths(five, [at(-2.0, 0.0), at(3.0, 0.0)]), Ordering::Equal);
            let longer = [at(0.0, 0.0), Point::new(0.0, f64::from_bits((5.0 * scale).to_bits() + 1))];
            assert_eq!(compare_lengths(five, longer), Ordering::Less);
            assert_eq!(compare_lengths(longer, five), Ordering::Greater);
        }
        let tenth = [Point::new(0.1, 0.1), Point::new(0.4, 0.5)];
        assert_eq!(compare_lengths(tenth, [tenth[1], tenth[0]]), Ordering::Equal);
        assert_ne!(compare_lengths(tenth, [Point::new(0.0, 0.0), Point::new(0.5, 0.0)]), Ordering::Equal);
    }
}
