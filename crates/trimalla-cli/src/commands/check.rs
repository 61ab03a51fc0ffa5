//! `trimalla check`: checks a mesh, and compares it with its drawing.

use std::path::PathBuf;

use clap::Args;
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Angle;
use trimalla::quality::{against_input, below_bound};
use trimalla::refine::OptionError;
use trimalla::triangulation::{MeshFault, check_mesh, check_mesh_delaunay};
use trimalla_workbench::numbers::{Renumber as _, count};
use trimalla_workbench::refining::corners;

use crate::args::ImportOptions;
use crate::console;
use crate::exit::{Failure, STATUSES, Status};
use crate::input::{Input, read_drawing, read_mesh};

/// No more faults than this are named one by one.
const MOST_FAULTS: usize = 50;

const HELP: &str = "\
Examples:
  trimalla check key.1.ele
  trimalla check key.1.ele --input key.poly --min-angle 30

Checked are, with exact arithmetic: indices and columns; every triangle counter-clockwise; every
edge between at most two triangles; no overlap; every subsegment an edge; the circle test on every
edge that is not constrained. Constrained is what the .poly file of the mesh and --input say.
With --input: the vertices of the drawing come first and unchanged, and each of its segments is a
chain of edges that advances from end to end. Vertices of the drawing are on a chain only if they
lie exactly on the segment (within 12 last places where segments cross); computed ones may be off
by 16 last places of the segment's largest x in x, and of its largest y in y, for rounding.
With --min-angle: every triangle below the bound is a fault, also where the drawing forces it.

Each fault is a line on standard output, in the numbers of the file; after 50, the rest is counted.";

/// Check a mesh: every broken invariant, one a line
#[derive(Debug, Args)]
#[command(after_help = format!("{HELP}\n\n{STATUSES}"))]
pub(crate) struct Options {
    /// The mesh: an .ele file with its .node file beside it, the stem of both, or one file of any format that
    /// 'trimalla list' calls a mesh that is read (.msh, .inp, .mesh, .su2, .vtu, .vtk, .obj, .ply, .stl, .off, .soup,
    /// …)
    mesh: PathBuf,

    /// The drawing that the mesh was made from: .poly, .node, a stem, '-', or one of another program, read with the
    /// same options as for the mesh
    #[arg(long, value_name = "DRAWING")]
    input: Option<PathBuf>,

    #[command(flatten)]
    import: ImportOptions,

    /// The smallest angle that a triangle may have, in degrees, from 0 to 60
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true)]
    min_angle: Option<f64>,
}

/// Runs the command.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    if let Some(degrees) = options.min_angle.filter(|a| !(0.0..=60.0).contains(a)) {
        return Err(OptionError::MinAngle(degrees).into());
    }
    let mesh = read_mesh(&options.mesh)?.with_notes_shown();
    let drawing = options
        .input
        .as_deref()
        .map(|input| read_drawing(input, &options.import))
        .transpose()?
        .map(Input::with_notes_shown);
    let faults = faults(&mesh, drawing.as_ref(), options.min_angle);
    console::print(&text(&mesh, &faults))?;
    Ok(if faults.is_empty() { Status::Done } else { Status::Unmet })
}

/// Every fault, in words.
fn faults(mesh: &Input<IndexedMesh>, drawing: Option<&Input<Pslg>>, min_angle_deg: Option<f64>) -> Vec<String> {
    let numbered = |fault: MeshFault| fault.renumbered(mesh.first_index).to_string();
    let mut faults: Vec<String> = check_mesh(&mesh.value).into_iter().map(numbered).collect();
    let comparison = drawing.map(|drawing| (drawing, against_input(&mesh.value, &drawing.value)));
    let covered = comparison.as_ref().map_or(&[][..], |(_, found)| &found.covered);
    faults.extend(check_mesh_delaunay(&mesh.value, covered).into_iter().map(numbered));
    if let Some((drawing, found)) = comparison {
        let numbered = found.faults.into_iter().map(|fault| fault.renumbered(drawing.first_index));
        faults.extend(numbered.map(|fault| fault.to_string()));
    }
    if let Some(degrees) = min_angle_deg {
        let below = below_bound(&mesh.value, Angle::from_degrees(degrees));
        faults.extend(below.into_iter().map(|t| below_fault(mesh, t, degrees)));
    }
    faults
}

/// A triangle below the bound, in words.
fn below_fault(mesh: &Input<IndexedMesh>, triangle: usize, bound_deg: f64) -> String {
    let number = mesh.number(triangle);
    match corners(&mesh.value, triangle) {
        Some(corners) => {
            let (angle, at) = (corners.min_angle().degrees(), corners.centroid());
            format!("triangle {number} at {at} has an angle of {angle} degrees, below {bound_deg}")
        }
        None => format!("triangle {number} has no angles"),
    }
}

/// The first faults, one a line, and how many there are.
fn text(mesh: &Input<IndexedMesh>, faults: &[String]) -> String {
    let name = mesh.name();
    let mut lines: Vec<String> = faults.iter().take(MOST_FAULTS).map(|f| format!("{name}: {f}\n")).collect();
    if faults.len() > MOST_FAULTS {
        lines.push(format!("{name}: {} more\n", count(faults.len() - MOST_FAULTS, "fault")));
    }
    let vertices = count(mesh.value.points.len(), "vertex");
    let triangles = count(mesh.value.triangles.len(), "triangle");
    let verdict = match faults.len() {
        0 => "no faults".to_owned(),
        n => count(n, "fault"),
    };
    lines.push(format!("{name}: {vertices}, {triangles}: {verdict}\n"));
    lines.concat()
}
