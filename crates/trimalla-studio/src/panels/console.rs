//! The console: what was said, and a line for commands.

use eframe::egui::{Align, Color32, Key, RichText, ScrollArea, TextEdit, Ui};
use trimalla_workbench::MessageKind;
use trimalla_workbench::script::completions;

use crate::worker::Message;

/// So many lines are kept.
const KEPT: usize = 5000;

/// The console.
#[derive(Debug, Default)]
pub(crate) struct Console {
    lines: Vec<Message>,
    /// Whether some of them were not shown yet.
    is_new: bool,
    input: String,
    /// Commands that were typed, the newest last.
    typed: Vec<String>,
    /// Which of them is shown, counted from the end.
    shown: usize,
}

impl Console {
    /// Adds messages.
    pub(crate) fn add(&mut self, messages: Vec<Message>) {
        self.is_new |= !messages.is_empty();
        self.lines.extend(messages);
        let surplus = self.lines.len().saturating_sub(KEPT);
        self.lines.drain(..surplus);
    }

    /// Shows the console; a command that was entered.
    pub(crate) fn show(&mut self, ui: &mut Ui) -> Option<String> {
        let entered = self.show_input(ui);
        let is_dark = ui.visuals().dark_mode;
        ScrollArea::vertical().stick_to_bottom(true).auto_shrink(false).show(ui, |ui| {
            for (kind, text) in &self.lines {
                ui.label(RichText::new(text).monospace().color(colour(*kind, is_dark)));
            }
            if std::mem::take(&mut self.is_new) {
                ui.scroll_to_cursor(Some(Align::BOTTOM));
            }
        });
        entered
    }

    fn show_input(&mut self, ui: &mut Ui) -> Option<String> {
        let mut entered = None;
        ui.horizontal(|ui| {
            let label = ui.label("Command");
            let edit =
                TextEdit::singleline(&mut self.input).hint_text("Help").desired_width(ui.available_width() - 60.0);
            let response = ui.add(edit).labelled_by(label.id);
            let is_entered = response.lost_focus() && ui.input(|i| i.key_pressed(Key::Enter));
            if response.has_focus() {
                self.take_keys(ui);
            }
            if ui.button("Run").clicked() || is_entered {
                let line = std::mem::take(&mut self.input);
                if !line.trim().is_empty() {
                    self.typed.push(line.clone());
                    entered = Some(line);
                }
                self.shown = 0;
                response.request_focus();
            }
        });
        entered
    }

    /// Arrows walk through what was typed, Tab completes.
    fn take_keys(&mut self, ui: &Ui) {
        let (up, down, tab) =
            ui.input(|i| (i.key_pressed(Key::ArrowUp), i.key_pressed(Key::ArrowDown), i.key_pressed(Key::Tab)));
        if up || down {
            let most = self.typed.len();
            self.shown = if up { (self.shown + 1).min(most) } else { self.shown.saturating_sub(1) };
            self.input = if self.shown == 0 { String::new() } else { self.typed[most - self.shown].clone() };
        }
        if tab && !self.input.contains(' ') {
            let names: Vec<&str> = completions(&self.input).collect();
            if let [only] = names[..] {
                self.input = format!("{only} ");
            }
        }
    }
}

/// Black, blue and red, as the source has it; readable on dark ground too.
fn colour(kind: MessageKind, is_dark: bool) -> Color32 {
    match (kind, is_dark) {
        (MessageKind::Command, true) => Color32::from_gray(230),
        (MessageKind::Command, false) => Color32::BLACK,
        (MessageKind::Information, true) => Color32::from_rgb(120, 170, 255),
        (MessageKind::Information, false) => Color32::from_rgb(0, 60, 200),
        (MessageKind::Error, true) => Color32::from_rgb(255, 120, 110),
        (MessageKind::Error, false) => Color32::from_rgb(200, 0, 0),
    }
}
