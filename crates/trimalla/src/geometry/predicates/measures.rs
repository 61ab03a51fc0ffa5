//! Measures of triangles and segments that are compared exactly: lengths, angles, heights.
//!
//! Each measure is a quotient of polynomials or the root of one, so the order of two of them is the sign of a
//! polynomial. A measure is computed once with a bound of its error, and two measures are compared by numbers first;
//! the exact polynomial is evaluated only where rounding leaves the order open.

use core::cmp::Ordering;

use super::super::Point;
use super::ROUNDING;
use super::big_integer::BigInteger;
use super::exact::{Difference, ExactSum};
use super::integers::common_integers;
use super::lengths::compare_lengths;
use super::wide::Wide;

/// Squares between these bounds keep every product of four of them a normal number (2^-200, 2^200).
pub(super) const SQUARES: core::ops::RangeInclusive<f64> =
    f64::from_bits((1023 - 200) << 52)..=f64::from_bits((1023 + 200) << 52);

/// The corner of a counter-clockwise triangle with the largest angle: the first one opposite a longest side. Exact.
pub(crate) fn largest_corner(t: [Point; 3]) -> usize {
    let side = |i: usize| [t[(i + 1) % 3], t[(i + 2) % 3]];
    (1..3).fold(0, |best, i| if compare_lengths(side(i), side(best)).is_gt() { i } else { best })
}

/// An angle between 0 and 180 degrees.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AngleMeasure {
    /// The apex, and a point on either leg, counter-clockwise.
    points: [Point; 3],
    dot: f64,
    cross: f64,
    /// The product of the lengths of the legs.
    size: f64,
}

impl AngleMeasure {
    /// The angle at the first corner of a counter-clockwise triangle.
    pub(crate) fn new(points: [Point; 3]) -> Self {
        let [apex, p, q] = points;
        let (u, v) = (p - apex, q - apex);
        let size = (u.length_sq() * v.length_sq()).sqrt();
        Self { points, dot: u.dot(v), cross: u.cross(v), size }
    }

    /// The order of two angles. Exact.
    ///
    /// The cotangent, scalar product over cross product, falls as the angle grows. Against the product of the lengths
    /// of all legs, either product of a scalar and a cross product is off by 9 roundings and their difference by 2
    /// more: 20 in all.
    #[inline]
    pub(crate) fn compare(&self, other: &Self) -> Ordering {
        let excess = other.dot * self.cross - self.dot * other.cross;
        let bound = 32.0 * ROUNDING * (self.size * other.size);
        if SQUARES.contains(&self.size) && SQUARES.contains(&other.size) && excess.abs() > bound {
            return if excess < 0.0 { Ordering::Less } else { Ordering::Greater };
        }
        self.compare_exactly(other).reverse()
    }

    /// The angle in radians, rounded.
    pub(crate) fn radians(&self) -> f64 {
        let [a, b, c] = self.points;
        super::super::Triangle::new(a, b, c).angles()[0].radians()
    }

    /// The order of the cotangents.
    #[cold]
    #[inline(never)]
    fn compare_exactly(&self, other: &Self) -> Ordering {
        let ([a, b, c], [d, e, f]) = (self.points, other.points);
        if let Some(numbers) = common_integers([a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y, e.x, e.y, f.x, f.y]) {
            let n = numbers.map(i128::from);
            let leg = |apex: usize, p: usize| [n[2 * p] - n[2 * apex], n[2 * p + 1] - n[2 * apex + 1]];
            let dot = |[ux, uy]: [i128; 2], [vx, vy]: [i128; 2]| ux * vx + uy * vy;
            let cross = |[ux, uy]: [i128; 2], [vx, vy]: [i128; 2]| ux * vy - uy * vx;
            let ([u, v], [w, z]) = ([leg(0, 1), leg(0, 2)], [leg(3, 4), leg(3, 5)]);
            return Wide::product(dot(u, v), cross(w, z)).plus(Wide::product(-dot(w, z), cross(u, v))).sign();
        }
        let leg = |apex: Point, p: Point| [Difference::new(p.x, apex.x), Difference::new(p.y, apex.y)];
        let ([u, v], [w, z]) = ([leg(a, b), leg(a, c)], [leg(d, e), leg(d, f)]);
        let mut sum = ExactSum::new();
        for i in 0..2 {
            sum.add([u[i], v[i], w[0], z[1]]);
            sum.subtract([u[i], v[i], w[1], z[0]]);
            sum.subtract([w[i], z[i], u[0], v[1]]);
            sum.add([w[i], z[i], u[1], v[0]]);
        }
        sum.sign()
    }
}

