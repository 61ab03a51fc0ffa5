//! Edges that do not cross, and the triangles between them.

use std::cmp::Ordering;

use super::input::Prepared;
use crate::geometry::{Orientation, Point, lexicographically_less, orient2d};
use crate::half_edge::edges_of;

/// The triangles of a maximal set of edges that do not cross: each from its smallest vertex on, sorted.
///
/// # Shape
/// `edges` lists each edge once, in any direction, the boundary of the domain included.
///
/// ```text
///          c           The edges at each vertex are sorted by direction. Of two neighbours b, c in the order around a,
///        / |           counter-clockwise, an edge from b to c closes a triangle, as the edges are maximal; where there is
///       /  |           no such edge, or the turn is no left turn, the outside lies between.
///      a ──b
/// ```
///
/// # Complexity
/// O(n log n).
pub(crate) fn triangles(points: &[Point], prepared: &Prepared, edges: &[[u32; 2]]) -> Vec<[u32; 3]> {
    let around = Around::new(points, edges);
    let mut outside: Vec<[u32; 2]> = prepared.boundary.iter().map(|&[a, b]| [b, a]).collect();
    outside.sort_unstable();
    let is_inside = |[a, b, c]: [u32; 3]| [[a, b], [b, c], [c, a]].iter().all(|e| outside.binary_search(e).is_err());
    let mut found = Vec::new();
    for a in 0..points.len() as u32 {
        let near = around.of(a);
        for (i, &b) in near.iter().enumerate() {
            let c = near[(i + 1) % near.len()];
            // Each triangle is found at its smallest corner.
            if a < b && a < c && turns_left(points, a, b, c) && around.is_next(b, c, a) && is_inside([a, b, c]) {
                found.push([a, b, c]);
            }
        }
    }
    found.sort_unstable();
    found
}

/// The sum of the lengths of the edges of triangles, each edge once; rounded, and summed in one order.
pub(crate) fn total_length(points: &[Point], triangles: &[[u32; 3]]) -> f64 {
    edges_of(triangles).into_iter().map(|edge| length(points, edge.ends())).sum()
}

/// The length of an edge, rounded.
pub(crate) fn length(points: &[Point], [a, b]: [u32; 2]) -> f64 {
    let way = points[b as usize] - points[a as usize];
    crate::geometry::math::hypot(way.x, way.y)
}

/// The neighbours of each vertex, counter-clockwise.
struct Around {
    begin: Vec<u32>,
    near: Vec<u32>,
}

impl Around {
    fn new(points: &[Point], edges: &[[u32; 2]]) -> Self {
        let mut both: Vec<[u32; 2]> = edges.iter().flat_map(|&[a, b]| [[a, b], [b, a]]).collect();
        both.sort_unstable_by(|&[a, p], &[b, q]| a.cmp(&b).then_with(|| direction(points, a, p, q)));
        let mut begin = vec![0; points.len() + 1];
        for &[a, _] in &both {
            begin[a as usize + 1] += 1;
        }
        for v in 0..points.len() {
            begin[v + 1] += begin[v];
        }
        Self { begin, near: both.iter().map(|&[_, b]| b).collect() }
    }

    fn of(&self, v: u32) -> &[u32] {
        &self.near[self.begin[v as usize] as usize..self.begin[v as usize + 1] as usize]
    }

    /// Whether `q` is the neighbour of `v` that comes next after `p`.
    fn is_next(&self, v: u32, p: u32, q: u32) -> bool {
        let near = self.of(v);
        near.iter().position(|&w| w == p).is_some_and(|i| near[(i + 1) % near.len()] == q)
    }
}

/// The order of the directions from `v` to `p` and to `q`, counter-clockwise from straight down on.
fn direction(points: &[Point], v: u32, p: u32, q: u32) -> Ordering {
    let [v, p, q] = [v, p, q].map(|v| points[v as usize]);
    let is_left = |p: Point| lexicographically_less(p, v);
    is_left(p).cmp(&is_left(q)).then_with(|| match orient2d(v, p, q) {
        Orientation::CounterClockwise => Ordering::Less,
        Orientation::Collinear => Ordering::Equal,
        Orientation::Clockwise => Ordering::Greater,
    })
}

fn turns_left(points: &[Point], a: u32, b: u32, c: u32) -> bool {
    let [a, b, c] = [a, b, c].map(|v| points[v as usize]);
    orient2d(a, b, c) == Orientation::CounterClockwise
}
