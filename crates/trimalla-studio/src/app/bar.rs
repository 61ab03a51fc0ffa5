//! The rows of buttons on top.

use eframe::egui::{self, RichText, TextEdit, Ui};
use trimalla::Method;
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
                if name == "Triangulate" {
                    let menu = ui.menu_button("by …", |ui| self.show_methods(ui));
                    let chosen = menu.inner.flatten();
                    commands.extend(chosen);
                    menu.response.on_hover_text("triangulates by another algorithm, whose steps can be played");
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
        let speed = self.control.speed();
        commands.extend(document.and_then(|document| self.watch.show(ui, document, speed)));
        if played.cancels {
            self.worker.cancel();
        }
        self.switches.show(ui);
        commands
    }

    /// Shows the algorithms, each with what it does; the commands of the one that was chosen.
    fn show_methods(&self, ui: &mut Ui) -> Option<String> {
        let mut chosen = None;
        egui::ScrollArea::vertical().max_height(0.7 * self.room).show(ui, |ui| {
            for method in Method::all().filter(|&method| method != Method::Conforming) {
                let row = method.row();
                let text = RichText::new(format!("{}: {}", row.key, row.summary));
                if ui.button(text).on_hover_text(format!("source: {}", row.source)).clicked() {
                    chosen = Some(method);
                    ui.close();
                }
            }
        });
        let command = format!("Triangulate {}", chosen?.key());
        let again = self.worker.document().and_then(since_triangulated);
        Some(again.map_or_else(|| command.clone(), |done| format!("Undo {done}\n{command}")))
    }

    /// Shows the file, and what is done with it.
    fn show_files(&mut self, ui: &mut Ui) {
        let label = ui.label("File");
        let edit = TextEdit::singleline(&mut self.path).desired_width(200.0).hint_text("name.poly");
        let field = ui.add(edit).labelled_by(label.id);
        let is_entered = field.lost_focus() && ui.input(|i| i.key_pressed(egui::Key::Enter));
        let is_opened = ui.button("Open").on_hover_text("loads a drawing or a mesh, or runs a script (.tri)").clicked();
        let is_browsed =
            self.dialogs.are_there && ui.button("Browse …").on_hover_text("asks for a file to open (Ctrl+O)").clicked();
        let path = self.path.trim().to_owned();
        if is_browsed || is_opened && path.is_empty() && self.dialogs.are_there {
            self.browse();
        } else if is_opened || is_entered {
            self.open(&path);
        }
        ui.menu_button("Write …", |ui| self.show_write(ui));
    }
}

/// How many commands lead back to before 'Triangulate', where nothing but looking has come after it.
fn since_triangulated(document: &Document) -> Option<usize> {
    let looks = last_of(document, &["Watch", "Select"]);
    let script = document.script();
    let last = script.lines().rev().nth(looks).and_then(|line| line.split_whitespace().next())?;
    (last.eq_ignore_ascii_case("Triangulate") && document.undoable().0 > looks).then_some(looks + 1)
}

/// The command that goes one step back. To pick a triangle is no step: nothing is drawn otherwise then.
pub(super) fn back(document: Option<&Document>) -> String {
    let picks = document.map_or(0, |document| last_of(document, &["Select"]));
    let is_more = document.is_some_and(|document| document.undoable().0 > picks);
    if picks > 0 && is_more { format!("Undo {}", picks + 1) } else { "Undo".to_owned() }
}

/// How many of the last commands are of these.
fn last_of(document: &Document, names: &[&str]) -> usize {
    let script = document.script();
    let first = |line: &str| line.split_whitespace().next().unwrap_or_default().to_owned();
    let is = |line: &&str| names.iter().any(|name| first(line).eq_ignore_ascii_case(name));
    script.lines().rev().take_while(is).count()
}
