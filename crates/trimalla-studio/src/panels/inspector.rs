//! The inspector: the picked triangle, and what can be done with it.

use eframe::egui::{Slider, Ui};
use trimalla::quality::aspect_ratio;

use crate::scene::Picked;

/// Shows the picked triangle; the command of a button that was clicked.
pub(crate) fn show(ui: &mut Ui, picked: Option<&mut Picked>) -> Option<String> {
    ui.heading("Triangle");
    let Some(picked) = picked else {
        ui.label("Click a triangle to see its angles, its circle and its longest-edge path.");
        return None;
    };
    let [i, j, k] = picked.names;
    ui.label(format!("vertices {i} {j} {k}"));
    let angles = picked.triangle.angles().map(|angle| format!("{:.2}°", angle.degrees()));
    ui.label(format!("angles {}", angles.join("  ")));
    ui.label(format!("area {:.6}", picked.triangle.area()));
    ui.label(format!("aspect ratio {:.4}", aspect_ratio(&picked.triangle)));
    ui.label(format!("circle test: {}", if picked.passes_circle_test { "passed" } else { "an edge fails it" }));
    let list = |all: &[[u32; 3]]| {
        let names = all.iter().map(|[i, j, k]| format!("{i}-{j}-{k}"));
        names.collect::<Vec<_>>().join(", ")
    };
    ui.label(format!("neighbours {}", list(&picked.neighbours)));
    ui.label(format!("path of {} triangles", picked.path.len())).on_hover_text(list(&picked.path_names));
    let [p, q] = picked.terminal_names;
    ui.label(format!("terminal edge {p}-{q}"));
    if picked.path.len() > 1 {
        let all = picked.path.len();
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().slider_width = 60.0;
            if ui.button("Previous triangle").on_hover_text("one step back along the path").clicked() {
                picked.shown = picked.shown.saturating_sub(1).max(1);
            }
            if ui.button("Next triangle").on_hover_text("walks the path across longest edges").clicked() {
                // After the last one the walk begins again.
                picked.shown = if picked.shown == all { 1 } else { picked.shown + 1 };
            }
            ui.add(Slider::new(&mut picked.shown, 1..=all)).on_hover_text("how much of the path is shown");
        });
    }
    let mut command = None;
    ui.horizontal_wrapped(|ui| {
        for (name, help, line) in [
            ("Insert midpoint", "the midpoint of the terminal edge", format!("Midpoint {i} {j} {k}")),
            ("Insert centroid", "the centroid of the terminal triangles", format!("Centroid {i} {j} {k}")),
            ("Refine this", "treats it once, by the options", format!("Treat {i} {j} {k}")),
            ("Until destroyed", "treats it until it is gone", format!("Treat {i} {j} {k} destroyed")),
            ("Show", "tells about it in the console", format!("Show {i} {j} {k}")),
        ] {
            if ui.button(name).on_hover_text(help).clicked() {
                command = Some(line);
            }
        }
    });
    command
}
