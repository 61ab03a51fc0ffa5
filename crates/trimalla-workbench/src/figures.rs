//! What can be counted and measured of a document.

use trimalla::constrained::ConstrainedTriangulation;
use trimalla::geometry::Triangle;
use trimalla::half_edge::VertexId;

use crate::state::State;

/// Counts, angles and area of a document. Edges are counted where there is no triangle, too.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figures {
    /// Vertices in use; before the triangulation all points.
    pub vertices: usize,
    /// Vertices in use that are not of the drawing.
    pub steiner: usize,
    /// Triangles.
    pub triangles: usize,
    /// Edges.
    pub edges: usize,
    /// Edges that are part of segments, or bound a domain.
    pub constrained: usize,
    /// Edges with a triangle on one side only.
    pub boundary: usize,
    /// The smallest angle in degrees; 180 without triangles.
    pub min_angle_deg: f64,
    /// The largest angle in degrees; 0 without triangles.
    pub max_angle_deg: f64,
    /// The area of all triangles.
    pub area: f64,
}

impl Figures {
    pub(crate) fn of(state: &State) -> Self {
        let Some(mesh) = &state.mesh else {
            return Self { vertices: state.drawing().points.len(), min_angle_deg: 180.0, ..Self::default() };
        };
        Self::of_triangulation(mesh.triangulation(), state.drawing().points.len())
    }

    /// Of a triangulation whose first vertices, so many, are of the drawing.
    pub(crate) fn of_triangulation(t: &ConstrainedTriangulation, input: usize) -> Self {
        let mut figures = Self { min_angle_deg: 180.0, ..Self::default() };
        let is_steiner = |v: &VertexId| v.index() >= input;
        (figures.vertices, figures.steiner) = (t.used_vertices().count(), t.used_vertices().filter(is_steiner).count());
        for h in t.edges() {
            figures.edges += 1;
            figures.constrained += usize::from(t.is_marked(h));
            figures.boundary += usize::from(t.is_boundary_edge(h));
        }
        let mut extremes = [f64::NEG_INFINITY, f64::INFINITY];
        for f in t.real_faces() {
            let [a, b, c] = t.face_points(f);
            let triangle = Triangle::new(a, b, c);
            figures.triangles += 1;
            figures.area += triangle.area();
            let (smallest, largest, error) = cotangents(&triangle);
            // Angles take ten times as long, and few triangles come near the extremes. What overflows is measured.
            let is_less = smallest + error < extremes[0];
            if !is_less {
                extremes[0] = extremes[0].max(smallest - error);
                figures.min_angle_deg = figures.min_angle_deg.min(triangle.min_angle().degrees());
            }
            let is_more = largest - error > extremes[1];
            if !is_more {
                extremes[1] = extremes[1].min(largest + error);
                figures.max_angle_deg = figures.max_angle_deg.max(triangle.max_angle().degrees());
            }
        }
        figures
    }
}

/// The cotangents of the smallest and of the largest angle, and a bound of their rounding; NaN where numbers overflow.
fn cotangents(triangle: &Triangle) -> (f64, f64, f64) {
    let doubled_area = 2.0 * triangle.area();
    let lengths_sq = triangle.edge_lengths_sq();
    let sum = lengths_sq.iter().sum::<f64>();
    // The square of the opposite edge counts negatively.
    let cotangent = |opposite_sq: f64| (sum - 2.0 * opposite_sq) / (2.0 * doubled_area);
    let [least, most] = [f64::min, f64::max].map(|of| lengths_sq.iter().copied().reduce(of).unwrap_or(f64::NAN));
    // Some last places of the squares, and as many of the doubled area, which may be as much smaller as this says.
    let needle = sum / (2.0 * doubled_area);
    (cotangent(least), cotangent(most), 1e-14 * needle * (1.0 + needle))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Document, Quiet, script};

    #[test]
    fn extremes_are_those_of_all_triangles() {
        for text in [
            "Generate random 500 3",
            "Generate grid 400",
            "Generate spiral 300",
            "V 0 1e200 0\nV 1 -1e200 1e200\nV 2 0 1e-200\nV 3 0.1 1e17\nV 4 0 0",
            "V 0 1000000 0\nV 1 1000001 1e-9\nV 2 1000002 0\nV 3 1000001 -1e-3",
        ] {
            let mut document = Document::new();
            assert_eq!(script::run(&mut document, &format!("{text}\nTriangulate"), false, &mut Quiet), []);
            let t = document.triangulation().expect("triangulated");
            let all = || t.real_faces().map(|f| Triangle { corners: t.face_points(f) });
            let figures = document.figures();
            let least = all().map(|triangle| triangle.min_angle().degrees()).fold(180.0, f64::min);
            let most = all().map(|triangle| triangle.max_angle().degrees()).fold(0.0, f64::max);
            assert_eq!((figures.min_angle_deg, figures.max_angle_deg), (least, most), "{text}");
        }
    }
}
