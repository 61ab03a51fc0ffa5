//! The window: which panel is where, and what its buttons run.

use eframe::egui::{self, CentralPanel, Panel, Rect, Sense, Ui};
use trimalla::geometry::math;
use trimalla::locate::Locus;
use trimalla_workbench::{Document, MessageKind, script};

use crate::console::Console;
use crate::scene::{Picked, Scene};
use crate::view::View;
use crate::viewer::{self, Switches};
use crate::worker::Worker;
use crate::{configuration, inspector};

/// What a click into the drawing does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Tool {
    /// Picks a triangle.
    #[default]
    Pick,
    /// Inserts a vertex.
    Insert,
    /// Joins two vertices by a constrained edge.
    Edge,
    /// Deletes a vertex.
    Delete,
}

impl Tool {
    const ALL: [(Self, &'static str, &'static str); 4] = [
        (Self::Pick, "Pick", "picks a triangle"),
        (Self::Insert, "Insert", "inserts a vertex"),
        (Self::Edge, "Edge", "joins two vertices by a constrained edge"),
        (Self::Delete, "Delete", "deletes a vertex"),
    ];
}

/// The studio.
pub struct Studio {
    worker: Worker,
    scene: Scene,
    picked: Option<Picked>,
    console: Console,
    view: View,
    /// Whether the next frame shows everything.
    fits: bool,
    switches: Switches,
    tool: Tool,
    /// The first vertex of an edge to be drawn.
    from: Option<u32>,
    path: String,
}

impl Default for Studio {
    fn default() -> Self {
        Self::new()
    }
}

impl Studio {
    /// A studio with an empty document.
    #[must_use]
    pub fn new() -> Self {
        Self {
            worker: Worker::new(),
            scene: Scene::default(),
            picked: None,
            console: Console::default(),
            view: View::default(),
            fits: true,
            switches: Switches::default(),
            tool: Tool::default(),
            from: None,
            path: String::new(),
        }
    }

    /// Opens a drawing or a mesh, or runs a script (`.tri`).
    pub fn open(&mut self, path: &str) {
        self.path = path.to_owned();
        self.fits = true;
        if path.ends_with(".tri") {
            match script::read(path) {
                Ok(text) => self.run(text, None),
                Err(error) => self.console.add(vec![(MessageKind::Error, error.to_string())]),
            }
        } else {
            self.run(format!("Load {}", script::word(path)), None);
        }
    }

    /// The document, unless a command is at work on it.
    #[must_use]
    pub fn document(&self) -> Option<&Document> {
        self.worker.document()
    }

    /// Runs commands, one a line.
    fn run(&mut self, text: String, context: Option<&egui::Context>) {
        if self.worker.is_busy() {
            let busy = "a command is at work: 'Cancel' stops it".to_owned();
            return self.console.add(vec![(MessageKind::Command, text), (MessageKind::Error, busy)]);
        }
        self.worker.run(text, context.cloned());
        self.poll();
    }

    /// Takes what commands at work have said, and what they have done.
    fn poll(&mut self) {
        let (messages, is_back) = self.worker.poll();
        self.console.add(messages);
        if let Some(document) = self.worker.document().filter(|_| is_back) {
            self.scene = Scene::of(document);
            self.picked = self.picked.take().and_then(|picked| Picked::of(document, picked.names));
        }
    }

    /// The buttons on top; a command.
    fn show_bar(&mut self, ui: &mut Ui) -> Option<String> {
        let mut command = None;
        ui.horizontal_wrapped(|ui| {
            let label = ui.label("File");
            ui.add(egui::TextEdit::singleline(&mut self.path).desired_width(220.0)).labelled_by(label.id);
            if ui.button("Open").clicked() {
                self.fits = true;
                command = Some(format!("Load {}", script::word(self.path.trim())));
            }
            if ui.button("Export").clicked() {
                command = Some(format!("Export {}", script::word(self.path.trim())));
            }
            ui.separator();
            for (name, line) in [
                ("Triangulate", "Triangulate"),
                ("Step", "Step"),
                ("Refine", "Refine"),
                ("Undo", "Undo"),
                ("Redo", "Redo"),
                ("Check", "Check"),
                ("Clear", "Clear"),
            ] {
                if ui.button(name).clicked() {
                    command = Some(line.to_owned());
                }
            }
            ui.separator();
            if ui.button("Fit").clicked() {
                self.fits = true;
            }
            if self.worker.is_busy() {
                ui.spinner();
                if ui.button("Cancel").clicked() {
                    self.worker.cancel();
                }
            }
        });
        ui.horizontal_wrapped(|ui| {
            for (tool, name, help) in Tool::ALL {
                if ui.selectable_label(self.tool == tool, name).on_hover_text(help).clicked() {
                    (self.tool, self.from) = (tool, None);
                }
            }
            ui.separator();
            ui.checkbox(&mut self.switches.edges, "Edges");
            ui.checkbox(&mut self.switches.constraints, "Constraints");
            ui.checkbox(&mut self.switches.vertices, "Vertices");
            ui.checkbox(&mut self.switches.labels, "Labels");
            ui.checkbox(&mut self.switches.circle, "Circle");
            ui.checkbox(&mut self.switches.path, "Path");
            ui.add(egui::Slider::new(&mut self.switches.threshold_deg, 0.0..=60.0).text("Bad below"));
        });
        command
    }

