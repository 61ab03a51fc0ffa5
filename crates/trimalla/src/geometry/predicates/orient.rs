//! On which side of a directed line a point lies.

use super::super::Point;
use super::exact::{Difference, ExactSum};
use super::integers::common_integers;
use super::safe_range::{self, all_within, coord};
use super::{ROUNDING, UNDERFLOW_GUARD};
use core::cmp::Ordering;

/// The turn that three points make.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(i8)]
pub enum Orientation {
    /// A right turn.
    Clockwise = -1,
    /// No turn: the points lie on one line, or some coincide.
    Collinear = 0,
    /// A left turn.
    CounterClockwise = 1,
}

impl Orientation {
    /// The turn made in the opposite direction.
    #[must_use]
    #[inline]
    pub const fn reversed(self) -> Self {
        match self {
            Self::Clockwise => Self::CounterClockwise,
            Self::Collinear => Self::Collinear,
            Self::CounterClockwise => Self::Clockwise,
        }
    }

    /// The orientation that belongs to the sign of a signed area.
    #[inline]
    pub(in crate::geometry) const fn from_sign(sign: Ordering) -> Self {
        match sign {
            Ordering::Less => Self::Clockwise,
            Ordering::Equal => Self::Collinear,
            Ordering::Greater => Self::CounterClockwise,
        }
    }
}

/// Relative error bound of the rounded determinant of orientation against its sum of magnitudes.
pub(in crate::geometry) const TWO_PRODUCTS_BOUND: f64 = (3.0 + 16.0 * ROUNDING) * ROUNDING;

/// Tells how `a`, `b`, `c` turn: counter-clockwise where `c` lies left of the directed line from `a` to `b`.
///
/// # Guarantees
/// Exact for every finite input, subnormal and near-overflowing coordinates included; antisymmetric in its points.
///
/// # Complexity
/// Constant; about 1.5 ns where the filter decides.
///
/// # Source
/// `[Shewchuk97]`, ORIENT2D. The filter adds an absolute guard: the two products can together lose 2^-1074 to
/// underflow, far less than the 2^-1000 added here, so a sign that passes is right whatever the magnitudes are. An
/// overflow makes the bound infinite or the comparison undefined, and both are refused.
#[must_use]
#[inline]
pub fn orient2d(a: Point, b: Point, c: Point) -> Orientation {
    match Turn::of(a, b, c).proved() {
        Some(orientation) => orientation,
        None => orient2d_exact(a, b, c),
    }
}

/// The two products that [`orient2d`] compares, rounded: comparing them costs less than a proof.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turn {
    left: f64,
    right: f64,
}

impl Turn {
    /// The products for three points.
    #[inline(always)]
    pub(crate) fn of(a: Point, b: Point, c: Point) -> Self {
        Self { left: (a.x - c.x) * (b.y - c.y), right: (a.y - c.y) * (b.x - c.x) }
    }

    /// The products for `b`, `a`, `c`, which are those of `a`, `b`, `c` exchanged.
    #[inline(always)]
    pub(crate) const fn reversed(self) -> Self {
        Self { left: self.right, right: self.left }
    }

    /// Whether the rounded products say that the points make a right turn.
    #[inline(always)]
    pub(crate) fn seems_clockwise(self) -> bool {
        self.left < self.right
    }

    /// The turn, where rounding cannot change it.
    #[inline(always)]
    fn proved(self) -> Option<Orientation> {
        let determinant = self.left - self.right;
        let turn = if determinant > 0.0 { Orientation::CounterClockwise } else { Orientation::Clockwise };
        (determinant.abs() > self.bound()).then_some(turn)
    }

    /// Whether the points make a left turn that rounding cannot change.
    #[inline(always)]
    pub(crate) fn is_surely_counter_clockwise(self) -> bool {
        self.left - self.right > self.bound()
    }

    /// The bound of the rounding error in the difference of the products.
    #[inline(always)]
    fn bound(self) -> f64 {
        TWO_PRODUCTS_BOUND * (self.left.abs() + self.right.abs()) + UNDERFLOW_GUARD
    }
}

/// Decides the orientation that the filter left open.
#[cold]
#[inline(never)]
fn orient2d_exact(a: Point, b: Point, c: Point) -> Orientation {
    Orientation::from_sign(
        integer_sign(a, b, c).or_else(|| adaptive_sign(a, b, c)).unwrap_or_else(|| summed_sign(a, b, c)),
    )
}

/// The sign in integers: products of two 62-bit differences.
#[inline]
fn integer_sign(a: Point, b: Point, c: Point) -> Option<Ordering> {
    let [ax, ay, bx, by, cx, cy] = common_integers([a.x, a.y, b.x, b.y, c.x, c.y])?;
    let left = i128::from(ax - cx) * i128::from(by - cy);
    let right = i128::from(ay - cy) * i128::from(bx - cx);
    Some(left.cmp(&right))
}

/// The sign by adaptive expansions, where they are exact.
fn adaptive_sign(a: Point, b: Point, c: Point) -> Option<Ordering> {
    if !all_within([a, b, c], safe_range::ORIENTATION) {
        return None;
    }
    robust::orient2d(coord(a), coord(b), coord(c)).partial_cmp(&0.0)
}

