//! Removal of a vertex, in every dimension.
//!
//! 1. Flip spokes away while the two faces beside one form a strictly convex quadrilateral. A star-shaped
//!    polygon always has such an ear, until one of these is left:
//! 2. * three faces around an inner vertex: they become one;
//!    * four, the vertex on a diagonal of its neighbours: they become two (also on the boundary);
//!    * a vertex on the hull whose neighbours form a convex path: the path is the new hull.
//! 3. The edges beside the hole's rim and those that flips made go to Lawson's loop: all there are inside.
//!
//! Each flip takes a spoke away, so there are fewer flips than neighbours; each is found by looking at the
//! neighbours of the last. The result is the (constrained) Delaunay triangulation without the vertex,
//! because Lawson's loop ends in no other.

use super::lawson::Lawson;
use crate::geometry::{Point, strictly_between};
use crate::half_edge::{HalfEdgeId, Journal, VertexId};
use crate::triangulation::{Closure, Triangulation};

/// Why a vertex cannot be removed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RemoveError {
    /// The vertex does not exist or is not part of the triangulation.
    #[error("vertex {0} is not used")]
    Unused(VertexId),
    /// A constrained edge ends at the vertex.
    #[error("vertex {vertex} at {point} is an end of a constrained edge")]
    Constrained {
        /// The vertex.
        vertex: VertexId,
        /// Where it lies.
        point: Point,
    },
    /// The place a vertex should move to is not finite.
    #[error("vertex cannot move to {0}, which is not finite")]
    NotFinite(Point),
}

/// The edges of the hole that a vertex leaves, kept between removals so that none allocates.
#[derive(Clone, Debug, Default)]
pub(crate) struct Hole {
    /// The half-edges outside the rim.
    rim: Vec<HalfEdgeId>,
    /// Spokes that may be flipped away.
    spokes: Vec<HalfEdgeId>,
    /// The edges that flips made, as half-edges with the ear on their left.
    made: Vec<HalfEdgeId>,
}

impl Hole {
    /// Notes the rim of the star of a vertex, before anything changes.
    pub(crate) fn begin(&mut self, t: &Triangulation, v: VertexId) {
        self.rim.clear();
        self.rim.extend(t.star(v).map(|h| t.twin(h.next())));
    }
}

/// Takes `v` out of the triangulation; it stays as an unused vertex.
pub(crate) fn remove_vertex<J: Journal>(
    t: &mut Triangulation,
    v: VertexId,
    lawson: &mut Lawson,
    j: &mut J,
) -> Result<(), RemoveError> {
    if v.index() >= t.points.len() || !t.is_used(v) {
        return Err(RemoveError::Unused(v));
    }
    if t.star(v).any(|h| t.is_marked(h)) {
        return Err(RemoveError::Constrained { vertex: v, point: t.point(v) });
    }
    match t.dimension {
        0 => t.set_state(-1, t.closure, None, j),
        1 => remove_from_chain(t, v, j),
        _ => {
            let mut hole = std::mem::take(&mut lawson.hole);
            hole.begin(t, v);
            let neighbour = t.neighbours(v).next();
            flip_spokes_away(t, v, &mut hole, j);
            take_out(t, v, j);
            lower_dimension(t, neighbour, j);
            legalise_hole(t, &hole, lawson, j);
            lawson.hole = hole;
        }
    }
    t.forget_duplicates_of(v, j);
    Ok(())
}

/// Legalises every edge of the hole: those beside its rim, and those that flips made. Both are kept as half-edges away
/// from the vertex, which flips and unsplits leave where they are.
#[inline(never)] // Keeps the caller's loops small.
pub(crate) fn legalise_hole<J: Journal>(t: &mut Triangulation, hole: &Hole, lawson: &mut Lawson, j: &mut J) {
    if t.dimension < 2 {
        return;
    }
    for &outer in hole.rim.iter().filter(|o| t.is_alive(o.face())) {
        for h in t.twin(outer).face().half_edges() {
            lawson.push(h);
        }
    }
    for &h in &hole.made {
        lawson.push(t.twin(h));
    }
    lawson.legalise_all(t, j);
}

