//! Insertion of a vertex, wherever it lies, in every dimension.

use super::lawson::Lawson;
use crate::half_edge::{FaceId, HalfEdgeId, Journal, VertexId};
use crate::locate::Locus;
use crate::triangulation::{Closure, Triangulation};

/// Inserts unused vertex `v`, whose place is known, and legalises around it.
///
/// Inside a face: one face becomes three. On an edge: two become four, both halves keep the mark.
/// Outside the hull: the ghost that sees the point is split like any face, and flips reach the rest of
/// the visible hull. In lower dimensions: the chain grows, or rises to the plane.
///
/// Returns whether it was inserted: not on a vertex, not outside a domain.
///
/// # Complexity
/// One split and one flip for each further edge at `v`: about three on average.
#[inline]
pub(crate) fn insert_at<const BULK: bool, J: Journal>(
    t: &mut Triangulation,
    v: VertexId,
    locus: Locus,
    lawson: &mut Lawson,
    j: &mut J,
) -> bool {
    match locus {
        Locus::Face(f) => split_face::<BULK, J>(t, f, v, lawson, j),
        Locus::Edge(h) => split_edge::<BULK, J>(t, h, v, lawson, j),
        Locus::Outside(h) if t.closure == Closure::Hull => split_face::<BULK, J>(t, h.face(), v, lawson, j),
        Locus::Vertex(_) | Locus::Outside(_) => return false,
        Locus::Beyond(h) => {
            t.mesh.extend_chain(h, v, j);
        }
        Locus::OffLine(h) => raise(t, h, v, lawson, j),
        Locus::Nowhere => start(t, v, j),
    }
    true
}

#[inline(always)]
fn split_face<const BULK: bool, J: Journal>(
    t: &mut Triangulation,
    f: FaceId,
    v: VertexId,
    lawson: &mut Lawson,
    j: &mut J,
) {
    let faces = if BULK { t.mesh.rewire_split_face(f, v, j) } else { t.mesh.split_face(f, v, j) };
    lawson.legalise_around::<BULK, 3, J>(t, faces.map(|f| f.half_edge(0)), t.point(v), j);
}

fn split_edge<const BULK: bool, J: Journal>(
    t: &mut Triangulation,
    h: HalfEdgeId,
    v: VertexId,
    lawson: &mut Lawson,
    j: &mut J,
) {
    let n = if BULK { t.mesh.rewire_split_edge(h, v, j) } else { t.mesh.split_edge(h, v, j) };
    if t.dimension == 2 {
        let edges = t.mesh.opposite_edges_after_split(h, n);
        lawson.legalise_around::<BULK, 4, J>(t, edges, t.point(v), j);
    }
}

/// From dimension 1 to 2: all ghosts on the side of `v` become faces.
fn raise<J: Journal>(t: &mut Triangulation, h: HalfEdgeId, v: VertexId, lawson: &mut Lawson, j: &mut J) {
    let last = chain_end(t, h);
    let first = t.mesh.twin(chain_end(t, t.mesh.twin(h)));
    let spoke = t.mesh.attach_outside(first, last, v, j);
    t.set_state(2, t.closure, None, j);
    // A fan over collinear points passes the circle test; its edges are tested nevertheless.
    let fan: Vec<HalfEdgeId> = t.mesh.star_from(spoke).collect();
    for h in fan {
        lawson.legalise_around::<false, 1, J>(t, [h.next()], t.point(v), j);
    }
}

/// The last edge of a chain in the direction of `h`.
fn chain_end(t: &Triangulation, h: HalfEdgeId) -> HalfEdgeId {
    let mut edge = h;
    for _ in 0..t.mesh.face_slots() {
        let next = t.mesh.twin(edge.next()).next();
        if next == t.mesh.twin(edge) {
            break;
        }
        edge = next;
    }
    edge
}

/// From dimension −1 to 0, or 0 to 1.
fn start<J: Journal>(t: &mut Triangulation, v: VertexId, j: &mut J) {
    match t.lone {
        None => t.set_state(0, t.closure, Some(v), j),
        Some(a) => {
            t.mesh.start_chain(a, v, j);
            t.set_state(1, t.closure, None, j);
        }
    }
}
