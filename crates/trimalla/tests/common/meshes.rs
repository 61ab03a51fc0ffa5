//! Triangulations as the plain arrays that files hold.
#![allow(dead_code, reason = "every test uses a part of it")]

use trimalla::delaunay::Delaunay;
use trimalla::drawing::IndexedMesh;
use trimalla::geometry::Point;

/// The Delaunay mesh of points.
pub(crate) fn delaunay_mesh(points: &[Point]) -> IndexedMesh {
    let built = Delaunay::new(points).expect("finite points");
    let triangles = built.canonical().into_iter().map(|t| t.map(|v| v.0)).collect();
    mesh(points.to_vec(), triangles)
}

/// A mesh of nothing but points and triangles.
pub(crate) fn mesh(points: Vec<Point>, triangles: Vec<[u32; 3]>) -> IndexedMesh {
    IndexedMesh { input_points: points.len(), points, triangles, ..IndexedMesh::default() }
}

/// Points from pairs.
pub(crate) fn points<const N: usize>(pairs: [[f64; 2]; N]) -> Vec<Point> {
    pairs.map(Point::from).to_vec()
}
