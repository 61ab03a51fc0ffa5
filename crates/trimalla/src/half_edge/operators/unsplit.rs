//! Unsplits: take a vertex of degree three or four out again.

use crate::half_edge::{FaceId, HalfEdgeId, HalfEdgeMesh, Journal};

impl HalfEdgeMesh {
    /// Takes out the origin of `h`, a vertex with exactly three faces: they become one.
    ///
    /// ```text
    ///             c                         c
    ///            /|\                       / \
    ///           / | \                     /   \
    ///          /  |  \                   /     \
    ///         /  .q.  \        ──>      /   f   \       f = face of h = q→a stays in its slot
    ///        /  h   '  \               /         \
    ///       a ───────── b             a ───────── b
    /// ```
    ///
    /// The inverse of [`split_face`](Self::split_face). The three spokes must be unmarked.
    /// Returns the face that is left; `q` keeps no half-edge.
    pub(crate) fn unsplit_face<J: Journal>(&mut self, h: HalfEdgeId, j: &mut J) -> FaceId {
        let q = self.origin(h);
        // Faces (q,a,b), (q,b,c), (q,c,a), counter-clockwise from h = q→a.
        let hb = self.ccw(h);
        let hc = self.ccw(hb);
        let f = h.face();
        let (ab, bc, ca) = (h.next(), hb.next(), hc.next());
        let (a, b, c) = (self.origin(ab), self.origin(bc), self.origin(ca));
        let (twin_bc, twin_ca) = (self.twin(bc), self.twin(ca));
        let (mark_bc, mark_ca) = (self.mark(bc), self.mark(ca));
        // In f the edge a→b stays; b→q becomes b→c, q→a becomes c→a.
        let (new_bc, new_ca) = (h.prev(), h);
        self.set_origin(new_ca, c, j);
        self.glue(new_bc, twin_bc, j);
        self.glue(new_ca, twin_ca, j);
        if !self.mark.is_empty() {
            self.set_mark_one_side(new_bc, mark_bc, j);
            self.set_mark_one_side(new_ca, mark_ca, j);
        }
        self.free_face(bc.face(), j);
        self.free_face(ca.face(), j);
        for (v, to) in [(a, ab), (b, new_bc), (c, new_ca)] {
            self.rehome(v, to, j);
        }
        self.set_outgoing(q, HalfEdgeId::NONE, j);
        f
    }

    /// Takes out the origin of `h`, a vertex with exactly four faces: the two edges `h` and its
    /// opposite become one, the four faces two. Returns the half-edge along `h` that is left.
    ///
    /// ```text
    ///            q                          q
    ///          / | \                      /   \
    ///        /   |   \                  /       \
    ///      /     |     \              /           \
    ///     x ──── v ─ h ─> y   ──>    x ──────────> y     face of x→v, below face of y→v stay
    ///      \     |     /              \           /
    ///        \   |   /                  \       /
    ///          \ | /                      \   /
    ///            d                          d
    /// ```
    ///
    /// The inverse of [`split_edge`](Self::split_edge). The spokes to `q` and `d` must be unmarked;
    /// the marks of the two halves must be equal.
    pub(crate) fn unsplit_edge<J: Journal>(&mut self, h: HalfEdgeId, j: &mut J) -> HalfEdgeId {
        let v = self.origin(h);
        let n0 = h; // v→y in (v,y,q)
        let o = self.twin(h); // y→v in (y,v,d)
        let en = self.twin(h.prev()); // v→q in (x,v,q)
        let e = en.prev(); // x→v
        let m0 = self.twin(e); // v→x in (v,x,d)
        let on = o.next(); // v→d in (y,v,d)
        let (x, y) = (self.origin(e), self.origin(o));
        let (q, d) = (self.apex(e), self.apex(o));
        let (n1, m1) = (n0.next(), m0.next());
        let (twin_yq, twin_xd) = (self.twin(n1), self.twin(m1));
        let (mark_yq, mark_xd) = (self.mark(n1), self.mark(m1));
        self.set_origin(en, y, j);
        self.set_origin(on, x, j);
        self.glue(e, o, j);
        self.glue(en, twin_yq, j);
        self.glue(on, twin_xd, j);
        if !self.mark.is_empty() {
            self.set_mark_one_side(en, mark_yq, j);
            self.set_mark_one_side(on, mark_xd, j);
        }
        self.free_face(n0.face(), j);
        self.free_face(m0.face(), j);
        for (w, to) in [(x, e), (y, o), (q, e.prev()), (d, o.prev())] {
            self.rehome(w, to, j);
        }
        self.set_outgoing(v, HalfEdgeId::NONE, j);
        e
    }
}
