//! `trimalla interpolate`: heights at points.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use serde_json::json;
use trimalla::delaunay::Delaunay;
use trimalla::geometry::Point;
use trimalla::interpolate::{InterpolationMethod, Surface, interpolate};

use crate::args::{ImportOptions, ReportOptions, one_of};
use crate::console::{self, Stream};
use crate::exit::{Failure, STATUSES, Status};
use crate::input::read_drawing;
use crate::outputs::{self, Outputs};
use crate::terrain::{self, SourceOptions};
use crate::{json, progress, text};

const HELP: &str = "\
Examples:
  trimalla interpolate terrain.node places.node -o heights.csv
  trimalla interpolate terrain.1.ele places.node -o - --quiet     on standard output
  trimalla interpolate terrain.node places.node -o heights.csv --method natural-neighbour

Heights are an attribute of the points: in .node and .poly files a column after x and y. A height by
'linear' depends on the triangle alone; by 'natural-neighbour' and 'laplace' on the Delaunay neighbours
of the place, whatever triangles a mesh has. A place outside of the triangles has no height: its line
ends with the comma. The table has the columns x, y, height, and a line for each place, in order.";

/// Compute heights at points from the heights of a mesh's or a drawing's vertices
#[derive(Debug, Args)]
#[command(after_help = format!("{HELP}\n\n{STATUSES}"))]
pub(crate) struct Options {
    #[command(flatten)]
    source: SourceOptions,

    /// The places: the points of a .node, .poly, .csv or other drawing, or '-' for standard input
    points: PathBuf,

    /// How a height is computed
    #[arg(long, value_name = "KEY", default_value = InterpolationMethod::Linear.key(), value_parser = one_of(methods()))]
    method: InterpolationMethod,

    /// Which attribute of the points is the height, counted from 1
    #[arg(long, value_name = "N", default_value_t = 1)]
    attribute: usize,

    /// Write the table to this file, as comma-separated values; '-' is standard output; may be given several times
    #[arg(short, long, value_name = "OUT", help_heading = "Output")]
    output: Vec<PathBuf>,

    #[command(flatten)]
    report: ReportOptions,
}

fn methods() -> impl Iterator<Item = (&'static str, &'static str, InterpolationMethod)> {
    InterpolationMethod::ALL.iter().map(|method| (method.key(), method.row().summary, *method))
}

/// Runs the command.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    progress::handle_ctrl_c();
    outputs::recover(&options.output, options.report.quiet);
    let mesh = options.source.read_triangles()?;
    let places = read_drawing(&options.points, &ImportOptions::default())?;
    let read = mesh.files.iter().chain(&places.files).cloned();
    let outputs = Outputs::sparing(read).with_texts(&options.output, None)?;
    let stream = outputs.report_stream(&options.report)?;
    let heights = terrain::heights(&mesh, options.attribute)?;
    let triangulation = terrain::triangulation(&mesh)?;
    let start = Instant::now();
    let surface = Surface::new(&triangulation, &heights).map_err(|error| Failure::bad_input(error.to_string()))?;
    let mut found = surface.heights_at(&places.value.points);
    if options.method != InterpolationMethod::Linear {
        let delaunay = Delaunay::new(&mesh.value.points).map_err(|error| Failure::bad_input(error.to_string()))?;
        let smooth = interpolate(&delaunay, &heights, &places.value.points, options.method);
        let smooth = smooth.map_err(|error| Failure::bad_input(error.to_string()))?;
        // Where the mesh has no triangle there is no height, whatever points lie around.
        found = found.into_iter().zip(smooth).map(|(linear, smooth)| linear.and(smooth)).collect();
    }
    let seconds = start.elapsed().as_secs_f64();
    let warnings: Vec<_> = mesh.notes.iter().chain(&places.notes).cloned().collect();
    options.report.warn(&warnings);
    progress::begin_writing()?;
    let tables = vec![table(&places.value.points, &found); options.output.len()];
    let prepared = outputs.prepare_texts(&tables)?;
    let inside: Vec<f64> = found.iter().flatten().copied().collect();
    let range = inside
        .iter()
        .fold(None, |range: Option<[f64; 2]>, &h| Some(range.map_or([h, h], |[low, high]| [low.min(h), high.max(h)])));
    if options.report.json {
        json::print(&json!({
            "places": found.len(),
            "outside": found.len() - inside.len(),
            "lowest": range.map(|r| r[0]),
            "highest": range.map(|r| r[1]),
            "method": options.method.key(),
            "seconds": seconds,
            "warnings": warnings,
        }))?;
    } else if stream != Stream::Nowhere {
        let mut lines = text::Lines::default();
        lines.heading(mesh.name());
        lines.row("method", options.method);
        lines.row("places", format_args!("{} ({} outside)", found.len(), found.len() - inside.len()));
        if let Some([low, high]) = range {
            lines.row("heights", format_args!("{low} to {high}"));
        }
        text::add_end(&mut lines, seconds, &outputs.files());
        console::write(stream, &lines.into_text())?;
    }
    prepared.commit()?;
    Ok(Status::Done)
}

/// Comma-separated values; a place outside has an empty height.
fn table(places: &[Point], heights: &[Option<f64>]) -> String {
    let mut table = String::from("x,y,height\n");
    for (place, height) in places.iter().zip(heights) {
        let height = height.map_or_else(String::new, |h| h.to_string());
        let _ = writeln!(table, "{},{},{height}", place.x, place.y);
    }
    table
}
