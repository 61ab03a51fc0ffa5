//! The program and its subcommands.

pub(crate) mod check;
pub(crate) mod clean;
pub(crate) mod compare;
pub(crate) mod contour;
pub(crate) mod convert;
pub(crate) mod guards;
pub(crate) mod interpolate;
pub(crate) mod list;
pub(crate) mod mesh;
pub(crate) mod refine;
pub(crate) mod run;
pub(crate) mod setup;
pub(crate) mod stats;
pub(crate) mod triangle;
pub(crate) mod triangulate;
pub(crate) mod visible;
pub(crate) mod voronoi;

use clap::{Parser, Subcommand};

use crate::exit::{Failure, STATUSES, Status};

/// Triangulates planar drawings and refines them into meshes of good triangles
#[derive(Debug, Parser)]
#[command(name = "trimalla", version, after_help = format!("{EXAMPLES}\n\n{STATUSES}"))]
pub(crate) struct Program {
    #[command(subcommand)]
    command: Command,
}

const EXAMPLES: &str = "\
Examples:
  trimalla mesh key.poly -o key.1.ele         mesh a drawing, no angle below 30 degrees
  trimalla mesh key.poly -o key.svg           the same, as a picture
  trimalla check key.1.ele --input key.poly   prove the mesh right
  trimalla clean plan.poly                    what is wrong with a drawing, and where
  trimalla refine key.1.ele --input key.poly --max-area 0.1 -o key.2.ele
                                              refine it further
  trimalla compare key.poly --markdown        all algorithms at all angles, in a table
  trimalla contour terrain.node --step 10 -o lines.svg
                                              lines of equal height
  trimalla triangle -pq30a0.1 key             Triangle's switches and files
  trimalla guards plan.poly -o guards.svg     guards that see every place of a floor plan
  trimalla run session.tri                    a script of commands: draw, triangulate, edit, refine
  trimalla list                               algorithms, steps, rules and formats

'trimalla help mesh' explains the options of a subcommand.";

#[derive(Debug, Subcommand)]
enum Command {
    Mesh(mesh::Options),
    Refine(refine::Options),
    Triangulate(triangulate::Options),
    Check(check::Options),
    Clean(clean::Options),
    Stats(stats::Options),
    Compare(compare::Options),
    Convert(convert::Options),
    Voronoi(voronoi::Options),
    Interpolate(interpolate::Options),
    Contour(contour::Options),
    Visible(visible::Options),
    Guards(guards::Options),
    Run(run::Options),
    Triangle(triangle::Options),
    List(list::Options),
    Completions(setup::CompletionOptions),
    Man(setup::ManOptions),
}

/// Runs the subcommand of the command line.
pub(crate) fn run(program: Program) -> Result<Status, Failure> {
    match program.command {
        Command::Mesh(options) => mesh::run(&options),
        Command::Refine(options) => refine::run(&options),
        Command::Triangulate(options) => triangulate::run(&options),
        Command::Check(options) => check::run(&options),
        Command::Clean(options) => clean::run(&options),
        Command::Stats(options) => stats::run(&options),
        Command::Compare(options) => compare::run(&options),
        Command::Convert(options) => convert::run(&options),
        Command::Voronoi(options) => voronoi::run(&options),
        Command::Interpolate(options) => interpolate::run(&options),
        Command::Contour(options) => contour::run(&options),
        Command::Visible(options) => visible::run(&options),
        Command::Guards(options) => guards::run(&options),
        Command::Run(options) => run::run(&options),
        Command::Triangle(options) => triangle::run(&options),
        Command::List(options) => list::run(&options),
        Command::Completions(options) => setup::completions(&options),
        Command::Man(options) => setup::man(&options),
    }
}
