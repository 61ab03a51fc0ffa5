//! Recipes side by side: each refines a copy of the document, in viewers that show the same part of the plane.

mod base;
mod slot;
mod table;

use eframe::egui::{self, Panel, Ui};
use eframe::wgpu::TextureFormat;
use trimalla_workbench::{Document, MessageKind};

use self::base::{Base, Made, state_of};
use self::slot::Slot;
use crate::viewer::switches::Switches;
use crate::viewer::view::View;
use crate::worker::{Message, Worker};

/// No more recipes than these stand side by side.
const MOST: usize = 4;

/// A viewer is no lower than this.
const LEAST: f32 = 120.0;

/// The page.
pub(crate) struct Compare {
    slots: Vec<Slot>,
    view: View,
    fits: bool,
    format: Option<TextureFormat>,
    /// Viewers get numbers of their own; the first one is that of the main page.
    next: u64,
    /// What the recipes wait for.
    base: Option<Base>,
    /// The version of the document, and the number of what it holds.
    state: (Option<u64>, u64),
}

impl Compare {
    /// The page as it is at first: the document as it is, and two recipes.
    pub(crate) fn new(format: Option<TextureFormat>) -> Self {
        let mut compare = Self {
            slots: Vec::new(),
            view: View::default(),
            fits: true,
            format,
            next: 1,
            base: None,
            state: (None, 0),
        };
        compare.add(None);
        compare.add(Some("off-center"));
        compare.add(Some("lepp-centroid"));
        compare
    }

    fn add(&mut self, preset: Option<&str>) {
        self.slots.push(Slot::new(self.next, self.format, preset));
        self.next += 1;
    }

    /// Shows the page; messages to the user.
    pub(crate) fn show(&mut self, ui: &mut Ui, worker: &Worker, switches: &Switches) -> Vec<Message> {
        let mut said = Vec::new();
        self.note(worker);
        Panel::top("compare").show(ui, |ui| {
            ui.horizontal_wrapped(|ui| said.extend(self.show_buttons(ui, worker)));
            // Below each other, so that one that is added moves no field of the others.
            ui.horizontal_wrapped(|ui| self.slots.iter_mut().for_each(|slot| slot.show_recipe(ui)));
        });
        let most = (0.6 * ui.available_height()).max(40.0);
        Panel::bottom("results").resizable(true).default_size(220.0).max_size(most).show(ui, |ui| {
            egui::ScrollArea::both().auto_shrink(false).show(ui, |ui| table::show(ui, &self.slots, switches));
        });
        said.extend(self.begin(worker, ui.ctx()));
        self.slots.iter_mut().for_each(|slot| said.extend(slot.poll()));
        if self.is_busy() {
            ui.ctx().request_repaint_after(std::time::Duration::from_millis(50));
        }
        self.show_viewers(ui, switches);
        said
    }

    /// Notes what the document holds now.
    fn note(&mut self, worker: &Worker) {
        if let Some(document) = worker.document().filter(|document| self.state.0 != Some(document.version())) {
            self.state = (Some(document.version()), state_of(document));
        }
        let state = self.state.1;
        let asked = worker.document().map(Document::options);
        for slot in &mut self.slots {
            slot.note(worker.scene(), state);
            asked.into_iter().for_each(|options| slot.follow(options));
        }
    }

    fn is_busy(&self) -> bool {
        self.base.is_some() || self.slots.iter().any(Slot::is_busy)
    }

    /// Begins the recipes, once there is what they wait for.
    fn begin(&mut self, worker: &Worker, context: &egui::Context) -> Option<Message> {
        let (made, said) = self.base.as_mut()?.poll(worker, context);
        match made {
            Made::NotYet => return said,
            Made::Ready(ready) => self.run(&ready, context),
            Made::Failed => {}
        }
        self.base = None;
        said
    }

    fn run(&mut self, from: &Worker, context: &egui::Context) {
        let state = self.state.1;
        self.slots.iter_mut().for_each(|slot| slot.run(from, state, context));
        self.fits = true;
    }

    fn show_buttons(&mut self, ui: &mut Ui, worker: &Worker) -> Option<Message> {
        let mut said = None;
        let run = ui.add_enabled(self.base.is_none(), egui::Button::new("Run all"));
        if run.on_hover_text("refines a copy of the document by each recipe").clicked() {
            match worker.document().map(Document::triangulation) {
                Some(Some(_)) => {
                    self.base = Base::before_steps(worker, ui.ctx());
                    if self.base.is_none() {
                        self.run(worker, ui.ctx());
                    }
                }
                Some(None) => said = Some((MessageKind::Error, "there is no triangulation to refine yet".to_owned())),
                None => said = Some((MessageKind::Error, "a command is at work on the document".to_owned())),
            }
        }
        let is_busy = self.is_busy();
        let add = ui.add_enabled(self.slots.len() < MOST, egui::Button::new("Add recipe"));
        if add.on_hover_text("one more, up to four").clicked() {
            self.add(Some("lepp-midpoint"));
        }
        let remove = ui.add_enabled(self.slots.len() > 1 && !is_busy, egui::Button::new("Remove last"));
        if remove.clicked() {
            self.slots.pop();
        }
        if ui.button("Fit all").on_hover_text("shows everything").clicked() {
            self.fits = true;
        }
        // At the end, so that it moves nothing where it comes and goes.
        if is_busy {
            if ui.button("Cancel all").clicked() {
                self.base = None;
                self.slots.iter_mut().for_each(Slot::cancel);
            }
            ui.spinner();
        }
        said
    }

    /// Shows the viewers, two a row where there are more than two.
    fn show_viewers(&mut self, ui: &mut Ui, switches: &Switches) {
        let fits = std::mem::take(&mut self.fits);
        // Nothing to fit yet: again in the next frame.
        self.fits = fits && self.slots.iter().all(|slot| slot.scene().bounds.is_none());
        let columns = if self.slots.len() == 4 { 2 } else { self.slots.len() };
        let rows = self.slots.len().div_ceil(columns.max(1));
        let room = ui.available_height() / rows as f32 - ui.spacing().item_spacing.y;
        // In a small window one scrolls.
        let height = room.max(LEAST);
        let view = &mut self.view;
        egui::ScrollArea::vertical().scroll_source(egui::scroll_area::ScrollSource::SCROLL_BAR).show(ui, |ui| {
            for row in self.slots.chunks_mut(columns.max(1)) {
                ui.allocate_ui(egui::vec2(ui.available_width(), height), |ui| {
                    ui.columns(columns, |cells| {
                        for (ui, slot) in cells.iter_mut().zip(row) {
                            ui.set_height(height);
                            slot.show(ui, view, switches, fits);
                        }
                    });
                });
            }
        });
    }
}
