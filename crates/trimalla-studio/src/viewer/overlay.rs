//! What lies above the triangles: vertices, the picked triangle, what the last step did.

use eframe::egui::{Align2, Color32};
use trimalla::constrained::ConstrainedTriangulation;
use trimalla::geometry::Point;
use trimalla::refine::{Event, Name};
use trimalla::trace::{Act, Shape, Step};

use super::plane_painter::PlanePainter;
use super::switches::Switches;
use crate::scene::{Face, Picked, Scene};
use crate::told::{Told, places};

/// Names are written at so many vertices at most.
const LABELLED: usize = 200;
/// So many vertices are marked at most.
const MARKED: usize = 3000;
/// So many circles are drawn at most.
const CIRCLES: usize = 1000;
/// So many shapes of an algorithm are drawn at most.
const SHAPES: usize = 20_000;

/// Draws segments that are not triangulated yet, vertices, seeds of holes and circles.
pub(super) fn draw(painter: &PlanePainter, scene: &Scene, switches: &Switches) {
    if switches.constraints {
        scene.segments.iter().for_each(|&ends| painter.line(ends, 2.0, painter.palette.constrained));
    }
    if switches.circles {
        draw_circles(painter, scene);
    }
    draw_vertices(painter, scene, switches);
    if switches.holes {
        for &seed in &scene.holes {
            painter.cross(seed, 4.0, painter.palette.hole);
        }
    }
}

fn draw_circles(painter: &PlanePainter, scene: &Scene) {
    let seen: Vec<&Face> =
        scene.faces.iter().filter(|face| painter.sees(scene.corners(face))).take(CIRCLES + 1).collect();
    if seen.len() <= CIRCLES {
        seen.iter().for_each(|face| painter.circumcircle(scene.corners(face), 0.7, painter.palette.picked));
    }
}

fn draw_vertices(painter: &PlanePainter, scene: &Scene, switches: &Switches) {
    if !switches.vertices && !switches.steiner {
        return;
    }
    let seen: Vec<_> = scene.vertices.iter().filter(|v| painter.sees_point(v.at)).take(MARKED + 1).collect();
    if seen.len() > MARKED {
        return;
    }
    // Smaller where they are many for the room they have.
    let radius = (0.08 * painter.spacing(seen.len())).clamp(1.0, 3.0);
    for v in &seen {
        let palette = &painter.palette;
        if if v.is_steiner { switches.steiner } else { switches.vertices } {
            painter.dot(v.at, radius, if v.is_steiner { palette.steiner } else { palette.vertex });
            if switches.labels && seen.len() <= LABELLED {
                painter.text(v.at, Align2::LEFT_BOTTOM, v.name, 11.0, palette.vertex);
            }
        }
    }
}

/// Draws the picked triangle with its path, its terminal edge and its circle.
pub(crate) fn draw_picked(painter: &PlanePainter, picked: &Picked, switches: &Switches) {
    let palette = &painter.palette;
    let faces = if switches.path { &picked.path[..picked.shown.min(picked.path.len())] } else { &picked.path[..1] };
    for (number, &corners) in faces.iter().enumerate() {
        painter.fill(corners, palette.picked, if number == 0 { 170 } else { 90 });
        if switches.path {
            let middle = trimalla::geometry::Triangle { corners }.centroid();
            painter.text(middle, Align2::CENTER_CENTER, format!("t{number}"), 12.0, palette.vertex);
        }
    }
    if switches.path && picked.shown >= picked.path.len() {
        painter.line(picked.terminal_edge, 3.0, palette.terminal);
    }
    if switches.circle {
        painter.circumcircle(picked.triangle.corners, 1.5, palette.picked);
    }
}

/// Draws what an algorithm has told: the shapes that it has added, and what its present step is about.
pub(crate) fn draw_told(painter: &PlanePainter, told: &Told, step: Option<&Step>, points: &[Point]) {
    let palette = &painter.palette;
    // Of many shapes most are not seen.
    for shape in told.shapes().take(SHAPES) {
        draw_shape(painter, shape, points, (1.8, palette.accepted));
    }
    if let Some(step) = step {
        let colour = match step.act {
            Act::Look | Act::Add => palette.picked,
            Act::Remove | Act::Refuse => palette.refused,
        };
        draw_shape(painter, &step.shape, points, (3.5, colour));
    }
}

fn draw_shape(painter: &PlanePainter, shape: &Shape, points: &[Point], (width, colour): (f32, Color32)) {
    match *shape {
        Shape::Vertex(v) => {
            if let Some([at]) = places(points, [v]) {
                painter.ring(at, 3.0 + 1.5 * width, colour);
            }
        }
        Shape::Edge(ends) => {
            if let Some(ends) = places(points, ends) {
                painter.line(ends, width, colour);
            }
        }
        Shape::Triangle(corners) => {
            if let Some([a, b, c]) = places(points, corners) {
                painter.fill([a, b, c], colour, 60);
                [[a, b], [b, c], [c, a]].into_iter().for_each(|ends| painter.line(ends, width, colour));
            }
        }
        Shape::Line(ends) => painter.dashed(ends, width, colour),
        Shape::Circle(circle) => painter.circle(circle, width, colour),
    }
}

/// Draws what a step did: the triangles it made, the path of the one that was selected as far as it still stands, the
/// points tried, what was inserted.
pub(crate) fn draw_step(painter: &PlanePainter, event: &Event, t: &ConstrainedTriangulation) {
    let palette = &painter.palette;
    let place = |name: &Name| name.map(|v| t.points().get(v.index()).copied());
    let corners = |name: &Name| match place(name) {
        [Some(a), Some(b), Some(c)] => Some([a, b, c]),
        _ => None,
    };
    let ends = |[a, b]: [trimalla::half_edge::VertexId; 2]| {
        Some([t.points().get(a.index()).copied()?, t.points().get(b.index()).copied()?])
    };
    for made in event.made.iter().filter_map(corners) {
        painter.fill(made, palette.accepted, 60);
    }
    if let Some(selected) = event.selected.and_then(|(name, _)| corners(&name)) {
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            painter.dashed([selected[a], selected[b]], 2.0, palette.picked);
        }
    }
    for (number, face) in event.lepp.iter().enumerate() {
        // A triangle that is gone has no place in the new mesh.
        let is_gone = event.destroyed.contains(face);
        if let Some(corners) = corners(face).filter(|_| !is_gone) {
            let middle = trimalla::geometry::Triangle { corners }.centroid();
            painter.text(middle, Align2::CENTER_CENTER, format!("t{number}"), 12.0, palette.vertex);
        }
    }
    if let Some(edge) = event.terminal_edge.and_then(ends) {
        painter.dashed(edge, 3.0, palette.terminal);
    }
    for edge in event.encroached.iter().chain(&event.subsegment).filter_map(|&edge| ends(edge)) {
        painter.dashed(edge, 3.0, palette.refused);
    }
    for (number, candidate) in (1..).zip(&event.candidates) {
        let Some(point) = candidate.point else { continue };
        let is_inserted = event.inserted.is_some_and(|inserted| inserted.point == point);
        if !is_inserted {
            painter.cross(point, 5.0, palette.refused);
            painter.text(point, Align2::LEFT_BOTTOM, number, 12.0, palette.refused);
        }
    }
    if let Some(inserted) = event.inserted {
        painter.ring(inserted.point, 7.0, palette.accepted);
    }
    for &(_, at) in &event.deleted {
        painter.cross(at, 5.0, palette.hole);
    }
}
