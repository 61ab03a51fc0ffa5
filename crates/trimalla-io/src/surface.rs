//! Meshes as surfaces: the vertices with their heights, for formats of three dimensions.

use trimalla::drawing::IndexedMesh;

/// A vertex with its height: the first attribute, or 0 where vertices have none.
pub(crate) fn place(mesh: &IndexedMesh, vertex: usize) -> [f64; 3] {
    let point = mesh.points[vertex];
    let height = match mesh.attributes_per_point {
        0 => 0.0,
        width => mesh.point_attributes[vertex * width],
    };
    [point.x, point.y, height]
}

/// All vertices with their heights.
pub(crate) fn places(mesh: &IndexedMesh) -> impl Iterator<Item = [f64; 3]> + '_ {
    (0..mesh.points.len()).map(|i| place(mesh, i))
}
