//! Star: replaces the faces of a cavity by a fan around a new vertex.

use crate::half_edge::{FaceId, HalfEdgeId, HalfEdgeMesh, Journal, VertexId};

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
    /// The rim is in order, its first edge once more at the end. Returns the half-edge from `v` to `rim[0].from`.
    pub(crate) fn fill_star<J: Journal>(
        &mut self,
        faces: &mut Vec<FaceId>,
        rim: &[RimEdge],
        v: VertexId,
        j: &mut J,
    ) -> HalfEdgeId {
        debug_assert_eq!(faces.len() + 3, rim.len(), "a cavity without vertices inside");
        faces.extend(self.take_two_faces(j));
        let (first, mut before) = (faces[0], faces[faces.len() - 1]);
        for (i, (&f, edge)) in faces.iter().zip(rim.windows(2)).enumerate() {
            let after = faces.get(i + 1).map_or(first, |&after| after);
            self.set_fan_face(f, [edge[0], edge[1]], v, [before, after], j);
            before = f;
        }
        let spoke = first.half_edge(2);
        self.set_outgoing(v, spoke, j);
        spoke
    }

    /// Makes `f` the face on an edge of the rim and `v`, between the faces before and after it.
    #[inline(always)] // In the loop around the rim.
    fn set_fan_face<J: Journal>(
        &mut self,
        f: FaceId,
        [edge, next]: [RimEdge; 2],
        v: VertexId,
        [before, after]: [FaceId; 2],
        j: &mut J,
    ) {
        let base = f.half_edge(0);
        let twins = [edge.outer, after.half_edge(2), before.half_edge(1)];
        self.set_vertices_and_twins(f, [edge.from, next.from, v], twins, j);
        self.set_twin(edge.outer, base, j);
        self.set_marks_one_side(f, [edge.mark, next.spoke, edge.spoke], j);
        self.set_region(f, edge.region, j);
        // Whatever half-edge it kept may have gone with the cavity.
        self.set_outgoing(edge.from, base, j);
    }
}
