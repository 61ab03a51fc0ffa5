//! `trimalla voronoi`: the Voronoi diagram of points, clipped.

use std::fmt::Write as _;
use std::time::Instant;

use clap::Args;
use serde_json::json;
use trimalla::delaunay::Delaunay;
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::dual::{ClippedVoronoi, Piece, Voronoi, VoronoiError};
use trimalla::geometry::{BoundingBox, Point};

use crate::args::{OutputOptions, ReportOptions, one_of};
use crate::console::{self, Stream};
use crate::exit::{Failure, STATUSES, Status};
use crate::input::Input;
use crate::outputs::{self, Outputs};
use crate::terrain::{self, SourceOptions};
use crate::{json, progress, text};

const HELP: &str = "\
Examples:
  trimalla voronoi points.node -o cells.svg
  trimalla voronoi key.poly --clip domain -o cells.poly -o cells.csv

Cells are clipped to a box around the points, a tenth larger; to their convex hull; or to the domain of
the drawing, which may be concave and have holes. Their corners are shared, so that the areas of the cells
sum to that of the domain.

A drawing (.poly) has first the points of the input, then the corners of the cells; sides on the boundary have
marker 1. A table (.csv) has the columns point, piece, ring, x, y, a line for each corner: points are numbered
as in their file, ring 0 is the outside of a piece, the others are holes.";

/// To what cells are clipped.
#[derive(Clone, Copy, Debug)]
enum Clip {
    Box,
    Hull,
    Domain,
}

const CLIPS: [(&str, &str, Clip); 3] = [
    ("box", "a box around the points, a tenth larger", Clip::Box),
    ("hull", "the convex hull of the points", Clip::Hull),
    ("domain", "the domain of the drawing, or the triangles of the mesh", Clip::Domain),
];

/// Draw the Voronoi diagram of the points of a drawing or a mesh, clipped
#[derive(Debug, Args)]
#[command(after_help = format!("{HELP}\n\n{STATUSES}"))]
pub(crate) struct Options {
    #[command(flatten)]
    source: SourceOptions,

    /// To what the cells are clipped
    #[arg(long, value_name = "TO", default_value = "box", value_parser = one_of(CLIPS))]
    clip: Clip,

    #[command(flatten)]
    output: OutputOptions,

    #[command(flatten)]
    report: ReportOptions,
}

/// Runs the command.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    progress::handle_ctrl_c();
    outputs::recover(&options.output.output, options.report.quiet);
    let source = match options.clip {
        Clip::Domain => options.source.read_triangles()?,
        Clip::Box | Clip::Hull => options.source.read_points()?,
    };
    let outputs = Outputs::sparing(source.files.clone()).with_lines(&options.output, &source)?;
    let stream = outputs.report_stream(&options.report)?;
    let start = Instant::now();
    let sites = &source.value.points[..source.value.input_points.min(source.value.points.len())];
    let sites = if sites.is_empty() { &source.value.points } else { sites };
    let delaunay = Delaunay::new(sites).map_err(|error| Failure::bad_input(error.to_string()))?;
    let voronoi = Voronoi::new(&delaunay);
    let clipped = clip(options.clip, &source, &delaunay, &voronoi)?;
    let seconds = start.elapsed().as_secs_f64();
    options.report.warn(&source.notes);
    progress::begin_writing()?;
    let prepared = outputs.prepare_lines(&drawing(&voronoi, &clipped), &table(&clipped, &source))?;
    let [cells, bounded] = [voronoi.cells().count(), voronoi.cells().filter(|&v| voronoi.is_bounded(v)).count()];
    let (pieces, area) =
        (clipped.cells().map(|(_, pieces)| pieces.len()).sum::<usize>(), clipped.area(clipped.outline()));
    if options.report.json {
        json::print(&json!({
            "cells": cells,
            "bounded_cells": bounded,
            "vertices": voronoi.vertices().len(),
            "edges": voronoi.edges().len(),
            "clipped_cells": clipped.cells().count(),
            "pieces": pieces,
            "area": area,
            "seconds": seconds,
            "warnings": source.notes,
        }))?;
    } else if stream != Stream::Nowhere {
        let mut lines = text::Lines::default();
        lines.heading(source.name());
        lines.row("cells", format_args!("{cells} ({bounded} bounded)"));
        lines.row("diagram", format_args!("{} vertices, {} edges", voronoi.vertices().len(), voronoi.edges().len()));
        lines.row("clipped", format_args!("{} cells in {pieces} pieces, area {area}", clipped.cells().count()));
        text::add_end(&mut lines, seconds, &outputs.files());
        console::write(stream, &lines.into_text())?;
    }
    prepared.commit()?;
    Ok(Status::Done)
}

fn clip(
    to: Clip,
    source: &Input<IndexedMesh>,
    delaunay: &Delaunay,
    voronoi: &Voronoi,
) -> Result<ClippedVoronoi, Failure> {
    let failed = |error: VoronoiError| Failure::bad_input(error.to_string());
    match to {
        Clip::Box => match delaunay.bounding_box() {
            Some(bounds) => voronoi.clipped_to_box(larger(bounds)).map_err(failed),
            None => Ok(ClippedVoronoi::default()),
        },
        Clip::Hull => voronoi.clipped_to(delaunay).map_err(failed),
        Clip::Domain => voronoi.clipped_to(&terrain::triangulation(source)?).map_err(failed),
    }
}

/// A box larger by a tenth of its longer side all around; by 1 around a single point.
fn larger(bounds: BoundingBox) -> BoundingBox {
    let half = bounds.half_width().max(bounds.half_height());
    let by = if half > 0.0 { half / 5.0 } else { 1.0 };
    let finite = |x: f64| x.clamp(-f64::MAX, f64::MAX);
    BoundingBox {
        min: Point::new(finite(bounds.min.x - by), finite(bounds.min.y - by)),
        max: Point::new(finite(bounds.max.x + by), finite(bounds.max.y + by)),
    }
}

/// The points, then the corners and sides of the cells.
fn drawing(voronoi: &Voronoi, clipped: &ClippedVoronoi) -> Pslg {
    let first = voronoi.sites().len() as u32;
    let rings = clipped.outline().iter().flat_map(Piece::rings);
    let outline =
        rings.flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| [a.min(b), a.max(b)]));
    let mut outline: Vec<[u32; 2]> = outline.collect();
    outline.sort_unstable();
    let sides = clipped.sides();
    Pslg {
        points: voronoi.sites().iter().chain(clipped.points()).copied().collect(),
        segments: sides.iter().map(|side| side.map(|i| i + first)).collect(),
        segment_markers: sides.iter().map(|side| i32::from(outline.binary_search(side).is_ok())).collect(),
        ..Pslg::default()
    }
}

/// Comma-separated values.
fn table(clipped: &ClippedVoronoi, source: &Input<IndexedMesh>) -> String {
    let mut table = String::from("point,piece,ring,x,y\n");
    for (site, pieces) in clipped.cells() {
        for (piece, of_piece) in pieces.iter().enumerate() {
            for (ring, corners) in of_piece.rings().enumerate() {
                for p in clipped.ring(corners) {
                    let _ = writeln!(table, "{},{},{ring},{},{}", source.number(site.index()), piece + 1, p.x, p.y);
                }
            }
        }
    }
    table
}
