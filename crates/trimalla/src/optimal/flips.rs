//! `flip-max-min-angle`, `flip-min-max-angle`, `flip-shortest-diagonal`: any triangulation, made locally optimal.
//!
//! # Idea
//! Two triangles that form a strictly convex quadrilateral can be exchanged for the two on the other side of its other
//! diagonal. Do so while it makes the quadrilateral better. The result is *locally optimal*: no single flip improves
//! it.
//!
//! ```text
//!       c                 c
//!     ╱   ╲             ╱ │ ╲        max-min-angle: the smallest of the six angles grows
//!    a ─── b    ──>    a  │  b       min-max-angle: the largest of the six angles shrinks
//!     ╲   ╱             ╲ │ ╱        shortest-diagonal: cd is shorter than ab
//!       d                 d
//! ```
//!
//! # Steps
//! 1. Begin with the triangulation that is given (`trimalla triangulate MESH`), or with a sweep over the points.
//! 2. Put all inner edges, segments left out, into a queue.
//! 3. While the queue is not empty, take an edge out of it. If the other diagonal is better, flip it, and put the four
//!    sides of the quadrilateral into the queue.
//!
//! # What is reached
//! *max-min-angle*: the (constrained) Delaunay triangulation, whatever it begins with. No triangulation has a larger
//! smallest angle: the local optimum is global. *The two others*: a local optimum which depends on the beginning, and
//! may be far from the global one. `min-max-angle` and `min-weight` are for that.
//!
//! # Why it ends
//! Each flip makes a list smaller in lexicographic order that never grows: the largest angles of all triangles, sorted
//! downwards; or it makes the sum of the lengths smaller. So no triangulation comes twice.
//!
//! # Degenerate cases
//! *Equal*: an edge stays if the other diagonal is no better, by exact comparison; for `max-min-angle` the tie rule of
//! the circle test decides, so that the result is unique. *Collinear points*: nothing. *Points that are not used by a
//! given triangulation* stay unused.
//!
//! # Complexity
//! O(n²) flips at worst for `max-min-angle`; few flips an edge in practice for all three.
//!
//! # Source
//! `[Triangulaciones]`, part I; `[Lawson77]`; `[EdelsbrunnerTanWaupotitsch92]` for why local optima of the largest
//! angle are not global.

use super::input::{Optimal, OptimalInput, in_order};
use super::{OptimalError, edge_set};
use crate::delaunay::{BuildError, flip_illegal, flip_to_delaunay, sweep};
use crate::drawing::IndexedMesh;
use crate::geometry::{Orientation, Point, Triangle, compare_angles, compare_lengths, orient2d};
use crate::half_edge::{HalfEdgeId, NoJournal, VertexId};
use crate::trace::{Shape, Trace};
use crate::triangulation::Triangulation;

keyed! {
    /// What a flip must improve.
    FlipCriterion, {
        MaxMinAngle = "max-min-angle", "the smallest angle of the quadrilateral grows", "Lawson77";
        MinMaxAngle = "min-max-angle", "the largest angle of the quadrilateral shrinks", "EdelsbrunnerTanWaupotitsch92";
        ShortestDiagonal = "shortest-diagonal", "the diagonal gets shorter", "";
    }
}

/// Flips edges of any triangulation until no flip improves it; returns its triangles.
///
/// # Shape
/// Segments of the mesh are kept, if they are edges. Triangles come in their slots: a triangle that was not touched
/// stays where it was.
///
/// # Guarantees
/// No edge between two triangles, segments left out, has a strictly convex quadrilateral whose other diagonal is
/// better.
///
/// # Errors
/// [`OptimalError::Domain`] names the first fault of the mesh; cancelled.
///
/// # Complexity
/// See the file: O(n²) flips at worst for `max-min-angle`.
///
/// # Source
/// `[Triangulaciones]`, part I; `[Lawson77]`.
///
/// # Examples
/// ```
/// use trimalla::optimal::{FlipCriterion, locally_optimal};
/// use trimalla::trace::NoTrace;
/// use trimalla::{IndexedMesh, Point};
///
/// let points = [[0.0, 0.0], [4.0, -1.0], [8.0, 0.0], [4.0, 1.0]].map(Point::from).to_vec();
/// let mut mesh = IndexedMesh { points, triangles: vec![[0, 1, 2], [0, 2, 3]], ..IndexedMesh::default() };
/// for criterion in FlipCriterion::ALL {
///     assert_eq!(locally_optimal(&mesh, criterion, &mut NoTrace)?.edges(), [[0, 1], [0, 3], [1, 2], [1, 3], [2, 3]]);
/// }
/// mesh.segments = vec![[0, 2]];
/// assert_eq!(locally_optimal(&mesh, FlipCriterion::MaxMinAngle, &mut NoTrace)?.triangles, mesh.triangles);
/// # Ok::<(), trimalla::optimal::OptimalError>(())
/// ```
pub fn locally_optimal(
    mesh: &IndexedMesh,
    criterion: FlipCriterion,
    trace: &mut (impl Trace + ?Sized),
) -> Result<IndexedMesh, OptimalError> {
    let mut t = with_segments(mesh)?;
    tell_given(&t, trace);
    flip(&mut t, criterion, trace)?;
    Ok(IndexedMesh { triangles: triangles_of(&t), ..mesh.clone() })
}

