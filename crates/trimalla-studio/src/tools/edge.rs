//! A constrained edge, drawn from vertex to vertex in two phases: what it crosses, then the recursion that fills both
//! sides, call by call.

use eframe::egui::Align2;
use trimalla::geometry::Point;
use trimalla_workbench::{Document, EdgePlan, NamedPoint, PlanSide};

use super::{Asked, Hit};
use crate::viewer::plane_painter::PlanePainter;

/// The edge that was begun.
#[derive(Debug, Default)]
pub(crate) struct EdgeTool {
    from: Option<u32>,
    planned: Option<Planned>,
}

/// An edge whose both ends were clicked.
#[derive(Debug)]
pub(crate) struct Planned {
    pub(crate) ends: [u32; 2],
    pub(crate) plan: EdgePlan,
    /// Of which version of the document it is the plan.
    version: u64,
    /// So many calls of the recursion are shown; those on the left come first.
    pub(crate) shown: usize,
}

impl Planned {
    /// Calls of the recursion on both sides.
    pub(crate) fn calls(&self) -> usize {
        self.plan.left.calls.len() + self.plan.right.calls.len()
    }

    /// The side of a call, with its number there.
    pub(crate) fn call(&self, number: usize) -> (&PlanSide, usize) {
        let left = self.plan.left.calls.len();
        if number < left { (&self.plan.left, number) } else { (&self.plan.right, number - left) }
    }
}

impl EdgeTool {
    pub(super) fn is_begun(&self) -> bool {
        self.from.is_some() || self.planned.is_some()
    }

    /// The edge that was planned, unless the document has changed since.
    pub(crate) fn planned(&mut self, document: &Document) -> Option<&mut Planned> {
        self.planned.as_mut().filter(|planned| planned.version == document.version())
    }

    /// Plans an edge.
    pub(crate) fn plan(&mut self, document: &Document, ends: [u32; 2]) {
        let plan = document.edge_plan(ends[0], ends[1]).ok();
        self.planned = plan.map(|plan| Planned { ends, plan, version: document.version(), shown: 0 });
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
        match document.filter(|document| document.triangulation().is_some()) {
            // The window plans it when the command has been run.
            Some(_) => vec![Asked::Run(format!("Plan {from} {name}"))],
            None => vec![Asked::Run(format!("Edge {from} {name}"))],
        }
    }

    /// Draws the edge, and its plan.
    pub(super) fn draw(&self, painter: &PlanePainter, hit: Option<&Hit>, document: Option<&Document>) {
        let Some(document) = document else { return };
        if let Some(from) = self.from.and_then(|from| place(document, from)) {
            painter.ring(from, 7.0, painter.palette.terminal);
            if let Some(hit) = hit {
                painter.dashed([from, hit.vertex_at.unwrap_or(hit.at)], 1.5, painter.palette.terminal);
            }
        }
        let hovered = self.from.zip(hit.and_then(|hit| hit.vertex)).filter(|(from, to)| from != to);
        if let Some(planned) = self.planned.as_ref().filter(|planned| planned.version == document.version()) {
            draw_plan(painter, &planned.plan);
            (0..planned.shown).for_each(|number| draw_call(painter, planned, number));
        } else if let Some(plan) = hovered.and_then(|(from, to)| document.edge_plan(from, to).ok()) {
            draw_plan(painter, &plan);
        }
    }
}

/// Where a vertex is.
fn place(document: &Document, name: u32) -> Option<Point> {
    let v = document.vertex(name)?;
    let points = document.triangulation().map_or(document.drawing().points.as_slice(), |t| t.points());
    points.get(v.index()).copied()
}

/// The first phase: the edges that it crosses, and the vertices left and right of it.
fn draw_plan(painter: &PlanePainter, plan: &EdgePlan) {
    let palette = &painter.palette;
    for crossed in plan.crossed.iter().chain(&plan.constrained) {
        painter.dashed(crossed.map(|end| end.at), 3.5, palette.vertex);
    }
    painter.line([plan.from.at, plan.to.at], 3.0, palette.terminal);
    for (side, colour) in [(&plan.left, palette.left), (&plan.right, palette.right)] {
        side.boundary.iter().for_each(|v| painter.dot(v.at, 5.0, colour));
    }
}

/// A call of the second phase: the triangle that it makes. Of the last one shown also the base, what was tried and the
/// circle.
fn draw_call(painter: &PlanePainter, planned: &Planned, number: usize) {
    let (side, own) = planned.call(number);
    let palette = &painter.palette;
    let colour = if number < planned.plan.left.calls.len() { palette.left } else { palette.right };
    let Some(call) = side.calls.get(own) else { return };
    let at = |position: usize| side.boundary.get(position).map(|v: &NamedPoint| v.at);
    let (Some(a), Some(b), Some(c)) = (at(call.first), at(call.last), at(call.chosen)) else { return };
    painter.fill([a, b, c], colour, 90);
    for ends in [[a, b], [b, c], [c, a]] {
        painter.line(ends, 1.5, colour);
    }
    let middle = trimalla::geometry::Triangle { corners: [a, b, c] }.centroid();
    painter.text(middle, Align2::CENTER_CENTER, number + 1, 13.0, palette.vertex);
    if number + 1 == planned.shown {
        painter.line([a, b], 4.0, colour);
        painter.ring(c, 9.0, palette.accepted);
        call.tried().filter_map(at).for_each(|p| painter.ring(p, 6.0, palette.vertex));
        painter.circumcircle([a, b, c], 2.0, palette.accepted);
    }
}
