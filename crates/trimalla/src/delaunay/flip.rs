//! `flip`: any triangulation, then flips until every edge is legal.
//!
//! # Idea
//! An edge between two triangles that form a convex quadrilateral is *illegal* if the circle of one triangle holds the
//! opposite corner of the other. The *positive flip* replaces it by the other diagonal, which is legal then and raises
//! the smallest angle of the two triangles. A triangulation without illegal edges is Delaunay.
//!
//! ```text
//!         c                      c
//!       /   \                  / │ \
//!      /     \                /  │  \          the circle of a, b, c holds d:
//!     a ───── b      ──>     a   │   b         ab is illegal, cd is legal
//!      \     /                \  │  /
//!       \   /                  \ │ /           the four sides may have become illegal: back into the queue
//!         d                      d
//! ```
//!
//! # Steps
//! 1. Triangulate by a sweep: sort the points, and join each to the edges of the hull that it sees. The result has long
//!    thin triangles.
//! 2. Put all inner edges into a queue.
//! 3. While the queue is not empty, take an edge out of it. If it is illegal, flip it, and put the four sides of the
//!    quadrilateral into the queue.
//!
//! # Why it ends
//! On the paraboloid (see `lift`), a positive flip replaces two triangles by the two below them: the surface
//! sinks, and no edge comes back. There are O(n²) edges.
//!
//! # Degenerate cases
//! *Cocircular points*: the tie rule of [`in_circle_perturbed`] says which diagonal is legal, so the result is unique.
//! *Collinear points*: their chain; nothing is flipped. *Points on the hull's sides* are vertices of the hull from the
//! sweep on. The quadrilateral of an illegal edge is always strictly convex.
//!
//! # Complexity
//! O(n log n) for the sweep, O(n²) flips at worst. O(n) memory: an edge is in the queue once.
//!
//! # Source
//! `[Triangulaciones]`, part I; `[Lawson77]`.

use std::collections::VecDeque;

use super::delaunay::BuildError;
use super::sites::Sites;
use crate::geometry::{CircleSide, Orientation, Point, in_circle_perturbed, orient2d};
use crate::half_edge::{HalfEdgeId, HalfEdgeMesh, NoJournal, VertexId};
use crate::trace::{Shape, Trace};
use crate::triangulation::Triangulation;

