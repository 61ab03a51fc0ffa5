//! A painter that takes coordinates of the plane.

use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, vec2};
use trimalla::geometry::{Circle, Point, Triangle};

use super::switches::Palette;
use super::view::View;

/// Draws above the triangles.
pub(crate) struct PlanePainter {
    painter: Painter,
    view: View,
    rect: Rect,
    /// The box that is seen, a little larger.
    seen: [Point; 2],
    pub(crate) palette: Palette,
}

impl PlanePainter {
    /// For a view on a part of the screen.
    pub(crate) fn new(painter: &Painter, (view, rect): (View, Rect), is_dark: bool) -> Self {
        let around = rect.expand(8.0);
        let [p, q] = [around.left_top(), around.right_bottom()].map(|at| view.to_plane(at, rect));
        let seen = [Point::new(p.x.min(q.x), p.y.min(q.y)), Point::new(p.x.max(q.x), p.y.max(q.y))];
        Self { painter: painter.with_clip_rect(rect), view, rect, seen, palette: Palette::of(is_dark) }
    }

    /// Where a point is on the screen.
    pub(crate) fn at(&self, p: Point) -> Pos2 {
        self.view.to_screen(p, self.rect)
    }

    /// Whether a point is seen.
    pub(crate) fn sees_point(&self, p: Point) -> bool {
        self.sees([p])
    }

    /// Whether something between some points may be seen.
    pub(crate) fn sees<const N: usize>(&self, points: [Point; N]) -> bool {
        let [low, high] = self.seen;
        !(points.iter().all(|p| p.x < low.x)
            || points.iter().all(|p| p.x > high.x)
            || points.iter().all(|p| p.y < low.y)
            || points.iter().all(|p| p.y > high.y))
    }

    /// How far things are from each other, in points of the screen, if so many were spread over it.
    pub(crate) fn spacing(&self, count: usize) -> f32 {
        (self.rect.area() / count.max(1) as f32).sqrt()
    }

    /// Text in the upper left corner.
    pub(crate) fn note(&self, text: &str, colour: Color32) {
        let at = self.rect.left_top() + vec2(4.0, 4.0);
        let room = (self.rect.width() - 8.0).max(40.0);
        let laid_out = self.painter.layout(text.to_owned(), FontId::proportional(15.0), colour, room);
        let ground = self.palette.ground;
        self.painter.rect_filled(Rect::from_min_size(at, laid_out.size()).expand(4.0), 3.0, ground);
        self.painter.galley(at, laid_out, colour);
    }

    /// A line of text in the middle.
    pub(crate) fn hint(&self, text: &str) {
        let font = FontId::proportional(15.0);
        self.painter.text(self.rect.center(), Align2::CENTER_CENTER, text, font, self.palette.vertex);
    }

    /// What is drawn on the screen at once.
    pub(crate) fn add(&self, shape: impl Into<Shape>) {
        self.painter.add(shape);
    }

    pub(crate) fn line(&self, ends: [Point; 2], width: f32, colour: Color32) {
        if self.sees(ends) {
            self.painter.line_segment(ends.map(|p| self.at(p)), Stroke::new(width, colour));
        }
    }

    pub(crate) fn dashed(&self, ends: [Point; 2], width: f32, colour: Color32) {
        let [a, b] = ends.map(|p| self.at(p));
        // Far ends would take a million dashes.
        let far = self.rect.expand(2.0 * self.rect.width().max(self.rect.height()));
        if far.contains(a) && far.contains(b) {
            self.painter.extend(Shape::dashed_line(&[a, b], Stroke::new(width, colour), 6.0, 4.0));
        } else {
            self.line(ends, width, colour);
        }
    }

    pub(crate) fn fill(&self, corners: [Point; 3], colour: Color32, alpha: u8) {
        if self.sees(corners) {
            let corners = corners.map(|p| self.at(p));
            let [r, g, b, _] = colour.to_array();
            let fill = Color32::from_rgba_unmultiplied(r, g, b, alpha);
            self.painter.add(Shape::convex_polygon(corners.to_vec(), fill, Stroke::NONE));
        }
    }

    pub(crate) fn dot(&self, p: Point, radius: f32, colour: Color32) {
        let at = self.at(p);
        if self.rect.contains(at) {
            self.painter.circle_filled(at, radius, colour);
        }
    }

    pub(crate) fn ring(&self, p: Point, radius: f32, colour: Color32) {
        let at = self.at(p);
        if self.rect.contains(at) {
            self.painter.circle_stroke(at, radius, Stroke::new(2.0, colour));
        }
    }

    /// A cross, for what was refused.
    pub(crate) fn cross(&self, p: Point, radius: f32, colour: Color32) {
        let at = self.at(p);
        if self.rect.contains(at) {
            for (from, to) in [(vec2(-1.0, -1.0), vec2(1.0, 1.0)), (vec2(-1.0, 1.0), vec2(1.0, -1.0))] {
                self.painter.line_segment([at + radius * from, at + radius * to], Stroke::new(2.0, colour));
            }
        }
    }

    /// The circle through the corners of a triangle.
    pub(crate) fn circumcircle(&self, corners: [Point; 3], width: f32, colour: Color32) {
        let [a, b, c] = corners;
        let Some(center) = Triangle::new(a, b, c).circumcenter() else { return };
        self.circle_through(center, a, width, colour);
    }

    pub(crate) fn circle(&self, circle: Circle, width: f32, colour: Color32) {
        let corner = Point::new(circle.center.x + circle.radius, circle.center.y);
        self.circle_through(circle.center, corner, width, colour);
    }

    fn circle_through(&self, center: Point, corner: Point, width: f32, colour: Color32) {
        let (center, corner) = (self.at(center), self.at(corner));
        let radius = center.distance(corner);
        // A circle that looks like a line has no business here, and its outline would take many points.
        if radius < 50_000.0 {
            self.painter.circle_stroke(center, radius, Stroke::new(width, colour));
        }
    }

    pub(crate) fn text(&self, p: Point, anchor: Align2, text: impl ToString, size: f32, colour: Color32) {
        let at = self.at(p);
        if self.rect.contains(at) {
            let away = match anchor {
                Align2::LEFT_BOTTOM => vec2(5.0, -4.0),
                _ => vec2(0.0, 0.0),
            };
            self.painter.text(at + away, anchor, text, FontId::proportional(size), colour);
        }
    }
}
