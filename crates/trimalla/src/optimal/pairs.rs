//! `pairs`: the first algorithm of the lecture notes.
//!
//! # Idea
//! Any maximal set of edges that do not cross is a triangulation. So take the pairs of vertices in the order of
//! their indices, and join each pair that crosses nothing so far. The triangulation is correct and may be bad: its
//! edges are long, as nobody asked which pairs are near each other.
//!
//! ```text
//!     3 ───────── 2       order 01 02 03 12 13 23: the pair 13 comes after 02, crosses it, and is refused
//!     │        ╱  │
//!     │     ╱     │
//!     │  ╱        │
//!     0 ───────── 1
//! ```
//!
//! # Steps
//! 1. Take the boundary of the domain, if there is one.
//! 2. For each pair of vertices in the order of their indices: refuse it if a vertex lies on it, if it crosses an
//!    edge
//!    that was taken, or if it lies outside the domain; else take it.
//! 3. Read the triangles from the edges: [`edge_set`].
//!
//! # Degenerate cases
//! Collinear vertices: only neighbours on the line are joined. Equal points: the first one is the vertex. All
//! vertices on one line: no triangle.
//!
//! # Complexity
//! O(n³): O(n²) pairs, each tested against O(n) vertices and edges. The notes say O(n²), which counts a test as one
//! step. O(n) memory.
//!
//! # Source
//! `[Triangulaciones]`, part I.

use super::edge_set;
use super::input::Prepared;
use super::{Optimal, OptimalError, OptimalInput};
use crate::geometry::{Point, SegmentContact, segment_contact, strictly_between};
use crate::trace::{Shape, Trace};

/// Joins pairs in the order of their indices.
pub(super) fn triangulate(
    input: &OptimalInput<'_>,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Optimal, OptimalError> {
    let prepared = input.prepare()?;
    let vertices = &prepared.vertices;
    let pairs = vertices.iter().enumerate().flat_map(|(i, &u)| vertices[i + 1..].iter().map(move |&v| [u, v]));
    join(input.points, &prepared, pairs, trace)
}

/// Joins each pair that a sequence names if nothing is in its way.
///
/// # Errors
/// Cancelled.
///
/// # Complexity
/// O(n) a pair.
pub(super) fn join(
    points: &[Point],
    prepared: &Prepared,
    pairs: impl Iterator<Item = [u32; 2]>,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Optimal, OptimalError> {
    let mut edges: Vec<[u32; 2]> = prepared.fixed().collect();
    for &edge in &edges {
        trace.add(Shape::Edge(edge), "an edge of the drawing");
    }
    for pair in pairs {
        if trace.is_cancelled() {
            return Err(OptimalError::Cancelled);
        }
        trace.look(Shape::Edge(pair), "a pair");
        match obstacle(points, prepared, &edges, pair) {
            Some(why) => trace.refuse(Shape::Edge(pair), why),
            None => {
                trace.add(Shape::Edge(pair), "crosses nothing");
                edges.push(pair);
            }
        }
    }
    let triangles = edge_set::triangles(points, prepared, &edges);
    let value = edge_set::total_length(points, &triangles);
    Ok(Optimal { triangles, is_proved: false, value })
}

/// Why a pair is not joined, if there is a reason.
fn obstacle(points: &[Point], prepared: &Prepared, edges: &[[u32; 2]], pair: [u32; 2]) -> Option<&'static str> {
    let at = |v: u32| points[v as usize];
    let [p, q] = pair.map(at);
    if prepared.vertices.iter().any(|&v| strictly_between(p, q, at(v))) {
        return Some("passes through a vertex");
    }
    for &[a, b] in edges {
        if [a, b] == pair || [b, a] == pair {
            return Some("is an edge already");
        }
        if segment_contact(p, q, at(a), at(b)) == SegmentContact::Crossing {
            return Some("crosses an edge");
        }
    }
    (!prepared.starts_inside(points, pair[0], pair[1])).then_some("lies outside the domain")
}
