//! A triangulation refined until every angle is at least 32 degrees: the second sample program of Valenzuela (2009),
//! section 6.2.
//!
//! Run it with `cargo run -p trimalla --example refine_to_32`.
#![allow(clippy::print_stdout, reason = "an example prints")]

use trimalla::domain::Pslg;
use trimalla::geometry::Point;
use trimalla::refine::RefineOptions;
use trimalla::{MeshOptions, mesh};

fn main() -> Result<(), trimalla::Error> {
    let points =
        [(61.0, 17.0), (-23.0, -95.0), (55.0, 60.0), (-77.0, 4.0), (57.0, -114.0)].map(|(x, y)| Point::new(x, y));
    // Without segments the domain is the convex hull of the points.
    let pslg = Pslg { points: points.to_vec(), ..Pslg::default() };
    let options = MeshOptions { refine: RefineOptions::default().with_min_angle_deg(32.0), ..MeshOptions::default() };

    let (mesh, report) = mesh(&pslg, &options)?;

    for (i, p) in mesh.points.iter().enumerate() {
        println!("Vertex [{i}] -> {p}");
    }
    for [a, b, c] in &mesh.triangles {
        println!("Face [ {a} {b} {c} ]");
    }
    println!("smallest angle {:.2} degrees, {} vertices added", report.min_angle_deg, report.steiner_points);
    assert!(report.complete() && report.min_angle_deg >= 32.0, "the hull of the five points has no sharp corner");
    Ok(())
}
