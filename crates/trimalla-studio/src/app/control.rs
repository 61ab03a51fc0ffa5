//! The row that drives a refinement: step, back, play, to the end, and a slider over the history.

use std::time::Duration;

use eframe::egui::{Button, Slider, Ui, vec2};
use trimalla_workbench::Document;

use crate::viewer::switches::make_room;

/// The row.
#[derive(Debug)]
pub(super) struct Control {
    /// Steps a second while it plays.
    speed: f64,
    /// Since when it plays, in seconds of the window's clock; and how many commands could be undone then.
    plays: Option<Playing>,
    /// The version of the document before the last quiet command of a drag.
    before_drag: Option<u64>,
}

/// A play that goes on.
#[derive(Clone, Copy, Debug)]
struct Playing {
    next: f64,
    undoable: Option<usize>,
}

/// What the row asks for.
#[derive(Debug, Default)]
pub(super) struct Played {
    pub(super) command: Option<String>,
    pub(super) cancels: bool,
}

impl Default for Control {
    fn default() -> Self {
        Self { speed: 4.0, plays: None, before_drag: None }
    }
}

impl Control {
    /// Steps a second while something plays.
    pub(super) fn speed(&self) -> f64 {
        self.speed
    }

    /// Ends playing.
    pub(super) fn stop(&mut self) {
        self.plays = None;
    }

    /// Whether a drag goes on.
    pub(super) fn has_drag(&self) -> bool {
        self.before_drag.is_some()
    }

    /// Notes that the quiet command of a drag is run next.
    pub(super) fn begin_drag(&mut self, document: Option<&Document>) {
        self.before_drag = document.map(Document::version);
    }

    /// Whether the quiet command of a drag, which is done now, has changed the document: it is to be taken back before
    /// what follows it. A command that was refused stands nowhere.
    pub(super) fn takes_drag_back(&mut self, document: Option<&Document>) -> bool {
        self.before_drag.take().zip(document).is_some_and(|(before, document)| document.version() == before + 1)
    }

    /// Shows the row.
    pub(super) fn show(&mut self, ui: &mut Ui, document: Option<&Document>, is_busy: bool) -> Played {
        let mut played = Played::default();
        let mut ask = |command: String| played.command = Some(command);
        ui.horizontal_wrapped(|ui| {
            let (done, _) = document.map_or((1, 0), Document::undoable);
            let back = ui.add_enabled(done > 0, Button::new("Back"));
            let help = "takes the last command back, and with it what was picked since (left arrow)";
            if back.on_hover_text(help).clicked() {
                ask(super::bar::back(document));
            }
            if ui
                .button("Step")
                .on_hover_text("makes one step of refinement (right arrow, where nothing was taken back)")
                .clicked()
            {
                ask("Step".to_owned());
            }
            let name = if self.plays.is_some() { "Pause" } else { "Play" };
            let play = ui.add(Button::new(name).min_size(vec2(48.0, 0.0)));
            if play.on_hover_text("makes step after step").clicked() {
                self.plays = match self.plays {
                    Some(_) => None,
                    None => Some(Playing { next: ui.input(|i| i.time), undoable: None }),
                };
            }
            make_room(ui, 270.0);
            let speed = Slider::new(&mut self.speed, 0.5..=60.0).logarithmic(true).text("steps a second");
            ui.add(speed).on_hover_text("how fast 'Play' is");
            if ui.button("Refine").on_hover_text("refines to the end").clicked() {
                ask("Refine".to_owned());
            }
            if let Some(document) = document {
                self.show_history(ui, document, &mut ask);
            }
            if is_busy {
                ui.spinner();
                played.cancels = ui.button("Cancel").on_hover_text("stops the command at work (Escape)").clicked();
                self.plays = self.plays.filter(|_| !played.cancels);
            }
        });
        if let Some(document) = document {
            self.play(ui, document, &mut played);
        }
        played
    }

    /// Shows the slider over the history.
    fn show_history(&self, ui: &mut Ui, document: &Document, ask: &mut impl FnMut(String)) {
        let (done, undone) = document.undoable();
        let mut at = done;
        let all = done + undone;
        make_room(ui, 320.0);
        ui.spacing_mut().slider_width = 200.0;
        let slider = Slider::new(&mut at, 0..=all.max(1)).text("History");
        ui.add_enabled(all > 0, slider).on_hover_text("back and forth through all commands");
        let at = at.min(all);
        if at < done {
            ask(format!("Undo {}", done - at));
        } else if at > done {
            ask(format!("Redo {}", at - done));
        }
    }

    /// Makes the next step where it is time.
    fn play(&mut self, ui: &Ui, document: &Document, played: &mut Played) {
        let Some(playing) = &mut self.plays else { return };
        let (now, done) = (ui.input(|i| i.time), document.undoable().0);
        let has_ended = document.last_step().is_some_and(|event| event.outcome.is_last());
        if now >= playing.next {
            // The last step was refused, or nothing is left to do.
            if playing.undoable == Some(done) || playing.undoable.is_some() && has_ended {
                self.plays = None;
                ui.ctx().request_repaint();
                return;
            }
            *playing = Playing { next: now + 1.0 / self.speed, undoable: Some(done) };
            played.command = Some("Step".to_owned());
        }
        ui.ctx().request_repaint_after(Duration::from_secs_f64((playing.next - now).max(0.0)));
    }
}
