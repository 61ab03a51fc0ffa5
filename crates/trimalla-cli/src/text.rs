//! Reports for people.

use std::fmt::Write as _;

use trimalla::Meshed;
use trimalla::domain::Pslg;
use trimalla::geometry::{Point, Triangle};
use trimalla::refine::{Leftover, Reason, RefineOptions, Report};
use trimalla::triangulation::IndexedMesh;
use trimalla_compare::facts;

use crate::console::{self, count};
use crate::input::Input;

/// Lines of a label and a value, in columns.
#[derive(Debug, Default)]
pub(crate) struct Lines {
    text: String,
}

impl Lines {
    /// A line that stands alone.
    pub(crate) fn heading(&mut self, text: impl std::fmt::Display) {
        let _ = writeln!(self.text, "{text}");
    }

    /// A label and its value.
    pub(crate) fn row(&mut self, label: &str, value: impl std::fmt::Display) {
        let _ = writeln!(self.text, "  {label:<12} {value}");
    }

    pub(crate) fn into_text(self) -> String {
        self.text
    }
}

/// What was read, in one line.
pub(crate) fn of_drawing(drawing: &Input<Pslg>) -> String {
    format!("{}: {}", drawing.name(), facts(&drawing.value))
}

/// The size of a mesh, of whose vertices so many are not new.
pub(crate) fn add_counts(lines: &mut Lines, mesh: &IndexedMesh, old: usize) {
    let added = mesh.points.len() - old;
    lines.row("vertices", format_args!("{} ({added} added)", mesh.points.len()));
    lines.row("triangles", mesh.triangles.len());
}

/// What came of a refinement.
pub(crate) fn add_outcome(lines: &mut Lines, report: &Report, bound_deg: f64) {
    lines.row("angles", angles([report.min_angle_deg, report.max_angle_deg]));
    let reasons: Vec<_> = report.reasons().iter().map(|(reason, n)| format!("{reason} {n}")).collect();
    match report.leftovers.len() {
        0 => lines.row("bound", format_args!("{bound_deg} degrees, met everywhere")),
        n => lines.row("below bound", format_args!("{n} ({})", reasons.join(", "))),
    }
    if let Some(paths) = paths(&report.lepp_lengths) {
        lines.row("paths", paths);
    }
    if !report.lost_segments.is_empty() {
        lines.row("lost", format_args!("{} (no chain of edges)", count(report.lost_segments.len(), "segment")));
    }
}

/// What the smallest input angle costs at worst, where some triangle pays for it and the argument for it holds.
pub(crate) fn floor(meshed: &Meshed, options: &RefineOptions, drawing: &Input<Pslg>) -> Option<String> {
    let outlook = meshed.outlook.as_ref()?;
    let is_forced = meshed.report.complete() && !meshed.report.leftovers.is_empty();
    let (floor, input) = (outlook.angle_floor(options).filter(|_| is_forced)?, outlook.smallest_input_angle?);
    // Rounded down: what is said stays true.
    let floor = (100.0 * floor.degrees()).floor() / 100.0;
    let vertex = drawing.number(input.vertex.index());
    Some(format!(
        "no mesh angle need be below {floor:.2} degrees: the floor for the smallest input angle {:.2} at vertex {vertex}",
        input.angle.degrees()
    ))
}

/// How long the longest-edge propagation paths were, if any was followed.
fn paths(lengths: &[u64]) -> Option<String> {
    let total: u64 = lengths.iter().sum();
    let sum: u64 = (0..).zip(lengths).map(|(length, n)| length * n).sum();
    let share = |n: u64| 100.0 * n as f64 / total as f64;
    let counted = lengths.iter().enumerate().filter(|(_, n)| **n > 0);
    let shares: Vec<String> = counted.map(|(length, &n)| format!("{length}: {:.0} %", share(n))).collect();
    (total > 0).then(|| format!("{total}, mean length {:.2} ({})", sum as f64 / total as f64, shares.join(", ")))
}

/// The smallest and the largest angle.
pub(crate) fn angles([least, most]: [f64; 2]) -> String {
    format!("{least:.2} to {most:.2} degrees")
}

/// Time and files.
pub(crate) fn add_end(lines: &mut Lines, seconds: f64, files: &[String]) {
    lines.row("time", format_args!("{seconds:.3} s"));
    if !files.is_empty() {
        lines.row("output", files.join(", "));
    }
}

/// Names the first triangles that limits left below the bound, on standard error; those that nobody picked are none of them.
pub(crate) fn name_leftovers(mesh: &IndexedMesh, first_index: u32, report: &Report) {
    const SHOWN: usize = 10;
    let unmet: Vec<&Leftover> =
        report.leftovers.iter().filter(|l| !l.reason.is_forced() && l.reason != Reason::NotPicked).collect();
    if unmet.is_empty() {
        return;
    }
    let verb = if unmet.len() == 1 { "stays" } else { "stay" };
    let total = count(unmet.len(), "triangle");
    console::note("warning", &format!("{total} {verb} below the bound, though no angle of the input forces it"));
    for leftover in unmet.iter().take(SHOWN) {
        console::note_more(describe(mesh, first_index, leftover));
    }
    if unmet.len() > SHOWN {
        console::note_more(format_args!("and {} more", unmet.len() - SHOWN));
    }
}

fn describe(mesh: &IndexedMesh, first_index: u32, leftover: &Leftover) -> String {
    let number = leftover.triangle + first_index as usize;
    let at = corners(mesh, leftover.triangle).map(|c| format!(" at {}", c.centroid()));
    format!("triangle {number}{}: {:.2} degrees, {}", at.unwrap_or_default(), leftover.min_angle_deg, leftover.reason)
}

/// The corners of a triangle, if all are there.
pub(crate) fn corners(mesh: &IndexedMesh, triangle: usize) -> Option<Triangle> {
    let point = |v: u32| -> Option<Point> { mesh.points.get(v as usize).copied() };
    let [a, b, c] = *mesh.triangles.get(triangle)?;
    Some(Triangle::new(point(a)?, point(b)?, point(c)?))
}

/// The smallest and the largest angle of a mesh in degrees; zeros where there is no triangle.
pub(crate) fn extreme_angles_deg(mesh: &IndexedMesh) -> [f64; 2] {
    let triangles = (0..mesh.triangles.len()).filter_map(|t| corners(mesh, t));
    triangles
        .map(|t| [t.min_angle().degrees(), t.max_angle().degrees()])
        .reduce(|[a, b], [c, d]| [a.min(c), b.max(d)])
        .unwrap_or_default()
}
