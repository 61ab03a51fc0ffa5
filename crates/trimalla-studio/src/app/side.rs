//! The panel on the right.
//!
//! Buttons and fields stand above texts whose length changes, so that none moves under the pointer.

use eframe::egui::{RichText, Ui};

use super::Studio;
use crate::panels::{configuration, information, inspector, plan, step};

impl Studio {
    /// Shows the panel; a command.
    pub(super) fn show_side(&mut self, ui: &mut Ui) -> Option<String> {
        if self.worker.document().is_none() {
            self.show_progress(ui);
            return None;
        }
        let document = self.worker.document()?;
        let planned = plan::show(ui, &mut self.tools.edge, document);
        let inspected = inspector::show(ui, self.picked.as_mut());
        ui.separator();
        let configured = configuration::show(ui, document.options());
        ui.separator();
        if let Some(missed) = &self.missed {
            ui.label(RichText::new(missed).strong().color(ui.visuals().warn_fg_color));
        }
        if document.last_step().is_some() {
            step::show(ui, document);
            ui.separator();
        }
        let drawn = (&**self.worker.scene(), self.worker.growth());
        information::show(ui, (document, self.source.as_deref()), drawn, &self.course, self.switches.threshold_deg);
        configured.or(inspected).or(planned)
    }

    /// What there is to see of the command at work.
    fn show_progress(&self, ui: &mut Ui) {
        ui.heading("At work");
        let growth = self.worker.growth();
        if let Some(last) = growth.last() {
            let figures = &last.figures;
            ui.label(format!("{:.1} s: {} triangles", last.seconds, figures.triangles));
            ui.label(format!("{} vertices, {} added", figures.vertices, figures.steiner));
            ui.label(format!("smallest angle {:.2}°", figures.min_angle_deg));
            information::show_growth(ui, growth);
        }
    }
}
