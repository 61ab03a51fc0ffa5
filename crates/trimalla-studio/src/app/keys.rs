//! The keys of the window.

use eframe::egui::{self, Key, Ui};
use trimalla_workbench::MessageKind;

use super::{Page, Studio};
use crate::tools::Tool;

impl Studio {
    /// Keys that work wherever the pointer is; while one types, only that of the dialog that opens a file.
    pub(super) fn take_keys(&mut self, ui: &Ui) -> Vec<String> {
        let with_command = |key: Key| ui.input_mut(|i| i.consume_key(egui::Modifiers::COMMAND, key));
        if self.dialogs.are_there && with_command(Key::O) {
            self.browse();
        }
        if ui.ctx().egui_wants_keyboard_input() {
            return Vec::new();
        }
        let pressed = |key: Key| ui.input(|i| i.key_pressed(key) && i.modifiers.is_none());
        let mut commands = Vec::new();
        if ui.input_mut(|i| i.consume_key(egui::Modifiers::COMMAND | egui::Modifiers::SHIFT, Key::Z))
            || with_command(Key::Y)
        {
            commands.push("Redo".to_owned());
        }
        if with_command(Key::Z) {
            commands.push("Undo".to_owned());
        }
        if pressed(Key::Escape) {
            let said = self.tools.drop_begun();
            self.console.add(said.into_iter().map(|text| (MessageKind::Information, text)).collect());
            self.control.stop();
            self.watch.stop();
            self.worker.cancel();
        }
        if pressed(Key::F) {
            self.fits = true;
        }
        // The others belong to the rows of the drawing.
        if self.page != Page::Draw {
            return commands;
        }
        if pressed(Key::ArrowRight) {
            let has_future = self.worker.document().is_some_and(|document| document.undoable().1 > 0);
            commands.push(if has_future { "Redo" } else { "Step" }.to_owned());
        }
        if pressed(Key::ArrowLeft) {
            commands.push(super::bar::back(self.worker.document()));
        }
        for (number, (tool, ..)) in NUMBERS.into_iter().zip(Tool::ALL) {
            if pressed(number) {
                let said = self.tools.change(tool);
                self.console.add(said.into_iter().map(|text| (MessageKind::Information, text)).collect());
            }
        }
        commands
    }
}

/// The keys of the tools.
const NUMBERS: [Key; 8] = [Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7, Key::Num8];
