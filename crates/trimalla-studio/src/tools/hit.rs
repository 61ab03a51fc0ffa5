//! What lies under the pointer.

use std::fmt;

use eframe::egui::{Pos2, Rect};
use trimalla::geometry::{Point, Segment, math};
use trimalla::locate::Locus;
use trimalla_workbench::Document;

use crate::scene::Scene;
use crate::viewer::view::View;

/// What is no farther from the pointer than this is meant, in points of the screen.
const REACH: f32 = 12.0;

/// What lies under the pointer, by the names of vertices.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit {
    /// The place in the plane.
    pub(crate) at: Point,
    /// A vertex near it, and where it is.
    pub(crate) vertex: Option<u32>,
    pub(crate) vertex_at: Option<Point>,
    /// An edge of the triangle there, near the pointer.
    pub(crate) edge: Option<[u32; 2]>,
    /// The triangle there.
    pub(crate) face: Option<[u32; 3]>,
    /// How many digits behind the point a place of the screen has.
    digits: usize,
}

/// The place, with the digits that the view has, and what is there.
impl fmt::Display for Hit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = self.digits;
        write!(f, "pointer at {:.digits$}, {:.digits$}", self.at.x, self.at.y)?;
        if let Some([i, j, k]) = self.face {
            write!(f, "; triangle {i} {j} {k}")?;
        }
        if let Some([i, j]) = self.edge {
            write!(f, ", edge {i} {j}")?;
        }
        if let Some(name) = self.vertex {
            write!(f, ", vertex {name}")?;
        }
        Ok(())
    }
}

impl Hit {
    /// What lies at a place of the screen.
    pub(crate) fn at((place, rect): (Pos2, Rect), view: View, document: Option<&Document>, scene: &Scene) -> Self {
        let digits = math::log10(view.scale).clamp(0.0, 17.0).ceil() as usize + 1;
        let at = rounded(view.to_plane(place, rect), digits);
        let reach = f64::from(REACH) / view.scale;
        let near = scene.vertices.iter().filter(|v| (v.at.x - at.x).abs() < reach && (v.at.y - at.y).abs() < reach);
        let distance_sq = |p: Point| Point::distance_sq(at, p);
        let vertex = near.min_by(|a, b| distance_sq(a.at).total_cmp(&distance_sq(b.at)));
        let mut hit = Self {
            at,
            vertex: vertex.map(|v| v.name),
            vertex_at: vertex.map(|v| v.at),
            edge: None,
            digits,
            face: None,
        };
        if let Some((document, t)) = document.and_then(|d| Some((d, d.triangulation()?))).filter(|_| at.is_finite()) {
            let face = match t.locate(at) {
                Locus::Face(f) => Some(f),
                Locus::Edge(h) => [h, t.twin(h)].map(|h| h.face()).into_iter().find(|&f| t.is_real(f)),
                _ => None,
            };
            if let Some(face) = face {
                hit.face = Some(t.face_vertices(face).map(|v| document.name(v)));
                let away = |[start, end]: [Point; 2]| Segment { start, end }.distance(at);
                let by_distance = face.half_edges().map(|h| (away(t.edge_points(h)), h));
                let near = by_distance.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
                if let Some((_, h)) = near.filter(|&(distance, _)| distance < reach) {
                    hit.edge = Some([t.origin(h), t.dest(h)].map(|v| document.name(v)));
                }
            }
        }
        hit
    }
}

/// A place with so many digits behind the point: no click is more exact, and commands are shorter.
fn rounded(at: Point, digits: usize) -> Point {
    let round = |x: f64| format!("{x:.digits$}").parse().unwrap_or(x);
    Point::new(round(at.x), round(at.y))
}
