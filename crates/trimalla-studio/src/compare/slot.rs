//! One recipe of those that are compared: its options, a document of its own, its viewer.

use std::sync::Arc;

use eframe::egui::{
    self, ComboBox, DragValue, Label, Order, PointerButton, Popup, PopupCloseBehavior, Response, RichText, Ui,
};
use eframe::wgpu::TextureFormat;
use trimalla::refine::{Criteria, Group, NamedOptions, OPTIONS, Preset, Values};
use trimalla_workbench::{Document, Figures, MessageKind, Quiet};

use crate::panels::configuration;
use crate::scene::Scene;
use crate::viewer::Viewer;
use crate::viewer::switches::Switches;
use crate::viewer::view::View;
use crate::worker::{Message, Worker};

/// How wide the fields of preset and angle are.
const PRESET: f32 = 140.0;
const ANGLE: f32 = 56.0;

/// A recipe, or the document as it is.
pub(super) struct Slot {
    viewer: Viewer,
    /// An empty document, whose options are the recipe; `None` for the document as it is.
    recipe: Option<Document>,
    /// Whether its angle was changed here: until then it is that of the document.
    has_own_angle: bool,
    worker: Worker,
    /// The name of the recipe with which it ran, and the number of what the document held then.
    ran: Option<(String, u64)>,
    /// Whether the document holds something else now.
    is_stale: bool,
    /// What is drawn.
    scene: Arc<Scene>,
    /// Whether all options are shown.
    is_open: bool,
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
        Self {
            viewer: Viewer { number, format },
            recipe,
            has_own_angle: false,
            worker: Worker::new(),
            ran: None,
            is_stale: false,
            scene: Arc::default(),
            is_open: false,
        }
    }

    pub(super) fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    pub(super) fn cancel(&mut self) {
        self.worker.cancel();
    }

    pub(super) fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// Notes what the document holds, and what is drawn of it: that is the original, until the recipes have run.
    pub(super) fn note(&mut self, document: &Arc<Scene>, state: u64) {
        self.is_stale = self.ran.as_ref().is_some_and(|(_, ran)| *ran != state);
        let is_present = self.recipe.is_none() && (self.ran.is_none() || self.is_stale);
        let scene = if is_present { document } else { self.worker.scene() };
        if !Arc::ptr_eq(&self.scene, scene) {
            self.scene = scene.clone();
        }
    }

    /// Takes the angle that the document is asked for, unless it has its own.
    pub(super) fn follow(&mut self, asked: &NamedOptions) {
        let Some(recipe) = self.recipe.as_mut().filter(|_| !self.has_own_angle) else { return };
        let angle = angle_deg(asked);
        if angle_deg(recipe.options()) != angle {
            // The document has it: it is in range.
            let _ = recipe.run(&format!("Set min-angle {angle}"), &mut Quiet);
        }
    }

    /// What came of it; `None` before it was run.
    pub(super) fn figures(&self) -> Option<&Figures> {
        (!self.scene().faces.is_empty()).then(|| &self.scene().figures)
    }

    /// How long the run took, or takes until now; `None` where nothing was to be done.
    pub(super) fn seconds(&self) -> Option<f64> {
        self.recipe.as_ref().and_then(|_| self.worker.seconds())
    }

    /// The recipe with which it ran, and whether that is still the one above the drawings, and the drawing the same.
    pub(super) fn title(&self) -> String {
        match &self.ran {
            _ if self.recipe.is_none() => self.name(),
            Some((ran, _)) if self.is_stale => format!("{ran} (of an earlier drawing)"),
            Some((ran, _)) if *ran != self.name() => format!("{ran} (changed since)"),
            Some((ran, _)) => ran.clone(),
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
    pub(super) fn run(&mut self, document: &Worker, state: u64, context: &egui::Context) {
        let Some(worker) = document.copy() else { return };
        self.worker = worker;
        let lines = match &self.recipe {
            Some(recipe) => lines_of(recipe.options()) + "Refine",
            // Nothing is changed, and the copy is drawn.
            None => String::new(),
        };
        self.ran = Some((self.name(), state));
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

    /// Shows its drawing.
    pub(super) fn show(&mut self, ui: &mut Ui, view: &mut View, switches: &Switches, fits: bool) {
        let title = self.title();
        let text = RichText::new(if self.is_busy() { format!("{title}, at work …") } else { title }).strong();
        let is_told = self.is_stale && self.recipe.is_some();
        let text = if is_told { text.color(ui.visuals().warn_fg_color) } else { text };
        ui.add(Label::new(text).truncate());
        let name = format!("Drawing, {}", self.name());
        let scene = self.scene.clone();
        let shown = self.viewer.show(ui, (&scene, &name), view, switches, fits);
        if shown.response.dragged_by(PointerButton::Primary) {
            view.pan(shown.response.drag_delta());
        }
    }

    /// Shows the fields of its recipe, which take the same room whatever stands in them.
    pub(super) fn show_recipe(&mut self, ui: &mut Ui) {
        let number = self.viewer.number;
        let Some(recipe) = &mut self.recipe else { return };
        let options = recipe.options().clone();
        let mut command = None;
        ui.push_id(number, |ui| {
            ui.group(|ui| command = show_fields(ui, number, &options, &mut self.is_open));
        });
        if let Some(command) = command {
            self.has_own_angle |= command.starts_with("Set min-angle");
            // What is out of range is refused, and the option stays.
            let _ = recipe.run(&command, &mut Quiet);
        }
    }
}

/// Shows preset, angle and a button for the rest; the command of what was changed.
fn show_fields(ui: &mut Ui, number: u64, options: &NamedOptions, is_open: &mut bool) -> Option<String> {
    let mut command = None;
    let preset = options.preset.map_or("own steps", Preset::key);
    let combo = ComboBox::from_id_salt(("preset", number)).width(PRESET).truncate().selected_text(preset);
    let shown = combo.show_ui(ui, |ui| {
        for preset in Preset::ALL {
            if ui.selectable_label(options.preset == Some(preset), preset.key()).clicked() {
                command = Some(format!("Set preset {}", preset.key()));
            }
        }
    });
    shown.response.on_hover_text("the recipe");
    let mut angle = angle_deg(options);
    let drag = DragValue::new(&mut angle).range(0.0..=60.0).speed(0.1).suffix("°").update_while_editing(false);
    if ui.add_sized([ANGLE, ui.spacing().interact_size.y], drag).on_hover_text("the smallest angle asked for").changed()
    {
        command = Some(format!("Set min-angle {angle}"));
    }
    let more = ui.button("more").on_hover_text("all options of this recipe");
    if more.clicked() {
        *is_open = !*is_open;
    }
    let popup = Popup::from_response(&more).open_bool(is_open).close_behavior(PopupCloseBehavior::IgnoreClicks);
    let all = popup.show(|ui| configuration::show(ui, options));
    if all.is_some() && is_clicked_outside(ui, &more) {
        *is_open = false;
    }
    all.and_then(|all| all.inner).or(command)
}

/// Whether somebody clicked neither the button nor into what opens above the page: the options, and the lists of these.
fn is_clicked_outside(ui: &Ui, button: &Response) -> bool {
    let clicked = ui.input(|i| i.pointer.interact_pos().filter(|_| i.pointer.any_click()));
    let is_above = |at| ui.ctx().layer_id_at(at).is_some_and(|layer| layer.order >= Order::Foreground);
    clicked.is_some_and(|at| !button.rect.contains(at) && !is_above(at))
}

/// Commands that set all that a recipe has: the document may have other options.
fn lines_of(options: &NamedOptions) -> String {
    let preset = options.preset.map(|preset| format!("Set preset {}\n", preset.key()));
    let others = OPTIONS.iter().filter(|row| row.group != Group::Preset && !matches!(row.values, Values::Text(_)));
    let others = others.filter_map(|row| Some(format!("Set {} {}\n", row.key, row.get(options)?)));
    preset.into_iter().chain(others).collect()
}

/// The smallest angle asked for, in degrees.
fn angle_deg(options: &NamedOptions) -> f64 {
    options.min_angle_deg.unwrap_or(Criteria::DEFAULT_MIN_ANGLE_DEG)
}
