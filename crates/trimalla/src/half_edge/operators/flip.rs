//! Flip: the other diagonal of a quadrilateral.

use crate::half_edge::{HalfEdgeId, HalfEdgeMesh, Journal};

impl HalfEdgeMesh {
    /// Replaces edge `e` by the other diagonal of its two faces.
    ///
    /// ```text
    ///            q                          q
    ///          /   \                      / | \
    ///        /       \                  /   |   \
    ///      /           \              o     p    \      e = x→y becomes d→y
    ///     x ──── e ────> y    ──>    x      |      y    o = y→x becomes q→x
    ///      \ <── o ──── /             \     |    e      p = q→d, the new diagonal (was q→x)
    ///        \       /                  \   |   /
    ///          \   /                      \ | /
    ///            d                          d
    /// ```
    ///
    /// Half-edges `e` and `o` change places so that the two outer edges opposite `q`
    /// are `e` and `next(o)` afterwards: the edges that a Lawson loop tests next.
    /// Returns the new diagonal from `q` to `d`.
    ///
    /// # Guarantees
    /// The edge must be unmarked. Flipping the returned diagonal, and so on, four times in all,
    /// restores the faces (in other slots).
    #[inline]
    pub(crate) fn flip<J: Journal>(&mut self, e: HalfEdgeId, j: &mut J) -> HalfEdgeId {
        let o = self.twin(e);
        let (x, y) = (self.origin(e), self.origin(o));
        let p = self.rewire_flip(e, j);
        if !self.mark.is_empty() {
            let r = self.twin(p);
            let (mark_r, mark_p) = (self.mark(r), self.mark(p));
            self.set_mark_one_side(e, mark_r, j);
            self.set_mark_one_side(o, mark_p, j);
            self.set_mark_one_side(p, 0, j);
            self.set_mark_one_side(r, 0, j);
        }
        self.move_outgoing(x, e, o.next(), j);
        self.move_outgoing(y, o, e.next(), j);
        p
    }

    /// The half-edges of [`flip`](Self::flip) alone, in a mesh without marks.
    #[inline(always)]
    pub(crate) fn rewire_flip<J: Journal>(&mut self, e: HalfEdgeId, j: &mut J) -> HalfEdgeId {
        let o = self.twin(e);
        let (p, r) = (e.prev(), o.prev());
        let (at_p, at_r) = (self.half_edges[p.index()], self.half_edges[r.index()]);
        self.set_twin(at_p.twin, o, j);
        self.set_twin(at_r.twin, e, j);
        self.glue(p, r, j);
        self.set_half_edge(o, at_p, j);
        self.set_half_edge(e, at_r, j);
        p
    }
}
