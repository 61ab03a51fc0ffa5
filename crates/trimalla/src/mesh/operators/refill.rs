//! Refill: other faces in the same cavity.

use crate::mesh::{FaceId, HalfEdgeId, HalfEdgeMesh, Journal, VertexId};

/// Where a side of a new face leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// To side `.1` of new face `.0` of the same refill.
    New(u32, u32),
    /// To the rim: this half-edge outside the cavity; the edge carries this mark.
    Rim(HalfEdgeId, u32),
    /// To side `.1` of new face `.0`, across an edge that dangled into the cavity and carries mark `.2`.
    Doubled(u32, u32, u32),
}

impl HalfEdgeMesh {
    /// Replaces the faces of a cavity by as many others.
    ///
    /// ```text
    ///       s ───── t                  s ───── t
    ///      / \     / \                /  \ ‾‾--.. \
    ///     a ──u───v── b     ──>      a ──────────── b       the slots of `faces` are used again, in order
    ///      \ /     \ /                \ .. -- ‾‾ / /
    ///       w ───── x                  w ───── x
    /// ```
    ///
    /// `sides[i][k]` says what lies across the edge from `vertices[i][k]` to `vertices[i][k + 1]`: another
    /// new face, or a half-edge of the rim with the mark of that edge. Both sides of an inner edge are
    /// listed. Inner edges are unmarked afterwards.
    pub(crate) fn refill<J: Journal>(
        &mut self,
        faces: &[FaceId],
        vertices: &[[VertexId; 3]],
        sides: &[[Side; 3]],
        j: &mut J,
    ) {
        debug_assert_eq!(faces.len(), vertices.len(), "a cavity keeps its number of faces");
        for (i, &f) in faces.iter().enumerate() {
            self.set_face(f, vertices[i], j);
        }
        for (i, &f) in faces.iter().enumerate() {
            for (k, h) in (0..3).zip(f.half_edges()) {
                let (twin, mark) = match sides[i][k] {
                    Side::New(g, s) => (faces[g as usize].half_edge(s), 0),
                    Side::Doubled(g, s, mark) => (faces[g as usize].half_edge(s), mark),
                    Side::Rim(t, mark) => {
                        self.set_twin(t, h, j);
                        (t, mark)
                    }
                };
                self.set_twin(h, twin, j);
                if !self.mark.is_empty() {
                    self.set_mark_one_side(h, mark, j);
                }
            }
        }
        for (i, &f) in faces.iter().enumerate() {
            for (v, h) in vertices[i].into_iter().zip(f.half_edges()) {
                self.rehome(v, h, j);
            }
        }
    }
}