/// Triangulates `points[i]` for `i` in `subset` (all where `None`).
///
/// # Errors
/// Cancelled.
pub(super) fn build(
    points: &[Point],
    subset: Option<&[VertexId]>,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Triangulation, BuildError> {
    let mut t = sweep(points, subset, trace)?;
    flip_to_delaunay(&mut t, trace)?;
    Ok(t)
}

/// Flips illegal edges of any triangulation until there are none; returns how many flips there were.
///
/// # Shape
/// Edges of the boundary and edges with marks stay: a triangulation closed by its domain becomes the constrained
/// Delaunay triangulation of its boundary.
///
/// # Guarantees
/// Every other edge passes the circle test of [`in_circle_perturbed`]: the result is unique.
///
/// # Errors
/// Cancelled: some edges may be illegal then, and the triangulation is sound.
///
/// # Complexity
/// O(n²) flips at worst.
///
/// # Source
/// `[Triangulaciones]`, part I; `[Lawson77]`.
///
/// # Examples
/// ```
/// use trimalla::delaunay::flip_to_delaunay;
/// use trimalla::trace::NoTrace;
/// use trimalla::triangulation::Triangulation;
/// use trimalla::{IndexedMesh, Point};
///
/// let points = [[0.0, 0.0], [4.0, -1.0], [8.0, 0.0], [4.0, 1.0]].map(Point::from).to_vec();
/// let mesh = IndexedMesh { points, triangles: vec![[0, 1, 2], [0, 2, 3]], ..IndexedMesh::default() };
/// let mut t = Triangulation::from_indexed(&mesh).expect("a sound mesh");
/// assert_eq!(flip_to_delaunay(&mut t, &mut NoTrace), Ok(1));
/// ```
pub fn flip_to_delaunay(t: &mut Triangulation, trace: &mut (impl Trace + ?Sized)) -> Result<u64, BuildError> {
    flip_illegal(t, |t, e| !passes_circle_test(t, e), trace)
}

/// Steps 2 and 3: flips illegal edges until there are none; returns how many flips there were.
///
/// # Shape
/// Only edges without marks between two triangles are asked for. An edge may be illegal only if its quadrilateral is
/// strictly convex, and if a flip makes something better that never gets worse, so that no triangulation comes twice.
///
/// # Errors
/// Cancelled.
pub(crate) fn flip_illegal(
    t: &mut Triangulation,
    is_illegal: impl Fn(&Triangulation, HalfEdgeId) -> bool,
    trace: &mut (impl Trace + ?Sized),
) -> Result<u64, BuildError> {
    let mut queue = EdgeQueue::of_inner_edges(t);
    let mut flips = 0;
    while let Some(e) = queue.pop() {
        if trace.is_cancelled() {
            return Err(BuildError::Cancelled);
        }
        // A flip gives half-edges to other edges: what waits may be an edge of the boundary now.
        if !may_be_flipped(t, e) {
            continue;
        }
        let edge = ends(t, e);
        trace.look(Shape::Edge(edge), "is it legal?");
        if !is_illegal(t, e) {
            continue;
        }
        trace.remove(Shape::Edge(edge), "illegal");
        let diagonal = t.mesh.flip(e, &mut NoJournal);
        trace.add(Shape::Edge(ends(t, diagonal)), "legal");
        flips += 1;
        let twin = t.twin(diagonal);
        [diagonal.next(), diagonal.prev(), twin.next(), twin.prev()].into_iter().for_each(|side| queue.push(t, side));
    }
    Ok(flips)
}

/// Edges to test, each once.
#[derive(Debug)]
struct EdgeQueue {
    waiting: VecDeque<HalfEdgeId>,
    is_waiting: Vec<bool>,
}

impl EdgeQueue {
    fn of_inner_edges(t: &Triangulation) -> Self {
        let mut queue = Self { waiting: VecDeque::new(), is_waiting: vec![false; 3 * t.face_slots()] };
        t.edges().for_each(|e| queue.push(t, e));
        queue
    }

    /// Puts an edge in, if it lies between two triangles and has no mark.
    fn push(&mut self, t: &Triangulation, e: HalfEdgeId) {
        let is_waiting = self.is_waiting[e.index()] || self.is_waiting[t.twin(e).index()];
        if may_be_flipped(t, e) && !is_waiting {
            self.is_waiting[e.index()] = true;
            self.waiting.push_back(e);
        }
    }

    fn pop(&mut self) -> Option<HalfEdgeId> {
        let e = self.waiting.pop_front()?;
        self.is_waiting[e.index()] = false;
        Some(e)
    }
}

/// Whether an edge lies between two triangles and has no mark.
fn may_be_flipped(t: &Triangulation, e: HalfEdgeId) -> bool {
    t.is_real(e.face()) && t.is_real(t.twin(e).face()) && !t.is_marked(e)
}

fn ends(t: &Triangulation, e: HalfEdgeId) -> [u32; 2] {
    [t.origin(e).0, t.dest(e).0]
}

/// Whether the apex on one side of an edge is not inside the circle of the face on the other.
fn passes_circle_test(t: &Triangulation, e: HalfEdgeId) -> bool {
    let [a, b, c, d] = [t.origin(e), t.dest(e), t.apex(e), t.apex(t.twin(e))].map(|v| t.point(v));
    in_circle_perturbed(a, b, c, d) != CircleSide::Inside
}

/// Step 1: a triangulation by a sweep in lexicographic order.
///
/// ```text
///            ·──── b          the hull before p: its edges that p sees are next to the vertex before, as p comes later
///          ·      / \         in the order than all of them
///         ·      /    p
///          ·    /   /
///            ·─ a               a is the last vertex
/// ```
///
/// # Errors
/// Cancelled.
pub(crate) fn sweep(
    points: &[Point],
    subset: Option<&[VertexId]>,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Triangulation, BuildError> {
    let sites = Sites::gather(points, subset);
    let at = |v: u32| points[v as usize];
    let &[a, b, ..] = &sites.order[..] else { return Ok(sites.close(points, None)) };
    let is_on_line = |&v: &u32| orient2d(at(a), at(b), at(v)) == Orientation::Collinear;
    let chain = sites.order.iter().take_while(|v| is_on_line(v)).count();
    for pair in sites.order[..chain].windows(2) {
        trace.add(Shape::Edge([pair[0], pair[1]]), "the first points are on one line");
    }
    if chain == sites.order.len() {
        return Ok(sites.close_chain(points));
    }
    let name = |i: usize| VertexId(sites.order[i]);
    let mut mesh = HalfEdgeMesh::with_vertices(points.len());
    let mut last = mesh.start_chain(name(0), name(1), &mut NoJournal);
    for i in 2..chain {
        last = mesh.extend_chain(last, name(i), &mut NoJournal);
    }
    for i in chain..sites.order.len() {
        if trace.is_cancelled() {
            return Err(BuildError::Cancelled);
        }
        last = join_to_hull(&mut mesh, points, last, name(i), trace);
    }
    Ok(sites.close(points, Some(mesh)))
}

/// Joins a vertex to the edges of the hull that it sees; returns the edge of the new hull that ends in it.
///
/// Edges of the hull are half-edges of ghosts, with the outside to their left; `last` ends in the last vertex. As `p`
/// comes after all others, it sees an edge at the last vertex.
fn join_to_hull(
    mesh: &mut HalfEdgeMesh,
    points: &[Point],
    last: HalfEdgeId,
    p: VertexId,
    trace: &mut (impl Trace + ?Sized),
) -> HalfEdgeId {
    let sees = |mesh: &HalfEdgeMesh, edge: HalfEdgeId| {
        let [a, b] = [mesh.origin(edge), mesh.dest(edge)].map(|v| points[v.index()]);
        orient2d(a, b, points[p.index()]) == Orientation::CounterClockwise
    };
    let after = |mesh: &HalfEdgeMesh, edge: HalfEdgeId| mesh.twin(edge.next()).next();
    let before = |mesh: &HalfEdgeMesh, edge: HalfEdgeId| mesh.twin(edge.prev()).prev();
    // The edges that are seen are consecutive, on both sides of the last vertex.
    let (mut first, mut end) = (after(mesh, last), last);
    while sees(mesh, before(mesh, first)) {
        first = before(mesh, first);
        trace.add(Shape::Edge([mesh.origin(first).0, p.0]), "the hull's edge is seen");
    }
    while sees(mesh, after(mesh, end)) {
        end = after(mesh, end);
        trace.add(Shape::Edge([mesh.dest(end).0, p.0]), "the hull's edge is seen");
    }
    trace.add(Shape::Edge([mesh.dest(last).0, p.0]), "the last vertex is seen");
    let from_p = mesh.attach_outside(first, end, p, &mut NoJournal);
    mesh.twin(from_p)
}
