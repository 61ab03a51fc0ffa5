//! The canonical form, which is equal for equal triangulations.

use super::triangulation::Triangulation;
use crate::half_edge::VertexId;

impl Triangulation {
    /// The triangles, each rotated to its smallest vertex id, sorted.
    ///
    /// Algorithms, insertion orders and thread counts must agree on it; slots may differ.
    #[doc(alias = "canonical form")]
    #[must_use]
    pub fn canonical(&self) -> Vec<[VertexId; 3]> {
        let mut list: Vec<_> = self.real_faces().map(|f| rotate_to_smallest(self.face_vertices(f))).collect();
        list.sort_unstable();
        list
    }

    /// The edges of a chain in dimension 1, or all edges, each from its smaller vertex id, sorted.
    #[must_use]
    pub fn canonical_edges(&self) -> Vec<[VertexId; 2]> {
        let mut list: Vec<_> = self.edges().map(|h| self.edge_key(h).ends()).collect();
        list.sort_unstable();
        list
    }
}

fn rotate_to_smallest(mut t: [VertexId; 3]) -> [VertexId; 3] {
    while t[0] > t[1] || t[0] > t[2] {
        t.rotate_left(1);
    }
    t
}
