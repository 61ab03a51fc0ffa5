//! The constrained Delaunay triangulation by its definition, with exact visibility.
//!
//! A triangle belongs to it exactly if
//! 1. its corners see each other: no constraint crosses an edge, no vertex lies inside an edge,
//! 2. no vertex lies inside it,
//! 3. no vertex inside its circle is visible from its interior.
//!
//! A vertex `d` in the circle and outside the triangle is beyond exactly one edge `ab`, and every
//! sight line from the interior to `d` goes through that edge. Seen from `d`, what can hide the
//! edge changes only at directions of vertices of the triangle `dab`. Between two neighbouring such
//! directions one ray decides: either a constraint cuts it before `ab`, and then cuts the whole
//! wedge, or `d` sees through.

use core::cmp::Ordering;

use dashu_ratio::RBig;
use trimalla::geometry::Point;

use super::delaunay::{canonical, counter_clockwise, distinct, in_circle_perturbed, representatives};
use super::exact::{RPoint, on_open_segment, orient, orient_det, rational};

/// All triangles of the constrained Delaunay triangulation of the convex hull, ties by the
/// perturbation, canonical.
///
/// # Shape
/// Segments may not cross and may have no vertex inside; equal points, equal segments and segments
/// of one point are allowed. Nothing is carved: the result covers the convex hull.
///
/// # Complexity
/// O(n⁴) and more: meant for about 40 points.
#[must_use]
pub fn brute_force_cdt(points: &[Point], segments: &[[u32; 2]]) -> Vec<[u32; 3]> {
    let scene = Scene::new(points, segments);
    let n = scene.ids.len();
    let sees: Vec<Vec<bool>> = (0..n).map(|i| (0..n).map(|j| i < j && scene.sees(i, j)).collect()).collect();
    let mut triangles = Vec::new();
    for i in 0..n {
        for j in (i + 1..n).filter(|&j| sees[i][j]) {
            for k in (j + 1..n).filter(|&k| sees[i][k] && sees[j][k]) {
                let corners = counter_clockwise(points, [i, j, k].map(|at| scene.ids[at]));
                triangles.extend(corners.filter(|&t| scene.is_constrained_delaunay(t)));
            }
        }
    }
    canonical(&triangles)
}

/// The points, and the constraints that can hide them.
struct Scene<'a> {
    /// All points, duplicates too.
    points: &'a [Point],
    /// Indices of the distinct points.
    ids: Vec<u32>,
    /// Constraints between distinct points, each once.
    walls: Vec<[u32; 2]>,
}

impl<'a> Scene<'a> {
    /// Joins equal points and drops repeated constraints.
    fn new(points: &'a [Point], segments: &[[u32; 2]]) -> Self {
        let first = representatives(points);
        let mut walls: Vec<[u32; 2]> = segments.iter().map(|s| s.map(|v| first[v as usize])).collect();
        walls.iter_mut().for_each(|s| s.sort_unstable());
        walls.retain(|[a, b]| a != b);
        walls.sort_unstable();
        walls.dedup();
        Self { points, ids: distinct(points), walls }
    }

    /// The coordinates of a vertex.
    fn at(&self, vertex: u32) -> Point {
        self.points[vertex as usize]
    }

    /// Whether the open segment between two distinct points, named by their places in `ids`, meets
    /// neither a constraint in a single inner point nor a vertex.
    fn sees(&self, i: usize, j: usize) -> bool {
        let (a, b) = (self.at(self.ids[i]), self.at(self.ids[j]));
        let blocked = self.walls.iter().any(|w| crosses_properly(a, b, self.at(w[0]), self.at(w[1])));
        !blocked && !self.ids.iter().any(|&v| on_open_segment(self.at(v), a, b))
    }

    /// Conditions 2 and 3 for a triangle whose corners see each other.
    fn is_constrained_delaunay(&self, corners: [u32; 3]) -> bool {
        let [a, b, c] = corners.map(|v| self.at(v));
        self.ids.iter().filter(|v| !corners.contains(v)).all(|&v| {
            let d = self.at(v);
            if !in_circle_perturbed(a, b, c, d) {
                return true;
            }
            match [(a, b), (b, c), (c, a)].into_iter().find(|&(p, q)| orient(p, q, d) < 0) {
                None => false,
                Some((p, q)) => !self.sees_through(d, p, q),
            }
        })
    }

    /// Whether `d` sees some point of the open segment `ab`, which no constraint crosses; `d` is
    /// right of `ab`.
    fn sees_through(&self, d: Point, a: Point, b: Point) -> bool {
        if self.walls.iter().any(|w| w.map(|v| self.at(v)).iter().all(|&p| p == a || p == b)) {
            return false;
        }
        // Seen from d, b is clockwise of a: d, b, a turn left.
        let inside = |p: Point| orient(d, b, p) >= 0 && orient(d, p, a) >= 0 && orient(a, b, p) <= 0 && p != d;
        let mut turns: Vec<Point> = self.ids.iter().map(|&v| self.at(v)).filter(|&p| inside(p)).collect();
        turns.sort_by(|&p, &q| 0.cmp(&orient(d, p, q)));
        turns.dedup_by(|p, q| orient(d, *q, *p) == 0);
        let (d, a, b) = (rational(d), rational(a), rational(b));
        turns.windows(2).any(|pair| {
            let target = between(&d, &rational(pair[0]), &rational(pair[1]), &a, &b);
            !self.walls.iter().any(|w| cuts(&rational(self.at(w[0])), &rational(self.at(w[1])), &d, &target))
        })
    }
}

