//! `trimalla stats`: how good a mesh is.

use std::cmp::Ordering;
use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};
use trimalla::drawing::IndexedMesh;
use trimalla::quality::{AngleAt, Statistics, compare_equiangularity};

use crate::console::shown;
use crate::exit::{Failure, STATUSES, Status};
use crate::input::{Input, read_mesh};
use crate::{console, json};

const HELP: &str = "\
Examples:
  trimalla stats key.1.ele
  trimalla stats key.1 --json
  trimalla stats flipped.ele --against given.ele      which of two triangulations has the larger angles

Angles are in degrees, lengths in the units of the mesh, areas in their squares. The aspect ratio
is the circumradius over twice the inradius: 1 for an equilateral triangle.

--against compares two triangulations of the same points by the order of equiangularity: all angles of
each, sorted, the smallest first; where they differ first, the larger angle is better. The comparison is
exact. The Delaunay triangulation is best.";

/// Count and measure a mesh: sizes, angles, quality, histograms
#[derive(Debug, Args)]
#[command(after_help = format!("{HELP}\n\n{STATUSES}"))]
pub(crate) struct Options {
    /// The mesh: an .ele file with its .node file beside it, the stem of both, or one file of any format that
    /// 'trimalla list' calls a mesh that is read (.msh, .inp, .mesh, .su2, .vtu, .vtk, .obj, .ply, .stl, .off, .soup,
    /// …)
    mesh: PathBuf,

    /// Another triangulation of the same points: say which of the two is the more equiangular
    #[arg(long, value_name = "MESH")]
    against: Option<PathBuf>,

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
    let against = options.against.as_deref().map(|other| against(&mesh, other)).transpose()?;
    if options.json {
        let mut object = object(&statistics);
        if let Some(order) = against {
            object["equiangularity"] = json!(word(order, ["less", "equal", "greater"]));
        }
        json::print(&object)?;
    } else {
        let lines = against.zip(options.against.as_deref()).map_or_else(String::new, |(order, other)| {
            let word = word(order, ["less equiangular than", "as equiangular as", "more equiangular than"]);
            format!("\n{} is {word} {}\n", mesh.name(), shown(other))
        });
        console::print(&format!("{}\n{statistics}{lines}", mesh.name()))?;
    }
    Ok(Status::Done)
}

/// How a mesh compares with another of the same points.
fn against(mesh: &Input<IndexedMesh>, other: &Path) -> Result<Ordering, Failure> {
    let other = read_mesh(other)?.with_notes_shown();
    if mesh.value.points != other.value.points {
        return Err(Failure::bad_input(format!("{} and {} have different vertices", mesh.name(), other.name()))
            .hint("equiangularity compares triangulations of the same points"));
    }
    Ok(compare_equiangularity(&mesh.value, &other.value))
}

/// The word for an order.
fn word(order: Ordering, words: [&'static str; 3]) -> &'static str {
    match order {
        Ordering::Less => words[0],
        Ordering::Equal => words[1],
        Ordering::Greater => words[2],
    }
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
