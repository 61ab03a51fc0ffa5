//! Contours drawn vertex by vertex: the outline and the holes.

use trimalla::geometry::{Point, Ring};
use trimalla_workbench::Document;

use super::{Asked, Hit};
use crate::scene::Scene;
use crate::viewer::plane_painter::PlanePainter;

/// A contour that was begun: names and places of its vertices.
#[derive(Clone, Debug, Default)]
pub(super) struct Contour {
    ring: Vec<(u32, Point)>,
}

impl Contour {
    pub(super) fn is_empty(&self) -> bool {
        self.ring.is_empty()
    }

    pub(super) fn len(&self) -> usize {
        self.ring.len()
    }

    /// Whether a drawing has all its vertices, where they were clicked. One that was moved is where it is.
    pub(super) fn is_in(&mut self, document: &Document) -> bool {
        let points = &document.drawing().points;
        self.ring.iter_mut().all(|(name, at)| {
            let place = document.vertex(*name).and_then(|v| points.get(v.index()));
            *at = place.copied().unwrap_or(*at);
            place.is_some()
        })
    }

    /// Takes a vertex, or inserts one; the first one again closes the contour and gives it to a command.
    pub(super) fn click(&mut self, hit: &Hit, command: &str, document: Option<&Document>, scene: &Scene) -> Vec<Asked> {
        if document.is_some_and(|document| document.triangulation().is_some()) {
            return vec![Asked::Say("contours come before 'Triangulate'; 'Reset' goes back there".to_owned())];
        }
        let Some((name, at)) = hit.vertex.zip(hit.vertex_at) else {
            // Names ascend, so that one is free.
            let next = scene.vertices.iter().map(|v| v.name + 1).max().unwrap_or(0);
            self.ring.push((next, hit.at));
            return vec![Asked::Run(format!("V {next} {} {}", hit.at.x, hit.at.y))];
        };
        if self.ring.first().is_some_and(|&(first, _)| first == name) && self.ring.len() >= 3 {
            return vec![Asked::Run(self.close(command))];
        }
        if self.ring.iter().any(|&(other, _)| other == name) {
            return vec![Asked::Say(format!("vertex {name} is on the contour already; its first vertex closes it"))];
        }
        self.ring.push((name, at));
        Vec::new()
    }

    /// The command: outlines run counter-clockwise, holes clockwise.
    fn close(&mut self, command: &str) -> String {
        let mut ring = std::mem::take(&mut self.ring);
        let places: Vec<Point> = ring.iter().map(|&(_, at)| at).collect();
        if (Ring::new(&places).signed_area() > 0.0) != (command == "Outer") {
            ring.reverse();
        }
        let names: Vec<String> = ring.iter().map(|(name, _)| name.to_string()).collect();
        format!("{command} {} {}", names.len(), names.join(" "))
    }

    /// Draws what was begun, up to the pointer.
    pub(super) fn draw(&self, painter: &PlanePainter, hit: Option<&Hit>) {
        let colour = painter.palette.terminal;
        for sides in self.ring.windows(2) {
            painter.line([sides[0].1, sides[1].1], 2.0, colour);
        }
        if let (Some(&(_, first)), Some(&(_, last))) = (self.ring.first(), self.ring.last()) {
            painter.ring(first, 7.0, colour);
            if let Some(hit) = hit {
                painter.dashed([last, hit.vertex_at.unwrap_or(hit.at)], 1.5, colour);
            }
        }
    }
}
