//! The row that plays what an algorithm has told: step, back, play, and a slider over its steps.
//!
//! What a drag or a play has got to is shown at once, and becomes one command, `Watch`, when it ends.

use std::time::Duration;

use eframe::egui::{Button, Label, Slider, Ui, vec2};
use trimalla_workbench::{Construction, Document};

use crate::told;
use crate::viewer::switches::make_room;

/// The row.
#[derive(Debug, Default)]
pub(super) struct Watch {
    /// So many steps are shown by a drag or a play that goes on, on that version of the document.
    under_way: Option<(u64, usize)>,
    /// When the next step is due, by the window's clock, while it plays.
    next: Option<f64>,
}

impl Watch {
    /// How many steps are shown; `None` where all are, and nothing plays.
    pub(super) fn shown(&self, document: &Document, construction: &Construction) -> Option<usize> {
        let under_way = self.at(document);
        let shown = under_way.unwrap_or(construction.shown());
        (under_way.is_some() || shown < construction.steps().len()).then_some(shown)
    }

    /// Ends playing.
    pub(super) fn stop(&mut self) {
        *self = Self::default();
    }

    fn at(&self, document: &Document) -> Option<usize> {
        self.under_way.filter(|(version, _)| *version == document.version()).map(|(_, shown)| shown)
    }

    /// Shows the row, with so many steps a second while it plays; a command.
    pub(super) fn show(&mut self, ui: &mut Ui, document: &Document, speed: f64) -> Option<String> {
        let construction = document.construction()?;
        let all = construction.steps().len();
        if self.at(document).is_none() {
            self.stop();
        }
        let before = self.at(document).unwrap_or(construction.shown());
        let (mut shown, mut is_done) = (before, false);
        ui.horizontal_wrapped(|ui| {
            ui.label("Algorithm").on_hover_text("what the algorithm has told that triangulated");
            let back = ui.add_enabled(shown > 0, Button::new("Step back"));
            if back.on_hover_text("to the step before").clicked() {
                (shown, is_done) = (shown - 1, true);
            }
            let forward = ui.add_enabled(shown < all, Button::new("Step forward"));
            if forward.on_hover_text("to the next step").clicked() {
                (shown, is_done) = (shown + 1, true);
            }
            let name = if self.next.is_some() { "Stop" } else { "Play steps" };
            let play = ui.add_enabled(all > 0, Button::new(name).min_size(vec2(72.0, 0.0)));
            if play.on_hover_text("step after step, from the beginning where all are shown").clicked() {
                (shown, is_done) = self.press_play(ui, shown, all);
            }
            make_room(ui, 340.0);
            ui.spacing_mut().slider_width = 200.0;
            let slider = ui.add(Slider::new(&mut shown, 0..=all.max(1)).text(format!("of {all} steps")));
            is_done |= slider.drag_stopped() || slider.changed() && !slider.dragged();
            let step = shown.checked_sub(1).and_then(|last| construction.steps().get(last));
            let text = step.map_or_else(|| "the beginning".to_owned(), |step| told::in_words(document, step));
            make_room(ui, 200.0);
            ui.add(Label::new(&text).truncate()).on_hover_text(text);
        });
        let shown = self.play(ui, shown.min(all), all, speed);
        if is_done || self.next.is_none() && shown == all && self.under_way.is_some() && before == all {
            self.stop();
            return (shown != construction.shown()).then(|| format!("Watch {shown}"));
        }
        if shown != before || self.next.is_some() {
            self.under_way = Some((document.version(), shown));
        }
        None
    }

    /// Begins to play, or ends; how many steps are shown, and whether that is to be kept.
    fn press_play(&mut self, ui: &Ui, shown: usize, all: usize) -> (usize, bool) {
        if self.next.take().is_some() {
            return (shown, true);
        }
        self.next = Some(ui.input(|i| i.time));
        (if shown == all { 0 } else { shown }, false)
    }

    /// The steps that are shown while it plays.
    fn play(&mut self, ui: &Ui, shown: usize, all: usize, speed: f64) -> usize {
        let Some(next) = self.next else { return shown };
        let now = ui.input(|i| i.time);
        // More than one where a frame takes longer.
        let due = if now < next { 0 } else { 1 + ((now - next) * speed) as usize };
        let shown = (shown + due).min(all);
        if shown == all {
            self.next = None;
            ui.ctx().request_repaint();
            return shown;
        }
        let next = next + due as f64 / speed;
        self.next = Some(next);
        ui.ctx().request_repaint_after(Duration::from_secs_f64((next - now).max(0.0)));
        shown
    }
}
