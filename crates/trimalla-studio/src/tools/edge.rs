//! A constrained edge, drawn from vertex to vertex in two phases: what it crosses, then what fills the two sides.

use trimalla_workbench::Document;

use super::{Asked, Hit};
use crate::viewer::plane_painter::PlanePainter;

/// The edge that was begun.
#[derive(Clone, Debug, Default)]
pub(crate) struct EdgeTool {
    from: Option<u32>,
    /// Its ends, when both were clicked.
    planned: Option<[u32; 2]>,
}

impl EdgeTool {
    pub(super) fn is_begun(&self) -> bool {
        self.from.is_some() || self.planned.is_some()
    }

    /// The ends of the edge that was planned.
    pub(crate) fn planned(&self) -> Option<[u32; 2]> {
        self.planned
    }

    /// Drops what was begun.
    pub(crate) fn clear(&mut self) {
        *self = Self::default();
    }

    /// Takes an end; the second one inserts the edge before the triangulation, and plans it after.
    pub(super) fn click(&mut self, hit: &Hit, document: Option<&Document>) -> Vec<Asked> {
        let Some(name) = hit.vertex else {
            return vec![Asked::Say("click nearer to a vertex".to_owned())];
        };
        let Some(from) = self.from.take().filter(|&from| from != name) else {
            (self.from, self.planned) = (Some(name), None);
            return Vec::new();
        };
        if document.is_some_and(|document| document.triangulation().is_some()) {
            self.planned = Some([from, name]);
            vec![Asked::Run(format!("Plan {from} {name}"))]
        } else {
            vec![Asked::Run(format!("Edge {from} {name}"))]
        }
    }

    /// Draws the edge, and what it crosses.
    pub(super) fn draw(&self, painter: &PlanePainter, hit: Option<&Hit>, document: Option<&Document>) {
        let Some(document) = document else { return };
        let ends = match (self.planned, self.from) {
            (Some(planned), _) => Some(planned),
            (None, Some(from)) => hit.and_then(|hit| hit.vertex).map(|to| [from, to]),
            (None, None) => None,
        };
        let place = |name: u32| {
            let v = document.vertex(name)?;
            let points = document.triangulation().map_or(document.drawing().points.as_slice(), |t| t.points());
            points.get(v.index()).copied()
        };
        if let Some(from) = self.from.and_then(place) {
            painter.ring(from, 7.0, painter.palette.terminal);
            if let Some(hit) = hit {
                painter.dashed([from, hit.vertex_at.unwrap_or(hit.at)], 1.5, painter.palette.terminal);
            }
        }
        if let Some(ends) = ends {
            draw_plan(painter, document, ends, place);
        }
    }
}

/// Draws the edges that a constrained edge crosses, and the vertices left and right of it.
fn draw_plan(
    painter: &PlanePainter,
    document: &Document,
    ends: [u32; 2],
    place: impl Fn(u32) -> Option<trimalla::geometry::Point>,
) {
    let Some(t) = document.triangulation() else { return };
    let (Some(from), Some(to)) = (document.vertex(ends[0]), document.vertex(ends[1])) else { return };
    let Some(plan) = t.plan_segment(from, to) else { return };
    if let (Some(a), Some(b)) = (place(ends[0]), place(ends[1])) {
        painter.line([a, b], 2.0, painter.palette.terminal);
    }
    for &h in &plan.crossed {
        painter.line(t.edge_points(h), 3.0, painter.palette.refused);
    }
    for (side, colour) in [(&plan.left, painter.palette.left), (&plan.right, painter.palette.right)] {
        side.iter().for_each(|&v| painter.dot(t.point(v), 5.0, colour));
    }
}
