//! Reports for people.

use std::fmt::Write as _;

use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::quality::aspect_ratio;
use trimalla::refine::{Leftover, Missed, NamedOptions, Overview, Protect, Reason, Report, StopReason};
use trimalla::{Attempted, Improved};
use trimalla_compare::facts;
use trimalla_workbench::numbers::{count, short};
use trimalla_workbench::refining::{MissedBounds, corners};

use crate::console;
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

/// The input in one line, and in more lines what was read of another program's drawing.
pub(crate) fn of_drawing(drawing: &Input<Pslg>) -> String {
    let told = drawing.told.iter().map(|line| format!("\n  {line}"));
    format!("{}: {}{}", drawing.name(), facts(&drawing.value), told.collect::<String>())
}

/// A mesh that was read, in one line.
pub(crate) fn of_mesh(name: &str, mesh: &IndexedMesh) -> String {
    let IndexedMesh { points, triangles, segments, .. } = mesh;
    let parts = [(points.len(), "vertex"), (triangles.len(), "triangle"), (segments.len(), "subsegment")];
    let parts: Vec<_> = parts.into_iter().filter(|&(n, _)| n > 0).map(|(n, noun)| count(n, noun)).collect();
    format!("{name}: {}", parts.join(", "))
}

/// The size of a mesh, of whose vertices so many are not new.
pub(crate) fn add_counts(lines: &mut Lines, mesh: &IndexedMesh, old: usize) {
    let added = mesh.points.len() - old;
    lines.row("vertices", format_args!("{} ({added} added)", mesh.points.len()));
    lines.row("triangles", mesh.triangles.len());
}

/// The state before a refinement.
pub(crate) fn add_before(lines: &mut Lines, before: Option<Overview>) {
    let Some(Overview { vertices, triangles, min_angle_deg }) = before else { return };
    let angle = min_angle_deg.map_or_else(String::new, |angle| format!(", smallest angle {angle:.2} degrees"));
    lines.row("before", format_args!("{}, {}{angle}", count(vertices, "vertex"), count(triangles, "triangle")));
}

/// The outcome of a refinement, with its bounds.
pub(crate) fn add_outcome(lines: &mut Lines, report: &Report, asked: &NamedOptions, missed: &MissedBounds) {
    lines.row("angles", angles([report.min_angle_deg, report.max_angle_deg]));
    let bounds = bounds(asked);
    if report.leftovers.is_empty() {
        lines.row("bounds", format_args!("{bounds}: met everywhere"));
    } else {
        let by_bound = missed.counts().into_iter().filter(|&(_, n)| n > 0).map(|(bound, n)| format!("{bound} {n}"));
        let reasons = report.reasons().into_iter().map(|(reason, n)| format!("{reason} {n}"));
        let [by_bound, reasons] = [by_bound.collect::<Vec<_>>(), reasons.collect()].map(|list| list.join(", "));
        lines.row("bounds", bounds);
        lines.row("missed", format_args!("by {}: {by_bound} ({reasons})", count(report.leftovers.len(), "triangle")));
    }
    if let Some(paths) = paths(&report.lepp_lengths) {
        lines.row("paths", paths);
    }
    if !report.lost_segments.is_empty() {
        lines.row("lost", format_args!("{} (no chain of edges)", count(report.lost_segments.len(), "segment")));
    }
}

/// Which of several runs gave the mesh.
pub(crate) fn add_attempts(lines: &mut Lines, attempted: Option<&Attempted>) {
    if let Some(Attempted { preset, bound_deg, runs, .. }) = attempted {
        lines.row("attempts", format_args!("{}; kept: {preset} at {} degrees", count(*runs, "run"), short(*bound_deg)));
    }
}

/// How much smaller the mesh was made after its refinement.
pub(crate) fn add_improved(lines: &mut Lines, improved: Option<&Improved>) {
    if let Some(Improved { vertices_before, vertices, climbed_from_deg, is_proved }) = improved {
        let proof = if *is_proved { ", every angle proved" } else { "" };
        let climb =
            climbed_from_deg.map_or_else(String::new, |deg| format!(", from a bound of {} degrees", short(deg)));
        lines.row("improved", format_args!("{vertices_before} to {vertices} vertices{climb}{proof}"));
    }
}

