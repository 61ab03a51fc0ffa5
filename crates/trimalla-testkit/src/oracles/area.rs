//! Exact areas, doubled so that nothing is divided.

pub use dashu_ratio::RBig;
use trimalla::geometry::Point;

use super::exact::{orient_det, rational};
use super::hull::convex_hull;

/// Twice the sum of the signed areas of the triangles.
#[must_use]
pub fn doubled_area(points: &[Point], triangles: &[[u32; 3]]) -> RBig {
    let doubled = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|v| rational(points[v as usize]));
        orient_det(&a, &b, &c)
    };
    triangles.iter().map(doubled).fold(RBig::ZERO, |sum, area| sum + area)
}

/// Twice the signed area inside a ring, positive where it runs counter-clockwise.
#[must_use]
pub fn doubled_ring_area(ring: &[Point]) -> RBig {
    let Some(&first) = ring.first() else {
        return RBig::ZERO;
    };
    let origin = rational(first);
    let fan = ring.windows(2).map(|w| orient_det(&origin, &rational(w[0]), &rational(w[1])));
    fan.fold(RBig::ZERO, |sum, area| sum + area)
}

/// Whether the triangles have exactly the area of the convex hull of the points.
///
/// # Guarantees
/// For counter-clockwise triangles with disjoint interiors this means that they tile the hull.
#[must_use]
pub fn covers_hull(points: &[Point], triangles: &[[u32; 3]]) -> bool {
    doubled_area(points, triangles) == doubled_ring_area(&convex_hull(points))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unit_square() {
        let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| Point::new(x, y));
        assert_eq!(doubled_ring_area(&square), RBig::from(2));
        assert_eq!(doubled_area(&square, &[[0, 1, 2]]), RBig::from(1));
        assert!(covers_hull(&square, &[[0, 1, 2], [0, 2, 3]]));
        assert!(!covers_hull(&square, &[[0, 1, 2]]));
        assert_eq!(doubled_ring_area(&[]), RBig::ZERO);
    }
}
