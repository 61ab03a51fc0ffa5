//! The picture of one step: the triangulation after it, what was selected, its path, what went in and what is new.

use std::fmt::Write as _;

use trimalla::constrained::ConstrainedTriangulation;
use trimalla::geometry::{BoundingBox, Point};
use trimalla::half_edge::VertexId;
use trimalla::refine::{Event, Name};

/// Width and height of the picture, in pixels.
const SIZE: f64 = 800.0;
/// Room around the drawing and for the line of text above it.
const MARGIN: f64 = 40.0;

/// The picture of one step.
#[derive(Debug)]
pub struct Frame<'a> {
    event: &'a Event,
    cdt: &'a ConstrainedTriangulation,
    bounds: BoundingBox,
}

impl<'a> Frame<'a> {
    /// The picture of a step, given the triangulation after it.
    #[must_use]
    pub fn new(event: &'a Event, cdt: &'a ConstrainedTriangulation) -> Self {
        let bounds = cdt.bounding_box().unwrap_or_else(|| BoundingBox::around(Point::default()));
        Self { event, cdt, bounds }
    }

    /// The picture as SVG. Destroyed triangles are drawn as far as their vertices still exist.
    #[must_use]
    pub fn to_svg(&self) -> String {
        let side = SIZE + 2.0 * MARGIN;
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {side} {side}\" font-family=\"sans-serif\" font-size=\"15\">\n\
             <rect width=\"{side}\" height=\"{side}\" fill=\"#fff\"/>\n<text x=\"{MARGIN}\" y=\"25\">{}</text>\n",
            self.title()
        );
        self.fill(&mut svg, &self.event.made, "#d7ecd9");
        self.fill(&mut svg, &self.event.lepp, "#cfe0f5");
        if let Some((selected, _)) = &self.event.selected {
            self.fill(&mut svg, std::slice::from_ref(selected), "#f6c7a4");
        }
        self.edges(&mut svg);
        self.strokes(&mut svg);
        if let Some(inserted) = self.event.inserted {
            let (x, y) = self.place(inserted.point);
            let _ = writeln!(svg, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"5\" fill=\"#b3202a\"/>");
        }
        svg += "</svg>\n";
        svg
    }

    fn title(&self) -> String {
        let Event { number, outcome, inserted, given_up, .. } = self.event;
        let mut text = format!("step {number}: {}", outcome.key());
        if let Some(why) = self.event.why() {
            let _ = write!(text, ", selected for its {why}");
        }
        if let Some(inserted) = inserted {
            let _ = write!(text, ", vertex {} ({})", inserted.vertex, inserted.kind.key());
        }
        if let Some(reason) = given_up {
            let _ = write!(text, ", given up: {reason}");
        }
        text
    }

    /// From the drawing to the picture, y upwards.
    fn place(&self, p: Point) -> (f64, f64) {
        let (width, height) = (self.bounds.width(), self.bounds.height());
        let scale = SIZE / width.max(height).max(f64::MIN_POSITIVE);
        (MARGIN + (p.x - self.bounds.min.x) * scale, MARGIN + SIZE - (p.y - self.bounds.min.y) * scale)
    }

    fn fill(&self, svg: &mut String, triangles: &[Name], colour: &str) {
        for triangle in triangles {
            let corners = triangle.map(|v| self.place(self.cdt.point(v)));
            let points: Vec<String> = corners.iter().map(|(x, y)| format!("{x:.2},{y:.2}")).collect();
            let _ = writeln!(svg, "<polygon points=\"{}\" fill=\"{colour}\"/>", points.join(" "));
        }
    }

    fn edges(&self, svg: &mut String) {
        for marked in [false, true] {
            let mut path = String::new();
            for h in self.cdt.edges().filter(|&h| self.cdt.is_marked(h) == marked) {
                let [(x, y), (u, v)] = self.cdt.edge_points(h).map(|p| self.place(p));
                let _ = write!(path, "M{x:.2} {y:.2}L{u:.2} {v:.2}");
            }
            let (colour, width) = if marked { ("#222", 2.0) } else { ("#8a8a8a", 0.8) };
            let _ = writeln!(svg, "<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"/>");
        }
    }

    /// The terminal edge, and subsegments that are concerned.
    fn strokes(&self, svg: &mut String) {
        let terminal = self.event.terminal_edge.iter().map(|e| (e, "#1f5fa8"));
        let concerned = self.event.encroached.iter().chain(&self.event.subsegment).map(|e| (e, "#b3202a"));
        for (ends, colour) in terminal.chain(concerned) {
            let [(x, y), (u, v)] = ends.map(|v: VertexId| self.place(self.cdt.point(v)));
            let _ = writeln!(
                svg,
                "<line x1=\"{x:.2}\" y1=\"{y:.2}\" x2=\"{u:.2}\" y2=\"{v:.2}\" stroke=\"{colour}\" stroke-width=\"3.5\"/>"
            );
        }
    }
}
