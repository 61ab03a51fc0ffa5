//! Dimension one: collinear vertices as a chain of edges between ghosts.
//!
//! A chain of `k` vertices has `k − 1` edges, each with a ghost on both sides:
//!
//! ```text
//!              ∞   A1     ∞    A2     ∞            A_i = (v_i, v_{i+1}, ∞)
//!        v1 ───────── v2 ───────── v3              B_i = (v_{i+1}, v_i, ∞)
//!              ∞   B1     ∞    B2     ∞            at either end A and B share the edge to ∞
//! ```
//!
//! A vertex between two others is [`split_edge`](HalfEdgeMesh::split_edge), taken out again by
//! [`unsplit_edge`](HalfEdgeMesh::unsplit_edge).

use crate::half_edge::{HalfEdgeId, HalfEdgeMesh, Journal, VertexId};

const INF: VertexId = VertexId::INFINITE;

impl HalfEdgeMesh {
    /// Joins two unused vertices by an edge between two ghosts: dimension 0 becomes 1.
    ///
    /// ```text
    ///    a       b      ──>     a ──── h ───> b       returns h
    /// ```
    pub(crate) fn start_chain<J: Journal>(&mut self, a: VertexId, b: VertexId, j: &mut J) -> HalfEdgeId {
        let [up, down] = self.take_two_faces(j);
        let ([u0, u1, u2], [d0, d1, d2]) = (up.half_edges(), down.half_edges());
        self.set_face(up, [a, b, INF], j);
        self.set_face(down, [b, a, INF], j);
        self.glue(u0, d0, j);
        self.glue(u1, d2, j);
        self.glue(u2, d1, j);
        self.set_outgoing(a, u0, j);
        self.set_outgoing(b, d0, j);
        u0
    }

    /// Takes away the only edge `h`; the inverse of [`start_chain`](Self::start_chain).
    pub(crate) fn end_chain<J: Journal>(&mut self, h: HalfEdgeId, j: &mut J) {
        let (a, b) = (self.origin(h), self.dest(h));
        let (up, down) = (h.face(), self.twin(h).face());
        self.free_face(down, j);
        self.free_face(up, j);
        self.set_outgoing(a, HalfEdgeId::NONE, j);
        self.set_outgoing(b, HalfEdgeId::NONE, j);
    }

    /// Adds unused vertex `p` beyond the chain's end `b = dest(h)`, where `h` is the last edge.
    ///
    /// ```text
    ///    a ─── h ──> b         ──>     a ─── h ──> b ─── new ──> p
    /// ```
    ///
    /// Returns the new edge from `b` to `p`.
    pub(crate) fn extend_chain<J: Journal>(&mut self, h: HalfEdgeId, p: VertexId, j: &mut J) -> HalfEdgeId {
        let b = self.dest(h);
        let spoke = h.next(); // b→∞, shared with the ghost on the other side
        let back = self.twin(spoke);
        let [up, down] = self.take_two_faces(j);
        let ([u0, u1, u2], [d0, d1, d2]) = (up.half_edges(), down.half_edges());
        self.set_face(up, [b, p, INF], j);
        self.set_face(down, [p, b, INF], j);
        self.glue(u0, d0, j);
        self.glue(u1, d2, j);
        self.glue(u2, spoke, j);
        self.glue(d1, back, j);
        self.set_outgoing(p, d0, j);
        u0
    }

    /// Takes out the chain's end `dest(h)` with its edge `h`; the inverse of
    /// [`extend_chain`](Self::extend_chain). The chain must have another edge.
    pub(crate) fn shorten_chain<J: Journal>(&mut self, h: HalfEdgeId, j: &mut J) {
        let (b, p) = (self.origin(h), self.dest(h));
        let down = self.twin(h);
        let (spoke, back) = (self.twin(h.prev()), self.twin(down.next()));
        self.glue(spoke, back, j);
        self.free_face(down.face(), j);
        self.free_face(h.face(), j);
        self.set_outgoing(p, HalfEdgeId::NONE, j);
        self.rehome(b, back.next(), j);
        self.rehome(b, spoke, j);
    }
}
