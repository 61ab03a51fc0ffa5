//! Carve: everything outside the domain away, ghosts along its border.

use crate::mesh::{FaceId, HalfEdgeId, HalfEdgeMesh, Journal, VertexId};

impl HalfEdgeMesh {
    /// Removes the real faces that `keep` refuses and every old ghost, and closes each border of what is
    /// left with new ghosts.
    ///
    /// ```text
    ///        \  kept  /                     \  kept  /
    ///     ────a══════b────              ────a══════b────
    ///        / removed \                       ∞          one ghost (b,a,∞) an edge of the border;
    ///       /  faces    \                                 ghosts meet where the removed wedge between
    ///                                                     two border edges was
    /// ```
    ///
    /// A vertex where the border touches itself keeps one star: kept fan, two ghosts, kept fan, two
    /// ghosts, … in the order in which the fans lay around it. Vertices outside become unused.
    ///
    /// # Complexity
    /// Linear in all faces.
    pub(crate) fn carve<J: Journal>(&mut self, keep: &[bool], j: &mut J) {
        let kept = |m: &Self, f: FaceId| keep[f.index()] && m.is_real(f);
        let border: Vec<HalfEdgeId> = (0..self.face_slots())
            .map(FaceId::from_index)
            .filter(|&f| kept(self, f))
            .flat_map(FaceId::half_edges)
            .filter(|&h| !kept(self, self.twin(h).face()))
            .collect();
        // For border edge a→b, the border edge c→a reached by turning clockwise around a, through removed faces.
        let before: Vec<HalfEdgeId> = border.iter().map(|&h| self.turn_through(h, |m, f| !kept(m, f))).collect();
        let doomed: Vec<FaceId> =
            (0..self.face_slots()).map(FaceId::from_index).filter(|&f| self.is_alive(f) && !kept(self, f)).collect();
        let marks: Vec<u32> = border.iter().map(|&h| self.mark(h)).collect();
        let mut touched: Vec<VertexId> = Vec::new();
        for &f in doomed.iter().rev() {
            touched.extend(self.face_vertices(f).into_iter().filter(|v| v.is_finite()));
            self.free_face(f, j);
        }
        self.close_border(&border, &marks, &before, j);
        for v in touched {
            self.rehome(v, HalfEdgeId::NONE, j);
        }
    }

    /// Hangs a ghost on each border half-edge a→b, with its mark, and joins it at `a` to the ghost of the border half-edge
    /// c→a that comes `before` it: the one met first, turning clockwise around `a` through what is outside.
    pub(crate) fn close_border<J: Journal>(
        &mut self,
        border: &[HalfEdgeId],
        marks: &[u32],
        before: &[HalfEdgeId],
        j: &mut J,
    ) {
        let ghosts: Vec<FaceId> = border.iter().zip(marks).map(|(&h, &m)| self.hang_ghost(h, m, j)).collect();
        for (&ghost, &b) in ghosts.iter().zip(before) {
            // a→∞ of the ghost of a→b meets ∞→a of the ghost of c→a.
            let other = self.twin(b).face();
            self.glue(ghost.half_edge(1), other.half_edge(2), j);
        }
        for &h in border {
            self.rehome(self.origin(h), h, j);
        }
    }

    /// Ghost (b,a,∞) on border half-edge `h` = a→b.
    fn hang_ghost<J: Journal>(&mut self, h: HalfEdgeId, mark: u32, j: &mut J) -> FaceId {
        let ghost = self.take_face(j);
        let (a, b) = (self.origin(h), self.dest(h));
        self.set_face(ghost, [b, a, VertexId::INFINITE], j);
        self.glue(ghost.half_edge(0), h, j);
        if mark != 0 {
            self.set_mark(h, mark, j);
        }
        ghost
    }

    /// From border half-edge `h` = a→b, turns clockwise around `a` through faces that `removed` accepts;
    /// returns the half-edge c→a at which a kept face begins again.
    fn turn_through(&self, h: HalfEdgeId, removed: impl Fn(&Self, FaceId) -> bool) -> HalfEdgeId {
        let mut incoming = self.twin(h);
        for _ in 0..self.face_slots() {
            let across = self.twin(incoming.next());
            if !removed(self, across.face()) {
                return across;
            }
            incoming = across;
        }
        h
    }
}
