//! Five points, triangulated by divide and conquer: the first sample program of Valenzuela (2009), section 4.3.
//!
//! Run it with `cargo run -p trimalla --example five_points`; it prints the document's text.
#![allow(clippy::print_stdout, reason = "an example prints")]

use trimalla::delaunay::{Delaunay, DivideAndConquer};
use trimalla::geometry::{Point, lexicographic};
use trimalla::half_edge::VertexId;

fn main() -> Result<(), trimalla::delaunay::BuildError> {
    let points =
        [(61.0, 17.0), (-23.0, -95.0), (55.0, 60.0), (-77.0, 4.0), (57.0, -114.0)].map(|(x, y)| Point::new(x, y));
    let delaunay = Delaunay::with::<DivideAndConquer>(&points)?;

    for v in delaunay.used_vertices() {
        println!("Vertex [{v}] -> {}", delaunay.point(v));
    }
    for [a, b, c] in faces_as_merged(&delaunay) {
        println!("Face [ {a} {b} {c} ]");
    }
    Ok(())
}

/// The faces in the document's manner: each from the edge that joined the left and the right half when the halves
/// were merged, smaller faces first.
fn faces_as_merged(delaunay: &Delaunay) -> Vec<[VertexId; 3]> {
    let mut by_x: Vec<VertexId> = delaunay.used_vertices().collect();
    by_x.sort_by(|&a, &b| lexicographic(delaunay.point(a), delaunay.point(b)));
    let left = &by_x[..by_x.len() / 2];
    let joins_halves = |[a, b, _]: &[VertexId; 3]| left.contains(a) && !left.contains(b);

    let mut faces: Vec<[VertexId; 3]> = delaunay
        .real_faces()
        .map(|f| {
            let mut face = delaunay.face_vertices(f);
            let from_base = (0..3).find(|_| {
                face.rotate_left(1);
                joins_halves(&face)
            });
            debug_assert!(from_base.is_some(), "the last merge made every face here");
            face
        })
        .collect();
    let doubled_area = |face: &[VertexId; 3]| {
        let [a, b, c] = face.map(|v| delaunay.point(v));
        (b - a).cross(c - a)
    };
    faces.sort_by(|f, g| doubled_area(f).total_cmp(&doubled_area(g)));
    faces
}
