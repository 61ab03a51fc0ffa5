//! Splits: a vertex inside a face, a vertex on an edge.

use crate::half_edge::{FaceId, HalfEdgeId, HalfEdgeMesh, Journal, VertexId};

impl HalfEdgeMesh {
    /// Puts unused vertex `q` inside face `f`: one face becomes three.
    ///
    /// ```text
    ///             c                         c
    ///            / \                       /|\
    ///           /   \                     / | \
    ///          /     \                   /  |  \         f = (a,b,q)   stays in its slot
    ///         /   f   \        ──>      / t .q. s\       s = (b,c,q)
    ///        /         \               /  '   '  \       t = (c,a,q)
    ///       a ───────── b             a ────f──── b
    /// ```
    ///
    /// Half-edge 0 of each of the returned faces is the outer edge, opposite `q` — in `f` it is
    /// the half-edge that was first before. Ghost faces split the same way.
    #[inline]
    pub(crate) fn split_face<J: Journal>(&mut self, f: FaceId, q: VertexId, j: &mut J) -> [FaceId; 3] {
        let c = self.origin(f.half_edge(2));
        let [f, s, t] = self.rewire_split_face(f, q, j);
        if !self.mark.is_empty() {
            let [_, h1, h2] = f.half_edges();
            let (mark_bc, mark_ca) = (self.mark(h1), self.mark(h2));
            self.set_mark_one_side(s.half_edge(0), mark_bc, j);
            self.set_mark_one_side(t.half_edge(0), mark_ca, j);
            self.set_mark_one_side(h1, 0, j);
            self.set_mark_one_side(h2, 0, j);
        }
        let region = self.region(f);
        self.set_region(s, region, j);
        self.set_region(t, region, j);
        self.move_outgoing(c, f.half_edge(2), t.half_edge(0), j);
        self.set_outgoing(q, f.half_edge(2), j);
        [f, s, t]
    }

    /// The half-edges of [`split_face`](Self::split_face) alone, in a mesh without marks and regions.
    #[inline(always)]
    pub(crate) fn rewire_split_face<J: Journal>(&mut self, f: FaceId, q: VertexId, j: &mut J) -> [FaceId; 3] {
        let [_, h1, h2] = f.half_edges();
        let [at_a, at_b, at_c] = self.face(f);
        let [s, t] = self.take_two_faces(j);
        let ([s0, s1, s2], [t0, t1, t2]) = (s.half_edges(), t.half_edges());
        self.set_twin(at_b.twin, s0, j);
        self.set_twin(at_c.twin, t0, j);
        self.set_vertices_and_twins(s, [at_b.origin, at_c.origin, q], [at_b.twin, t2, h1], j);
        self.set_vertices_and_twins(t, [at_c.origin, at_a.origin, q], [at_c.twin, h2, s1], j);
        self.set_twin(h1, s2, j);
        self.set_origin(h2, q, j);
        self.set_twin(h2, t1, j);
        [f, s, t]
    }

    /// Puts unused vertex `v` on edge `e`: two faces become four. Returns the half-edge from `v` to
    /// what was `dest(e)`.
    ///
    /// ```text
    ///            q                          q
    ///          /   \                      / | \
    ///        /       \                  /   |   \        e   = x→v  stays in its slot
    ///      /           \              /     | n   \      n   = (v,y,q)
    ///     x ──── e ────> y    ──>    x ─ e ─ v ──── y    o   = y→v  stays in its slot
    ///      \ <── o ──── /             \  m  |     /      m   = (v,x,d)
    ///        \       /                  \   |   /
    ///          \   /                      \ | /
    ///            d                          d
    /// ```
    ///
    /// Both halves carry the edge's mark. Either side may be a ghost.
    /// The edges opposite `v` are `next(n)`, `prev(e)`, `next(m)`, `prev(o)`, with `n` the returned
    /// half-edge and `m = twin(e)`.
    pub(crate) fn split_edge<J: Journal>(&mut self, e: HalfEdgeId, v: VertexId, j: &mut J) -> HalfEdgeId {
        let o = self.twin(e);
        let (x, y) = (self.origin(e), self.origin(o));
        let n = self.rewire_split_edge(e, v, j);
        let m = self.twin(e);
        if !self.mark.is_empty() {
            let (en, on) = (e.next(), o.next());
            let (mark_e, mark_yq, mark_xd) = (self.mark(e), self.mark(en), self.mark(on));
            self.set_mark_one_side(n, mark_e, j);
            self.set_mark_one_side(m, mark_e, j);
            self.set_mark_one_side(n.next(), mark_yq, j);
            self.set_mark_one_side(m.next(), mark_xd, j);
            self.set_mark_one_side(en, 0, j);
            self.set_mark_one_side(on, 0, j);
        }
        let regions = [self.region(e.face()), self.region(o.face())];
        self.set_region(n.face(), regions[0], j);
        self.set_region(m.face(), regions[1], j);
        self.move_outgoing(y, e.next(), n.next(), j);
        self.move_outgoing(x, o.next(), m.next(), j);
        self.set_outgoing(v, n, j);
        n
    }

    /// The half-edges of [`split_edge`](Self::split_edge) alone, in a mesh without marks and regions.
    pub(crate) fn rewire_split_edge<J: Journal>(&mut self, e: HalfEdgeId, v: VertexId, j: &mut J) -> HalfEdgeId {
        let o = self.twin(e);
        let (x, y) = (self.origin(e), self.origin(o));
        let (q, d) = (self.apex(e), self.apex(o));
        let (en, on) = (e.next(), o.next());
        let (twin_yq, twin_xd) = (self.twin(en), self.twin(on));
        let [nf, mf] = self.take_two_faces(j);
        let ([n0, n1, n2], [m0, m1, m2]) = (nf.half_edges(), mf.half_edges());
        self.set_face(nf, [v, y, q], j);
        self.set_face(mf, [v, x, d], j);
        self.set_origin(en, v, j);
        self.set_origin(on, v, j);
        self.glue(e, m0, j);
        self.glue(o, n0, j);
        self.glue(en, n2, j);
        self.glue(on, m2, j);
        self.glue(n1, twin_yq, j);
        self.glue(m1, twin_xd, j);
        n0
    }

    /// The four edges opposite the vertex that [`split_edge`](Self::split_edge) of `e` put in, `n` being what it
    /// returned.
    pub(crate) fn opposite_edges_after_split(&self, e: HalfEdgeId, n: HalfEdgeId) -> [HalfEdgeId; 4] {
        let (m, o) = (self.twin(e), self.twin(n));
        [n.next(), e.prev(), m.next(), o.prev()]
    }
}