/// The sign by summing exact products.
fn summed_sign(a: Point, b: Point, c: Point) -> Ordering {
    summed(a, b, c).sign()
}

/// Twice the signed area of the triangle, exactly.
fn summed(a: Point, b: Point, c: Point) -> ExactSum {
    let mut sum = ExactSum::new();
    sum.add([Difference::new(a.x, c.x), Difference::new(b.y, c.y)]);
    sum.subtract([Difference::new(a.y, c.y), Difference::new(b.x, c.x)]);
    sum
}

/// Where between `p` and `q` the line through `a` and `b` passes, as the parameter from `p`, of points on different
/// sides of it: the exact ratio of their distances from the line, rounded.
pub(in crate::geometry) fn crossing_parameter([a, b]: [Point; 2], [p, q]: [Point; 2]) -> f64 {
    let ((from_p, p_exponent), (from_q, q_exponent)) = (summed(a, b, p).magnitude(), summed(a, b, q).magnitude());
    let exponent = q_exponent.saturating_sub(p_exponent).clamp(-1022, 1023);
    let power = f64::from_bits(u64::from((1023 + exponent).unsigned_abs()) << 52);
    1.0 / (1.0 + from_q / from_p * power)
}

/// The barycentric coordinates of a point of a triangle: its exact areas with the sides, each divided by their sum,
/// rounded.
///
/// # Guarantees
/// Each is within a few last places of itself, however flat the triangle is; corners run counter-clockwise.
pub(crate) fn barycentric([a, b, c]: [Point; 3], p: Point) -> [f64; 3] {
    let areas = [summed(b, c, p), summed(c, a, p), summed(a, b, p)].map(|area| area.magnitude());
    // A magnitude of 0 has the exponent 0, which says nothing.
    let exponents = areas.iter().filter(|(area, _)| *area > 0.0).map(|(_, exponent)| *exponent);
    let Some(largest) = exponents.max() else { return [1.0 / 3.0; 3] };
    let power =
        |exponent: i32| f64::from_bits(u64::from((1023 + (exponent - largest).max(-1022)).unsigned_abs()) << 52);
    let scaled = areas.map(|(area, exponent)| if area > 0.0 { area * power(exponent) } else { 0.0 });
    let total: f64 = scaled.iter().sum();
    scaled.map(|area| area / total)
}

/// Tells whether `a`, `b`, `c` make a strict left turn. Exact.
#[doc(alias = "orientation")]
#[must_use]
#[inline]
pub fn ccw(a: Point, b: Point, c: Point) -> bool {
    orient2d(a, b, c) == Orientation::CounterClockwise
}

/// Tells whether `p` lies strictly left of the directed line from `a` to `b`. Exact.
#[must_use]
#[inline]
pub fn left(a: Point, b: Point, p: Point) -> bool {
    ccw(a, b, p)
}

/// Tells whether `p` lies left of the directed line from `a` to `b` or on it. Exact.
#[doc(alias = "leftOn")]
#[must_use]
#[inline]
pub fn left_on(a: Point, b: Point, p: Point) -> bool {
    orient2d(a, b, p) != Orientation::Clockwise
}

/// Tells whether three points lie on one line. Exact.
#[doc(alias = "colineal")]
#[must_use]
#[inline]
pub fn collinear(a: Point, b: Point, c: Point) -> bool {
    orient2d(a, b, c) == Orientation::Collinear
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROUTES_AGREE_ON: [[f64; 6]; 6] = [
        [0.0, 0.0, 1.0, 0.0, 0.5, 0.25],
        [0.5, 0.5, 12.0, 12.0, 24.0, 24.0],
        [0.1, 0.1, 0.2, 0.2, 0.3, 0.3],
        [0.1, 0.1, 0.7, 0.7, 0.300_000_000_000_000_04, 0.3],
        [-3.0, 1.0, 5.0, -1.5, 1.0, -0.25],
        [0.1, 0.3, 0.1, 0.9, 0.1, 0.5],
    ];

    #[test]
    fn all_exact_routes_agree() {
        for [ax, ay, bx, by, cx, cy] in ROUTES_AGREE_ON {
            let (a, b, c) = (Point::new(ax, ay), Point::new(bx, by), Point::new(cx, cy));
            let expected = summed_sign(a, b, c);
            assert_eq!(adaptive_sign(a, b, c), Some(expected));
            assert_eq!(integer_sign(a, b, c), Some(expected));
            assert_eq!(orient2d(a, b, c), Orientation::from_sign(expected));
        }
    }

    #[test]
    fn squares_of_any_size_turn_left() {
        for s in [5e-324, 1e-308, 1e-300, 1e-100, 1.0, 1e150, 1e300, f64::MAX] {
            let (a, b, c) = (Point::new(-s, -s), Point::new(s, -s), Point::new(s, s));
            let d = Point::new(-s, s);
            assert!(ccw(a, b, c) && left(b, c, d) && left_on(c, d, a));
            assert_eq!(orient2d(a, c, b), Orientation::Clockwise);
            assert!(collinear(a, c, Point::new(0.0, 0.0)));
            assert_eq!(orient2d(a, c, c), Orientation::Collinear);
        }
    }
}