/// The triangulation of a mesh, its segments marked.
fn with_segments(mesh: &IndexedMesh) -> Result<Triangulation, OptimalError> {
    let mut t = Triangulation::from_indexed(mesh).map_err(OptimalError::Domain)?;
    for &[a, b] in &mesh.segments {
        if let Some(h) = t.half_edge_between(VertexId(a), VertexId(b)) {
            t.mesh.set_mark(h, 1, &mut NoJournal);
        }
    }
    Ok(t)
}

/// Step 1 for a triangulation that is given: its edges.
fn tell_given(t: &Triangulation, trace: &mut (impl Trace + ?Sized)) {
    if trace.is_listening() {
        for e in t.edges() {
            trace.add(Shape::Edge([t.origin(e).0, t.dest(e).0]), "given");
        }
    }
}

/// Triangulates points or a domain: a sweep, or the domain as it is, and flips.
pub(super) fn triangulate(
    input: &OptimalInput<'_>,
    criterion: FlipCriterion,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Optimal, OptimalError> {
    let prepared = input.prepare()?;
    let mut t = match input.domain {
        Some(domain) => {
            let t = with_segments(domain)?;
            tell_given(&t, trace);
            t
        }
        None => {
            let vertices: Vec<VertexId> = prepared.vertices.iter().map(|&v| VertexId(v)).collect();
            sweep(input.points, Some(&vertices), trace).map_err(|_| OptimalError::Cancelled)?
        }
    };
    flip(&mut t, criterion, trace)?;
    let triangles = in_order(triangles_of(&t));
    let value = value(input.points, &triangles, criterion);
    Ok(Optimal { triangles, is_proved: criterion == FlipCriterion::MaxMinAngle, value })
}

/// Steps 2 and 3.
fn flip(
    t: &mut Triangulation,
    criterion: FlipCriterion,
    trace: &mut (impl Trace + ?Sized),
) -> Result<u64, OptimalError> {
    let flips = match criterion {
        FlipCriterion::MaxMinAngle => flip_to_delaunay(t, trace),
        FlipCriterion::MinMaxAngle => flip_illegal(t, |t, e| is_better(t, e, is_less_obtuse), trace),
        FlipCriterion::ShortestDiagonal => flip_illegal(t, |t, e| is_better(t, e, is_shorter), trace),
    };
    flips.map_err(|_: BuildError| OptimalError::Cancelled)
}

/// The four corners around an edge from `a` to `b`: `c` to its left, `d` to its right.
type Corners = [Point; 4];

/// Whether the quadrilateral of an edge is strictly convex and the other diagonal passes a test.
fn is_better(t: &Triangulation, e: HalfEdgeId, test: impl Fn(Corners) -> bool) -> bool {
    let [a, b, c, d] = [t.origin(e), t.dest(e), t.apex(e), t.apex(t.twin(e))].map(|v| t.point(v));
    let is_left = |a, b, c| orient2d(a, b, c) == Orientation::CounterClockwise;
    is_left(c, a, d) && is_left(d, b, c) && test([a, b, c, d])
}

fn is_shorter([a, b, c, d]: Corners) -> bool {
    compare_lengths([c, d], [a, b]).is_lt()
}

fn is_less_obtuse([a, b, c, d]: Corners) -> bool {
    let largest_of = |one: [Point; 3], other: [Point; 3]| {
        let (one, other) = (largest_angle(one), largest_angle(other));
        if compare_angles(one, other).is_ge() { one } else { other }
    };
    compare_angles(largest_of([c, a, d], [d, b, c]), largest_of([a, b, c], [b, a, d])).is_lt()
}

/// The corners of a triangle from that of its largest angle on, which is opposite a longest side.
fn largest_angle(mut t: [Point; 3]) -> [Point; 3] {
    let side = |t: [Point; 3], i: usize| [t[(i + 1) % 3], t[(i + 2) % 3]];
    let longest = (1..3).fold(0, |best, i| if compare_lengths(side(t, i), side(t, best)).is_gt() { i } else { best });
    t.rotate_left(longest);
    t
}

fn triangles_of(t: &Triangulation) -> Vec<[u32; 3]> {
    t.real_faces().map(|f| t.face_vertices(f).map(|v| v.0)).collect()
}

/// The smallest or the largest angle in radians, or the sum of the lengths.
fn value(points: &[Point], triangles: &[[u32; 3]], criterion: FlipCriterion) -> f64 {
    let shapes = triangles.iter().map(|t| {
        let [a, b, c] = t.map(|v| points[v as usize]);
        Triangle::new(a, b, c)
    });
    match criterion {
        FlipCriterion::MaxMinAngle => shapes.map(|t| t.min_angle().radians()).fold(f64::INFINITY, f64::min),
        FlipCriterion::MinMaxAngle => shapes.map(|t| t.max_angle().radians()).fold(0.0, f64::max),
        FlipCriterion::ShortestDiagonal => edge_set::total_length(points, triangles),
    }
}
