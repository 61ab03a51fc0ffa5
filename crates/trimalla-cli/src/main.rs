//! The program `trimalla`: a drawing in, a good mesh out.
//!
//! | module | holds |
//! |---|---|
//! | [`commands`] | the command line, one file a subcommand |
//! | [`args`] | options that several subcommands share |
//! | [`input`] | drawings and meshes with the numbering of their files |
//! | [`terrain`] | a triangulation from a mesh or a drawing, its points and their heights |
//! | [`refining`] | the common part of `mesh` and `refine`: options, and the report of the workbench's outcome |
//! | [`drawing_faults`], [`snapping`] | what may help where a drawing is at fault; drawings mended in passing |
//! | [`outputs`], [`targets`] | the output files, checked before any work; leftovers of killed runs |
//! | [`trace`], [`player`] | every step recorded: as a line, as a picture, and on a page that plays them |
//! | [`recipe_options`], [`recipe_file`], [`picks`] | the options of a refinement, and as files; triangles picked by number |
//! | [`sizes`] | how large triangles are to be |
//! | [`progress`] | the progress line, and Ctrl-C |
//! | [`prompt`], [`script_text`] | commands typed at a terminal; what a script shows |
//! | [`triangle`] | Triangle's switches and files |
//! | [`words`] | what the words of a command line mean where no subcommand stands first |
//! | [`text`], [`json`] | reports for people and for programs |
//! | [`console`], [`exit`] | the two streams and the exit status |

mod args;
mod commands;
mod console;
mod drawing_faults;
mod exit;
mod input;
mod json;
mod mesh_faults;
mod outputs;
mod picks;
mod player;
mod progress;
mod prompt;
mod recipe_file;
mod recipe_options;
mod refining;
mod repeat;
mod script_text;
mod sizes;
mod snapping;
mod targets;
mod terrain;
mod text;
mod trace;
mod triangle;
mod words;

use std::process::ExitCode;

use clap::Parser as _;

fn main() -> ExitCode {
    let words = match words::of(std::env::args_os()) {
        Ok(words) => words,
        Err(failure) => return console::report(failure).into(),
    };
    match commands::run(commands::Program::parse_from(words)) {
        Ok(status) => status.into(),
        Err(failure) => console::report(failure).into(),
    }
}
