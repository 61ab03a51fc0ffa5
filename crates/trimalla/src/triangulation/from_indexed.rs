//! From plain arrays to half-edges: the same triangles in the same slots, closed by ghosts.
//!
//! 1. Triangle `t` becomes face `t`, its corners in the order given; sides that run opposite ways between the same two
//!    vertices become twins.
//! 2. What is left has no triangle beyond: the boundary. Each boundary half-edge gets a ghost, and the ghosts around a
//!    vertex meet where the outside is.
//! 3. Where the boundary touches itself in a vertex, several fans of triangles meet there. Their first edges are put in
//!    order around the vertex by exact signs, and each fan is joined to the one before it:
//!
//! ```text
//!        \ fan 2 /                a: fan 1 from a→b to a→c, fan 2 from a→d to a→e, counter-clockwise
//!       e \     / d
//!     ∞    \   /    ∞             turning clockwise from a→d through the outside, a→c is met first:
//!           \ /                   the ghost of a→d meets that of c→a
//!    ────c── a ──b────
//!          fan 1
//! ```
//!
//! Degenerate cases: no two fans begin in one direction, or their triangles would overlap, which is checked before.

use std::cmp::Ordering;

use super::{Closure, MeshFault, Triangulation, check_mesh};
use crate::drawing::{IndexedMesh, Side, Sides};
use crate::geometry::{Orientation, Point, lexicographic, orient2d};
use crate::half_edge::{Boundary, FaceId, HalfEdgeId, HalfEdgeMesh, NoJournal, VertexId};

impl Triangulation {
    /// The triangulation that has exactly the triangles of a mesh, in their order, closed by its boundary.
    ///
    /// Nothing is marked yet, and nothing need be Delaunay. A mesh without triangles gives a triangulation of nothing.
    ///
    /// # Guarantees
    /// Face `t` is triangle `t`, its half-edge `k` starts at corner `k`. Vertices keep their indices; those that no
    /// triangle uses stay unused, and are noted as duplicates where they lie exactly on one that is used.
    ///
    /// # Errors
    /// Every fault that [`check_mesh`] finds.
    ///
    /// # Complexity
    /// O(n log n).
    pub fn from_indexed(mesh: &IndexedMesh) -> Result<Self, Vec<MeshFault>> {
        let faults = check_mesh(mesh);
        if !faults.is_empty() {
            return Err(faults);
        }
        let mut t = Self::of_unused(mesh.points.clone());
        if mesh.triangles.is_empty() {
            return Ok(t);
        }
        t.mesh = closed_half_edges(mesh);
        t.set_state(2, Closure::Domain, None, &mut NoJournal);
        t.duplicates = unused_on_others(&t);
        Ok(t)
    }
}

/// The half-edges of a sound mesh, closed by ghosts.
///
/// # Complexity
/// Linear, and n log n in the degree of each vertex.
pub(crate) fn closed_half_edges(mesh: &IndexedMesh) -> HalfEdgeMesh {
    let sides = Sides::of(mesh);
    let mut closed = half_edges(mesh, &sides);
    close(&mut closed, mesh, &sides);
    closed
}

/// Step 1.
fn half_edges(mesh: &IndexedMesh, sides: &Sides) -> HalfEdgeMesh {
    let origin = mesh.triangles.iter().flatten().map(|&v| VertexId(v)).collect();
    let mut twin = vec![HalfEdgeId::NONE; 3 * mesh.triangles.len()];
    for side in sides.iter() {
        if let Some(beyond) = sides.find(side.dest, side.origin) {
            twin[half_edge(mesh, side).index()] = half_edge(mesh, beyond);
        }
    }
    HalfEdgeMesh::from_arrays(origin, twin, mesh.points.len())
}

/// The half-edge of a side.
fn half_edge(mesh: &IndexedMesh, side: &Side) -> HalfEdgeId {
    let corner = mesh.triangles[side.triangle].iter().position(|&v| v == side.origin).unwrap_or(0);
    FaceId::from_index(side.triangle).half_edge(corner as u32)
}

/// Steps 2 and 3.
fn close(half_edges: &mut HalfEdgeMesh, mesh: &IndexedMesh, sides: &Sides) {
    let mut boundary: Vec<Side> = sides.boundary().copied().collect();
    boundary.sort_unstable_by_key(|s| (s.origin, s.dest));
    let mut before = Vec::with_capacity(boundary.len());
    for at_vertex in boundary.chunk_by_mut(|s, r| s.origin == r.origin) {
        let point = |v: u32| mesh.points[v as usize];
        at_vertex.sort_unstable_by(|s, r| around(point(s.origin), point(s.dest), point(r.dest)));
        let ends: Vec<HalfEdgeId> = at_vertex.iter().map(|s| half_edge(mesh, &end_of_fan(sides, *s))).collect();
        before.extend((0..ends.len()).map(|i| ends[(i + ends.len() - 1) % ends.len()]));
    }
    let edges: Vec<HalfEdgeId> = boundary.iter().map(|s| half_edge(mesh, s)).collect();
    half_edges.close_boundary(&Boundary { edges, before }, &vec![0; boundary.len()], &mut NoJournal);
}

/// The boundary side that ends at the origin of a boundary side, in the same fan of triangles.
fn end_of_fan(sides: &Sides, first: Side) -> Side {
    let v = first.origin;
    let mut out = first;
    for _ in sides.from(v) {
        match sides.find(v, out.apex) {
            Some(next) => out = *next,
            None => break,
        }
    }
    Side { origin: out.apex, dest: v, apex: out.dest, triangle: out.triangle }
}

/// The order of directions around a point, counter-clockwise from the positive x axis on.
fn around(center: Point, p: Point, q: Point) -> Ordering {
    let below = |p: Point| p.y < center.y || (p.y == center.y && p.x < center.x);
    let by_turn = || match orient2d(center, p, q) {
        Orientation::CounterClockwise => Ordering::Less,
        Orientation::Collinear => Ordering::Equal,
        Orientation::Clockwise => Ordering::Greater,
    };
    below(p).cmp(&below(q)).then_with(by_turn)
}

/// Unused vertices that lie exactly on others, with the one that stands for all there, sorted: the one in use, else the
/// first.
fn unused_on_others(t: &Triangulation) -> Vec<(VertexId, VertexId)> {
    let mut order: Vec<VertexId> =
        (0..t.points.len()).map(VertexId::from_index).filter(|&v| t.point(v).is_finite()).collect();
    order.sort_unstable_by(|&a, &b| lexicographic(t.point(a), t.point(b)).then(a.cmp(&b)));
    let mut duplicates = Vec::new();
    for same in order.chunk_by(|&a, &b| t.point(a) == t.point(b)) {
        let kept = same.iter().copied().find(|&v| t.is_used(v)).unwrap_or(same[0]);
        duplicates.extend(same.iter().filter(|&&v| v != kept).map(|&v| (v, kept)));
    }
    duplicates.sort_unstable();
    duplicates
}
