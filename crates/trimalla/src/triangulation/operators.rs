//! Operators on a bare triangulation: each proves its new faces before it rewires.

use super::triangulation::{Closure, Triangulation};
use crate::geometry::{Orientation, Point, orient2d};
use crate::half_edge::{FaceId, HalfEdgeId, Journal, VertexId};

impl Triangulation {
    /// Replaces an edge by the other diagonal of its two faces, if both new faces are strictly counter-clockwise.
    ///
    /// Refused, with `None` and nothing changed: constrained edges, edges of the boundary, and quadrilaterals that are
    /// not strictly convex. Returns the new diagonal.
    pub fn try_flip<J: Journal>(&mut self, h: HalfEdgeId, j: &mut J) -> Option<HalfEdgeId> {
        let t = self.twin(h);
        let real = self.is_real(h.face()) && self.is_real(t.face());
        let (q, d) = (self.apex(h), self.apex(t));
        let convex = real && self.is_ccw(q, self.origin(h), d) && self.is_ccw(d, self.dest(h), q);
        (convex && !self.is_marked(h)).then(|| self.mesh.flip(h, j))
    }

    /// Puts a new vertex strictly inside a real face; `None`, and nothing changed, where it does not lie there.
    pub fn try_split_face<J: Journal>(&mut self, f: FaceId, p: Point, j: &mut J) -> Option<VertexId> {
        let inside =
            self.is_real(f) && f.half_edges().into_iter().all(|h| self.side_of(h, p) == Orientation::CounterClockwise);
        inside.then(|| {
            let v = self.add_vertex(p, j);
            self.mesh.split_face(f, v, j);
            v
        })
    }

    /// Puts a new vertex on an edge, if every face that this makes is strictly counter-clockwise; the vertex may lie
    /// off the edge by its rounding, but on the convex hull it lies exactly on it. `None`, and nothing changed,
    /// otherwise.
    pub fn try_split_edge<J: Journal>(&mut self, h: HalfEdgeId, p: Point, j: &mut J) -> Option<VertexId> {
        let on_hull = self.closure == Closure::Hull && self.is_boundary_edge(h);
        let fits = self.may_split_edge(h, p) && (!on_hull || self.side_of(h, p) == Orientation::Collinear);
        fits.then(|| {
            let v = self.add_vertex(p, j);
            self.mesh.split_edge(h, v, j);
            v
        })
    }

    /// Whether the real faces that a vertex at `p` on edge `h` would make are strictly counter-clockwise.
    pub(crate) fn may_split_edge(&self, h: HalfEdgeId, p: Point) -> bool {
        if self.dimension < 2 || !self.is_alive(h.face()) || !self.origin(h).is_finite() || !self.dest(h).is_finite() {
            return false;
        }
        let [x, y] = self.edge_points(h);
        let left = |a: Point, b: Point, c: Point| orient2d(a, b, c) == Orientation::CounterClockwise;
        [(self.apex(h), x, y), (self.apex(self.twin(h)), y, x)].into_iter().all(|(apex, from, to)| {
            !apex.is_finite() || left(from, p, self.point(apex)) && left(p, to, self.point(apex))
        })
    }
}
