//! `trimalla completions` and `trimalla man`: what a shell and a manual reader need of the program.

use clap::{Args, CommandFactory as _};
use clap_complete::Shell;
use clap_mangen::Man;

use super::Program;
use crate::console;
use crate::exit::{Failure, STATUSES, Status};

/// Print what a shell needs to complete the command line
#[derive(Debug, Args)]
#[command(after_help = format!("{COMPLETION_EXAMPLES}\n\n{STATUSES}"))]
pub(crate) struct CompletionOptions {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

/// Print a page of the manual
#[derive(Debug, Args)]
#[command(after_help = format!("{MAN_EXAMPLES}\n\n{STATUSES}"))]
pub(crate) struct ManOptions {
    /// The subcommand [default: the program itself]
    subcommand: Option<String>,
    /// Print the names of the subcommands instead
    #[arg(long, conflicts_with = "subcommand")]
    list: bool,
}

const COMPLETION_EXAMPLES: &str = "\
Examples:
  trimalla completions bash > ~/.local/share/bash-completion/completions/trimalla
  trimalla completions zsh > ~/.zfunc/_trimalla
  trimalla completions fish > ~/.config/fish/completions/trimalla.fish";

const MAN_EXAMPLES: &str = "\
Examples:
  trimalla man > trimalla.1
  trimalla man mesh > trimalla-mesh.1
  trimalla man mesh | man -l -";

/// Runs `completions`.
pub(crate) fn completions(options: &CompletionOptions) -> Result<Status, Failure> {
    let mut text = Vec::new();
    clap_complete::generate(options.shell, &mut Program::command(), "trimalla", &mut text);
    print(&text)
}

/// Runs `man`.
pub(crate) fn man(options: &ManOptions) -> Result<Status, Failure> {
    if options.list {
        let names: Vec<String> = names(&Program::command()).map(|name| format!("{name}\n")).collect();
        console::print(&names.concat())?;
        return Ok(Status::Done);
    }
    let mut text = Vec::new();
    let written = page(options.subcommand.as_deref())?.render(&mut text);
    written.map_err(|e| Failure::new(Status::Unwritable, format!("cannot write the page: {e}")))?;
    print(&text)
}

/// The page of the program or of one of its subcommands.
fn page(subcommand: Option<&str>) -> Result<Man, Failure> {
    let program = Program::command();
    let Some(name) = subcommand else { return Ok(Man::new(program)) };
    let Some(found) = program.find_subcommand(name) else {
        let names: Vec<&str> = names(&program).collect();
        let message = format!("no subcommand is called '{name}': there are {}", names.join(", "));
        return Err(Failure::new(Status::WrongUse, message));
    };
    let titled = found.clone().name(format!("trimalla-{name}")).bin_name(format!("trimalla {name}"));
    Ok(Man::new(titled.version(env!("CARGO_PKG_VERSION"))))
}

fn names(program: &clap::Command) -> impl Iterator<Item = &str> {
    program.get_subcommands().map(clap::Command::get_name)
}

fn print(text: &[u8]) -> Result<Status, Failure> {
    console::print(&String::from_utf8_lossy(text))?;
    Ok(Status::Done)
}
