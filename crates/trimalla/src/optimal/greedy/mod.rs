//! `greedy` and `greedy-naive`: the shortest edges first.
//!
//! # Idea
//! Take all pairs of vertices from the shortest to the longest, and join each pair that crosses nothing so far. The
//! edges are short where they can be, and their sum is near the least one possible, though not always within a
//! constant factor of it.
//!
//! ```text
//!     ·────────·           ab comes before cd and forbids it, also where cd and other edges together
//!     │ ╲    c │           would have been shorter
//!     │   a    │
//!     │    ╲   │
//!     ·─────b──d
//! ```
//!
//! # Steps
//! 1. List the pairs. The naive way lists all. The fast way leaves out what cannot come up: see [`candidates`].
//! 2. Sort them by length, exactly; ties by the indices of the vertices.
//! 3. Take one after the other. Refuse a pair if a vertex lies on it, or if it crosses an edge that was taken. The
//!    naive way compares it with all edges, the fast way with those that are near: see [`crossings`].
//! 4. End when there are as many edges as every triangulation has.
//! 5. Read the triangles from the edges.
//!
//! # Degenerate cases
//! *Equal lengths*, as in grids: the pair with the lower smaller index first, then the lower larger one, so that the
//! result is unique. *Collinear vertices*: only neighbours on the line are joined. *Equal points*: the first one is
//! the vertex.
//!
//! # Complexity
//! Naive: O(n³) time, O(n²) memory. Fast: O(n log n) expected for points spread evenly, O(n) memory; O(n²) candidates
//! and O(n³) time at worst. With a domain, the candidates are all pairs that see each other: O(n²) memory.
//!
//! # How near the least weight
//! At worst the sum is O(√n) times the least one `[LevcopoulosKrznaric98]`. Measured: 1.001 times for 1000 and for
//! 10,000 points spread evenly, 1.0001 times for a star of 300 corners.
//!
//! The *quasi-greedy* triangulation of Levcopoulos and Krznaric takes another edge than the shortest in some places,
//! and stays within a constant factor. It is not built. The constant is "astronomically large" `[YousefiYoung14]`, and
//! a rule of this kind that we tried (before a pair closes a triangle, a pair at its third corner at most a tenth
//! longer is taken instead) made sums of random points longer. For less than greedy there is `min-weight`, which proves
//! the least sum of 100,000 points in seconds, and `min-weight-polygon`.
//!
//! # Source
//! `[DickersonEtAl97]` for the plan of the fast way; `[DasJoseph89]` for the diamond test. Their test of crossings
//! needs the edges around each vertex in order; ours needs the Delaunay triangulation, and takes any set of
//! candidates.

mod candidates;
mod crossings;

use super::edge_set;
use super::input::Prepared;
use super::{Optimal, OptimalError, OptimalInput, pairs};
use crate::delaunay::{AlgorithmKey, BuildError};
use crate::geometry::{Point, compare_lengths, order_if_clear};
use crate::half_edge::VertexId;
use crate::trace::{Shape, Trace};
use crate::triangulation::Triangulation;
use crossings::Crossings;

/// How many pairs may be sorted: 1.6 GB.
const MAX_PAIRS: usize = 1 << 26;

/// An error if there are too many pairs.
const fn check_pairs(count: usize) -> Result<(), OptimalError> {
    if count > MAX_PAIRS { Err(OptimalError::TooManyPairs { count, limit: MAX_PAIRS }) } else { Ok(()) }
}

/// All pairs in order of length, each compared with all edges.
pub(super) fn naive(input: &OptimalInput<'_>, trace: &mut (impl Trace + ?Sized)) -> Result<Optimal, OptimalError> {
    let prepared = input.prepare()?;
    let vertices = &prepared.vertices;
    check_pairs(vertices.len().saturating_mul(vertices.len()) / 2)?;
    let all = vertices.iter().enumerate().flat_map(|(i, &u)| vertices[i + 1..].iter().map(move |&v| [u, v]));
    let mut pairs: Vec<[u32; 2]> = all.collect();
    sort_by_length(input.points, &mut pairs);
    pairs::join(input.points, &prepared, pairs.into_iter(), trace)
}

