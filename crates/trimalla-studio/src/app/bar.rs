//! The rows of buttons on top.

use eframe::egui::{self, TextEdit, Ui};
use trimalla_workbench::{Document, script};

use super::{Page, Studio};

impl Studio {
    /// Shows the rows; commands of what was clicked.
    pub(super) fn show_bar(&mut self, ui: &mut Ui) -> Vec<String> {
        let mut commands = Vec::new();
        ui.horizontal_wrapped(|ui| {
            for (page, name, help) in [
                (Page::Welcome, "Learn", "shapes to begin with, and lessons"),
                (Page::Draw, "Draw", "the document"),
                (Page::Compare, "Compare", "recipes side by side, each on a copy of the document"),
            ] {
                ui.selectable_value(&mut self.page, page, name).on_hover_text(help);
            }
            let is_dark = ui.visuals().dark_mode;
            if ui.selectable_label(is_dark, "Dark").on_hover_text("light or dark").clicked() {
                ui.ctx().set_theme(if is_dark { egui::Theme::Light } else { egui::Theme::Dark });
            }
            ui.separator();
            commands.extend(self.show_files(ui));
            ui.separator();
            for (name, help) in [
                ("Triangulate", "triangulates the drawing"),
                ("Undo", "takes the last command back (Ctrl+Z)"),
                ("Redo", "does again what was taken back (Ctrl+Y)"),
                ("Check", "checks every invariant of the triangulation"),
                ("Clear", "begins an empty document"),
            ] {
                // While a command is at work, a message says so.
                let (done, undone) = self.worker.document().map_or((1, 1), Document::undoable);
                let is_possible = match name {
                    "Undo" => done > 0,
                    "Redo" => undone > 0,
                    _ => true,
                };
                if ui.add_enabled(is_possible, egui::Button::new(name)).on_hover_text(help).clicked() {
                    commands.push(name.to_owned());
                }
            }
            ui.separator();
            if ui.button("Fit").on_hover_text("shows everything (F)").clicked() {
                self.fits = true;
            }
        });
        match self.page {
            Page::Welcome => return commands,
            Page::Compare => {
                self.switches.show(ui);
                return commands;
            }
            Page::Draw => {}
        }
        ui.horizontal_wrapped(|ui| self.tools.show(ui));
        let document = self.worker.document();
        let played = self.control.show(ui, document, self.worker.is_busy());
        commands.extend(played.command);
        if played.cancels {
            self.worker.cancel();
        }
        self.switches.show(ui);
        commands
    }

    /// Shows the file, and what is done with it.
    fn show_files(&mut self, ui: &mut Ui) -> Option<String> {
        let mut command = None;
        let label = ui.label("File");
        let edit = TextEdit::singleline(&mut self.path).desired_width(200.0).hint_text("name.poly");
        let field = ui.add(edit).labelled_by(label.id);
        let is_entered = field.lost_focus() && ui.input(|i| i.key_pressed(egui::Key::Enter));
        let is_opened = ui.button("Open").on_hover_text("loads a drawing or a mesh, or runs a script (.tri)").clicked();
        if is_opened || is_entered {
            let path = self.path.trim().to_owned();
            self.open(&path);
        }
        ui.menu_button("Write …", |ui| {
            let stem = self.stem();
            for (name, word, ending, help) in WRITTEN {
                let file = format!("{stem}{ending}");
                if ui.button(format!("{name}: {file}")).on_hover_text(help).clicked() {
                    command = Some(format!("{word} {}", script::word(&file)));
                    ui.close();
                }
            }
            ui.separator();
            let named = ui.button("In the format of the name above").on_hover_text("by its ending");
            if named.clicked() {
                command = Some(format!("Export {}", script::word(self.path.trim())));
                ui.close();
            }
        });
        command
    }

    /// The name above without its ending, to which others are put.
    fn stem(&self) -> String {
        let path = std::path::Path::new(self.path.trim());
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
        let stem = path.with_extension("");
        let stem = stem.to_string_lossy();
        // What is read is not replaced.
        let is_input = ["poly", "node", "ele", "mesh", "soup", "txt"].contains(&&*ending);
        match (stem.is_empty(), is_input) {
            (true, _) => "mesh".to_owned(),
            (false, true) => format!("{stem}.1"),
            (false, false) => stem.into_owned(),
        }
    }
}

/// What can be written: its name, the command, the ending, the help.
const WRITTEN: [(&str, &str, &str, &str); 8] = [
    ("Picture", "Export", ".svg", "lines that scale"),
    ("Picture", "Export", ".png", "pixels"),
    ("Player", "Player", ".html", "one page that plays the refinement in any browser, step by step"),
    ("Mesh", "Export", ".ele", "with .node and .poly, as Triangle writes them"),
    ("Mesh", "Export", ".vtu", "for ParaView"),
    ("Mesh", "Export", ".mesh", "as MeshSuite writes it"),
    ("Script", "Save", ".tri", "the commands that led here"),
    ("Recipe", "SaveRecipe", ".toml", "the options on the right"),
];
