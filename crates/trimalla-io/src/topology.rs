//! Which triangles share an edge, found by sorting: deterministic, and good for any soup of triangles.

use trimalla::drawing::IndexedMesh;

/// A side of a triangle: side `i` lies opposite corner `i`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Side {
    pub(crate) edge: [u32; 2],
    pub(crate) triangle: usize,
    pub(crate) corner: usize,
}

/// All sides of all triangles, sorted by edge (smaller vertex first), then by triangle.
pub(crate) fn sorted_sides(mesh: &IndexedMesh) -> Vec<Side> {
    let mut sides = Vec::with_capacity(3 * mesh.triangles.len());
    for (triangle, corners) in mesh.triangles.iter().enumerate() {
        for corner in 0..3 {
            let (a, b) = (corners[(corner + 1) % 3], corners[(corner + 2) % 3]);
            sides.push(Side { edge: [a.min(b), a.max(b)], triangle, corner });
        }
    }
    sides.sort_unstable();
    sides
}

/// The sides grouped by edge.
pub(crate) fn by_edge(sides: &[Side]) -> impl Iterator<Item = &[Side]> {
    sides.chunk_by(|a, b| a.edge == b.edge)
}
