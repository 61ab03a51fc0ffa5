//! The rows of buttons on top.

use eframe::egui::{self, TextEdit, Ui};
use trimalla_workbench::script;

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
                if ui.button(name).on_hover_text(help).clicked() {
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
        ui.add(TextEdit::singleline(&mut self.path).desired_width(220.0)).labelled_by(label.id);
        for (name, word, help) in [
            ("Open", "Load", "loads a drawing or a mesh"),
            ("Export", "Export", "writes mesh or drawing in the format of the ending"),
            ("Save", "Save", "writes the commands that led here, as a script"),
        ] {
            if ui.button(name).on_hover_text(help).clicked() {
                self.fits |= word == "Load";
                command = Some(format!("{word} {}", script::word(self.path.trim())));
            }
        }
        command
    }
}