/// Every bound on triangles.
fn bounds(asked: &NamedOptions) -> String {
    let angle = format!("angle {} degrees", asked.min_angle_deg.unwrap_or_default());
    let area = asked.max_area.map(|area| format!("area {area}"));
    let aspect_ratio = asked.max_aspect_ratio.map(|ratio| format!("aspect ratio {ratio}"));
    let protect = asked.protect.filter(|&protect| protect != Protect::None);
    let protect = protect.map(|protect| format!("protected segments: {}", protect.key()));
    [Some(angle), area, aspect_ratio, protect].into_iter().flatten().collect::<Vec<_>>().join(", ")
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

/// Says on standard error that a refinement gave up, and what to try.
pub(crate) fn name_stop(report: &Report) {
    if report.stop == StopReason::NoLongerImproves {
        let text = "the refinement stopped, since more vertices left no fewer triangles below the bound; try a smaller --min-angle, or --algorithm lepp-off-center";
        console::note("warning", text);
    }
}

/// Says on standard error that no run met the bound that was asked, and what to try.
pub(crate) fn name_lowered(asked: &NamedOptions, attempted: &Attempted) {
    let (asked, met) = (short(asked.min_angle_deg.unwrap_or_default()), short(attempted.bound_deg));
    let text = format!(
        "no run met {asked} degrees; the mesh meets {met}: ask for that, or try a single run with --algorithm lepp-off-center"
    );
    console::note("warning", &text);
}

/// Names, on standard error, the first triangles that limits kept from meeting a bound; triangles that were not picked
/// are left out.
pub(crate) fn name_leftovers(mesh: &IndexedMesh, first_index: u32, report: &Report, missed: &MissedBounds) {
    const SHOWN: usize = 10;
    let all = report.leftovers.iter().zip(&missed.by_leftover);
    let unmet: Vec<_> = all.filter(|(l, _)| !l.reason.is_forced() && l.reason != Reason::NotPicked).collect();
    if unmet.is_empty() {
        return;
    }
    let total = count(unmet.len(), "triangle");
    let are_of_angles = unmet.iter().all(|(_, missed)| missed.angle && !missed.area && !missed.aspect_ratio);
    let what = match (are_of_angles, unmet.len()) {
        (true, 1) => "stays below the bound",
        (true, _) => "stay below the bound",
        (false, 1) => "misses a bound",
        (false, _) => "miss bounds",
    };
    console::note("warning", &format!("{total} {what}, though the input does not force it"));
    for (leftover, missed) in unmet.iter().take(SHOWN) {
        console::note_more(describe(mesh, first_index, leftover, missed));
    }
    if unmet.len() > SHOWN {
        console::note_more(format_args!("and {} more", unmet.len() - SHOWN));
    }
}

fn describe(mesh: &IndexedMesh, first_index: u32, leftover: &Leftover, missed: &Missed) -> String {
    let number = leftover.triangle + first_index as usize;
    let corners = corners(mesh, leftover.triangle);
    let at = corners.map(|c| format!(" at {}", c.centroid()));
    let angle = missed.angle.then(|| format!("{:.2} degrees", leftover.min_angle_deg));
    let area = corners.filter(|_| missed.area).map(|c| format!("area {:.3e}", c.area()));
    let ratio = corners.filter(|_| missed.aspect_ratio).map(|c| format!("aspect ratio {:.2}", aspect_ratio(&c)));
    let what = [angle, area, ratio, Some(leftover.reason.to_string())].into_iter().flatten().collect::<Vec<_>>();
    format!("triangle {number}{}: {}", at.unwrap_or_default(), what.join(", "))
}

/// The smallest and the largest angle of a mesh in degrees; zeros where there is no triangle.
pub(crate) fn extreme_angles_deg(mesh: &IndexedMesh) -> [f64; 2] {
    let triangles = (0..mesh.triangles.len()).filter_map(|t| corners(mesh, t));
    triangles
        .map(|t| [t.min_angle().degrees(), t.max_angle().degrees()])
        .reduce(|[a, b], [c, d]| [a.min(c), b.max(d)])
        .unwrap_or_default()
}