/// The smallest height of a triangle: twice its area over its longest side.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HeightMeasure {
    /// The corners, the longest side opposite the first one.
    points: [Point; 3],
    area_sq: f64,
    longest_sq: f64,
    /// What the error of `area_sq` is measured against.
    size: f64,
}

impl HeightMeasure {
    /// The smallest height of a triangle whose longest side is opposite its first corner.
    pub(crate) fn new(points: [Point; 3]) -> Self {
        let [apex, p, q] = points;
        let (u, v) = (p - apex, q - apex);
        let (area, size) = (u.cross(v), (u.x * v.y).abs() + (u.y * v.x).abs());
        Self { points, area_sq: area * area, longest_sq: (q - p).length_sq(), size: size * size }
    }

    /// The order of two heights. Exact.
    ///
    /// Against `size`, a squared area is off by 10 roundings; a squared side by 4 of itself; their product makes one
    /// more, and the difference another one.
    #[inline]
    pub(crate) fn compare(&self, other: &Self) -> Ordering {
        let excess = self.area_sq * other.longest_sq - other.area_sq * self.longest_sq;
        let bound = 32.0 * ROUNDING * (self.size * other.longest_sq + other.size * self.longest_sq);
        let fits = |measure: &Self| [measure.size, measure.longest_sq].iter().all(|v| SQUARES.contains(v));
        if fits(self) && fits(other) && excess.abs() > bound {
            return if excess < 0.0 { Ordering::Less } else { Ordering::Greater };
        }
        self.compare_exactly(other)
    }

    /// The height, rounded.
    pub(crate) fn length(&self) -> f64 {
        let [triangle, _] = big_triangles([self.points; 2]);
        let exponent = BigInteger::exponent(coordinates([self.points; 2]));
        triangle.doubled_area().squared().root_of_quotient(&triangle.side_sq(0), exponent)
    }

    #[cold]
    #[inline(never)]
    fn compare_exactly(&self, other: &Self) -> Ordering {
        let [one, two] = big_triangles([self.points, other.points]);
        let product = |area: &BigTriangle, side: &BigTriangle| area.doubled_area().squared().times(&side.side_sq(0));
        product(&one, &two).compare(&product(&two, &one))
    }
}

/// A triangle with integer coordinates.
pub(super) struct BigTriangle {
    x: [BigInteger; 3],
    y: [BigInteger; 3],
}

/// Two triangles with one common power of two.
pub(super) fn big_triangles(triangles: [[Point; 3]; 2]) -> [BigTriangle; 2] {
    let [ax, ay, bx, by, cx, cy, dx, dy, ex, ey, fx, fy] = BigInteger::scaled(coordinates(triangles));
    [BigTriangle { x: [ax, bx, cx], y: [ay, by, cy] }, BigTriangle { x: [dx, ex, fx], y: [dy, ey, fy] }]
}

/// The coordinates of two triangles, point by point.
pub(super) fn coordinates([[a, b, c], [d, e, f]]: [[Point; 3]; 2]) -> [f64; 12] {
    [a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y, e.x, e.y, f.x, f.y]
}

impl BigTriangle {
    /// Cross product of two sides.
    pub(super) fn doubled_area(&self) -> BigInteger {
        let [u, v] = [self.side(2), self.side(1)];
        u[1].times(&v[0]).minus(&u[0].times(&v[1]))
    }

    /// The side opposite a corner, as the corners run.
    pub(super) fn side(&self, corner: usize) -> [BigInteger; 2] {
        let (from, to) = ((corner + 1) % 3, (corner + 2) % 3);
        [self.x[to].minus(&self.x[from]), self.y[to].minus(&self.y[from])]
    }

    /// The squared length of the side opposite a corner.
    fn side_sq(&self, corner: usize) -> BigInteger {
        let side = self.side(corner);
        dot(&side, &side)
    }
}

pub(super) fn dot(u: &[BigInteger; 2], v: &[BigInteger; 2]) -> BigInteger {
    u[0].times(&v[0]).plus(&u[1].times(&v[1]))
}
