//! The Delaunay triangulation by its definition: a triangle belongs to it unless another point is
//! inside its circle.

use core::cmp::Ordering;
use std::collections::HashMap;

use trimalla::geometry::Point;

use super::exact::{in_circle, lexicographic, orient};

/// All triangles of the Delaunay triangulation under the tie rule, in canonical form.
///
/// # Shape
/// Of equal points the lowest index stands for all. No triangle where all points are collinear.
///
/// # Complexity
/// O(n⁴): meant for about 40 points.
#[must_use]
pub fn brute_force_delaunay(points: &[Point]) -> Vec<[u32; 3]> {
    let ids = distinct(points);
    let mut triangles = Vec::new();
    for (i, &a) in ids.iter().enumerate() {
        for (j, &b) in ids.iter().enumerate().skip(i + 1) {
            for &c in &ids[j + 1..] {
                let corners = counter_clockwise(points, [a, b, c]);
                triangles.extend(corners.filter(|&t| has_empty_circle(points, &ids, t)));
            }
        }
    }
    canonical(&triangles)
}

/// Whether `d` is inside the circle of the counter-clockwise `abc`, ties decided by the
/// perturbation.
///
/// # Guarantees
/// On a true tie the lexicographically smallest of the four points is raised. If that is `d`, it
/// leaves the circle. If it is a corner, the plane through the lifted corners rises on that
/// corner's side of the opposite edge, so `d` gets inside exactly if it lies on that side.
#[must_use]
pub fn in_circle_perturbed(a: Point, b: Point, c: Point, d: Point) -> bool {
    match in_circle(a, b, c, d) {
        0 => {
            let smallest = [a, b, c, d].into_iter().min_by(|&p, &q| lexicographic(p, q)).unwrap();
            if smallest == d {
                false
            } else if smallest == a {
                orient(d, b, c) > 0
            } else if smallest == b {
                orient(d, c, a) > 0
            } else {
                orient(d, a, b) > 0
            }
        }
        sign => sign > 0,
    }
}

/// The canonical form: each triangle rotated so that its smallest vertex id comes first, the list
/// sorted.
#[must_use]
pub fn canonical(triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut list: Vec<[u32; 3]> = triangles
        .iter()
        .map(|&t| {
            let mut turned = t;
            let smallest = (0..3).min_by_key(|&k| t[k]).unwrap();
            turned.rotate_left(smallest);
            turned
        })
        .collect();
    list.sort_unstable();
    list
}

/// For each point the lowest index of a point equal to it; `-0.0` equals `0.0`.
#[must_use]
pub fn representatives(points: &[Point]) -> Vec<u32> {
    let mut first: HashMap<[u64; 2], u32> = HashMap::new();
    let key = |p: &Point| [p.x, p.y].map(|v| if v == 0.0 { 0 } else { v.to_bits() });
    points.iter().zip(0..).map(|(p, i)| *first.entry(key(p)).or_insert(i)).collect()
}

/// Indices of the points that stand for themselves.
pub(super) fn distinct(points: &[Point]) -> Vec<u32> {
    representatives(points).into_iter().zip(0..).filter(|&(first, i)| first == i).map(|(_, i)| i).collect()
}

/// The three corners in counter-clockwise order; nothing where they are collinear.
pub(super) fn counter_clockwise(points: &[Point], [a, b, c]: [u32; 3]) -> Option<[u32; 3]> {
    let [pa, pb, pc] = [a, b, c].map(|v| points[v as usize]);
    match orient(pa, pb, pc).cmp(&0) {
        Ordering::Greater => Some([a, b, c]),
        Ordering::Less => Some([a, c, b]),
        Ordering::Equal => None,
    }
}

/// Whether no other point is inside the circle of the counter-clockwise triangle.
fn has_empty_circle(points: &[Point], ids: &[u32], corners: [u32; 3]) -> bool {
    let [a, b, c] = corners.map(|v| points[v as usize]);
    ids.iter().all(|d| corners.contains(d) || !in_circle_perturbed(a, b, c, points[*d as usize]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generators::{PointSetKind, point_set};
    use crate::oracles::{covers_hull, delaunay_triangle_count};

    #[test]
    fn square_diagonal_avoids_the_smallest_point() {
        let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| Point::new(x, y));
        assert_eq!(brute_force_delaunay(&square), [[0, 1, 3], [1, 2, 3]]);
    }

    #[test]
    fn worked_example_of_five_points() {
        let five = [(61.0, 17.0), (-23.0, -95.0), (55.0, 60.0), (-77.0, 4.0), (57.0, -114.0)];
        let five = five.map(|(x, y)| Point::new(x, y));
        assert_eq!(brute_force_delaunay(&five), canonical(&[[3, 0, 2], [1, 4, 0], [1, 0, 3]]));
    }

    #[test]
    fn duplicates_are_represented_by_the_lowest_index() {
        let points = [(0.0, 0.0), (-0.0, 0.0), (1.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(|(x, y)| Point::new(x, y));
        assert_eq!(representatives(&points), [0, 0, 2, 2, 4]);
        assert_eq!(brute_force_delaunay(&points), [[0, 2, 4]]);
    }

    #[test]
    fn every_generator_gives_a_triangulation_of_the_hull() {
        for kind in PointSetKind::ALL {
            for seed in 0..3 {
                let points = point_set(kind, 18, seed);
                let triangles = brute_force_delaunay(&points);
                assert_eq!(triangles.len(), delaunay_triangle_count(&points), "{kind:?} seed {seed}: {points:?}");
                assert!(covers_hull(&points, &triangles), "{kind:?} seed {seed}: {points:?}");
            }
        }
    }

    #[test]
    fn the_answer_does_not_depend_on_the_order_of_points() {
        let points = point_set(PointSetKind::IntegerGrid, 25, 1);
        let reversed: Vec<Point> = points.iter().rev().copied().collect();
        let last = u32::try_from(points.len() - 1).unwrap();
        let renamed: Vec<[u32; 3]> = brute_force_delaunay(&reversed).into_iter().map(|t| t.map(|v| last - v)).collect();
        assert_eq!(canonical(&renamed), brute_force_delaunay(&points));
    }
}