/// Candidates in order of length, each compared with the edges near it.
pub(super) fn fast(input: &OptimalInput<'_>, trace: &mut (impl Trace + ?Sized)) -> Result<Optimal, OptimalError> {
    let prepared = input.prepare()?;
    let Some(t) = underlying(input, &prepared)? else { return Ok(Optimal::default()) };
    // Step 1.
    let mut pairs = match input.domain {
        None => candidates::by_diamonds(input.points, &prepared.vertices, trace)?,
        Some(_) => candidates::by_sight(&t, trace)?,
    };
    // Step 2.
    sort_by_length(input.points, &mut pairs);
    let edges = join(&t, &prepared, &pairs, trace)?;
    // Step 5.
    let triangles = edge_set::triangles(input.points, &prepared, &edges);
    let value = edge_set::total_length(input.points, &triangles);
    Ok(Optimal { triangles, is_proved: false, value })
}

/// Step 2: by length, then by vertices. Each pair has its smaller vertex first.
fn sort_by_length(points: &[Point], pairs: &mut [[u32; 2]]) {
    let ends = |pair: [u32; 2]| pair.map(|v| points[v as usize]);
    // Rounded lengths beside the pairs, so that most comparisons read no point.
    let keyed = |&pair: &[u32; 2]| {
        let [a, b] = ends(pair);
        (Point::distance_sq(a, b), pair)
    };
    let mut sorted: Vec<(f64, [u32; 2])> = pairs.iter().map(keyed).collect();
    let order = |&(length, pair): &(f64, [u32; 2]), &(other_length, other): &(f64, [u32; 2])| {
        order_if_clear(length, other_length)
            .unwrap_or_else(|| compare_lengths(ends(pair), ends(other)).then(pair.cmp(&other)))
    };
    sorted.sort_unstable_by(order);
    for (pair, (_, there)) in pairs.iter_mut().zip(sorted) {
        *pair = there;
    }
}

/// The triangulation in which crossings are looked for; `None` if there is no triangle.
fn underlying(input: &OptimalInput<'_>, prepared: &Prepared) -> Result<Option<Triangulation>, OptimalError> {
    let t = match input.domain {
        // The domain has been checked.
        Some(domain) => Triangulation::from_indexed(domain).unwrap_or_default(),
        None => {
            let vertices: Vec<VertexId> = prepared.vertices.iter().map(|&v| VertexId(v)).collect();
            match AlgorithmKey::Incremental.triangulate(input.points, Some(&vertices)) {
                Ok(t) => t,
                Err(BuildError::TooManyPoints(count)) => {
                    return Err(OptimalError::TooMany { count, limit: BuildError::MAX_POINTS });
                }
                Err(_) => return Ok(None),
            }
        }
    };
    Ok((t.dimension() == 2).then_some(t))
}

/// Steps 3 and 4.
fn join(
    t: &Triangulation,
    prepared: &Prepared,
    pairs: &[[u32; 2]],
    trace: &mut (impl Trace + ?Sized),
) -> Result<Vec<[u32; 2]>, OptimalError> {
    let most = t.edges().count();
    let mut taken = Crossings::new(t);
    for edge in prepared.fixed() {
        trace.add(Shape::Edge(edge), "an edge of the drawing");
        taken.take_edge(edge);
    }
    for &pair in pairs {
        if taken.edges().len() == most {
            break;
        }
        if trace.is_cancelled() {
            return Err(OptimalError::Cancelled);
        }
        trace.look(Shape::Edge(pair), "the shortest pair that is left");
        match taken.take(pair) {
            Ok(()) => trace.add(Shape::Edge(pair), "crosses nothing"),
            Err(why) => trace.refuse(Shape::Edge(pair), why),
        }
    }
    Ok(taken.into_edges())
}
