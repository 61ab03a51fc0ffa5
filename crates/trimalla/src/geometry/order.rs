//! The lexicographic order of points, on which every tie rule of the library rests.

use super::Point;
use core::cmp::Ordering;

/// Compares two finite points by x, then by y.
///
/// # Guarantees
/// A total order of finite points in which `-0.0` equals `0.0`. A coordinate that is not a number compares as equal.
#[must_use]
#[inline]
pub fn lexicographic(a: Point, b: Point) -> Ordering {
    number_order(a.x, b.x).then(number_order(a.y, b.y))
}

/// Tells whether `a` comes strictly before `b` in [`lexicographic`] order.
#[must_use]
#[inline]
pub fn lexicographically_less(a: Point, b: Point) -> bool {
    a.x < b.x || (a.x == b.x && a.y < b.y)
}

/// Compares two numbers; what cannot be compared counts as equal.
#[inline]
fn number_order(a: f64, b: f64) -> Ordering {
    a.partial_cmp(&b).unwrap_or(Ordering::Equal)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeros_of_either_sign_are_one_number() {
        let (plus, minus) = (Point::new(0.0, 1.0), Point::new(-0.0, 1.0));
        assert_eq!(lexicographic(plus, minus), Ordering::Equal);
        assert!(!lexicographically_less(minus, plus));
        assert!(lexicographically_less(Point::new(-0.0, 0.5), plus));
    }

    #[test]
    fn x_comes_before_y() {
        let (a, b) = (Point::new(0.0, 9.0), Point::new(1.0, -9.0));
        assert_eq!(lexicographic(a, b), Ordering::Less);
        assert_eq!(lexicographic(b, a), Ordering::Greater);
        assert!(lexicographically_less(a, b));
    }
}
