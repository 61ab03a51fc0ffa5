//! What a call prints: warnings on standard error, counts on standard output.

use std::fmt::Write as _;
use std::path::PathBuf;

use trimalla::quality::Statistics;
use trimalla::refine::StopReason;
use trimalla_io::bars;
use trimalla_triangle::{Made, Switches};
use trimalla_workbench::numbers::{Renumber, count};

use super::files::File;
use super::reading::{Content, Read};
use crate::console::{note, shown};
use crate::exit::{Failure, Status};
use crate::text;

/// Says what was ignored in the files.
pub(super) fn notes(read: &Read, switches: &Switches) {
    if !switches.quiet {
        read.notes.iter().for_each(|text| note("warning", text));
    }
}

/// Says what is unusual in the input, and what the mesh has not reached.
pub(super) fn warnings(read: &Read, made: &Made, switches: &Switches, wanted: &[File]) {
    if switches.quiet {
        return;
    }
    let name = read.name();
    let mut all: Vec<String> = match &read.content {
        Content::Drawing(drawing) => {
            let numbers = read.numbers(drawing);
            made.warnings.iter().map(|warning| numbers.warning(warning)).collect()
        }
        Content::Mesh(..) => made.warnings.iter().map(|warning| format!("{name}: {warning}")).collect(),
    };
    for &(hole, at) in &made.outside_holes {
        let number = hole + read.first_index as usize;
        all.push(format!("{name}: hole {number} at {at} lies outside and removes nothing"));
    }
    if !wanted.contains(&File::Node) && !switches.no_vertices && made.mesh.points.len() > read.vertices() {
        let added = count(made.mesh.points.len() - read.vertices(), "new vertex");
        all.push(format!("{added} in no file: -I writes no .node file beside one that is read; leave out -I"));
    }
    all.extend(shortfall(made));
    all.extend(
        made.report
            .as_ref()
            .filter(|report| report.leftovers.is_empty())
            .and_then(|report| lower_bound(switches.min_angle_deg.unwrap_or_default(), report.min_angle_deg)),
    );
    all.iter().for_each(|text| note("warning", text));
}

/// The triangles that miss a bound, by reason.
fn shortfall(made: &Made) -> Option<String> {
    let report = made.report.as_ref().filter(|report| !report.leftovers.is_empty())?;
    let reasons: Vec<_> = report.reasons().into_iter().map(|(reason, n)| format!("{reason} {n}")).collect();
    let stopped = if report.stop == StopReason::Budget { "; no more vertices were allowed" } else { "" };
    let bad = count(report.leftovers.len(), "triangle");
    Some(format!("{bad} below a bound ({}){stopped}", reasons.join(", ")))
}

/// What to say of a mesh that meets all of its bounds, but a lower one on angles than was asked: the library returns
/// such a mesh where the one that was asked is out of reach.
fn lower_bound(asked_deg: f64, smallest_deg: f64) -> Option<String> {
    const ROUNDING_DEG: f64 = 1e-9;
    (smallest_deg < asked_deg - ROUNDING_DEG)
        .then(|| format!("no mesh with all angles at {asked_deg} degrees was found; the smallest is {smallest_deg:.2}"))
}

/// The failure of a mesh that `-C` found at fault.
pub(super) fn faults(read: &Read, made: &Made) -> Option<Failure> {
    const SHOWN: usize = 10;
    let first = read.first_index;
    let named = made.faults.iter().take(SHOWN).map(|fault| fault.clone().renumbered(first).to_string());
    let mut lines: Vec<String> = named.collect();
    if made.faults.len() > SHOWN {
        lines.push(format!("and {} more", made.faults.len() - SHOWN));
    }
    (!lines.is_empty()).then(|| Failure::of_many(Status::Unmet, lines))
}

/// The report; empty under `-Q`.
pub(super) fn text(read: &Read, made: &Made, switches: &Switches, paths: &[PathBuf], seconds: f64) -> String {
    let mut text = String::new();
    if switches.quiet {
        return text;
    }
    for path in paths {
        let _ = writeln!(text, "Writing {}.", shown(path));
    }
    let _ = writeln!(text, "\nStatistics:\n");
    for (label, n) in read.counts() {
        let _ = writeln!(text, "  Input {label}: {n}");
    }
    let [edges, exterior] = made.edge_counts;
    let subsegments = made.mesh.segments.len();
    let mut used = vec![false; made.vertices];
    made.mesh.triangles.iter().flatten().for_each(|&v| used[v as usize] = true);
    let _ = writeln!(text, "\n  Mesh vertices: {}", used.iter().filter(|&&used| used).count());
    let _ = writeln!(text, "  Mesh triangles: {}\n  Mesh edges: {edges}", made.mesh.triangles.len());
    let _ = writeln!(text, "  Mesh exterior boundary edges: {exterior}");
    let _ = writeln!(text, "  Mesh interior boundary edges: {}", subsegments.saturating_sub(exterior));
    let _ = writeln!(text, "  Mesh subsegments (constrained edges): {subsegments}");
    if switches.check {
        let _ = writeln!(text, "\nThe mesh is consistent and Delaunay.");
    }
    if switches.verbosity > 0 {
        let angles = text::angles(text::extreme_angles_deg(&made.mesh));
        let chart = bars::smallest_angles(&Statistics::of(&made.mesh));
        let _ = writeln!(text, "\nAngles {angles}; {seconds:.3} s\n\n{chart}");
    }
    text
}

impl Read {
    fn vertices(&self) -> usize {
        match &self.content {
            Content::Drawing(drawing) => drawing.points.len(),
            Content::Mesh(mesh, _) => mesh.points.len(),
        }
    }

    fn counts(&self) -> [(&'static str, usize); 3] {
        let (second, third) = match &self.content {
            Content::Drawing(drawing) => (("segments", drawing.segments.len()), ("holes", drawing.holes.len())),
            Content::Mesh(mesh, _) => (("triangles", mesh.triangles.len()), ("subsegments", mesh.segments.len())),
        };
        [("vertices", self.vertices()), second, third]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lower_bound_is_told() {
        assert_eq!(lower_bound(30.0, 30.000000000000004), None);
        assert_eq!(lower_bound(30.0, 29.999999999999996), None);
        let told = lower_bound(36.5, 36.0).unwrap();
        assert_eq!(told, "no mesh with all angles at 36.5 degrees was found; the smallest is 36.00");
    }
}
