//! `min-max-length` and `min-max-length-by-tree`: the longest edge as short as possible.
//!
//! # Idea
//! Some triangulation with the shortest possible longest edge has all edges of the *relative neighbourhood graph*: p
//! and q are relative neighbours if no point is nearer to both than they are to each other. With the edges of the
//! convex hull, which every triangulation has, the graph is connected and cuts the hull into faces. Each face is
//! triangulated on its own, by dynamic programming.
//!
//! ```text
//!      ╭───────╮                          a ───── b
//!     ╱   ╱ ╲   ╲      p and q are        │     ╱ │ ╲        The faces between the edges of the graph (and of the
//!    │   ╱   ╲   │     neighbours, as     │   c   │   e      hull) are polygons. Edges may hang into them: the
//!    │  p─────q  │     the lune between   │       │ ╱        walk around the face a c b … goes along c b twice.
//!    │   ╲   ╱   │     them is empty      f ───── d
//!     ╲   ╲ ╱   ╱
//!      ╰───────╯
//! ```
//!
//! The lecture notes know a part of the theorem, which is enough: the edges of a minimum spanning tree, which are edges
//! of the graph. The faces are larger then, and `min-max-length-by-tree` shows what that costs.
//!
//! # Steps
//! 1. Compute the Delaunay triangulation. It has all edges of the graph, of the tree and of the hull.
//! 2. Keep those of its edges that are in the graph ([`graph::relative_neighbours`]) or the tree
//!    ([`graph::spanning_tree`]).
//! 3. Walk around each face between the kept edges.
//! 4. Triangulate each face with the longest edge as short as possible ([`decompose`]). First only
//!    edges up to the length of the longest side are allowed; if they do not suffice, twice that length, and so on.
//!
//! # Degenerate cases
//! Points at equal distances: a point on the boundary of a lune is not inside. Of equally short trees that with the
//! first edges is taken, by the indices of their ends. Points in line: neighbours on the line are joined. All points on
//! one line: no triangle, and the value is 0.
//!
//! # Guarantees
//! Lengths are compared exactly, by their squares; so the result is optimal for the points as they are given.
//!
//! # Complexity
//! `min-max-length`: O(n²) for the graph, less where points are spread evenly; O(k³) for a face with k sides, which are
//! few in the graph of most sets. (Edelsbrunner and Tan triangulate a face in O(k²), which the dynamic programming does
//! not attain.) `min-max-length-by-tree`: O(n³), as the few faces have up to 2 n sides.
//!
//! # Source
//! `[EdelsbrunnerTan93]`; `[Klincsek80]` for the faces; `[Triangulaciones]` for the tree.

mod graph;

use std::cmp::Ordering;

use super::decompose::{self, Objective};
use super::input::in_order;
use super::mesh::Mesh;
use super::{Optimal, OptimalError, OptimalInput};
use crate::geometry::{Point, Segment, compare_lengths};
use crate::half_edge::{EdgeKey, edges_of};
use crate::trace::Trace;

/// The longest edge as short as possible, through the relative neighbourhood graph.
pub(super) fn by_neighbours(
    input: &OptimalInput<'_>,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Optimal, OptimalError> {
    minimise(input, "min-max-length", trace, graph::relative_neighbours)
}

/// The longest edge as short as possible, through a minimum spanning tree.
pub(super) fn by_tree(input: &OptimalInput<'_>, trace: &mut (impl Trace + ?Sized)) -> Result<Optimal, OptimalError> {
    minimise(input, "min-max-length-by-tree", trace, graph::spanning_tree)
}

