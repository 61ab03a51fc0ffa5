//! `trimalla refine`: a mesh in, a finer mesh out.

use std::path::{Path, PathBuf};

use clap::Args;
use trimalla::Error;
use trimalla::domain::MeshError;
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla_workbench::refining::TaskInput;

use crate::args::ImportOptions;
use crate::console::shown;
use crate::exit::{Failure, STATUSES, Status};
use crate::input::{Input, read_drawing, read_mesh};
use crate::progress;
use crate::refining::{Job, RefiningOptions};
use crate::repeat::CommandLine;
use crate::{drawing_faults, mesh_faults, text};

const HELP: &str = "\
Examples:
  trimalla refine key.1.ele --input key.poly --max-area 0.1 -o key.2.ele
                                                  smaller triangles
  trimalla refine key.1.ele --input key.poly --min-angle 33 -o key.2.ele
                                                  rounder ones
  trimalla refine scan.ele --min-angle 0 --algorithm lepp-bisection --max-area 2 -o fine.ele
                                                  nested triangles, no flips
  trimalla refine key.1.ele --input key.poly --pick 12,31 -o key.2.ele
                                                  two triangles treated, no others

A soup (.soup or .txt) has the six coordinates of a triangle in each line: neighbours are found, and what
only one triangle has is the boundary. Files of solvers (.msh, .inp, .mesh, .su2, .vtu, …) bring their regions and
boundaries by name. Otherwise the mesh is an .ele file with its .node file beside it, and what lies beside them counts too:
  .poly  subsegments with their markers, and holes
  .area  for each triangle the largest area that triangles in it may have (none if not positive)
Triangles are taken as they are, attributes are handed down. The vertices of the mesh come first
in the result, in order, bit for bit.

Give the drawing that the mesh was made from with --input. Then its segments are found again in
the mesh: splits are computed from their ends, and small input angles are known as such. A mesh
that meets the bounds comes back as it is. Without --input, subsegments that go straight on are
joined, every vertex counts as one of the input, and a warning says so.

A mesh that is not constrained Delaunay is made so by flips first, which a warning counts; but
lepp-bisection, which flips nothing, keeps it as it is.
What is no mesh (triangles inverted or on one another, corners inside edges, two vertices on one
place) is named with triangles, vertices and coordinates, in the numbers of the file.";

/// Refine a mesh further: smaller triangles, larger angles, what exists stays
#[derive(Debug, Args)]
#[command(after_help = format!("{HELP}\n\n{STATUSES}"))]
pub(crate) struct Options {
    /// The mesh: an .ele file with its .node file beside it, the stem of both, or one file of any format that
    /// 'trimalla list' calls a mesh that is read (.msh, .inp, .mesh, .su2, .vtu, .vtk, .obj, .ply, .stl, .off, .soup,
    /// …)
    mesh: PathBuf,

    /// The drawing that the mesh was made from: .poly, .node, a stem, '-', or one of another program
    #[arg(long, value_name = "DRAWING", help_heading = "Drawing")]
    input: Option<PathBuf>,

    #[command(flatten)]
    import: ImportOptions,

    #[command(flatten)]
    refining: RefiningOptions,
}

/// Runs the command.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    let asked = options.refining.asked()?;
    progress::handle_ctrl_c();
    options.refining.recover();
    let mut mesh = read_mesh(&options.mesh)?;
    let areas = read_areas(&options.mesh, &mut mesh)?;
    let drawing = options.input.as_deref().map(|input| read_drawing(input, &options.import)).transpose()?;
    mesh.files.extend(drawing.iter().flat_map(|drawing| drawing.files.clone())); // None of these is overwritten.
    let outputs = options.refining.outputs(&mesh)?;
    let job = Job {
        title: mesh.title(),
        heading: text::of_mesh(&mesh.name(), &mesh.value),
        command: options
            .input
            .iter()
            .fold(options.import.repeat(CommandLine::new("refine", &options.mesh)), |line, input| {
                line.with("input", shown(input))
            }),
        first_index: mesh.first_index,
        vertices: mesh.value.points.len(),
        triangles: Some(&mesh.value.triangles),
        notes: mesh.notes.iter().chain(drawing.iter().flat_map(|drawing| &drawing.notes)).cloned().collect(),
        advice: &|_| None,
    };
    let input = TaskInput::Mesh {
        mesh: &mesh.value,
        name: mesh.name(),
        areas: &areas,
        drawing: drawing.as_ref().map(|drawing| (&drawing.value, drawing.numbers())),
    };
    options.refining.run(&asked, job, input, &outputs, |error| failure(error, &mesh, drawing.as_ref()))
}

/// The area bounds beside a mesh; none where there is no such file.
fn read_areas(path: &Path, mesh: &mut Input<IndexedMesh>) -> Result<Vec<Option<f64>>, Failure> {
    let found = trimalla_io::read_areas(path, mesh.value.triangles.len())?;
    Ok(found.map_or_else(Vec::new, |(areas, file)| {
        mesh.files.push(file);
        areas.0
    }))
}

/// An error of the library in the numbers of the files.
fn failure(error: Error, mesh: &Input<IndexedMesh>, drawing: Option<&Input<Pslg>>) -> Failure {
    let first = mesh.first_index;
    match (error, drawing) {
        (Error::Mesh(MeshError::Faults(faults)), _) => mesh_faults::failure(&mesh.name(), first, faults),
        (Error::NotOfDrawing(faults), _) => {
            let first = drawing.map_or(first, |drawing| drawing.first_index);
            mesh_faults::failure(&mesh.name(), first, faults)
                .hint("--input takes the drawing that this mesh was made from")
        }
        (Error::Mesh(MeshError::VertexChanged { vertex, was, is }), Some(drawing)) => Failure::bad_input(format!(
            "{}: vertex {} of {} lies at {was}, but at {is} in the mesh",
            mesh.name(),
            drawing.number(vertex),
            drawing.name()
        ))
        .hint("--input takes the drawing that this mesh was made from"),
        (Error::Mesh(MeshError::Drawing(error)), Some(drawing)) => drawing_faults::failure(&drawing.numbers(), &error),
        (Error::Option(error), _) => error.into(),
        (other, _) => Failure::bad_input(format!("{}: {other}", mesh.name())),
    }
}
