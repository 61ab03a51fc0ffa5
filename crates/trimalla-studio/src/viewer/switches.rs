//! What is shown, and how.

use eframe::egui::{Color32, ComboBox, DragValue, Slider, Ui};
use trimalla::geometry::math;
use trimalla::refine::{Criteria, NamedOptions};

use crate::panels::console;

/// What the colours of triangles stand for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Colours {
    /// Their smallest angles.
    #[default]
    Angle = 0,
    /// How round they are: twice the inradius by the circumradius.
    Roundness = 1,
    /// The regions in which they are.
    Region = 2,
}

impl Colours {
    const ALL: [(Self, &'static str); 3] =
        [(Self::Angle, "smallest angle"), (Self::Roundness, "roundness"), (Self::Region, "region")];
}

/// What is shown, besides triangles.
///
/// One field for each switch of the window.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Switches {
    pub(crate) colours: Colours,
    /// Triangles with an angle below this are bad.
    pub(crate) threshold_deg: f64,
    /// Whether the user has moved it.
    is_own: bool,
    pub(crate) edges: bool,
    /// Constrained edges inside the domain.
    pub(crate) constraints: bool,
    /// Constrained edges that bound the domain.
    pub(crate) boundary: bool,
    pub(crate) vertices: bool,
    pub(crate) steiner: bool,
    pub(crate) labels: bool,
    pub(crate) holes: bool,
    /// The circle of the picked triangle.
    pub(crate) circle: bool,
    /// The circles of all triangles.
    pub(crate) circles: bool,
    /// The longest-edge path of the picked triangle.
    pub(crate) path: bool,
    /// What the last step of a refinement did.
    pub(crate) step: bool,
}

impl Default for Switches {
    fn default() -> Self {
        Self {
            colours: Colours::default(),
            threshold_deg: Criteria::DEFAULT_MIN_ANGLE_DEG,
            is_own: false,
            edges: true,
            constraints: true,
            boundary: true,
            vertices: true,
            steiner: true,
            labels: true,
            holes: true,
            circle: true,
            circles: false,
            path: true,
            step: true,
        }
    }
}

impl Switches {
    /// What is asked is what is bad, until the user moves the threshold.
    pub(crate) fn follow(&mut self, options: &NamedOptions) {
        if !self.is_own {
            self.threshold_deg = options.min_angle_deg.unwrap_or(Criteria::DEFAULT_MIN_ANGLE_DEG);
        }
    }

    /// Shows the switches.
    pub(crate) fn show(&mut self, ui: &mut Ui) {
        ui.horizontal_wrapped(|ui| {
            let label = ui.label("Colour by");
            let chosen = Colours::ALL.iter().find(|(colours, _)| *colours == self.colours).map_or("", |(_, name)| name);
            let shown = ComboBox::from_id_salt("colours").selected_text(chosen).show_ui(ui, |ui| {
                for (colours, name) in Colours::ALL {
                    ui.selectable_value(&mut self.colours, colours, name);
                }
            });
            let _ = shown.response.labelled_by(label.id);
            make_room(ui, 240.0);
            let before = self.threshold_deg;
            let bad = ui.add(Slider::new(&mut self.threshold_deg, 0.0..=60.0).text("Bad below"));
            self.is_own |= self.threshold_deg != before;
            bad.on_hover_text("triangles with an angle below this many degrees are red; 'min-angle' until it is moved");
            ui.separator();
            for (is_on, name, help) in [
                (&mut self.edges, "Edges", "edges of triangles"),
                (&mut self.constraints, "Constraints", "segments: before 'Triangulate', and inside the domain"),
                (&mut self.boundary, "Boundary", "the boundary of the domain and of its holes"),
                (&mut self.vertices, "Vertices", "vertices of the drawing"),
                (&mut self.steiner, "Added", "vertices that a refinement has added, Steiner points"),
                (&mut self.labels, "Labels", "the names of vertices, where few are seen"),
                (&mut self.holes, "Holes", "seeds of holes"),
                (&mut self.circle, "Circle", "the circumcircle of the picked triangle"),
                (&mut self.circles, "All circles", "the circumcircles of all triangles, where few are seen"),
                (&mut self.path, "Path", "the longest-edge propagation path of the picked triangle"),
                (&mut self.step, "Step shown", "what the last step of the refinement did"),
            ] {
                ui.checkbox(is_on, name).on_hover_text(help);
            }
        });
    }
}

/// Goes to the next row where less than so much is left of a row: sliders do not do so by themselves.
pub(crate) fn make_room(ui: &mut Ui, width: f32) {
    if ui.available_size_before_wrap().x < width {
        ui.end_row();
    }
}

/// Colours of what lies above the triangles, on light and on dark ground.
pub(crate) struct Palette {
    pub(crate) ground: Color32,
    pub(crate) edge: Color32,
    pub(crate) constrained: Color32,
    pub(crate) vertex: Color32,
    pub(crate) steiner: Color32,
    pub(crate) picked: Color32,
    pub(crate) terminal: Color32,
    pub(crate) hole: Color32,
    pub(crate) left: Color32,
    pub(crate) right: Color32,
    pub(crate) refused: Color32,
    pub(crate) accepted: Color32,
}

impl Palette {
    pub(crate) fn of(is_dark: bool) -> Self {
        let [ground, edge, constrained, vertex] = if is_dark {
            [Color32::from_gray(20), Color32::from_gray(120), Color32::from_rgb(240, 200, 90), Color32::from_gray(225)]
        } else {
            [Color32::from_gray(250), Color32::from_gray(115), Color32::from_rgb(135, 68, 0), Color32::from_gray(25)]
        };
        Self {
            ground,
            edge,
            constrained,
            vertex,
            steiner: Color32::from_rgb(40, 120, 220),
            picked: Color32::from_rgb(90, 110, 250),
            terminal: Color32::from_rgb(215, 30, 150),
            hole: Color32::from_rgb(200, 60, 60),
            left: Color32::from_rgb(20, 150, 120),
            right: Color32::from_rgb(200, 120, 0),
            refused: Color32::from_rgb(210, 50, 50),
            accepted: Color32::from_rgb(20, 140, 60),
        }
    }
}

/// Shows scale and centre of the view as numbers, and what lies under the pointer.
pub(crate) fn show_view(ui: &mut Ui, view: &mut super::view::View, hovered: Option<&str>) {
    // As many digits as places of the screen have.
    let digits = math::log10(view.scale).clamp(0.0, 15.0).ceil() as usize + 1;
    ui.horizontal_wrapped(|ui| {
        for (name, value) in [("Center x", &mut view.center.x), ("y", &mut view.center.y)] {
            let label = ui.label(name);
            let speed = 1.0 / view.scale;
            let number = DragValue::new(value).speed(speed).max_decimals(digits).update_while_editing(false);
            ui.add(number).labelled_by(label.id);
        }
        let label = ui.label("Scale");
        let scale = view.scale;
        let mut shown = scale;
        let rounded = |scale: f64, _| console::rounded(&scale.to_string());
        let number = DragValue::new(&mut shown).speed(scale / 100.0).custom_formatter(rounded);
        if ui.add(number.update_while_editing(false)).labelled_by(label.id).changed() {
            view.set_scale(shown);
        }
        ui.checkbox(&mut view.is_y_down, "y down");
        if let Some(hovered) = hovered {
            ui.label(hovered);
        }
    });
}
