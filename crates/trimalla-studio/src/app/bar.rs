//! The rows of buttons on top.

use eframe::egui::{self, TextEdit, Ui};
use trimalla_workbench::{Document, MessageKind};

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
            self.show_files(ui);
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
        let said = ui.horizontal_wrapped(|ui| self.tools.show(ui)).inner;
        self.console.add(said.into_iter().map(|text| (MessageKind::Information, text)).collect());
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
    fn show_files(&mut self, ui: &mut Ui) {
        let label = ui.label("File");
        let edit = TextEdit::singleline(&mut self.path).desired_width(200.0).hint_text("name.poly");
        let field = ui.add(edit).labelled_by(label.id);
        let is_entered = field.lost_focus() && ui.input(|i| i.key_pressed(egui::Key::Enter));
        let is_opened = ui.button("Open").on_hover_text("loads a drawing or a mesh, or runs a script (.tri)").clicked();
        if is_opened || is_entered {
            let path = self.path.trim().to_owned();
            self.open(&path);
        }
        ui.menu_button("Write …", |ui| self.show_write(ui));
    }
}
