//! What the five documents under this library ask for, each passage as it is printed there: docs/documents.md lists
//! them all.

mod contours;
mod flow;
mod mesh;
mod points;

use trimalla::constrained::ConstrainedDelaunay;
use trimalla::geometry::{Point, Triangle};
use trimalla::half_edge::FaceId;

/// The first triangle with an angle below a bound: `getBadTriangle` of Valenzuela (2009), section 6.2.
fn bad_triangle(t: &ConstrainedDelaunay, min_angle_deg: f64) -> Option<FaceId> {
    t.real_faces().find(|&f| smallest_angle_deg(t.face_points(f)) < min_angle_deg)
}

fn smallest_angle_deg([a, b, c]: [Point; 3]) -> f64 {
    Triangle::new(a, b, c).min_angle().degrees()
}
