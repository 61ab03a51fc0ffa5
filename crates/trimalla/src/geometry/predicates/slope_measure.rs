//! The slope of a triangle of a surface, compared exactly.

use core::cmp::Ordering;

use super::super::Point;
use super::ROUNDING;
use super::big_integer::BigInteger;
use super::measures::{BigTriangle, SQUARES, big_triangles, coordinates, dot};

/// The slope of the plane through three points with heights: the length of its gradient.
///
/// Equal slopes are told apart by a symbolic perturbation: the height of vertex `i` is raised by an amount far smaller
/// than that of vertex `i - 1`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SlopeMeasure {
    /// The names of the corners.
    ids: [u32; 3],
    points: [Point; 3],
    heights: [f64; 3],
    /// The squared gradient is this over `area_sq`.
    rise_sq: f64,
    area_sq: f64,
    /// What the errors are measured against.
    sizes: [f64; 2],
}

impl SlopeMeasure {
    /// The slope of a triangle, which must not be flat in the plane.
    pub(crate) fn new(ids: [u32; 3], points: [Point; 3], heights: [f64; 3]) -> Self {
        let ([a, b, c], [ha, hb, hc]) = (points, heights);
        let (u, v, uh, vh) = (b - a, c - a, hb - ha, hc - ha);
        let minor = |p: f64, q: f64, r: f64, s: f64| (p * q - r * s, (p * q).abs() + (r * s).abs());
        let ((x, x_size), (y, y_size)) = (minor(uh, v.y, vh, u.y), minor(vh, u.x, uh, v.x));
        let (area, area_size) = minor(u.x, v.y, u.y, v.x);
        let sizes = [x_size * x_size + y_size * y_size, area_size * area_size];
        Self { ids, points, heights, rise_sq: x * x + y * y, area_sq: area * area, sizes }
    }

    /// The order of two slopes. Exact; equal only for one and the same triangle.
    ///
    /// Against `sizes`, a squared rise is off by 12 roundings and a squared area by 10, their product by one more, and
    /// the difference by another one.
    #[inline]
    pub(crate) fn compare(&self, other: &Self) -> Ordering {
        let excess = self.rise_sq * other.area_sq - other.rise_sq * self.area_sq;
        let bound = 64.0 * ROUNDING * (self.sizes[0] * other.sizes[1] + other.sizes[0] * self.sizes[1]);
        let fits = |measure: &Self| measure.sizes.iter().all(|v| SQUARES.contains(v));
        if fits(self) && fits(other) && excess.abs() > bound {
            return if excess < 0.0 { Ordering::Less } else { Ordering::Greater };
        }
        self.compare_exactly(other)
    }

    /// The slope: rise over run, rounded.
    pub(crate) fn slope(&self) -> f64 {
        let triangles = [self.points; 2];
        let [triangle, _] = big_triangles(triangles);
        let exponent = BigInteger::exponent(self.heights) - BigInteger::exponent(coordinates(triangles));
        let rise = triangle.rise(&BigInteger::scaled(self.heights));
        dot(&rise, &rise).root_of_quotient(&triangle.doubled_area().squared(), exponent)
    }

    #[cold]
    #[inline(never)]
    fn compare_exactly(&self, other: &Self) -> Ordering {
        if self.ids == other.ids {
            return Ordering::Equal;
        }
        let triangles = big_triangles([self.points, other.points]);
        let [a, b, c] = self.heights;
        let [d, e, f] = other.heights;
        let [a, b, c, d, e, f] = BigInteger::scaled([a, b, c, d, e, f]);
        let heights = [[a, b, c], [d, e, f]];
        let areas = [0, 1].map(|k| triangles[k].doubled_area().squared());
        let rises = [0, 1].map(|k| triangles[k].rise(&heights[k]));
        let across = |parts: [BigInteger; 2]| parts[0].times(&areas[1]).compare(&parts[1].times(&areas[0]));
        let plain = across([0, 1].map(|k| dot(&rises[k], &rises[k])));
        plain.then_with(|| self.perturbed(other, &triangles, &rises, across))
    }

    /// The order by the coefficients of the perturbation, the largest power first: the derivatives by each height, then
    /// the products of two of them.
    fn perturbed(
        &self,
        other: &Self,
        triangles: &[BigTriangle; 2],
        rises: &[[BigInteger; 2]; 2],
        across: impl Fn([BigInteger; 2]) -> Ordering,
    ) -> Ordering {
        let ids = [self.ids, other.ids];
        let mut names = [self.ids, other.ids].concat();
        names.sort_unstable();
        names.dedup();
        // How the rise of triangle k changes with the height of a vertex.
        let change = |k: usize, v: u32| match ids[k].iter().position(|&id| id == v) {
            Some(corner) => triangles[k].rise_by(corner),
            None => [BigInteger::ZERO, BigInteger::ZERO],
        };
        // With amounts e^(2^2i) the powers of e are in this order: linear terms by vertex, among them the products.
        for (i, &v) in names.iter().enumerate() {
            let order = across([0, 1].map(|k| dot(&rises[k], &change(k, v))));
            if order.is_ne() {
                return order;
            }
            for &w in &names[..=i] {
                let order = across([0, 1].map(|k| dot(&change(k, v), &change(k, w))));
                if order.is_ne() {
                    return order;
                }
            }
        }
        Ordering::Equal
    }
}

impl BigTriangle {
    /// How the rise changes with the height of a corner: the side opposite, turned by a quarter.
    fn rise_by(&self, corner: usize) -> [BigInteger; 2] {
        let [x, y] = self.side(corner);
        [y.negated(), x]
    }

    /// The gradient of the plane with these heights, times twice the area.
    fn rise(&self, heights: &[BigInteger; 3]) -> [BigInteger; 2] {
        let [a, b, c] = [0, 1, 2].map(|i| self.rise_by(i).map(|part| part.times(&heights[i])));
        [0, 1].map(|k| a[k].plus(&b[k]).plus(&c[k]))
    }
}
