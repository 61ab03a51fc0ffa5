//! Every edge once.

use super::half_edges::HalfEdgeMesh;
use super::ids::{FaceId, HalfEdgeId, VertexId};

impl HalfEdgeMesh {
    /// One half-edge of every finite edge: the one of a real face, the lower one where both are.
    pub fn edges(&self) -> impl DoubleEndedIterator<Item = HalfEdgeId> + '_ {
        (0..self.half_edges.len()).map(HalfEdgeId::from_index).filter(|&h| self.stands_for_edge(h))
    }

    /// Of the [`edges`](Self::edges) those that carry a constraint mark.
    pub fn marked_edges(&self) -> impl DoubleEndedIterator<Item = HalfEdgeId> + '_ {
        // Most faces have no mark at all.
        let faces = self.mark.iter().enumerate().filter(|(_, marks)| marks[0] | marks[1] | marks[2] != 0);
        let sides = faces.flat_map(|(f, _)| FaceId::from_index(f).half_edges());
        sides.filter(|&h| self.is_marked(h) && self.stands_for_edge(h))
    }

    /// Whether a half-edge is the one by which [`edges`](Self::edges) names its edge.
    #[inline] // In loops over all edges.
    fn stands_for_edge(&self, h: HalfEdgeId) -> bool {
        let (a, b, t) = (self.origin(h), self.dest(h), self.twin(h));
        if a == VertexId::DEAD || !a.is_finite() || !b.is_finite() {
            return false;
        }
        // Between two finite ends a face is a ghost by its apex. The face across is looked at only where it matters.
        match (self.apex(h).is_finite(), h < t) {
            (true, true) => true,
            (true, false) => !self.apex(t).is_finite(),
            (false, is_lower) => is_lower && !self.apex(t).is_finite(),
        }
    }
}
