//! Carve: removes every face outside the domain and puts ghosts along its boundary.

use crate::half_edge::{FaceId, HalfEdgeId, HalfEdgeMesh, Journal, VertexId};

/// The boundary between the faces of a domain and the outside.
#[derive(Clone, Debug, Default)]
pub(crate) struct Boundary {
    /// The half-edges a→b of faces inside with none across.
    pub(crate) edges: Vec<HalfEdgeId>,
    /// For each, the boundary half-edge c→a met first, turning clockwise around `a` through what is outside.
    pub(crate) before: Vec<HalfEdgeId>,
}

impl HalfEdgeMesh {
    /// Removes every face but those `kept` (one entry a face slot, true for real faces alone), and closes each boundary
    /// of what is left with new ghosts.
    ///
    /// ```text
    ///        \  kept  /                     \  kept  /
    ///     ────a══════b────              ────a══════b────
    ///        / removed \                       ∞          one ghost (b,a,∞) an edge of the boundary;
    ///       /  faces    \                                 ghosts meet where the removed wedge between
    ///                                                     two boundary edges was
    /// ```
    ///
    /// A vertex where the boundary touches itself keeps one star: kept fan, two ghosts, kept fan, two
    /// ghosts, … in the order in which the fans lay around it. Vertices outside become unused. Returns the ghosts.
    ///
    /// # Complexity
    /// Linear in all faces.
    pub(crate) fn carve<J: Journal>(&mut self, kept: &[bool], boundary: &Boundary, j: &mut J) -> Vec<FaceId> {
        let marks: Vec<u32> = boundary.edges.iter().map(|&h| self.mark(h)).collect();
        // The lowest slot is freed last: it is used again first.
        for f in (0..self.face_slots()).rev().map(FaceId::from_index) {
            if !kept[f.index()] && self.is_alive(f) {
                for h in f.half_edges() {
                    self.move_outgoing(self.origin(h), h, HalfEdgeId::NONE, j);
                }
                self.free_face(f, j);
            }
        }
        self.close_boundary(boundary, &marks, j)
    }

    /// The boundary of kept faces, in the order of their slots.
    ///
    /// # Complexity
    /// Linear in the face slots, most of which are only counted.
    pub(crate) fn boundary_of(&self, kept: &[bool]) -> Boundary {
        let others = (0..self.face_slots()).map(FaceId::from_index).filter(|f| !kept[f.index()] && self.is_alive(*f));
        let across = others.flat_map(FaceId::half_edges).map(|h| self.twin(h));
        let mut edges: Vec<HalfEdgeId> = across.filter(|h| kept[h.face().index()]).collect();
        edges.sort_unstable();
        let before = edges.iter().map(|&h| self.turn_through(h, kept)).collect();
        Boundary { edges, before }
    }

    /// Adds a ghost at each half-edge of a boundary, with its mark, and joins it to the ghost of the one before;
    /// returns the ghosts.
    pub(crate) fn close_boundary<J: Journal>(&mut self, boundary: &Boundary, marks: &[u32], j: &mut J) -> Vec<FaceId> {
        let ghosts: Vec<FaceId> = boundary.edges.iter().zip(marks).map(|(&h, &m)| self.hang_ghost(h, m, j)).collect();
        for (&ghost, &b) in ghosts.iter().zip(&boundary.before) {
            // a→∞ of the ghost of a→b meets ∞→a of the ghost of c→a.
            let other = self.twin(b).face();
            self.glue(ghost.half_edge(1), other.half_edge(2), j);
        }
        for &h in &boundary.edges {
            self.set_outgoing(self.origin(h), h, j);
        }
        ghosts
    }

    /// Ghost (b,a,∞) on boundary half-edge `h` = a→b.
    pub(super) fn hang_ghost<J: Journal>(&mut self, h: HalfEdgeId, mark: u32, j: &mut J) -> FaceId {
        let ghost = self.take_face(j);
        let (a, b) = (self.origin(h), self.dest(h));
        self.set_face(ghost, [b, a, VertexId::INFINITE], j);
        self.glue(ghost.half_edge(0), h, j);
        if mark != 0 {
            self.set_mark(h, mark, j);
        }
        ghost
    }

    /// From boundary half-edge `h` = a→b turns clockwise around `a` through faces that are not kept; returns the
    /// half-edge c→a at which a kept face begins again.
    fn turn_through(&self, h: HalfEdgeId, kept: &[bool]) -> HalfEdgeId {
        let mut incoming = self.twin(h);
        for _ in 0..self.face_slots() {
            let across = self.twin(incoming.next());
            if kept[across.face().index()] {
                return across;
            }
            incoming = across;
        }
        h
    }
}
