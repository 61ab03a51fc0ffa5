//! The inspector: the picked triangle, and what can be done with it.
//!
//! It takes the same room whatever is picked: buttons first, then one line for each fact, cut where it is long.

use eframe::egui::{Button, Label, Slider, Ui};
use trimalla::quality::aspect_ratio;

use crate::scene::Picked;

/// Shows the picked triangle; the command of a button that was clicked.
pub(crate) fn show(ui: &mut Ui, mut picked: Option<&mut Picked>) -> Option<String> {
    ui.heading("Triangle");
    let [i, j, k] = picked.as_ref().map_or([0; 3], |picked| picked.names);
    let mut command = None;
    ui.horizontal_wrapped(|ui| {
        for (name, help, line) in [
            ("Insert midpoint", "the midpoint of the terminal edge", format!("Midpoint {i} {j} {k}")),
            ("Insert centroid", "the centroid of the terminal triangles", format!("Centroid {i} {j} {k}")),
            ("Refine this", "treats it once, by the options", format!("Treat {i} {j} {k}")),
            ("Until destroyed", "treats it until it is gone", format!("Treat {i} {j} {k} destroyed")),
            ("Show", "tells about it in the console", format!("Show {i} {j} {k}")),
        ] {
            if ui.add_enabled(picked.is_some(), Button::new(name)).on_hover_text(help).clicked() {
                command = Some(line);
            }
        }
    });
    show_walk(ui, picked.as_deref_mut());
    let facts = picked.as_deref().map_or_else(nothing_picked, facts);
    for (text, help) in facts {
        let label = ui.add(Label::new(text).truncate());
        if !help.is_empty() {
            label.on_hover_text(help);
        }
    }
    command
}

/// Shows the buttons that walk the path.
fn show_walk(ui: &mut Ui, picked: Option<&mut Picked>) {
    let all = picked.as_ref().map_or(1, |picked| picked.path.len());
    let mut none = 1;
    let shown = picked.map_or(&mut none, |picked| &mut picked.shown);
    ui.add_enabled_ui(all > 1, |ui| {
        ui.horizontal_wrapped(|ui| {
            if ui.button("Previous triangle").on_hover_text("one step back along the path").clicked() {
                *shown = shown.saturating_sub(1).max(1);
            }
            if ui.button("Next triangle").on_hover_text("walks the path across longest edges").clicked() {
                // After the last one the walk begins again.
                *shown = if *shown == all { 1 } else { *shown + 1 };
            }
            ui.spacing_mut().slider_width = 56.0;
            ui.add(Slider::new(shown, 1..=all).show_value(false)).on_hover_text("how much of the path is shown");
        });
    });
}

const FACTS: usize = 8;

fn nothing_picked() -> [(String, String); FACTS] {
    let mut lines: [(String, String); FACTS] = Default::default();
    lines[0].0 = "Click a triangle: here are its angles,".to_owned();
    lines[1].0 = "its circle and its longest-edge path.".to_owned();
    lines
}

/// What there is to know of a triangle, each with what stands under the pointer.
fn facts(picked: &Picked) -> [(String, String); FACTS] {
    let [i, j, k] = picked.names;
    let angles = picked.triangle.angles().map(|angle| format!("{:.2}°", angle.degrees()));
    let list = |all: &[[u32; 3]]| {
        let names = all.iter().map(|[i, j, k]| format!("{i}-{j}-{k}"));
        names.collect::<Vec<_>>().join(", ")
    };
    let [p, q] = picked.terminal_names;
    let area = picked.triangle.area();
    let plain = |text: String| (text, String::new());
    [
        plain(format!("vertices {i} {j} {k}")),
        plain(format!("angles {}", angles.join("  "))),
        (format!("area {area:.6}"), area.to_string()),
        plain(format!("aspect ratio {:.4}", aspect_ratio(&picked.triangle))),
        plain(format!("circle test: {}", if picked.passes_circle_test { "passed" } else { "an edge fails it" })),
        plain(format!("neighbours {}", list(&picked.neighbours))),
        (format!("path of {} triangles", picked.path.len()), list(&picked.path_names)),
        plain(format!("terminal edge {p}-{q}")),
    ]
}
