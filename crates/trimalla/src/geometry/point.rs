//! Points and vectors of the plane.

use core::fmt;
use core::ops::{Add, Sub};

/// A point of the plane, in the caller's coordinate units; y points up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Point {
    /// Abscissa.
    pub x: f64,
    /// Ordinate.
    pub y: f64,
}

/// A displacement between two points.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Vector {
    /// Displacement along x.
    pub x: f64,
    /// Displacement along y.
    pub y: f64,
}

impl Point {
    /// A point from its coordinates.
    #[must_use]
    #[inline]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// Tells whether both coordinates are neither infinite nor NaN.
    #[must_use]
    #[inline]
    pub const fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }

    /// The point halfway between two points, rounded.
    ///
    /// # Guarantees
    /// Finite for finite input; `midpoint(a, b)` and `midpoint(b, a)` have the same bits; each coordinate lies
    /// between those of the ends, ends included.
    #[must_use]
    #[inline]
    pub fn midpoint(a: Self, b: Self) -> Self {
        Self::new(a.x.midpoint(b.x), a.y.midpoint(b.y))
    }

    /// The point at parameter `t` of the way from `a` to `b`, rounded.
    ///
    /// # Guarantees
    /// Exactly `a` at `t = 0` and exactly `b` at `t = 1`; finite for finite input and `t` in `[0, 1]`; each
    /// coordinate lies between those of the ends, ends included.
    #[must_use]
    #[inline]
    pub fn lerp(a: Self, b: Self, t: f64) -> Self {
        Self::new(lerp(a.x, b.x, t), lerp(a.y, b.y, t))
    }

    /// The squared distance of two points, `dx * dx + dy * dy`, rounded.
    ///
    /// # Guarantees
    /// Symmetric to the last bit. Squares of distances beyond about `1e154` are infinite, below `1e-162` zero.
    #[must_use]
    #[inline]
    pub fn distance_sq(a: Self, b: Self) -> f64 {
        (a - b).length_sq()
    }
}

/// Interpolates one coordinate from the nearer end, so that both ends come out exactly.
#[inline]
fn lerp(a: f64, b: f64, t: f64) -> f64 {
    let value = if t == 1.0 {
        b
    } else if t == 0.0 {
        a
    } else {
        a * (1.0 - t) + b * t
    };
    if (0.0..=1.0).contains(&t) { value.max(a.min(b)).min(a.max(b)) } else { value }
}

impl Vector {
    /// A vector from its components.
    #[must_use]
    #[inline]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The scalar product, rounded.
    #[must_use]
    #[inline]
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// The third component of the vector product, rounded: positive where `other` turns counter-clockwise.
    ///
    /// No decision about topology may rest on its sign: that is what [`orient2d`](super::orient2d) is for.
    #[must_use]
    #[inline]
    pub fn cross(self, other: Self) -> f64 {
        self.x * other.y - self.y * other.x
    }

    /// The squared length `x * x + y * y`, rounded.
    #[must_use]
    #[inline]
    pub fn length_sq(self) -> f64 {
        self.x * self.x + self.y * self.y
    }

    /// The vector stretched by a factor.
    #[must_use]
    #[inline]
    pub fn scaled(self, factor: f64) -> Self {
        Self::new(self.x * factor, self.y * factor)
    }
}

impl Sub for Vector {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y)
    }
}

impl Sub for Point {
    type Output = Vector;

    #[inline]
    fn sub(self, other: Self) -> Vector {
        Vector::new(self.x - other.x, self.y - other.y)
    }
}

impl Add<Vector> for Point {
    type Output = Self;

    #[inline]
    fn add(self, by: Vector) -> Self {
        Self::new(self.x + by.x, self.y + by.y)
    }
}

impl From<[f64; 2]> for Point {
    #[inline]
    fn from([x, y]: [f64; 2]) -> Self {
        Self::new(x, y)
    }
}

impl From<[f32; 2]> for Point {
    #[inline]
    fn from([x, y]: [f32; 2]) -> Self {
        Self::new(f64::from(x), f64::from(y))
    }
}

impl From<Point> for [f64; 2] {
    #[inline]
    fn from(point: Point) -> Self {
        [point.x, point.y]
    }
}

/// Shows a number in full, with an exponent where it would be long without.
#[derive(Clone, Copy, Debug)]
pub struct Short(pub f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(x) = *self;
        let is_plain = x == 0.0 || (1e-7..1e17).contains(&x.abs()) || !x.is_finite();
        if is_plain { write!(f, "{x}") } else { write!(f, "{x:e}") }
    }
}

impl fmt::Display for Point {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({}, {})", Short(self.x), Short(self.y))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HUGE: Point = Point::new(f64::MAX, -f64::MAX);

    #[test]
    fn a_midpoint_is_symmetric_and_never_overflows() {
        let pairs = [
            (HUGE, HUGE),
            (HUGE, Point::new(-f64::MAX, f64::MAX)),
            (Point::new(0.1, 0.3), Point::new(0.7, -1e-320)),
            (Point::new(5e-324, 0.0), Point::new(0.0, 5e-324)),
        ];
        for (a, b) in pairs {
            let (ab, ba) = (Point::midpoint(a, b), Point::midpoint(b, a));
            assert!(ab.is_finite());
            assert_eq!([ab.x.to_bits(), ab.y.to_bits()], [ba.x.to_bits(), ba.y.to_bits()]);
        }
        assert_eq!(Point::midpoint(HUGE, HUGE), HUGE);
    }

    #[test]
    fn interpolation_meets_both_ends_exactly() {
        let (a, b) = (Point::new(0.1, -f64::MAX), Point::new(0.7, f64::MAX));
        assert_eq!(Point::lerp(a, b, 0.0), a);
        assert_eq!(Point::lerp(a, b, 1.0), b);
        assert_eq!(Point::lerp(a, a, 0.3), a);
        assert!(Point::lerp(a, b, 0.5).is_finite());
    }

    #[test]
    fn a_point_prints_as_a_pair() {
        assert_eq!(Point::new(1.5, -2.0).to_string(), "(1.5, -2)");
        assert_eq!(Point::new(1e308, -5e-324).to_string(), "(1e308, -5e-324)");
        assert_eq!(Point::new(0.000_001, f64::NAN).to_string(), "(0.000001, NaN)");
        assert_eq!(Point::from([0.5_f32, 2.0]), Point::from([0.5_f64, 2.0]));
    }
}
