//! A triangulation refined by LEPP until every angle is at least 32 degrees: the second sample program of Valenzuela
//! (2009), section 6.2, with his loop: the points are triangulated, and no domain is carved before.
//!
//! Run it with `cargo run -p trimalla --example refine_to_32`.
#![allow(clippy::print_stdout, reason = "an example prints")]

use trimalla::constrained::ConstrainedDelaunay;
use trimalla::delaunay::{Delaunay, DivideAndConquer};
use trimalla::geometry::{Point, Triangle};
use trimalla::half_edge::FaceId;
use trimalla::refine::{Centroid, LeppRule};

const SMALL_ANGLE: f64 = 32.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let points =
        [(61.0, 17.0), (-23.0, -95.0), (55.0, 60.0), (-77.0, 4.0), (57.0, -114.0)].map(|(x, y)| Point::new(x, y));
    let mut t = ConstrainedDelaunay::from_delaunay(Delaunay::with::<DivideAndConquer>(&points)?);

    while let Some(bad) = bad_triangle(&t) {
        // The first insertion makes the hull the domain, so that its edges can be halved.
        let path = t.lepp(bad, LeppRule::StopAtBoundary);
        t.lepp_insert(path.terminal_edge, Some(Centroid::Area)).ok_or("rounding leaves no room")?;
    }

    for f in t.real_faces() {
        let [a, b, c] = t.face_vertices(f);
        println!("Face [ {a} {b} {c} ]");
    }
    println!("{} vertices, no angle below {SMALL_ANGLE} degrees", t.used_vertices().count());
    Ok(())
}

/// The first triangle with an angle below the bound.
fn bad_triangle(t: &ConstrainedDelaunay) -> Option<FaceId> {
    t.real_faces().find(|&f| {
        let [a, b, c] = t.face_points(f);
        Triangle::new(a, b, c).min_angle().degrees() < SMALL_ANGLE
    })
}
