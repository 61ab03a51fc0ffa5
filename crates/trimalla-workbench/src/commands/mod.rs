//! The commands, one file each: name, arguments, help, parsing and running.

mod centroid;
mod check;
mod clear;
mod delete;
mod edge;
mod example;
mod expect;
mod export;
mod flip;
mod generate;
mod help;
mod inner;
mod insert;
mod lepp;
mod load;
mod midpoint;
mod move_vertex;
mod outer;
mod plan;
mod player;
mod recipe;
mod redo;
mod refine;
mod release;
mod reset;
mod save;
mod save_recipe;
mod select;
mod set;
mod show;
mod stats;
mod step;
mod terminal;
mod treat;
mod triangulate;
mod undo;
mod v;
mod watch;

pub use self::example::EXAMPLES;
use crate::arguments::{Arguments, Word};
use crate::changes::Work;
use crate::document::Document;
use crate::error::CommandError;
use crate::messages::Interface;

/// A command that changes the document.
pub(crate) trait Act {
    /// Does it; after an error the caller takes all changes back.
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError>;
}

/// A command that changes the document in slices, so that a program without threads can answer between two of them.
pub(crate) trait Job: Send {
    /// Does the next slice; after an error the caller takes all changes back.
    fn advance(&mut self, work: &mut Work<'_>) -> Result<Slice, CommandError>;
}

/// What is left of a command after a slice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Slice {
    /// There is another one.
    More,
    /// This was the last.
    Last,
}

/// A command that only reads the document.
pub(crate) trait Ask {
    /// Answers by messages.
    fn ask(&self, document: &Document, interface: &mut dyn Interface) -> Result<(), CommandError>;
}

/// A command as it was parsed.
pub(crate) enum Deed {
    /// It changes the document.
    Edit(Box<dyn Act>),
    /// It changes the document in slices.
    Slices(Box<dyn Job>),
    /// It reads the document.
    Ask(Box<dyn Ask>),
    /// It takes commands back.
    Undo(usize),
    /// It does commands again.
    Redo(usize),
}

impl Deed {
    fn edit(act: impl Act + 'static) -> Result<Self, CommandError> {
        Ok(Self::Edit(Box::new(act)))
    }

    fn slices(job: impl Job + 'static) -> Result<Self, CommandError> {
        Ok(Self::Slices(Box::new(job)))
    }

    fn ask(ask: impl Ask + 'static) -> Result<Self, CommandError> {
        Ok(Self::Ask(Box::new(ask)))
    }
}

/// A command: its name, its arguments and its help.
#[derive(Clone, Copy, Debug)]
pub struct CommandRow {
    /// The name; the case of letters does not matter.
    pub name: &'static str,
    /// The arguments, in the form in which manuals have them.
    pub arguments: &'static str,
    /// What it does, in one line.
    pub summary: &'static str,
    /// What else there is to say.
    pub help: &'static str,
    parse: fn(&mut Arguments<'_>) -> Result<Deed, CommandError>,
}

/// Every command, by subject.
pub const COMMANDS: &[CommandRow] = &[
    clear::ROW,
    reset::ROW,
    v::ROW,
    outer::ROW,
    inner::ROW,
    edge::ROW,
    generate::ROW,
    load::ROW,
    example::ROW,
    triangulate::ROW,
    watch::ROW,
    lepp::ROW,
    insert::ROW,
    midpoint::ROW,
    centroid::ROW,
    move_vertex::ROW,
    delete::ROW,
    flip::ROW,
    release::ROW,
    select::ROW,
    set::ROW,
    recipe::ROW,
    step::ROW,
    refine::ROW,
    treat::ROW,
    undo::ROW,
    redo::ROW,
    plan::ROW,
    show::ROW,
    stats::ROW,
    check::ROW,
    expect::ROW,
    save::ROW,
    save_recipe::ROW,
    export::ROW,
    player::ROW,
    help::ROW,
];

/// The row of a name.
fn row(name: &str) -> Option<&'static CommandRow> {
    COMMANDS.iter().find(|row| row.name.eq_ignore_ascii_case(name))
}

/// Parses the arguments of a command. Nothing may be left of the line.
pub(crate) fn parse(name: Word<'_>, arguments: &mut Arguments<'_>) -> Result<Deed, CommandError> {
    let unknown = || name.fault(format!("there is no command '{}'; 'Help' lists all", name.text));
    let row = row(name.text).ok_or_else(unknown)?;
    let deed = (row.parse)(arguments)?;
    arguments.end()?;
    Ok(deed)
}
