//! The subcommands.

pub(crate) mod check;
pub(crate) mod compare;
pub(crate) mod convert;
pub(crate) mod list;
pub(crate) mod mesh;
pub(crate) mod refine;
pub(crate) mod stats;
pub(crate) mod triangulate;

use crate::args::{Command, Program};
use crate::exit::{Failure, Status};

/// Runs the subcommand of the command line.
pub(crate) fn run(program: Program) -> Result<Status, Failure> {
    match program.command {
        Command::Mesh(options) => mesh::run(&options),
        Command::Refine(options) => refine::run(&options),
        Command::Triangulate(options) => triangulate::run(&options),
        Command::Check(options) => check::run(&options),
        Command::Stats(options) => stats::run(&options),
        Command::Compare(options) => compare::run(&options),
        Command::Convert(options) => convert::run(&options),
        Command::List(options) => list::run(&options),
    }
}
