//! One recipe of those that are compared: its options, a document of its own, its viewer.

use std::sync::Arc;

use eframe::egui::{self, ComboBox, DragValue, PointerButton, Ui};
use eframe::wgpu::TextureFormat;
use trimalla::refine::{Criteria, NamedOptions, Preset};
use trimalla_workbench::{Document, Figures, MessageKind, Quiet};

use crate::panels::configuration;
use crate::scene::Scene;
use crate::viewer::Viewer;
use crate::viewer::switches::Switches;
use crate::viewer::view::View;
use crate::worker::{Message, Worker};

/// A recipe, or the document as it is.
pub(super) struct Slot {
    viewer: Viewer,
    /// An empty document, whose options are the recipe; `None` for the document as it is.
    recipe: Option<Document>,
    worker: Worker,
    /// The name of the recipe with which it ran.
    ran: Option<String>,
}

impl Slot {
    /// With a preset, or as the document is.
    pub(super) fn new(number: u64, format: Option<TextureFormat>, preset: Option<&str>) -> Self {
        let recipe = preset.map(|preset| {
            let mut recipe = Document::new();
            // Only an unknown preset is refused, and then the default one stays.
            let _ = recipe.run(&format!("Set preset {preset}"), &mut Quiet);
            recipe
        });
        Self { viewer: Viewer { number, format }, recipe, worker: Worker::new(), ran: None }
    }

    pub(super) fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    pub(super) fn cancel(&mut self) {
        self.worker.cancel();
    }

    pub(super) fn scene(&self) -> &Arc<Scene> {
        self.worker.scene()
    }

    /// What came of it; `None` before it was run.
    pub(super) fn figures(&self) -> Option<&Figures> {
        (!self.scene().faces.is_empty()).then(|| &self.scene().figures)
    }

    /// How long the run took, or takes until now; `None` where nothing was to be done.
    pub(super) fn seconds(&self) -> Option<f64> {
        self.recipe.as_ref().and_then(|_| self.worker.seconds())
    }

    /// The recipe with which it ran, and whether that is still the one above the drawing.
    pub(super) fn title(&self) -> String {
        match &self.ran {
            Some(ran) if *ran != self.name() => format!("{ran} (changed since)"),
            Some(ran) => ran.clone(),
            None => format!("{} (not run yet)", self.name()),
        }
    }

    /// The recipe in words.
    pub(super) fn name(&self) -> String {
        let Some(recipe) = &self.recipe else { return "original".to_owned() };
        let options = recipe.options();
        let preset = options.preset.map_or("own steps", Preset::key);
        format!("{preset}, {}°", angle_deg(options))
    }

    /// Refines a copy of a document, unless a command is at work on it.
    pub(super) fn run(&mut self, document: &Worker, context: &egui::Context) {
        let Some(worker) = document.copy() else { return };
        self.worker = worker;
        let lines = match &self.recipe {
            Some(recipe) => recipe.script() + "Refine",
            // Nothing is changed, and the copy is drawn.
            None => String::new(),
        };
        self.ran = Some(self.name());
        self.worker.run(&lines, true, Some(context.clone()));
    }

    /// Takes what the run has said: its errors.
    pub(super) fn poll(&mut self) -> Vec<Message> {
        let (messages, _) = self.worker.poll();
        let name = self.name();
        messages
            .into_iter()
            .filter(|(kind, _)| *kind == MessageKind::Error)
            .map(|(kind, text)| (kind, format!("{name}: {text}")))
            .collect()
    }

    /// Shows its recipe and its drawing.
    pub(super) fn show(&mut self, ui: &mut Ui, view: &mut View, switches: &Switches, fits: bool) {
        ui.horizontal(|ui| self.show_recipe(ui));
        let name = format!("Drawing, {}", self.name());
        let scene = self.scene().clone();
        let shown = self.viewer.show(ui, (&scene, &name), view, switches, fits);
        if shown.response.dragged_by(PointerButton::Primary) {
            view.pan(shown.response.drag_delta());
        }
    }

    fn show_recipe(&mut self, ui: &mut Ui) {
        let number = self.viewer.number;
        let Some(recipe) = &mut self.recipe else {
            ui.strong("original").on_hover_text("the document as it is");
            return;
        };
        let options = recipe.options().clone();
        let mut command = None;
        let preset = options.preset.map_or("own steps", Preset::key);
        let shown = ComboBox::from_id_salt(("preset", number)).selected_text(preset).show_ui(ui, |ui| {
            for preset in Preset::ALL {
                if ui.selectable_label(options.preset == Some(preset), preset.key()).clicked() {
                    command = Some(format!("Set preset {}", preset.key()));
                }
            }
        });
        shown.response.on_hover_text("the recipe");
        let mut angle = angle_deg(&options);
        let drag = DragValue::new(&mut angle).range(0.0..=60.0).speed(0.1).suffix("°");
        if ui.add(drag).on_hover_text("the smallest angle asked for").changed() {
            command = Some(format!("Set min-angle {angle}"));
        }
        ui.menu_button("more", |ui| command = configuration::show(ui, &options).or(command.take()));
        if let Some(command) = command {
            // What is out of range is refused, and the option stays.
            let _ = recipe.run(&command, &mut Quiet);
        }
        if self.worker.is_busy() {
            ui.spinner();
        }
    }
}

/// The smallest angle asked for, in degrees.
fn angle_deg(options: &NamedOptions) -> f64 {
    options.min_angle_deg.unwrap_or(Criteria::DEFAULT_MIN_ANGLE_DEG)
}
