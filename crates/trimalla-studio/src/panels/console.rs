//! The console: what was said, and a line for commands.

use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::{Align, Color32, Id, Key, RichText, ScrollArea, TextEdit, Ui};
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
                let (text, colour) = match kind {
                    MessageKind::Information if has_missed(text) => (rounded(text), ui.visuals().warn_fg_color),
                    MessageKind::Information => (rounded(text), colour(*kind, is_dark)),
                    _ => (text.clone(), colour(*kind, is_dark)),
                };
                ui.label(RichText::new(text).monospace().color(colour));
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
            // Tab completes a name that was begun, and leaves the field otherwise.
            let is_begun = !self.input.is_empty() && !self.input.contains(' ');
            let edit = TextEdit::singleline(&mut self.input).hint_text("Help").lock_focus(is_begun);
            let response = ui.add(edit.desired_width(ui.available_width() - 60.0)).labelled_by(label.id);
            let is_entered = response.lost_focus() && ui.input(|i| i.key_pressed(Key::Enter));
            if response.has_focus() && self.take_keys(ui) {
                put_cursor_behind(ui, response.id, &self.input);
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

    /// Arrows walk through what was typed, Tab completes; whether either has changed the line.
    fn take_keys(&mut self, ui: &Ui) -> bool {
        let before = self.input.clone();
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
        self.input != before
    }
}

/// Puts the cursor of a field behind its text.
fn put_cursor_behind(ui: &Ui, field: Id, text: &str) {
    if let Some(mut state) = TextEdit::load_state(ui.ctx(), field) {
        state.cursor.set_char_range(Some(CCursorRange::one(CCursor::end_of_str(text))));
        state.store(ui.ctx(), field);
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

/// Whether a message tells of a refinement that has missed its bounds.
fn has_missed(text: &str) -> bool {
    text.ends_with(" below the bounds") && !text.ends_with(" 0 below the bounds")
}

/// A text whose long numbers are rounded to eight digits: no picture shows more.
pub(crate) fn rounded(text: &str) -> String {
    let is_of_number = |c: char| c.is_ascii_digit() || ".-+e".contains(c);
    let mut short = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit() || c == '-') {
        let (before, from) = rest.split_at(start);
        let (number, after) = from.split_at(from.find(|c| !is_of_number(c)).unwrap_or(from.len()));
        short.push_str(before);
        let is_long = number.contains('.') && number.chars().filter(char::is_ascii_digit).count() > 9;
        match number.parse::<f64>() {
            Ok(value) if is_long => short.push_str(&eight_digits(value)),
            _ => short.push_str(number),
        }
        rest = after;
    }
    short + rest
}

fn eight_digits(value: f64) -> String {
    let scientific = format!("{value:.7e}");
    scientific.parse::<f64>().map_or(scientific, |value| value.to_string())
}

#[cfg(test)]
mod tests {
    use super::rounded;

    #[test]
    fn long_numbers_are_rounded_and_all_else_stays() {
        for (text, wanted) in [
            ("vertex 9 at (0.12345678901234567, -3.5)", "vertex 9 at (0.12345679, -3.5)"),
            ("area 12.000000000000002.", "area 12.000000000000002."),
            ("area 12.000000000000002 in all", "area 12 in all"),
            ("mesh-2.svg written, 1234567890123 steps - all", "mesh-2.svg written, 1234567890123 steps - all"),
            ("1.2345678901234e-7", "0.00000012345679"),
            ("", ""),
        ] {
            assert_eq!(rounded(text), wanted);
        }
    }
}
