//! What there is to know of the document: a block on what was loaded, a block for each run, the shares of angles, and
//! how size and smallest angle have changed from command to command.

use std::collections::BTreeMap;

use eframe::egui::{CollapsingHeader, Ui};
use egui_plot::{Bar, BarChart, Line, Plot, PlotPoints, VLine};
use trimalla_workbench::{Document, Figures};

use crate::scene::{CLASSES, Scene};

/// How high a plot is.
const HEIGHT: f32 = 130.0;

/// Figures after each command, by the place in the history.
#[derive(Debug, Default)]
pub(crate) struct Course {
    figures: BTreeMap<usize, [f64; 2]>,
}

impl Course {
    /// Notes the figures of the document as it is now.
    pub(crate) fn note(&mut self, document: &Document, figures: &Figures) {
        let (done, undone) = document.undoable();
        // What stood there was undone, and something else was done.
        if undone == 0 {
            let _ = self.figures.split_off(&done);
        }
        if figures.triangles > 0 {
            self.figures.insert(done, [figures.triangles as f64, figures.min_angle_deg]);
        }
    }
}

/// Shows the panel.
pub(crate) fn show(ui: &mut Ui, document: &Document, scene: &Scene, course: &Course) {
    let figures = &scene.figures;
    ui.heading("Document");
    ui.label(format!("{} vertices, {} added", figures.vertices, figures.steiner));
    ui.label(format!("{} triangles, {} edges", figures.triangles, figures.edges));
    if figures.triangles == 0 {
        return;
    }
    ui.label(format!("angles {:.2}° to {:.2}°", figures.min_angle_deg, figures.max_angle_deg));
    ui.label(format!("area {}", figures.area));
    CollapsingHeader::new("Smallest angles").default_open(true).show(ui, |ui| show_angles(ui, scene));
    if course.figures.len() > 1 {
        CollapsingHeader::new("From command to command").show(ui, |ui| show_course(ui, course, document.undoable().0));
    }
}

/// How many triangles have which smallest angle.
fn show_angles(ui: &mut Ui, scene: &Scene) {
    let width = 60.0 / CLASSES as f64;
    let bar = |(class, &count): (usize, &usize)| Bar::new(width * (class as f64 + 0.5), count as f64).width(width);
    let bars: Vec<Bar> = scene.classes.iter().enumerate().map(bar).collect();
    let plot = Plot::new("smallest angles").height(HEIGHT).allow_scroll(false).allow_drag(false).allow_zoom(false);
    plot.x_axis_label("degrees").show(ui, |plot| plot.bar_chart(BarChart::new("triangles", bars)));
}

/// Triangles and smallest angle after each command; a line stands where the document is now.
fn show_course(ui: &mut Ui, course: &Course, now: usize) {
    for (which, name) in [(0, "triangles"), (1, "smallest angle")] {
        let points: Vec<[f64; 2]> = course.figures.iter().map(|(&at, values)| [at as f64, values[which]]).collect();
        let plot = Plot::new(name).height(HEIGHT).allow_scroll(false).allow_drag(false).allow_zoom(false);
        plot.x_axis_label("command").y_axis_label(name).show(ui, |plot| {
            plot.line(Line::new(name, PlotPoints::from(points)));
            plot.vline(VLine::new("now", now as f64));
        });
    }
}
