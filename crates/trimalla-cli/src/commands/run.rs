//! `trimalla run`: a script of commands, or a prompt for them.

use std::io::{self, IsTerminal as _, Read as _};
use std::path::{Path, PathBuf};

use clap::Args;
use trimalla_workbench::{Document, script};

use crate::console;
use crate::exit::{Failure, Status};
use crate::progress;
use crate::prompt;
use crate::script_text::{Lines, Shown};

const HELP: &str = "\
Examples:
  trimalla run session.tri             run the commands of a file
  trimalla run session.tri --keep-going
                                       go on after commands that are refused
  trimalla run -                       a prompt, or the commands of standard input

'Help' lists the commands, 'Help LEPP' explains one. They are those of Valenzuela's tool (V, Outer,
Inner, Triangulate, LEPP, Clear, Reset) and more; 'Undo' takes any of them back, and 'Save FILE'
writes those that led to what is there. 'Expect' fails the script unless something holds.

Exit status:
  0    every command was done
  1    a command was refused; without --keep-going the script ends there
  2    wrong use
  3    the script cannot be read
  4    the messages cannot be written
  130  interrupted by Ctrl-C: the command at work has changed nothing

Files that 'Save', 'Export' and 'Player' have written before a script ends stay. Each is written whole
or not at all, and one that was read is never replaced, the script itself included.";

/// Run a script of commands: draw, triangulate, edit, refine, check
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct Options {
    /// The script; '-' for standard input, with a prompt where that is a terminal
    script: PathBuf,

    /// Go on after commands that are refused
    #[arg(long)]
    keep_going: bool,

    /// Show each command before its messages
    #[arg(long)]
    echo: bool,

    /// Print nothing but errors
    #[arg(short, long)]
    quiet: bool,
}

/// Runs the command.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    progress::handle_ctrl_c();
    // Commands poll it, and a save is not cut in two.
    progress::defer_ctrl_c();
    let mut document = Document::new();
    let mut shown = Shown::new(options.echo, options.quiet);
    let is_input = options.script == Path::new("-");
    if is_input && io::stdin().is_terminal() {
        return prompt::run(&mut document, &mut shown);
    }
    let text = if is_input { standard_input()? } else { script::read(&options.script)? };
    if !is_input {
        document.spare(&options.script);
    }
    let name = if is_input { "standard input".to_owned() } else { console::shown(&options.script) };
    let refused = script::run(&mut document, &text, options.keep_going, &mut shown);
    if !refused.is_empty() {
        let mut lines = Lines::new(&name, &text);
        refused.iter().for_each(|error| lines.show(error));
    }
    shown.end()?;
    if progress::is_interrupted() {
        return Ok(Status::Interrupted);
    }
    Ok(if refused.is_empty() { Status::Done } else { Status::Unmet })
}

fn standard_input() -> Result<String, Failure> {
    let mut text = String::new();
    let failed = |error: io::Error| Failure::bad_input(format!("cannot read standard input: {error}"));
    io::stdin().lock().take(script::LONGEST + 1).read_to_string(&mut text).map_err(failed)?;
    if text.len() as u64 > script::LONGEST {
        return Err(Failure::bad_input(format!("standard input: longer than {} bytes", script::LONGEST)));
    }
    Ok(text)
}
