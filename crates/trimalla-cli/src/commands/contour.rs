//! `trimalla contour`: lines of equal height.

use std::fmt::Write as _;
use std::time::Instant;

use clap::Args;
use serde_json::json;
use trimalla::drawing::Pslg;
use trimalla::half_edge::HalfEdgeId;
use trimalla::interpolate::{Contour, Levels, Surface};
use trimalla::triangulation::Triangulation;

use crate::args::{OutputOptions, ReportOptions};
use crate::console::{self, Stream};
use crate::exit::{Failure, STATUSES, Status};
use crate::outputs::{self, Outputs};
use crate::terrain::{self, SourceOptions};
use crate::{json, progress, text};

const HELP: &str = "\
Examples:
  trimalla contour terrain.node --step 10 -o lines.svg
  trimalla contour terrain.1.ele --levels 50,75,100 -o lines.poly -o lines.csv

Heights are an attribute of the points: in .node and .poly files a column after x and y. A vertex at the
height of a level counts as above it, so that every line is closed or ends at the boundary. Lines have
the higher ground on their left.

A drawing (.poly) has the height of a line as the attribute of its points, and as marker of its segments the
number of the level, counted from 1; a picture shows the boundary, too. A table (.csv) has the columns
level, line, x, y, a line of the file for each point; a closed line repeats its first point.";

/// Draw lines of equal height on a mesh or a drawing whose points have heights
#[derive(Debug, Args)]
#[command(after_help = format!("{HELP}\n\n{STATUSES}"))]
pub(crate) struct Options {
    #[command(flatten)]
    source: SourceOptions,

    /// Draw a line at every multiple of this [default: ten to twenty-five levels]
    #[arg(long, value_name = "HEIGHT", conflicts_with = "levels")]
    step: Option<f64>,

    /// Draw lines at these heights
    #[arg(long, value_name = "HEIGHTS", value_delimiter = ',', allow_negative_numbers = true)]
    levels: Vec<f64>,

    /// Which attribute of the points is the height, counted from 1
    #[arg(long, value_name = "N", default_value_t = 1)]
    attribute: usize,

    #[command(flatten)]
    output: OutputOptions,

    #[command(flatten)]
    report: ReportOptions,
}

/// Runs the command.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    progress::handle_ctrl_c();
    outputs::recover(&options.output.output, options.report.quiet);
    let mesh = options.source.read_triangles()?;
    let outputs = Outputs::sparing(mesh.files.clone()).with_lines(&options.output, &mesh)?;
    let stream = outputs.report_stream(&options.report)?;
    let heights = terrain::heights(&mesh, options.attribute)?;
    let triangulation = terrain::triangulation(&mesh)?;
    let start = Instant::now();
    let surface = Surface::new(&triangulation, &heights).map_err(|error| Failure::bad_input(error.to_string()))?;
    let range = surface.range().unwrap_or_default();
    let levels = match options.step {
        Some(step) => Levels::Every(step),
        None if options.levels.is_empty() => Levels::Every(round_step(range)),
        None => Levels::At(options.levels.clone()),
    };
    let contours = surface.contours(&levels).map_err(|error| Failure::wrong_use(error.to_string()))?;
    let seconds = start.elapsed().as_secs_f64();
    options.report.warn(&mesh.notes);
    progress::begin_writing()?;
    let prepared = outputs.prepare_lines(&drawing(&contours, &triangulation, &heights), &table(&contours))?;
    let closed = contours.iter().filter(|c| c.is_closed).count();
    let points: usize = contours.iter().map(|c| c.points.len()).sum();
    let drawn = contours.chunk_by(|a, b| a.level == b.level).count();
    if options.report.json {
        json::print(&json!({
            "levels": drawn,
            "lines": contours.len(),
            "closed": closed,
            "points": points,
            "lowest": range[0],
            "highest": range[1],
            "seconds": seconds,
            "warnings": mesh.notes,
        }))?;
    } else if stream != Stream::Nowhere {
        let mut lines = text::Lines::default();
        lines.heading(mesh.name());
        lines.row("heights", format_args!("{} to {}", range[0], range[1]));
        lines.row("levels", format_args!("{drawn} with lines"));
        lines.row("lines", format_args!("{} ({closed} closed), {points} points", contours.len()));
        text::add_end(&mut lines, seconds, &outputs.files());
        console::write(stream, &lines.into_text())?;
    }
    prepared.commit()?;
    Ok(Status::Done)
}

/// 1, 2 or 5 times a power of ten, so that there are ten to twenty-five levels; 1 for a level surface.
fn round_step([low, high]: [f64; 2]) -> f64 {
    let about = high / 10.0 - low / 10.0;
    if !(about > 0.0 && about.is_finite()) {
        return 1.0;
    }
    let power = trimalla::geometry::math::pow(10.0, trimalla::geometry::math::log10(about).floor());
    let step = [5.0, 2.0, 1.0].into_iter().map(|n| n * power).find(|&step| step <= about * (1.0 + 1e-9));
    step.filter(|step| *step > 0.0 && step.is_finite()).unwrap_or(about)
}

/// The boundary of the terrain, then the lines: points with heights, segments with the number of their level.
fn drawing(contours: &[Contour], t: &Triangulation, heights: &[f64]) -> Pslg {
    let mut drawing = Pslg { attributes_per_point: 1, ..Pslg::default() };
    let is_inner = |h: &HalfEdgeId| t.is_inner_side_of_boundary(*h);
    for first in t.boundary_loops().into_iter().filter(is_inner) {
        let corners: Vec<_> = t.boundary_loop(first).map(|h| t.origin(h)).collect();
        drawing.add_ring(corners.iter().map(|&v| t.point(v)));
        drawing.point_attributes.extend(corners.iter().map(|v| heights[v.index()]));
    }
    drawing.segment_markers.resize(drawing.segments.len(), 0);
    for (number, of_level) in (1..).zip(contours.chunk_by(|a, b| a.level == b.level)) {
        for contour in of_level {
            let first = drawing.points.len() as u32;
            drawing.points.extend_from_slice(&contour.points);
            let end = drawing.points.len() as u32;
            drawing.segments.extend((first + 1..end).map(|i| [i - 1, i]));
            if contour.is_closed && end - first > 2 {
                drawing.segments.push([end - 1, first]);
            }
            drawing.point_attributes.resize(drawing.points.len(), contour.level);
            drawing.segment_markers.resize(drawing.segments.len(), number);
        }
    }
    drawing
}

/// Comma-separated values.
fn table(contours: &[Contour]) -> String {
    let mut table = String::from("level,line,x,y\n");
    for (number, contour) in (1..).zip(contours) {
        let again = contour.points.iter().take(usize::from(contour.is_closed));
        for p in contour.points.iter().chain(again) {
            let _ = writeln!(table, "{},{number},{},{}", contour.level, p.x, p.y);
        }
    }
    table
}
