//! `trimalla stats`: how good a mesh is.

use std::path::PathBuf;

use clap::Args;
use serde_json::{Value, json};
use trimalla::quality::{AngleAt, Statistics};

use crate::exit::{Failure, STATUSES, Status};
use crate::input::read_mesh;
use crate::{console, json};

const HELP: &str = "\
Examples:
  trimalla stats key.1.ele
  trimalla stats key.1 --json

Angles are in degrees, lengths in the units of the mesh, areas in their squares. The aspect ratio
is the circumradius over twice the inradius: 1 for an equilateral triangle.";

/// Count and measure a mesh: sizes, angles, quality, histograms
#[derive(Debug, Args)]
#[command(after_help = format!("{HELP}\n\n{STATUSES}"))]
pub(crate) struct Options {
    /// The mesh: an .ele file with its .node file beside it, the stem of both, or one file of any format that
    /// 'trimalla list' calls a mesh that is read (.msh, .inp, .mesh, .su2, .vtu, .vtk, .obj, .ply, .stl, .off, .soup,
    /// …)
    mesh: PathBuf,

    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

/// Runs the command.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    let mesh = read_mesh(&options.mesh)?.with_notes_shown();
    let mut statistics = Statistics::of(&mesh.value);
    for at in [&mut statistics.min_angle, &mut statistics.max_angle].into_iter().flatten() {
        at.triangle += mesh.first_index as usize;
    }
    if options.json {
        json::print(&object(&statistics))?;
    } else {
        console::print(&format!("{}\n{statistics}", mesh.name()))?;
    }
    Ok(Status::Done)
}

/// The statistics for programs.
fn object(s: &Statistics) -> Value {
    json!({
        "vertices": s.vertices,
        "used_vertices": s.used_vertices,
        "triangles": s.triangles,
        "unmeasured": s.unmeasured,
        "edges": s.edges,
        "boundary_edges": s.boundary_edges,
        "subsegments": s.subsegments,
        "boundary_loops": s.boundary_loops,
        "components": s.components,
        "holes": s.holes,
        "area": s.total_area,
        "min_angle": s.min_angle.map(degrees),
        "max_angle": s.max_angle.map(degrees),
        "smallest_angles": json::of_histogram(&s.smallest_angles),
        "all_angles": json::of_histogram(&s.all_angles),
        "aspect_ratio": s.aspect_ratio.map(json::of_spread),
        "aspect_ratios": json::of_classes(&s.aspect_ratios),
        "edge_length": s.edge_length.map(json::of_spread),
        "triangle_area": s.area.map(json::of_spread),
        "degrees": s.degrees,
    })
}

fn degrees(at: AngleAt) -> f64 {
    at.angle.degrees()
}