/// Where removal left no face, what is left is a chain: in the plane every vertex has a real face.
fn lower_dimension<J: Journal>(t: &mut Triangulation, neighbour: Option<VertexId>, j: &mut J) {
    if neighbour.is_some_and(|w| t.star(w).all(|h| t.is_ghost(h.face()))) {
        t.set_state(1, t.closure, None, j);
    }
}

fn remove_from_chain<J: Journal>(t: &mut Triangulation, v: VertexId, j: &mut J) {
    let edges: Vec<HalfEdgeId> = t.edges_around(v).collect();
    match edges[..] {
        [h, g] if t.dest(h) != t.dest(g) => {
            t.mesh.unsplit_edge(h, j);
        }
        [h, ..] => {
            let other = t.dest(h);
            if t.degree(other) > 1 {
                let towards = t.twin(h);
                t.mesh.shorten_chain(towards, j);
            } else {
                t.mesh.end_chain(h, j);
                t.set_state(0, t.closure, Some(other), j);
            }
        }
        [] => {}
    }
}

/// Flips spokes of `v` away as long as one is an ear, and notes the edges made.
#[inline(never)] // Keeps the caller's loops small.
pub(crate) fn flip_spokes_away<J: Journal>(t: &mut Triangulation, v: VertexId, hole: &mut Hole, j: &mut J) {
    let Hole { spokes, made, .. } = hole;
    spokes.clear();
    made.clear();
    spokes.extend(t.star(v));
    while let Some(h) = spokes.pop() {
        // A spoke that was flipped away no longer starts at v.
        if t.origin(h) != v || !is_ear(t, h) {
            continue;
        }
        let (a, c) = (t.dest(t.cw(h)), t.dest(t.ccw(h)));
        made.push(t.mesh.flip(h, j));
        // The neighbours' ears changed; find their spokes again, their slots may have moved.
        spokes.extend(t.star(v).filter(|&s| t.dest(s) == a || t.dest(s) == c));
    }
}

/// Whether spoke `h` = v→b between neighbours a (clockwise) and c (counter-clockwise) can be flipped:
/// (a, b, c) and (a, c, v) are strictly counter-clockwise.
///
/// ```text
///          c                   c
///        / | \               /   \
///       v ─h─ b     ──>     v     b
///        \ | /               \   /         (and the edge a–c)
///          a                   a
/// ```
fn is_ear(t: &Triangulation, h: HalfEdgeId) -> bool {
    let (before, after) = (t.cw(h), t.ccw(h));
    let (a, b, c) = (t.dest(before), t.dest(h), t.dest(after));
    let finite = a.is_finite() && b.is_finite() && c.is_finite();
    // Between two constrained spokes the last one stays: it is what their merging needs.
    let locked = t.is_marked(h) || t.is_marked(before) && t.is_marked(after);
    finite && a != c && !locked && t.is_ccw(a, b, c) && t.is_ccw(a, c, t.origin(h))
}

/// Step 2: removes the vertex when no ear is left.
fn take_out<J: Journal>(t: &mut Triangulation, v: VertexId, j: &mut J) {
    let on_hull = t.star(v).any(|h| !t.dest(h).is_finite());
    match (t.star(v).count(), t.outgoing(v)) {
        (3, Some(h)) if !on_hull => {
            t.mesh.unsplit_face(h, j);
        }
        (4, _) => {
            let straight = t.star(v).find(|&h| {
                let opposite = t.dest(t.ccw(t.ccw(h)));
                let ends = t.dest(h).is_finite() && opposite.is_finite();
                ends && strictly_between(t.point(t.dest(h)), t.point(opposite), t.point(v))
            });
            match straight {
                Some(h) => {
                    t.mesh.unsplit_edge(h, j);
                }
                None => t.mesh.detach_outside(v, j),
            }
        }
        _ => t.mesh.detach_outside(v, j),
    }
    debug_assert!(t.closure == Closure::Hull || !on_hull, "boundary vertices of a domain end constrained edges");
}
