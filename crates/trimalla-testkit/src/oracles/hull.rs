//! The convex hull, with the points that lie on its sides counted.

use core::cmp::Ordering;

use trimalla::geometry::Point;

use super::exact::{lexicographic, on_open_segment, orient};

/// Corners of the convex hull, counter-clockwise from the lexicographically smallest, without
/// points inside a side.
///
/// # Shape
/// Empty for no points, one point where all are equal, the two ends where all are collinear.
#[must_use]
pub fn convex_hull(points: &[Point]) -> Vec<Point> {
    let sorted = distinct_sorted(points);
    if sorted.len() < 3 {
        return sorted;
    }
    let mut hull = half_hull(sorted.iter().copied());
    hull.pop();
    let mut upper = half_hull(sorted.iter().rev().copied());
    upper.pop();
    hull.append(&mut upper);
    hull
}

/// Number of distinct points on the boundary of the convex hull, those inside a side included.
///
/// # Guarantees
/// Where all points are collinear this is the number of distinct points.
#[must_use]
pub fn convex_hull_size(points: &[Point]) -> usize {
    let corners = convex_hull(points);
    let on_side = |p: Point| {
        let next = corners.iter().skip(1).chain(corners.first());
        corners.iter().zip(next).any(|(&a, &b)| a == p || on_open_segment(p, a, b))
    };
    distinct_sorted(points).into_iter().filter(|&p| on_side(p)).count()
}

/// Number of triangles of every triangulation of all the points: `2n − 2 − h`, and 0 where they are
/// collinear.
#[must_use]
pub fn delaunay_triangle_count(points: &[Point]) -> usize {
    let corners = convex_hull(points).len();
    if corners < 3 { 0 } else { 2 * distinct_sorted(points).len() - 2 - convex_hull_size(points) }
}

/// The points in lexicographic order, each once.
fn distinct_sorted(points: &[Point]) -> Vec<Point> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|&a, &b| lexicographic(a, b));
    sorted.dedup_by(|a, b| lexicographic(*a, *b) == Ordering::Equal);
    sorted
}

/// The chain of strict left turns through points that come in order.
fn half_hull(points: impl Iterator<Item = Point>) -> Vec<Point> {
    let mut chain: Vec<Point> = Vec::new();
    for p in points {
        while chain.len() > 1 && orient(chain[chain.len() - 2], chain[chain.len() - 1], p) <= 0 {
            chain.pop();
        }
        chain.push(p);
    }
    chain
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(list: &[(f64, f64)]) -> Vec<Point> {
        list.iter().map(|&(x, y)| Point::new(x, y)).collect()
    }

    #[test]
    fn points_inside_a_side_count() {
        let grid: Vec<(f64, f64)> = (0..9).map(|i| (f64::from(i % 3), f64::from(i / 3))).collect();
        let grid = points(&grid);
        assert_eq!(convex_hull(&grid), points(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]));
        assert_eq!(convex_hull_size(&grid), 8);
        assert_eq!(delaunay_triangle_count(&grid), 8);
    }

    #[test]
    fn low_dimensions() {
        assert_eq!(convex_hull_size(&[]), 0);
        assert_eq!(convex_hull_size(&points(&[(1.0, 1.0), (1.0, 1.0)])), 1);
        let line = points(&[(0.0, 0.0), (2.0, 2.0), (1.0, 1.0), (3.0, 3.0), (1.0, 1.0)]);
        assert_eq!(convex_hull(&line).len(), 2);
        assert_eq!(convex_hull_size(&line), 4);
        assert_eq!(delaunay_triangle_count(&line), 0);
    }
}
