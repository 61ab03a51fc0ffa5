//! The table: what each algorithm attains on the same points.

use std::error::Error;
use std::fmt::Write as _;

use trimalla::drawing::IndexedMesh;
use trimalla::geometry::{Point, Triangle};
use trimalla::quality::{DelaunayMeasures, max_detour};
use trimalla::trace::NoTrace;
use trimalla::{DomainOptions, Method, triangulate_by};

use crate::figures::points;

/// A criterion: its name, whether more is better, digits, and how it is measured.
type Criterion = (&'static str, bool, usize, fn(&IndexedMesh) -> f64);

const CRITERIA: [Criterion; 9] = [
    ("smallest angle", true, 2, |mesh| DelaunayMeasures::of(mesh).min_angle.to_degrees()),
    ("largest angle", false, 2, |mesh| over(mesh, 0.0, f64::max, |t| t.max_angle().degrees())),
    ("sum of lengths", false, 1, |mesh| mesh.edges().iter().map(|&ends| length(mesh, ends)).sum()),
    ("longest edge", false, 2, |mesh| mesh.edges().iter().map(|&ends| length(mesh, ends)).fold(0.0, f64::max)),
    ("smallest height", true, 3, |mesh| over(mesh, f64::INFINITY, f64::min, height)),
    ("steepest slope", false, 3, steepest),
    ("largest enclosing circle", false, 2, |mesh| DelaunayMeasures::of(mesh).max_enclosing_radius),
    ("sum of inradii", true, 2, |mesh| DelaunayMeasures::of(mesh).inradius_sum),
    ("detour", false, 3, max_detour),
];

/// The criteria by the algorithms for points, the best in bold.
pub(crate) fn criteria() -> Result<String, Box<dyn Error>> {
    let cloud = points();
    let mut rows: Vec<(String, IndexedMesh)> = Vec::new();
    for method in Method::all().filter(|method| matches!(method, Method::Delaunay(_) | Method::Optimal(_))) {
        let Ok(made) = triangulate_by(&cloud, method, &DomainOptions::default(), 0, &mut NoTrace) else { continue };
        let triangles = sorted(&made.mesh);
        match rows.iter_mut().find(|(_, mesh)| sorted(mesh) == triangles) {
            Some((keys, _)) => *keys += &format!(", `{}`", method.key()),
            None => rows.push((format!("`{}`", method.key()), made.mesh)),
        }
    }
    let mut text = String::from(
        "24 points with heights, each algorithm on all of them; rows with the same triangles are one. The best values are \
         bold: every algorithm is best by its own criterion, and none by all.\n\n| algorithms |",
    );
    CRITERIA.iter().for_each(|(name, ..)| text += &format!(" {name} |"));
    text += &format!("\n|---|{}\n", "---:|".repeat(CRITERIA.len()));
    let columns: Vec<Vec<f64>> =
        CRITERIA.iter().map(|(_, _, _, measure)| rows.iter().map(|(_, mesh)| measure(mesh)).collect()).collect();
    for (i, (keys, _)) in rows.iter().enumerate() {
        let _ = write!(text, "| {keys} |");
        for (&(_, is_more_better, digits, _), column) in CRITERIA.iter().zip(&columns) {
            let best = column.iter().copied().fold(column[0], if is_more_better { f64::max } else { f64::min });
            let shown = format!("{:.digits$}", column[i]);
            let _ = if shown == format!("{best:.digits$}") {
                write!(text, " **{shown}** |")
            } else {
                write!(text, " {shown} |")
            };
        }
        text.push('\n');
    }
    Ok(text)
}

/// Triangles that can be compared.
fn sorted(mesh: &IndexedMesh) -> Vec<[u32; 3]> {
    let mut triangles: Vec<[u32; 3]> = mesh.triangles.clone();
    triangles.iter_mut().for_each(|t| t.sort_unstable());
    triangles.sort_unstable();
    triangles
}

fn over(mesh: &IndexedMesh, start: f64, fold: fn(f64, f64) -> f64, of: impl Fn(Triangle) -> f64) -> f64 {
    let triangle = |t: &[u32; 3]| Triangle { corners: t.map(|v| mesh.points[v as usize]) };
    mesh.triangles.iter().map(|t| of(triangle(t))).fold(start, fold)
}

fn length(mesh: &IndexedMesh, ends: [u32; 2]) -> f64 {
    let [a, b] = ends.map(|v| mesh.points[v as usize]);
    Point::distance_sq(a, b).sqrt()
}

/// The smallest height of a triangle.
fn height(triangle: Triangle) -> f64 {
    let longest = triangle.edge_lengths_sq().into_iter().fold(0.0, f64::max).sqrt();
    2.0 * triangle.area() / longest
}

/// The steepest of the planes through the heights.
fn steepest(mesh: &IndexedMesh) -> f64 {
    let slope = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|v| mesh.points[v as usize]);
        let [x, y, z] = t.map(|v| mesh.point_attributes[v as usize]);
        let (u, v) = (b - a, c - a);
        let (p, q, area) = (y - x, z - x, u.x * v.y - u.y * v.x);
        let gradient = [(p * v.y - q * u.y) / area, (q * u.x - p * v.x) / area];
        (gradient[0] * gradient[0] + gradient[1] * gradient[1]).sqrt()
    };
    mesh.triangles.iter().map(slope).fold(0.0, f64::max)
}
