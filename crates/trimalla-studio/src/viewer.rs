//! The drawing of a scene.

use eframe::egui::epaint::{Mesh, Vertex as Corner, WHITE_UV};
use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Stroke, pos2};
use trimalla::geometry::Point;

use crate::scene::{Picked, Scene};
use crate::view::View;

/// What is shown, besides triangles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Switches {
    pub(crate) edges: bool,
    pub(crate) constraints: bool,
    pub(crate) vertices: bool,
    pub(crate) labels: bool,
    pub(crate) circle: bool,
    pub(crate) path: bool,
    /// Triangles with an angle below this are marked.
    pub(crate) threshold_deg: f64,
}

impl Default for Switches {
    fn default() -> Self {
        Self {
            edges: true,
            constraints: true,
            vertices: true,
            labels: true,
            circle: true,
            path: true,
            threshold_deg: 30.0,
        }
    }
}

/// Names are written at so many vertices at most.
const LABELLED: usize = 200;

/// Colours on light and on dark ground.
struct Colours {
    edge: Color32,
    constrained: Color32,
    vertex: Color32,
    steiner: Color32,
    picked: Color32,
    terminal: Color32,
}

impl Colours {
    fn of(is_dark: bool) -> Self {
        let [edge, constrained, vertex] = if is_dark {
            [Color32::from_gray(90), Color32::from_rgb(240, 200, 90), Color32::from_gray(220)]
        } else {
            [Color32::from_gray(130), Color32::from_rgb(150, 80, 0), Color32::from_gray(30)]
        };
        let [steiner, picked, terminal] =
            [Color32::from_rgb(60, 140, 230), Color32::from_rgb(90, 120, 250), Color32::from_rgb(220, 40, 160)];
        Self { edge, constrained, vertex, steiner, picked, terminal }
    }
}

/// Draws a scene.
pub(crate) fn draw(
    painter: &Painter,
    (view, rect): (View, Rect),
    scene: &Scene,
    picked: Option<&Picked>,
    switches: &Switches,
    is_dark: bool,
) {
    let painter = painter.with_clip_rect(rect);
    let colours = Colours::of(is_dark);
    let at = |p: Point| view.to_screen(p, rect);
    fill(&painter, rect, scene, switches, is_dark, &at);
    if let Some(picked) = picked {
        draw_picked(&painter, picked, switches, &colours, &at);
    }
    for edge in &scene.edges {
        let [a, b] = edge.ends.map(at);
        let is_shown = if edge.is_constrained { switches.constraints } else { switches.edges };
        if is_shown && rect.intersects(Rect::from_two_pos(a, b).expand(1.0)) {
            let stroke = if edge.is_constrained {
                Stroke::new(2.0, colours.constrained)
            } else {
                Stroke::new(1.0, colours.edge)
            };
            painter.line_segment([a, b], stroke);
        }
    }
    let seen: Vec<_> = scene.vertices.iter().map(|v| (v, at(v.at))).filter(|(_, at)| rect.contains(*at)).collect();
    for (v, at) in &seen {
        if switches.vertices && seen.len() <= 50 * LABELLED {
            painter.circle_filled(*at, 3.0, if v.is_steiner { colours.steiner } else { colours.vertex });
        }
        if switches.labels && seen.len() <= LABELLED {
            let corner = *at + eframe::egui::vec2(4.0, -4.0);
            painter.text(corner, Align2::LEFT_BOTTOM, v.name, FontId::proportional(11.0), colours.vertex);
        }
    }
}

/// Fills triangles by their smallest angle.
fn fill(painter: &Painter, rect: Rect, scene: &Scene, switches: &Switches, is_dark: bool, at: &impl Fn(Point) -> Pos2) {
    let mut mesh = Mesh::default();
    for face in &scene.faces {
        let corners = face.corners.map(at);
        if !rect.intersects(Rect::from_points(&corners)) {
            continue;
        }
        let color = colour_of(face.min_angle_deg, switches.threshold_deg, is_dark);
        let first = mesh.vertices.len() as u32;
        mesh.vertices.extend(corners.map(|pos| Corner { pos, uv: WHITE_UV, color }));
        mesh.indices.extend([first, first + 1, first + 2]);
    }
    painter.add(mesh);
}

/// From red over yellow to green; below the threshold a full red.
fn colour_of(angle_deg: f64, threshold_deg: f64, is_dark: bool) -> Color32 {
    let part = (angle_deg / 60.0).clamp(0.0, 1.0) as f32;
    let (red, green) = ((255.0 * (1.4 - part).min(1.0)) as u8, (255.0 * (0.35 + part).min(1.0)) as u8);
    if angle_deg < threshold_deg {
        return Color32::from_rgb(235, 95, 85);
    }
    if is_dark { Color32::from_rgb(red / 3, green / 2, 60) } else { Color32::from_rgb(red, green, 170) }
}

/// Draws the picked triangle with its path, its terminal edge and its circle.
fn draw_picked(
    painter: &Painter,
    picked: &Picked,
    switches: &Switches,
    colours: &Colours,
    at: &impl Fn(Point) -> Pos2,
) {
    let faces = if switches.path { &picked.path[..] } else { &picked.path[..1] };
    for (number, corners) in faces.iter().enumerate() {
        let corners = corners.map(at);
        let alpha = if number == 0 { 170 } else { 90 };
        let [r, g, b, _] = colours.picked.to_array();
        let fill = Color32::from_rgba_unmultiplied(r, g, b, alpha);
        painter.add(eframe::egui::Shape::convex_polygon(corners.to_vec(), fill, Stroke::NONE));
        let middle = corners.iter().fold(pos2(0.0, 0.0), |sum, c| sum + c.to_vec2() / 3.0);
        if switches.path {
            let font = FontId::proportional(12.0);
            painter.text(middle, Align2::CENTER_CENTER, format!("t{number}"), font, colours.vertex);
        }
    }
    if switches.path {
        painter.line_segment(picked.terminal_edge.map(at), Stroke::new(3.0, colours.terminal));
    }
    if switches.circle {
        if let Some(center) = picked.triangle.circumcenter() {
            let (center, corner) = (at(center), at(picked.triangle.corners[0]));
            painter.circle_stroke(center, center.distance(corner), Stroke::new(1.0, colours.picked));
        }
    }
}
