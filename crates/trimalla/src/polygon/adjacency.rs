//! Which triangles share an edge.

/// No triangle.
pub(super) const NONE: u32 = u32::MAX;

/// The neighbours of triangles of which no two have an edge in the same direction: across the edge from corner `k` to
/// the next, the triangle, and the place of the edge in it. [`NONE`] at the boundary.
pub(super) fn neighbours(triangles: &[[u32; 3]]) -> Vec<[(u32, u8); 3]> {
    let mut edges: Vec<([u32; 2], u32, u8)> = Vec::with_capacity(3 * triangles.len());
    for (number, &[a, b, c]) in (0..).zip(triangles) {
        edges.extend([([a, b], number, 0), ([b, c], number, 1), ([c, a], number, 2)]);
    }
    edges.sort_unstable();
    let mut neighbours = vec![[(NONE, 0); 3]; triangles.len()];
    for &([a, b], triangle, place) in &edges {
        if let Ok(at) = edges.binary_search_by_key(&[b, a], |edge| edge.0) {
            neighbours[triangle as usize][usize::from(place)] = (edges[at].1, edges[at].2);
        }
    }
    neighbours
}
