//! Every edge once, and every half-edge.

use std::ops::Range;

use super::half_edges::{HalfEdge, HalfEdgeMesh};
use super::ids::{EdgeId, FaceId, HalfEdgeId, VertexId};

/// So many faces are tested for marks at once.
const BLOCK: usize = 8;

/// Whether the faces of a block may have a mark: a full one is tested, the last one of a mesh may be short.
#[inline(always)] // In loops over all marked edges.
fn may_have_mark(block: &[[u32; 3]]) -> bool {
    <&[[u32; 3]; BLOCK]>::try_from(block).map_or(true, |full| full.as_flattened().iter().fold(0, |all, m| all | m) != 0)
}

impl HalfEdgeMesh {
    /// Both half-edges of every finite edge, oldest slot first; on the boundary the outer one lies in a ghost face.
    ///
    /// # Source
    /// Section 2.4 of `[Valenzuela09]`: iterators over all vertices, edges, half-edges and faces.
    pub fn half_edges(&self) -> impl DoubleEndedIterator<Item = HalfEdgeId> + '_ {
        let is_finite = |h: HalfEdgeId| {
            let (a, b) = (self.origin(h), self.dest(h));
            a != VertexId::DEAD && a.is_finite() && b.is_finite()
        };
        (0..self.half_edges.len()).map(HalfEdgeId::from_index).filter(move |&h| is_finite(h))
    }

    /// The edge of a half-edge and of its twin; `None` where the half-edge belongs to no finite edge.
    #[must_use]
    pub fn edge_of(&self, h: HalfEdgeId) -> Option<EdgeId> {
        if !self.is_alive(h.face()) {
            return None;
        }
        [h, self.twin(h)].into_iter().find(|&h| self.stands_for_edge(h)).map(|h| EdgeId(h.0))
    }

    /// One half-edge of every finite edge: the one in a real face; where both are, the lower one.
    pub fn edges(&self) -> impl DoubleEndedIterator<Item = HalfEdgeId> + '_ {
        self.edges_among(0..self.half_edges.len())
    }

    /// Those [`edges`](Self::edges) whose half-edges have indices in a range.
    pub(crate) fn edges_among(&self, indices: Range<usize>) -> impl DoubleEndedIterator<Item = HalfEdgeId> + '_ {
        indices.map(HalfEdgeId::from_index).filter(|&h| self.stands_for_edge(h))
    }

    /// Those [`edges`](Self::edges) that carry a constraint mark.
    pub fn marked_edges(&self) -> impl DoubleEndedIterator<Item = HalfEdgeId> + '_ {
        // Most faces have no mark at all.
        let faces = self.mark.iter().enumerate().filter(|(_, marks)| marks[0] | marks[1] | marks[2] != 0);
        faces.flat_map(|(f, marks)| self.marked_edges_of(FaceId::from_index(f), *marks))
    }

    /// Calls `each` with every one of the [`marked_edges`](Self::marked_edges): faster than the iterator, as blocks of
    /// faces without a mark are passed at once.
    pub(crate) fn for_each_marked_edge(&self, mut each: impl FnMut(HalfEdgeId)) {
        for (b, block) in self.mark.chunks(BLOCK).enumerate().filter(|(_, block)| may_have_mark(block)) {
            for (i, &marks) in block.iter().enumerate() {
                if marks != [0; 3] {
                    self.marked_edges_of(FaceId::from_index(b * BLOCK + i), marks).for_each(&mut each);
                }
            }
        }
    }

    /// Those edges of a face, with these marks, that it names.
    #[inline(always)] // In loops over all marked edges.
    fn marked_edges_of(&self, f: FaceId, marks: [u32; 3]) -> impl DoubleEndedIterator<Item = HalfEdgeId> + '_ {
        let [x, y, z] = self.face(f);
        let corners = [[x, y, z], [y, z, x], [z, x, y]].into_iter().zip(f.half_edges()).zip(marks);
        let marked = corners.filter(|(_, mark)| *mark != 0).map(|(side, _)| side);
        marked.filter(|&(corners, h)| self.is_named_by(corners, h)).map(|(_, h)| h)
    }

    /// Whether a half-edge is the one by which [`edges`](Self::edges) names its edge.
    #[inline(always)] // In loops over all edges.
    fn stands_for_edge(&self, h: HalfEdgeId) -> bool {
        let stored = |h: HalfEdgeId| self.half_edges[h.index()];
        self.is_named_by([stored(h), stored(h.next()), stored(h.prev())], h)
    }

    /// [`stands_for_edge`](Self::stands_for_edge) for a caller that has the records of the half-edge, the next one and
    /// the last one.
    #[inline(always)] // In loops over all edges.
    fn is_named_by(&self, corners: [HalfEdge; 3], h: HalfEdgeId) -> bool {
        let ([a, b, apex], t) = (corners.map(|corner| corner.origin), corners[0].twin);
        if a == VertexId::DEAD || !a.is_finite() || !b.is_finite() {
            return false;
        }
        // A face with two finite ends is a ghost if its apex is infinite. The face across is read only where it
        // matters.
        match (apex.is_finite(), h < t) {
            (true, true) => true,
            (true, false) => !self.apex(t).is_finite(),
            (false, is_lower) => is_lower && !self.apex(t).is_finite(),
        }
    }
}
