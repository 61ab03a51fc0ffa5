//! A vertex outside the hull, or off the line of a chain.

use crate::half_edge::{HalfEdgeId, HalfEdgeMesh, Journal, VertexId};

impl HalfEdgeMesh {
    /// Joins unused vertex `p` to a run of ghosts: each becomes a real face, two ghosts are added.
    ///
    /// ```text
    ///         ∞     ∞     ∞                         ∞    p    ∞
    ///                                                 / / \ \
    ///      a ──── b ──── c ──── d       ──>         /  /   \  \
    ///      first ghost … last ghost               a ─ b ─── c ─ d
    /// ```
    ///
    /// `first` is the finite edge of the first ghost of the run, `last` that of the last; the run goes
    /// from ghost to ghost across the edges `dest → ∞`, that is, along the finite edges head to tail.
    /// With a whole side of a chain this raises the dimension from 1 to 2.
    ///
    /// Returns the half-edge from `p` to the origin of `first`.
    pub(crate) fn attach_outside<J: Journal>(
        &mut self,
        first: HalfEdgeId,
        last: HalfEdgeId,
        p: VertexId,
        j: &mut J,
    ) -> HalfEdgeId {
        let (a, d) = (self.origin(first), self.dest(last));
        // Spokes that bound the run: ∞→a in the first ghost, d→∞ in the last.
        let (in_a, out_d) = (first.prev(), last.next());
        let (before, after) = (self.twin(in_a), self.twin(out_d));
        let mut edge = first;
        loop {
            let across = self.twin(edge.next()); // ∞→b in the next ghost
            self.set_origin(edge.prev(), p, j);
            if edge == last {
                break;
            }
            edge = across.next();
        }
        let [left, right] = self.take_two_faces(j);
        let ([l0, l1, l2], [r0, r1, r2]) = (left.half_edges(), right.half_edges());
        // a→p outside p→a, and p→d outside d→p.
        self.set_face(left, [a, p, VertexId::INFINITE], j);
        self.set_face(right, [p, d, VertexId::INFINITE], j);
        self.glue(l0, in_a, j);
        self.glue(r0, out_d, j);
        self.glue(l1, r2, j);
        self.glue(l2, before, j);
        self.glue(r1, after, j);
        self.set_outgoing(p, in_a, j);
        in_a
    }

    /// Replaces `v`, a vertex with exactly two ghosts, by infinity in its real faces and takes the two
    /// ghosts out; the inverse of [`attach_outside`](Self::attach_outside).
    ///
    /// The caller has made sure that the path of `v`'s neighbours is the new hull. Where no real face
    /// is left the result is a chain: the dimension went from 2 to 1.
    pub(crate) fn detach_outside<J: Journal>(&mut self, v: VertexId, j: &mut J) {
        let Some(out) = self.star(v).find(|&h| !self.dest(h).is_finite()) else { return };
        // out = v→∞ in ghost (a,v,∞); its twin ∞→v lies in ghost (v,d,∞).
        let left = out.face();
        let right = self.twin(out).face();
        let l0 = out.prev(); // a→v
        let r0 = self.twin(out).next(); // v→d
        let (in_a, out_d) = (self.twin(l0), self.twin(r0)); // v→a, d→v: to be ∞→a, d→∞
        let (before, after) = (self.twin(out.next()), self.twin(r0.next())); // a→∞ … ∞→d beyond the two ghosts
        let (a, d) = (self.origin(l0), self.dest(r0));
        let spokes: Vec<HalfEdgeId> = self.star(v).filter(|h| h.face() != left && h.face() != right).collect();
        for h in spokes {
            self.set_origin(h, VertexId::INFINITE, j);
        }
        self.glue(in_a, before, j);
        self.glue(out_d, after, j);
        self.free_face(right, j);
        self.free_face(left, j);
        self.rehome(a, in_a.next(), j);
        self.rehome(d, out_d, j);
        self.set_outgoing(v, HalfEdgeId::NONE, j);
    }
}