/// Whether two segments meet in one point that is inside both.
fn crosses_properly(a: Point, b: Point, p: Point, q: Point) -> bool {
    orient(a, b, p) * orient(a, b, q) < 0 && orient(p, q, a) * orient(p, q, b) < 0
}

/// [`crosses_properly`] for rational points.
fn cuts(p: &RPoint, q: &RPoint, d: &RPoint, target: &RPoint) -> bool {
    let side = |a: &RPoint, b: &RPoint, c: &RPoint| orient_det(a, b, c).cmp(&RBig::ZERO);
    let apart = |x: Ordering, y: Ordering| x != Ordering::Equal && x == y.reverse();
    apart(side(d, target, p), side(d, target, q)) && apart(side(p, q, d), side(p, q, target))
}

/// Where the ray from `d` between the directions of `p` and `q` meets the line `ab`.
fn between(d: &RPoint, p: &RPoint, q: &RPoint, a: &RPoint, b: &RPoint) -> RPoint {
    let two = RBig::from(2);
    let through = [(&p[0] + &q[0]) / &two, (&p[1] + &q[1]) / &two];
    let (from, to) = (orient_det(a, b, d), orient_det(a, b, &through));
    let t = &from / (&from - to);
    [&d[0] + &t * (&through[0] - &d[0]), &d[1] + &t * (&through[1] - &d[1])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generators::{PslgKind, pslg};
    use crate::oracles::{brute_force_delaunay, covers_hull, delaunay_triangle_count};

    fn points(list: &[(f64, f64)]) -> Vec<Point> {
        list.iter().map(|&(x, y)| Point::new(x, y)).collect()
    }

    #[test]
    fn without_constraints_it_is_delaunay() {
        let p = points(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0), (1.0, 0.5), (1.0, 3.0)]);
        assert_eq!(brute_force_cdt(&p, &[]), brute_force_delaunay(&p));
    }

    #[test]
    fn a_constraint_takes_the_other_diagonal() {
        let square = points(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
        assert_eq!(brute_force_cdt(&square, &[[0, 2], [2, 0], [1, 1]]), [[0, 1, 2], [0, 2, 3]]);
    }

    #[test]
    fn a_wall_hides_a_vertex_inside_the_circle() {
        // The wall 3-4 hides vertex 5 from the triangle 0 1 2, whose circle holds 5.
        let p = points(&[(0.0, 0.0), (4.0, 0.0), (2.0, 4.0), (-3.0, -0.5), (7.0, -0.5), (2.0, -0.75)]);
        let free = brute_force_cdt(&p, &[]);
        let walled = brute_force_cdt(&p, &[[3, 4]]);
        assert!(!free.contains(&[0, 1, 2]), "{free:?}");
        assert!(walled.contains(&[0, 1, 2]), "{walled:?}");
        assert!(covers_hull(&p, &walled));
    }

    #[test]
    fn a_wall_with_a_gap_does_not_hide() {
        let p = points(&[
            (0.0, 0.0),
            (4.0, 0.0),
            (2.0, 4.0),
            (-3.0, -0.5),
            (1.9, -0.5),
            (2.1, -0.5),
            (7.0, -0.5),
            (2.0, -0.75),
        ]);
        let split = brute_force_cdt(&p, &[[3, 4], [5, 6]]);
        assert!(!split.contains(&[0, 1, 2]), "{split:?}");
        assert!(covers_hull(&p, &split));
        assert_eq!(split.len(), delaunay_triangle_count(&p));
    }

    #[test]
    fn every_clean_generator_gives_a_triangulation_with_all_segments() {
        for kind in PslgKind::ALL.into_iter().filter(|k| k.is_clean()) {
            for seed in 0..2 {
                let input = pslg(kind, 20, seed);
                if input.points.len() > 48 {
                    continue;
                }
                let triangles = brute_force_cdt(&input.points, &input.segments);
                assert_eq!(triangles.len(), delaunay_triangle_count(&input.points), "{kind:?} seed {seed}");
                assert!(covers_hull(&input.points, &triangles), "{kind:?} seed {seed}");
                let first = representatives(&input.points);
                for s in &input.segments {
                    let [a, b] = s.map(|v| first[v as usize]);
                    let has = |t: &[u32; 3]| t.contains(&a) && t.contains(&b);
                    assert!(a == b || triangles.iter().any(has), "{kind:?} seed {seed}: segment {s:?} is no edge");
                }
            }
        }
    }
}
