//! Triangles drawn without the card, from coordinates in double precision: for views so near that single precision
//! would show. Few triangles are seen there.

use eframe::egui::epaint::{Mesh, Vertex as Corner, WHITE_UV};
use eframe::egui::{Color32, Rgba};

use super::plane_painter::PlanePainter;
use super::switches::{Colours, Switches};
use crate::scene::{Edge, Face, Scene};

/// Draws the triangles that may be seen.
pub(super) fn draw(painter: &PlanePainter, scene: &Scene, switches: &Switches, is_dark: bool) {
    let seen: Vec<&Face> = scene.faces.iter().filter(|face| painter.sees(scene.corners(face))).collect();
    let mut mesh = Mesh::default();
    for face in &seen {
        let color = colour(face, switches, is_dark);
        let first = mesh.vertices.len() as u32;
        mesh.vertices.extend(scene.corners(face).map(|p| Corner { pos: painter.at(p), uv: WHITE_UV, color }));
        mesh.indices.extend([first, first + 1, first + 2]);
    }
    painter.add(mesh);
    for face in &seen {
        let corners = scene.corners(face);
        for opposite in 0..3 {
            let ends = [corners[(opposite + 1) % 3], corners[(opposite + 2) % 3]];
            let is_heavy = match face.facts.edge(opposite) {
                Edge::Free => false,
                Edge::Inside => switches.constraints,
                Edge::Boundary => switches.boundary,
            };
            if is_heavy {
                painter.line(ends, 2.0, painter.palette.constrained);
            } else if switches.edges {
                painter.line(ends, 1.0, painter.palette.edge);
            }
        }
    }
}

/// The colours of the shader.
fn colour(face: &Face, switches: &Switches, is_dark: bool) -> Color32 {
    let mix = |low: [f32; 3], high: [f32; 3], part: f32| {
        let [r, g, b] = std::array::from_fn(|i| low[i] + (high[i] - low[i]) * part.clamp(0.0, 1.0));
        [r, g, b]
    };
    let ramp = |part| {
        if is_dark {
            mix([0.42, 0.34, 0.14], [0.10, 0.38, 0.36], part)
        } else {
            mix([0.99, 0.93, 0.68], [0.55, 0.83, 0.76], part)
        }
    };
    let is_bad = f64::from(face.min_angle_deg) < switches.threshold_deg && switches.colours != Colours::Region;
    let [r, g, b] = match switches.colours {
        _ if is_bad && is_dark => [0.78, 0.29, 0.18],
        _ if is_bad => [0.90, 0.45, 0.32],
        Colours::Angle => ramp(face.min_angle_deg / 60.0),
        Colours::Roundness => ramp(face.facts.quality()),
        Colours::Region => of_region(face.facts.region(), is_dark),
    };
    Color32::from_rgb((255.0 * r) as u8, (255.0 * g) as u8, (255.0 * b) as u8)
}

fn of_region(number: u32, is_dark: bool) -> [f32; 3] {
    if number == 0 {
        return if is_dark { [0.20; 3] } else { [0.93; 3] };
    }
    let hue = (number as f32 * 0.618_034).fract();
    let pure = Rgba::from(eframe::egui::ecolor::Hsva::new(hue, 1.0, 1.0, 1.0));
    let pure = [pure.r(), pure.g(), pure.b()];
    let (ground, part) = if is_dark { (0.12, 0.40) } else { (1.0, 0.45) };
    pure.map(|channel| ground + (channel - ground) * part)
}
