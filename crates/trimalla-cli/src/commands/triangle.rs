//! `trimalla triangle`: Triangle's switches and files.

use std::ffi::OsString;

use clap::Args;

use crate::console;
use crate::exit::{Failure, STATUSES, Status};
use crate::triangle::{self, switches_text};

const HELP: &str = "\
Examples:
  trimalla triangle dots                     the Delaunay triangulation of dots.node
  trimalla triangle -pe object.1             the constrained one of object.1.poly, with its edges
  trimalla triangle -pq31.5a.1 object        a mesh of object.poly
  trimalla triangle -rpaa6.2 z.3             the mesh z.3 refined, within the areas of z.3.area
  trimalla triangle -v points                a Voronoi diagram
  ln -s trimalla triangle                    a program called triangle does the same

Switches cluster behind a dash, and numbers stick to their letters. FILE is the stem of files, whose
iteration number counts up: the mesh of object.poly is object.1.node, object.1.ele, object.1.poly. FILE may
have its ending: .poly asks for -p, .ele for -r, .area for -ra. Segments that cross are split.";

/// Make a mesh as Triangle does: its switches, its files, its numbers
#[derive(Debug, Args)]
#[command(disable_help_flag = true, after_help = help())]
pub(crate) struct Options {
    /// Switches behind dashes, and FILE
    #[arg(value_name = "-SWITCHES FILE", num_args = 0.., allow_hyphen_values = true, trailing_var_arg = true)]
    words: Vec<OsString>,
}

/// Runs the command.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    let asks_for_help = options.words.iter().any(|word| word == "--help");
    match triangle::Call::of(&options.words)? {
        Some(call) if !asks_for_help => triangle::run(call),
        _ => {
            let text = format!("trimalla triangle [-SWITCHES]... FILE\n\n{}\n", help());
            console::print(&text).map(|()| Status::Done)
        }
    }
}

fn help() -> String {
    format!(
        "{HELP}\n\n{}\n{STATUSES}\n\nA mesh that misses a bound is written with status 0 here, as there.",
        switches_text()
    )
}