/// Steps 1 to 4.
fn minimise<T: Trace + ?Sized>(
    input: &OptimalInput<'_>,
    method: &'static str,
    trace: &mut T,
    choose: impl Fn(&[Point], &[[u32; 2]], &mut T) -> Result<Vec<[u32; 2]>, OptimalError>,
) -> Result<Optimal, OptimalError> {
    let start = input.start()?;
    if input.domain.is_some() {
        return Err(OptimalError::PointsOnly { method });
    }
    let points = input.points;
    let delaunay = Mesh::new(start, &[]);
    let mut kept = choose(points, &edges(&delaunay.triangles), trace)?;
    kept.sort_unstable();
    let triangles = decompose::fill(&delaunay, &kept, method, trace, |walk, trace| shortest(points, walk, trace))?;
    let value = edges(&triangles).into_iter().max_by(|&e, &f| by_length(points, e, f));
    let value = value.map_or(0.0, |[a, b]| Segment::new(points[a as usize], points[b as usize]).length());
    Ok(Optimal { triangles: in_order(triangles), is_proved: true, value })
}

/// Step 4: a triangulation of a face with the longest edge as short as possible.
fn shortest(points: &[Point], walk: &[u32], trace: &mut (impl Trace + ?Sized)) -> Result<Vec<[u32; 3]>, OptimalError> {
    let sides = (0..walk.len()).map(|i| [walk[i], walk[(i + 1) % walk.len()]]);
    let mut limit_sq = sides.map(|side| length_sq(points, side)).fold(LEAST_SQ, f64::max);
    loop {
        let objective = LongestEdge { points, limit_sq };
        let best = decompose::triangulate(points, walk, &objective, trace)?;
        // What is left out is longer than the limit; so is what rounding may confuse with it.
        let is_within = |longest: Measured| longest.square <= limit_sq * (1.0 - 1e-12);
        match best {
            Some(best) if limit_sq == f64::INFINITY || best.value.is_none_or(is_within) => return Ok(best.triangles),
            _ => limit_sq *= 4.0,
        }
    }
}

/// Squares below this may have lost digits.
const LEAST_SQ: f64 = 1e-280;

/// The longer of two edges counts.
struct LongestEdge<'a> {
    points: &'a [Point],
    /// Longer edges are not allowed, by rounded squares.
    limit_sq: f64,
}

/// An edge and its squared length, rounded.
#[derive(Clone, Copy)]
struct Measured {
    ends: [u32; 2],
    square: f64,
}

impl Objective for LongestEdge<'_> {
    type Value = Measured;

    fn edge(&self, ends: [u32; 2]) -> Measured {
        Measured { ends, square: length_sq(self.points, ends) }
    }

    fn join(&self, a: &Measured, b: &Measured) -> Measured {
        if self.compare(a, b).is_lt() { *b } else { *a }
    }

    /// By rounded squares, where these are apart by more than their errors; otherwise exactly.
    #[inline]
    fn compare(&self, a: &Measured, b: &Measured) -> Ordering {
        let is_certain =
            (a.square - b.square).abs() > 2e-15 * (a.square + b.square) && a.square.min(b.square) > LEAST_SQ;
        if is_certain && a.square.max(b.square) < f64::INFINITY {
            return a.square.total_cmp(&b.square);
        }
        by_length(self.points, a.ends, b.ends)
    }

    fn is_allowed(&self, edge: [u32; 2]) -> bool {
        length_sq(self.points, edge) <= self.limit_sq
    }
}

/// The order of two edges by length. Exact.
fn by_length(points: &[Point], a: [u32; 2], b: [u32; 2]) -> Ordering {
    if a == b {
        return Ordering::Equal;
    }
    compare_lengths(a.map(|v| points[v as usize]), b.map(|v| points[v as usize]))
}

/// The squared length of an edge, rounded.
fn length_sq(points: &[Point], [a, b]: [u32; 2]) -> f64 {
    Point::distance_sq(points[a as usize], points[b as usize])
}

/// The edges of triangles, each from its lower vertex, sorted.
fn edges(triangles: &[[u32; 3]]) -> Vec<[u32; 2]> {
    edges_of(triangles).into_iter().map(EdgeKey::ends).collect()
}
