//! What there is to know of the document: a block on what was loaded, a block for each run, the shares of angles, and
//! how size and smallest angle have changed from command to command.

use std::collections::BTreeMap;

use eframe::egui::{CollapsingHeader, Label, Ui};
use egui_plot::{Bar, BarChart, Line, Plot, PlotPoints, VLine, uniform_grid_spacer};
use trimalla::quality::Histogram;
use trimalla_workbench::{Document, Figures, RunInformation};

use crate::scene::Scene;
use crate::worker::Grown;

/// From where the drawing came: the file or the example that was loaded last, if nothing began anew since.
pub(crate) fn source_of(document: &Document) -> Option<String> {
    let script = document.script();
    let is = |name: &str, others: &[&str]| others.iter().any(|other| name.eq_ignore_ascii_case(other));
    let mut commands = script.lines().rev().map(|line| line.split_once(char::is_whitespace).unwrap_or((line, "")));
    let (name, rest) = commands.find(|(name, _)| is(name, &["Load", "Example", "Clear"]))?;
    (!is(name, &["Clear"])).then(|| rest.trim().trim_matches('"').to_owned())
}

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
pub(crate) fn show(
    ui: &mut Ui,
    (document, source): (&Document, Option<&str>),
    (scene, growth): (&Scene, &[Grown]),
    course: &Course,
    threshold_deg: f64,
) {
    let figures = &scene.figures;
    ui.heading("Document");
    if let Some(source) = source {
        ui.add(Label::new(format!("of {source}")).truncate()).on_hover_text(source);
    }
    ui.label(format!("{} vertices, {} added", figures.vertices, figures.steiner));
    ui.label(format!("{} triangles, {} edges", figures.triangles, figures.edges));
    if figures.triangles == 0 {
        return;
    }
    ui.label(format!("angles {:.2}° to {:.2}°", figures.min_angle_deg, figures.max_angle_deg));
    ui.label(format!("area {:.6}", figures.area)).on_hover_text(figures.area.to_string());
    for (number, run) in (1..).zip(document.runs_here()) {
        let title = format!("Run {number}: {} to {} triangles", run.before.triangles, run.after.triangles);
        CollapsingHeader::new(title).id_salt(("run", number)).show(ui, |ui| show_run(ui, run));
    }
    CollapsingHeader::new("Smallest angles")
        .default_open(true)
        .show(ui, |ui| show_angles(ui, &scene.angles, threshold_deg));
    if !scene.path_lengths.is_empty() {
        let header = CollapsingHeader::new("Lengths of longest-edge paths");
        header.show(ui, |ui| show_lengths(ui, "paths", &scene.path_lengths));
    }
    if growth.len() > 1 {
        CollapsingHeader::new("During the last run").default_open(true).show(ui, |ui| show_growth(ui, growth));
    }
    if course.figures.len() > 1 {
        CollapsingHeader::new("From command to command").show(ui, |ui| show_course(ui, course, document.undoable().0));
    }
}

/// What a run was asked, and what it did.
fn show_run(ui: &mut Ui, run: &RunInformation) {
    run.lines().iter().for_each(|line| drop(ui.label(line)));
    if run.path_lengths.iter().sum::<u64>() > 0 {
        ui.label("lengths of the longest-edge paths that were followed");
        show_lengths(ui, "paths followed", &run.path_lengths);
    }
}

/// How many triangles have which smallest angle.
fn show_angles(ui: &mut Ui, angles: &Histogram, threshold_deg: f64) {
    let bar = |(bin, &count): (usize, &usize)| {
        let [low, high] = angles.range_deg(bin);
        Bar::new(f64::midpoint(low, high), count as f64).width(angles.width_deg)
    };
    let bars: Vec<Bar> = angles.counts.iter().enumerate().map(bar).collect();
    let plot = plot("smallest angles").include_x(0.0).include_x(60.0);
    let plot = plot.x_grid_spacer(uniform_grid_spacer(|_| [60.0, 20.0, 10.0]));
    plot.x_axis_label("degrees; bad ones left of the line").show(ui, |plot| {
        plot.bar_chart(BarChart::new("triangles", bars));
        plot.vline(VLine::new("bad below", threshold_deg));
    });
}

/// How many longest-edge paths have which length.
fn show_lengths(ui: &mut Ui, name: &str, lengths: &[u64]) {
    let bar = |(length, &count): (usize, &u64)| Bar::new(length as f64, count as f64);
    let bars: Vec<Bar> = lengths.iter().enumerate().map(bar).collect();
    plot(name).x_axis_label("triangles").show(ui, |plot| plot.bar_chart(BarChart::new("paths", bars)));
}

/// A plot that stands still.
fn plot(name: impl std::hash::Hash + std::fmt::Debug) -> Plot<'static> {
    Plot::new(name).height(HEIGHT).allow_scroll(false).allow_drag(false).allow_zoom(false)
}

/// Triangles and smallest angle while a long command works.
pub(crate) fn show_growth(ui: &mut Ui, growth: &[Grown]) {
    let triangles = |grown: &Grown| [grown.seconds, grown.figures.triangles as f64];
    let angle = |grown: &Grown| [grown.seconds, grown.figures.min_angle_deg];
    show_curve(ui, "triangles", "seconds", growth.iter().map(triangles).collect(), None);
    show_curve(ui, "smallest angle", "seconds", growth.iter().map(angle).collect(), None);
}

/// Triangles and smallest angle after each command; a line stands where the document is now.
fn show_course(ui: &mut Ui, course: &Course, now: usize) {
    for (which, name) in [(0, "triangles"), (1, "smallest angle")] {
        let points = course.figures.iter().map(|(&at, values)| [at as f64, values[which]]).collect();
        show_curve(ui, name, "command", points, Some(now as f64));
    }
}

fn show_curve(ui: &mut Ui, name: &str, x_axis: &str, points: Vec<[f64; 2]>, mark: Option<f64>) {
    plot((name, x_axis)).x_axis_label(x_axis).y_axis_label(name).show(ui, |plot| {
        plot.line(Line::new(name, PlotPoints::from(points)));
        if let Some(mark) = mark {
            plot.vline(VLine::new("now", mark));
        }
    });
}
