//! The page that one sees first.

use eframe::egui::{Grid, RichText, ScrollArea, Ui};
use trimalla_workbench::EXAMPLES;
use trimalla_workbench::script::{LEARN, scenes};

/// What was chosen on the welcome page.
pub(crate) enum Welcomed {
    /// A lesson, by its number.
    Lesson(usize),
    /// Commands.
    Run(String),
    /// An empty page to draw on.
    Draw,
}

/// Generated drawings: the name, and the commands.
const GENERATED: [(&str, &str); 4] = [
    ("200 random points", "Clear\nGenerate random 200 1\nTriangulate"),
    ("a random polygon", "Clear\nGenerate polygon 40 3\nTriangulate"),
    ("a spiral", "Clear\nGenerate spiral 200\nTriangulate"),
    ("a grid", "Clear\nGenerate grid 400\nTriangulate"),
];

/// Shows the page.
pub(crate) fn show(ui: &mut Ui) -> Option<Welcomed> {
    let mut chosen = None;
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        ui.heading("trimalla");
        ui.label("Planar triangulation and mesh refinement: see it, step it, replay it.");
        ui.add_space(12.0);
        ui.heading("Begin with a shape");
        ui.label("It is triangulated. Then 'Refine' makes good triangles of it, and 'Step' shows how.");
        ui.horizontal_wrapped(|ui| {
            for name in EXAMPLES {
                if ui.button(name).clicked() {
                    chosen = Some(Welcomed::Run(format!("Clear\nExample {name}\nTriangulate")));
                }
            }
            for (name, commands) in GENERATED {
                if ui.button(name).clicked() {
                    chosen = Some(Welcomed::Run(commands.to_owned()));
                }
            }
        });
        ui.horizontal_wrapped(|ui| {
            if ui.button("Draw my own").on_hover_text("an empty page, with the tool that draws an outline").clicked() {
                chosen = Some(Welcomed::Draw);
            }
            ui.label("or drop a file into the window, or open one by the row on top.");
        });
        ui.add_space(12.0);
        ui.heading("See an algorithm work");
        // Two columns, where there is room for them.
        let columns = if ui.available_width() > 560.0 { 2 } else { 1 };
        Grid::new("lessons").show(ui, |ui| {
            let rows = LEARN.len().div_ceil(columns);
            for number in (0..rows).flat_map(|row| (0..columns).map(move |column| row + column * rows)) {
                if let Some(lesson) = LEARN.get(number) {
                    if ui.button(RichText::new(lesson.title).strong()).clicked() {
                        chosen = Some(Welcomed::Lesson(number));
                    }
                    ui.label(format!("{} scenes", scenes(lesson.text).len()));
                }
                if number + rows >= columns * rows {
                    ui.end_row();
                }
            }
        });
        ui.add_space(12.0);
        ui.heading("Then");
        for text in [
            "Click a triangle: its angles, its circle and its longest-edge path show.",
            "'Back', the arrows and the slider go through everything that was done, back and forth.",
            "'Next triangle' in the panel on the right walks the path of a picked triangle.",
            "'by …' triangulates by any of many algorithms, and the row that appears plays its steps.",
            "'Compare' refines a copy by several recipes, side by side.",
            "Everything a click does appears in the console as a command; 'Write' keeps them as a script.",
        ] {
            ui.label(format!("•  {text}"));
        }
    });
    chosen
}
