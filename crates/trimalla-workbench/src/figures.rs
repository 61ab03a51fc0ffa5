//! What can be counted and measured of a document.

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
        let t = mesh.triangulation();
        let input = state.drawing().points.len();
        let mut figures = Self { min_angle_deg: 180.0, ..Self::default() };
        let is_steiner = |v: &VertexId| v.index() >= input;
        (figures.vertices, figures.steiner) = (t.used_vertices().count(), t.used_vertices().filter(is_steiner).count());
        for h in t.edges() {
            figures.edges += 1;
            figures.constrained += usize::from(t.is_marked(h));
            figures.boundary += usize::from(t.is_boundary_edge(h));
        }
        for f in t.real_faces() {
            let [a, b, c] = t.face_points(f);
            let triangle = Triangle::new(a, b, c);
            figures.triangles += 1;
            figures.min_angle_deg = figures.min_angle_deg.min(triangle.min_angle().degrees());
            figures.max_angle_deg = figures.max_angle_deg.max(triangle.max_angle().degrees());
            figures.area += triangle.area();
        }
        figures
    }
}
