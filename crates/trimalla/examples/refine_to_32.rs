//! A triangulation refined by LEPP until every angle is at least 32 degrees: the second sample program of Valenzuela (2009),
//! section 6.2, with his loop.
//!
//! Run it with `cargo run -p trimalla --example refine_to_32`.
#![allow(clippy::print_stdout, reason = "an example prints")]

use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build};
use trimalla::drawing::Pslg;
use trimalla::geometry::{Point, Triangle};
use trimalla::half_edge::FaceId;
use trimalla::refine::{Centroid, LeppRule};

const SMALL_ANGLE: f64 = 32.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let points =
        [(61.0, 17.0), (-23.0, -95.0), (55.0, 60.0), (-77.0, 4.0), (57.0, -114.0)].map(|(x, y)| Point::new(x, y));
    // Without segments the domain is the convex hull of the points.
    let pslg = Pslg { points: points.to_vec(), ..Pslg::default() };
    let (mut t, _) = build(&pslg, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::DivideAndConquer)?;

    while let Some(bad) = bad_triangle(&t) {
        let path = t.lepp(bad, LeppRule::StopAtConstraints);
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
