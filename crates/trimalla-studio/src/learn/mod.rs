//! The welcome page, and lessons that play in the drawing: scenes of commands with captions.

mod welcome;

use eframe::egui::{self, Slider, Ui};
use trimalla_workbench::Document;
use trimalla_workbench::script::{Lesson, Scene, scenes};

use crate::viewer::switches::make_room;

pub(crate) use self::welcome::{Welcomed, show as show_welcome};

/// A lesson that was begun.
pub(crate) struct Playing {
    title: &'static str,
    scenes: Vec<Scene>,
    /// So many scenes were shown.
    shown: usize,
    /// How many commands were done before each of them.
    before: Vec<usize>,
    plays: bool,
    /// Seconds between scenes that play.
    pause: f64,
    /// When the next scene is due, by the window's clock.
    next: f64,
}

/// What a lesson asks for.
pub(crate) enum Asked {
    /// These commands.
    Run(String),
    /// The lesson is over; the command that brings back what was there before.
    End(Option<String>),
}

impl Playing {
    /// Begins a lesson.
    pub(crate) fn new(lesson: &Lesson) -> Self {
        Self {
            title: lesson.title,
            scenes: scenes(lesson.text),
            shown: 0,
            before: Vec::new(),
            plays: false,
            pause: 4.0,
            next: 0.0,
        }
    }

    /// Shows the caption and the buttons; what was asked for.
    pub(crate) fn show(&mut self, ui: &mut Ui, document: Option<&Document>) -> Option<Asked> {
        let mut asked = None;
        ui.horizontal_wrapped(|ui| {
            ui.strong(self.title);
            ui.label(format!("{} of {}", self.shown, self.scenes.len()));
            if ui.add_enabled(self.shown > 0, egui::Button::new("Previous scene")).clicked() {
                (self.plays, asked) = (false, document.and_then(|document| self.back(document)));
            }
            let next = ui.add_enabled(!self.is_over(), egui::Button::new("Next scene"));
            if next.on_hover_text("runs the commands of the next scene").clicked() {
                asked = document.and_then(|document| self.forward(document));
            }
            let name = if self.plays { "Pause lesson" } else { "Play lesson" };
            if ui.add_enabled(!self.is_over() || self.plays, egui::Button::new(name)).clicked() {
                self.plays = !self.plays;
                self.next = ui.input(|i| i.time);
            }
            make_room(ui, 280.0);
            ui.add(Slider::new(&mut self.pause, 0.5..=15.0).text("seconds a scene"));
            if ui.button("End lesson").on_hover_text("brings back what was there before").clicked() {
                let begun = self.before.first().copied();
                let done = document.zip(begun).map(|(document, begun)| document.undoable().0.saturating_sub(begun));
                asked = Some(Asked::End(done.filter(|&done| done > 0).map(|done| format!("Undo {done}"))));
            }
        });
        let caption = self.shown.checked_sub(1).and_then(|last| self.scenes.get(last)).map(|scene| &*scene.caption);
        ui.label(caption.unwrap_or("'Next scene' begins."));
        asked.or_else(|| self.play(ui, document?))
    }

    fn is_over(&self) -> bool {
        self.shown == self.scenes.len()
    }

    /// The commands of the next scene; the first begins with an empty document.
    pub(crate) fn forward(&mut self, document: &Document) -> Option<Asked> {
        let scene = self.scenes.get(self.shown)?;
        let first = if self.shown == 0 { "Clear\n" } else { "" };
        let commands = format!("{first}{}", scene.lines.join("\n"));
        self.before.push(document.undoable().0);
        self.shown += 1;
        Some(Asked::Run(commands))
    }

    /// Takes the commands of the last scene back.
    fn back(&mut self, document: &Document) -> Option<Asked> {
        let before = self.before.pop()?;
        self.shown -= 1;
        let done = document.undoable().0.saturating_sub(before);
        (done > 0).then(|| Asked::Run(format!("Undo {done}")))
    }

    /// The next scene, if it plays and it is time.
    fn play(&mut self, ui: &Ui, document: &Document) -> Option<Asked> {
        if !self.plays {
            return None;
        }
        let now = ui.input(|i| i.time);
        if self.is_over() {
            self.plays = false;
            return None;
        }
        let asked = if now >= self.next { self.forward(document) } else { None };
        if asked.is_some() {
            self.next = now + self.pause;
        }
        ui.ctx().request_repaint_after(std::time::Duration::from_secs_f64((self.next - now).max(0.0)));
        asked
    }
}