    /// The panel on the right; a command.
    fn show_side(&mut self, ui: &mut Ui) -> Option<String> {
        let mut command = inspector::show(ui, self.picked.as_ref());
        ui.separator();
        let figures = &self.scene.figures;
        if let Some(document) = self.worker.document() {
            ui.heading("Document");
            ui.label(format!("{} vertices, {} added", figures.vertices, figures.steiner));
            ui.label(format!("{} triangles, {} edges", figures.triangles, figures.edges));
            if figures.triangles > 0 {
                ui.label(format!("angles {:.2}° to {:.2}°", figures.min_angle_deg, figures.max_angle_deg));
            }
            ui.separator();
            command = configuration::show(ui, document.options()).or(command);
        }
        command
    }

    /// The drawing; a command.
    fn show_viewer(&mut self, ui: &mut Ui) -> Option<String> {
        let (response, painter) = ui.allocate_painter(ui.available_size(), Sense::click_and_drag());
        let rect = response.rect;
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Drawing"));
        if self.fits {
            if let Some(bounds) = self.scene.bounds() {
                self.view = View::around(bounds, rect);
                self.fits = self.worker.is_busy();
            }
        }
        if response.dragged() {
            self.view.pan(response.drag_delta());
        }
        if let Some(at) = response.hover_pos() {
            let (wheel, pinch) = ui.input(|i| (i.smooth_scroll_delta.y, i.zoom_delta()));
            let factor = f64::from(pinch) * math::exp(f64::from(wheel) / 300.0);
            if factor != 1.0 {
                self.view.zoom(factor, at, rect);
            }
        }
        let is_dark = ui.visuals().dark_mode;
        viewer::draw(&painter, (self.view, rect), &self.scene, self.picked.as_ref(), &self.switches, is_dark);
        let at = response.clicked().then(|| response.interact_pointer_pos()).flatten()?;
        self.click(at, rect)
    }

    /// What a click into the drawing does.
    fn click(&mut self, at: egui::Pos2, rect: Rect) -> Option<String> {
        let p = self.view.to_plane(at, rect);
        if !p.is_finite() {
            return None;
        }
        let near = |studio: &Self| {
            let on_screen = |v: &crate::scene::Vertex| studio.view.to_screen(v.at, rect).distance(at);
            let nearest = studio.scene.vertices.iter().min_by(|a, b| on_screen(a).total_cmp(&on_screen(b)))?;
            (on_screen(nearest) < 12.0).then_some(nearest.name)
        };
        match self.tool {
            Tool::Insert => Some(format!("Insert {} {}", p.x, p.y)),
            Tool::Delete => near(self).map(|name| format!("Delete {name}")),
            Tool::Edge => {
                let name = near(self)?;
                match self.from.take() {
                    Some(from) if from != name => Some(format!("Edge {from} {name}")),
                    _ => {
                        self.from = Some(name);
                        None
                    }
                }
            }
            Tool::Pick => {
                let document = self.worker.document()?;
                let t = document.triangulation()?;
                let Locus::Face(f) = t.locate(p) else {
                    self.picked = None;
                    return Some("Select".to_owned());
                };
                let names = t.face_vertices(f).map(|v| document.name(v));
                self.picked = Picked::of(document, names);
                let [i, j, k] = names;
                Some(format!("Select {i} {j} {k}"))
            }
        }
    }
}

impl eframe::App for Studio {
    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        self.show(ui);
    }
}

impl Studio {
    /// Shows the window's contents.
    pub fn show(&mut self, ui: &mut Ui) {
        self.poll();
        if self.worker.is_busy() {
            ui.ctx().request_repaint_after(std::time::Duration::from_millis(30));
        }
        let mut commands = Vec::new();
        for file in ui.input(|i| i.raw.dropped_files.clone()) {
            self.open(&file.path().to_string_lossy());
        }
        Panel::top("bar").show(ui, |ui| commands.extend(self.show_bar(ui)));
        Panel::bottom("console").resizable(true).default_size(170.0).show(ui, |ui| {
            commands.extend(self.console.show(ui));
        });
        Panel::right("side").resizable(true).default_size(300.0).show(ui, |ui| {
            egui::ScrollArea::vertical().show(ui, |ui| commands.extend(self.show_side(ui)));
        });
        CentralPanel::default().show(ui, |ui| commands.extend(self.show_viewer(ui)));
        for command in commands {
            let context = ui.ctx().clone();
            self.run(command, Some(&context));
        }
    }
}
