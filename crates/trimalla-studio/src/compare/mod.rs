//! Recipes side by side: each refines a copy of the document, in viewers that show the same part of the plane.

mod slot;
mod table;

use eframe::egui::{self, Panel, Ui};
use eframe::wgpu::TextureFormat;
use trimalla_workbench::{Document, MessageKind};

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
}

impl Compare {
    /// The page as it is at first: the document as it is, and two recipes.
    pub(crate) fn new(format: Option<TextureFormat>) -> Self {
        let mut compare = Self { slots: Vec::new(), view: View::default(), fits: true, format, next: 1 };
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
        Panel::top("compare").show(ui, |ui| {
            ui.horizontal_wrapped(|ui| said.extend(self.show_buttons(ui, worker)));
        });
        let most = (0.6 * ui.available_height()).max(40.0);
        Panel::bottom("results").resizable(true).default_size(220.0).max_size(most).show(ui, |ui| {
            egui::ScrollArea::vertical().auto_shrink(false).show(ui, |ui| table::show(ui, &self.slots, switches));
        });
        self.slots.iter_mut().for_each(|slot| said.extend(slot.poll()));
        if self.slots.iter().any(Slot::is_busy) {
            ui.ctx().request_repaint_after(std::time::Duration::from_millis(50));
        }
        self.show_viewers(ui, switches);
        said
    }

    fn show_buttons(&mut self, ui: &mut Ui, worker: &Worker) -> Option<Message> {
        let mut said = None;
        if ui.button("Run all").on_hover_text("refines a copy of the document by each recipe").clicked() {
            match worker.document().and_then(Document::triangulation) {
                Some(_) => {
                    self.slots.iter_mut().for_each(|slot| slot.run(worker, ui.ctx()));
                    self.fits = true;
                }
                None => said = Some((MessageKind::Error, "there is no triangulation to refine yet".to_owned())),
            }
        }
        let is_busy = self.slots.iter().any(Slot::is_busy);
        if is_busy {
            ui.spinner();
            if ui.button("Cancel all").clicked() {
                self.slots.iter_mut().for_each(Slot::cancel);
            }
        }
        ui.separator();
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
