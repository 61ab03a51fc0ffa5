//! `trimalla convert`: from one format to another.

use std::path::PathBuf;

use clap::Args;
use trimalla_io::{Format, Precision};

use crate::args::{ImportOptions, OutputOptions, PRECISIONS, one_of};
use crate::exit::{Failure, STATUSES, Status};
use crate::input::{is_mesh, read_drawing, read_mesh};
use crate::outputs::{self, Outputs};
use crate::progress;

const HELP: &str = "\
Examples:
  trimalla convert key.poly key.svg           a picture of a drawing
  trimalla convert plan.dxf plan.poly         a CAD drawing as vertices, segments and seeds
  trimalla convert key.1.ele key.1.svg        a picture of a mesh
  trimalla convert key.1.ele key.1.png        the same in pixels, without letters
  trimalla convert key.1.ele key.1.neigh      which triangles share an edge
  trimalla convert key.1.ele - --format edge  its edges, on standard output
  trimalla convert key.1.ele key.msh          for Gmsh and solvers, regions and boundaries by name
  trimalla convert part.inp part.su2          from Abaqus to SU2

An .ele file, or a stem that has one, is a mesh and is read with its .node and .poly files. Meshes
in one file are .msh, .inp, .mesh, .meshsuite, .su2, .vtu, .vtk, .obj, .ply, .stl, .off, .soup and
.txt. All else is a drawing. Numbers keep their bits, and records their numbering. Names of regions
and boundaries are kept where the output has a place for them: 'trimalla list' names the formats.";

/// Convert a drawing or a mesh to another format, or to a picture
#[derive(Debug, Args)]
#[command(after_help = format!("{HELP}\n\n{STATUSES}"))]
pub(crate) struct Options {
    /// A mesh (.ele or its stem, .msh, .inp, .vtu, …), or a drawing (.poly, .node, a stem, '-', or one of another
    /// program)
    input: PathBuf,

    /// Where to; the ending says the format
    output: PathBuf,

    /// The format, where the output's name does not say it, such as '-'
    #[arg(long, value_name = "FORMAT", value_parser = one_of(Format::ALL.map(|f| (f.extension(), f.summary(), f))))]
    format: Option<Format>,

    /// How exact the coordinates of a mesh are in the output
    #[arg(long, value_name = "BITS", default_value = "f64", value_parser = one_of(PRECISIONS))]
    precision: Precision,

    #[command(flatten)]
    import: ImportOptions,
}

/// Runs the command.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    progress::handle_ctrl_c();
    outputs::recover([&options.output], false);
    let output =
        OutputOptions { output: vec![options.output.clone()], format: options.format, precision: options.precision };
    if is_mesh(&options.input) {
        let mesh = read_mesh(&options.input)?.with_notes_shown();
        let outputs = Outputs::plan(&output, &mesh)?;
        progress::begin_writing()?;
        outputs.prepare_mesh(trimalla_io::Outputs::default(), &mesh.value, &[])?.commit()?;
    } else {
        let drawing = read_drawing(&options.input, &options.import)?.with_notes_shown();
        let outputs = Outputs::plan(&output, &drawing)?;
        progress::begin_writing()?;
        let prepared = outputs.prepare_drawing(&drawing.value).map_err(|failure| match output_format(options) {
            Some(format) if !format.holds_drawings() && format != Format::Area => {
                failure.hint("a drawing has no triangles; 'trimalla triangulate' makes them")
            }
            _ => failure,
        })?;
        prepared.commit()?;
    }
    Ok(Status::Done)
}

fn output_format(options: &Options) -> Option<Format> {
    Format::from_path(&options.output).or(options.format)
}
