//! Edges and triangles named by their vertices, whatever their direction, first corner and slot.
//!
//! A half-edge and its twin have one key, and a triangle keeps its key when its slot changes. Lists sorted by keys
//! therefore do not depend on slots.

use std::fmt;

use super::half_edges::HalfEdgeMesh;
use super::ids::{FaceId, HalfEdgeId, VertexId};

/// An edge without direction: its two ends, the lower one first. Ordered by the lower end, then by the other.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct EdgeKey<V = VertexId>([V; 2]);

impl<V: Copy + Ord> EdgeKey<V> {
    /// The key of the edge between two vertices.
    #[must_use]
    #[inline]
    pub fn of([a, b]: [V; 2]) -> Self {
        Self([a.min(b), a.max(b)])
    }

    /// The ends, the lower one first.
    #[must_use]
    #[inline]
    pub const fn ends(self) -> [V; 2] {
        self.0
    }
}

/// A triangle without a first corner: its vertices in ascending order.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TriangleKey<V = VertexId>([V; 3]);

impl<V: Copy + Ord> TriangleKey<V> {
    /// The key of the triangle of three vertices.
    #[must_use]
    #[inline]
    pub fn of([a, b, c]: [V; 3]) -> Self {
        let (low, high) = (a.min(b), a.max(b));
        Self([low.min(c), low.max(high.min(c)), high.max(c)])
    }

    /// The vertices in ascending order.
    #[must_use]
    #[inline]
    pub const fn vertices(self) -> [V; 3] {
        self.0
    }
}

impl<V: fmt::Debug> fmt::Debug for EdgeKey<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl<V: fmt::Debug> fmt::Debug for TriangleKey<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// The keys of the edges of some triangles, each once, in ascending order.
#[must_use]
pub(crate) fn edges_of<V: Copy + Ord>(triangles: &[[V; 3]]) -> Vec<EdgeKey<V>> {
    let sides = |&[a, b, c]: &[V; 3]| [[a, b], [b, c], [c, a]].map(EdgeKey::of);
    let mut edges: Vec<EdgeKey<V>> = triangles.iter().flat_map(sides).collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}

impl HalfEdgeMesh {
    /// The key of the edge of a half-edge; its twin has the same one.
    #[must_use]
    #[inline]
    pub fn edge_key(&self, h: HalfEdgeId) -> EdgeKey {
        EdgeKey::of([self.origin(h), self.dest(h)])
    }

    /// The key of a face; a ghost's ends with [`VertexId::INFINITE`].
    #[must_use]
    #[inline]
    pub fn face_key(&self, f: FaceId) -> TriangleKey {
        TriangleKey::of(self.face_vertices(f))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_do_not_depend_on_direction_or_first_corner() {
        assert_eq!(EdgeKey::of([7, 3]), EdgeKey::of([3, 7]));
        assert_eq!(EdgeKey::of([7, 3]).ends(), [3, 7]);
        let orders = [[1, 2, 3], [2, 3, 1], [3, 1, 2], [3, 2, 1], [2, 1, 3], [1, 3, 2]];
        assert!(orders.into_iter().all(|t| TriangleKey::of(t).vertices() == [1, 2, 3]));
        let shared: Vec<[u32; 2]> = edges_of(&[[0, 1, 2], [2, 1, 3]]).into_iter().map(EdgeKey::ends).collect();
        assert_eq!(shared, [[0, 1], [0, 2], [1, 2], [1, 3], [2, 3]]);
    }
}
