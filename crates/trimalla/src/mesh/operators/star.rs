//! Star: the faces of a cavity away, a fan around a new vertex in their place.

use crate::mesh::{FaceId, HalfEdgeId, HalfEdgeMesh, Journal, VertexId};

/// An edge of a cavity's rim, as it was before: what the face on it needs to know. It ends where the next one starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct RimEdge {
    /// Where it starts, the cavity on its left.
    pub(crate) from: VertexId,
    /// The half-edge on its other side, outside the cavity.
    pub(crate) outer: HalfEdgeId,
    /// Its mark.
    pub(crate) mark: u32,
    /// The region of the cavity along it.
    pub(crate) region: u32,
    /// The mark that the spoke from `from` to the new vertex gets.
    pub(crate) spoke: u32,
}

impl HalfEdgeMesh {
    /// Replaces the faces of a cavity by a fan from its rim to the unused vertex `v`.
    ///
    /// ```text
    ///       e ───── d                  e ───── d
    ///      / \     / \                / \     / \          rim, counter-clockwise: a→b b→c c→d d→e e→a
    ///     /   \   /   \              /   \   /   \         face i is (from i, to i, v): its half-edge 0 is
    ///    a     \ /     c    ──>     a ─── v ───── c        the rim edge, 1 the spoke to v, 2 the spoke from v
    ///     \     X     /              \    |      /
    ///      \   / \   /                \   |    /           the slots of `faces` are used again, in order,
    ///       ── b ────                  ── b ───            and slots taken for the rest are added to it
    /// ```
    ///
    /// The rim is closed and in order. Returns the half-edge from `v` to `rim[0].from`.
    pub(crate) fn fill_star<J: Journal>(
        &mut self,
        faces: &mut Vec<FaceId>,
        rim: &[RimEdge],
        v: VertexId,
        j: &mut J,
    ) -> HalfEdgeId {
        debug_assert_eq!(faces.len() + 2, rim.len(), "a cavity without vertices inside");
        while faces.len() < rim.len() {
            let f = self.take_face(j);
            faces.push(f);
        }
        let (first, last) = ((rim[0], faces[0]), faces[rim.len() - 1]);
        let mut before = last;
        for (i, (&f, e)) in faces.iter().zip(rim).enumerate() {
            let (next, face_after) = match (rim.get(i + 1), faces.get(i + 1)) {
                (Some(&edge), Some(&face)) => (edge, face),
                _ => first,
            };
            let [base, to_v, from_v] = f.half_edges();
            let twins = [e.outer, face_after.half_edge(2), before.half_edge(1)];
            self.set_vertices_and_twins(f, [e.from, next.from, v], twins, j);
            self.set_twin(e.outer, base, j);
            before = f;
            if !self.mark.is_empty() {
                self.set_mark_one_side(base, e.mark, j);
                self.set_mark_one_side(to_v, next.spoke, j);
                self.set_mark_one_side(from_v, e.spoke, j);
            }
            self.set_region(f, e.region, j);
            // Whatever half-edge it kept may have gone with the cavity.
            self.set_outgoing(e.from, base, j);
        }
        let spoke = first.1.half_edge(2);
        self.set_outgoing(v, spoke, j);
        spoke
    }
}
