//! Every triangulation of a few points, or of a domain: the oracle of every criterion.
#![allow(dead_code, reason = "every file of tests uses a part of it")]

use std::collections::BTreeSet;

use trimalla::geometry::Point;
use trimalla_testkit::oracles::{on_open_segment, orient};

/// Every triangulation of the convex hull of points, each a sorted list of triangles from their smallest index on.
///
/// Every place is a vertex of every triangulation; of equal points the first one is. None for collinear points.
/// There are some thousand for nine points.
pub(crate) fn triangulations(points: &[Point]) -> Vec<Vec<[u32; 3]>> {
    triangulations_of(points, &hull_edges(points), &places(points))
}

/// Every triangulation of a domain that lies to the left of each edge of its boundary.
///
/// Every point is a vertex; points outside the domain must not be given.
pub(crate) fn triangulations_within(points: &[Point], boundary: &[[u32; 2]]) -> Vec<Vec<[u32; 3]>> {
    triangulations_of(points, boundary, &places(points))
}

/// The edges of the convex hull, the hull to their left; collinear vertices on it are ends of edges.
pub(crate) fn hull_edges(points: &[Point]) -> Vec<[u32; 2]> {
    let places = places(points);
    let at = |v: u32| points[v as usize];
    let is_on_hull = |&[u, v]: &[u32; 2]| {
        let sides: Vec<i32> = places.iter().map(|&w| orient(at(u), at(v), at(w))).collect();
        let is_empty = !places.iter().any(|&w| on_open_segment(at(w), at(u), at(v)));
        u != v && is_empty && sides.iter().all(|&s| s >= 0) && sides.contains(&1)
    };
    let pairs = places.iter().flat_map(|&u| places.iter().map(move |&v| [u, v]));
    pairs.filter(is_on_hull).collect()
}

/// The first of equal points, by index.
fn places(points: &[Point]) -> Vec<u32> {
    let first = |v: usize| points.iter().position(|p| *p == points[v]) == Some(v);
    (0..points.len()).filter(|&v| first(v)).map(|v| v as u32).collect()
}

fn triangulations_of(points: &[Point], boundary: &[[u32; 2]], places: &[u32]) -> Vec<Vec<[u32; 3]>> {
    let mut found = Vec::new();
    if boundary.is_empty() {
        return found;
    }
    let front = Front {
        points,
        places,
        open: boundary.iter().copied().collect(),
        closed: boundary.iter().map(|&[a, b]| [b, a]).collect(),
        triangles: Vec::new(),
    };
    front.advance(&mut found);
    found
}

/// A part of a triangulation.
///
/// The first open edge gets a triangle on its left, in every way that there is: so each triangulation comes up once.
#[derive(Clone)]
struct Front<'a> {
    points: &'a [Point],
    places: &'a [u32],
    /// Directed edges whose triangle on the left is missing.
    open: BTreeSet<[u32; 2]>,
    /// Directed edges that have their triangle on the left, or the outside.
    closed: BTreeSet<[u32; 2]>,
    triangles: Vec<[u32; 3]>,
}

impl Front<'_> {
    fn advance(&self, found: &mut Vec<Vec<[u32; 3]>>) {
        let Some(&[a, b]) = self.open.first() else {
            let mut triangles = self.triangles.clone();
            triangles.sort_unstable();
            found.push(triangles);
            return;
        };
        for &c in self.places {
            if self.fits([a, b, c]) {
                let mut next = self.clone();
                next.add([a, b, c]);
                next.advance(found);
            }
        }
    }

    fn at(&self, v: u32) -> Point {
        self.points[v as usize]
    }

    /// Whether a triangle is counter-clockwise, holds no further vertex, and neither overlaps a triangle nor crosses an
    /// edge that is there.
    fn fits(&self, [a, b, c]: [u32; 3]) -> bool {
        let [p, q, r] = [a, b, c].map(|v| self.at(v));
        let holds = |v: u32| {
            let s = self.at(v);
            ![a, b, c].contains(&v) && orient(p, q, s) >= 0 && orient(q, r, s) >= 0 && orient(r, p, s) >= 0
        };
        orient(p, q, r) > 0
            && !self.places.iter().any(|&v| holds(v))
            && [[b, c], [c, a]].iter().all(|e| !self.closed.contains(e) && !self.crosses(*e))
    }

    fn crosses(&self, [a, b]: [u32; 2]) -> bool {
        let [p, q] = [a, b].map(|v| self.at(v));
        self.open.iter().chain(&self.closed).any(|&[c, d]| {
            let [r, s] = [c, d].map(|v| self.at(v));
            orient(p, q, r) * orient(p, q, s) < 0 && orient(r, s, p) * orient(r, s, q) < 0
        })
    }

    fn add(&mut self, mut triangle: [u32; 3]) {
        let [a, b, c] = triangle;
        for [u, v] in [[a, b], [b, c], [c, a]] {
            self.closed.insert([u, v]);
            if !self.open.remove(&[u, v]) {
                self.open.insert([v, u]);
            }
        }
        while triangle[0] > triangle[1].min(triangle[2]) {
            triangle.rotate_left(1);
        }
        self.triangles.push(triangle);
    }
}

#[test]
fn convex_polygons_have_as_many_as_catalan_says() {
    for (n, count) in [(3, 1), (4, 2), (5, 5), (6, 14), (7, 42), (8, 132), (9, 429)] {
        let points: Vec<Point> = (0..n).map(|i| Point::new(f64::from(i), f64::from(i * i))).collect();
        let all = triangulations(&points);
        let distinct: BTreeSet<_> = all.iter().collect();
        assert_eq!((all.len(), distinct.len()), (count, count), "{n} corners");
    }
}

#[test]
fn grids_lines_and_holes_are_counted_right() {
    let grid =
        |w: usize, h: usize| -> Vec<Point> { (0..w * h).map(|k| Point::new((k % w) as f64, (k / w) as f64)).collect() };
    // The triangulations of grids of 1 × n cells: binomials; of 2 × 2 cells: 64.
    assert_eq!(triangulations(&grid(3, 2)).len(), 6);
    assert_eq!(triangulations(&grid(4, 2)).len(), 20);
    assert_eq!(triangulations(&grid(3, 3)).len(), 64);
    assert!(triangulations(&grid(5, 1)).is_empty());
    let twice: Vec<Point> = [grid(3, 2), grid(3, 2)].concat();
    assert_eq!(triangulations(&twice), triangulations(&grid(3, 2)));
    // A triangle with a triangular hole.
    let frame = [[0.0, 0.0], [9.0, 0.0], [0.0, 9.0], [2.0, 2.0], [2.0, 4.0], [4.0, 2.0]].map(Point::from);
    let boundary = [[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3]];
    let all = triangulations_within(&frame, &boundary);
    assert!(all.iter().all(|t| t.len() == 6) && all.len() > 1, "{all:?}");
}
