//! A command at work, slice by slice.

use std::fmt;

use crate::changes::Traces;
use crate::commands::Job;
use crate::document::Document;
use crate::error::CommandError;
use crate::messages::Interface;

/// What is left of a command that is done in slices.
pub(crate) struct Unfinished {
    /// The line of the command.
    pub(crate) line: String,
    pub(crate) job: Box<dyn Job>,
    /// What it has overwritten so far.
    pub(crate) traces: Traces,
}

/// A command at work on a document, for programs that must answer between two slices and have no threads.
///
/// `Refine`, `Step` and `LEPP` are done in slices of about a millisecond on a document of 10^5 vertices, `Generate` and
/// `Triangulate` in slices of some milliseconds; `Load` reads the file in one, and takes triangles up in another. What
/// is linear in the document (to copy it, to sort its points, to carve its outside) is a slice of its own, and so are
/// algorithms other than the incremental one. Every other command is one slice. The command is one all the same: it is
/// noted and undone as a whole, and its outcome does not depend on where the slices end. It holds the document until
/// then, so that nothing else can change it; dropped before, it takes the document with it.
///
/// # Examples
/// ```
/// use trimalla_workbench::{Advanced, Document, Quiet, script};
///
/// let mut document = Document::new();
/// script::run(&mut document, "Generate polygon 30\nTriangulate", false, &mut Quiet);
/// let mut running = document.begin("Refine");
/// let (refined, outcome) = loop {
///     match running.advance(&mut Quiet) {
///         Advanced::More(rest) => running = rest, // A program answers its user here.
///         Advanced::Done(document, outcome) => break (document, outcome),
///     }
/// };
/// outcome?;
/// assert!(refined.figures().min_angle_deg > 20.0);
/// # Ok::<(), trimalla_workbench::CommandError>(())
/// ```
#[derive(Debug)]
pub struct Running {
    document: Document,
    next: Next,
}

enum Next {
    /// The command of this line is to be begun.
    Line(String),
    Rest(Unfinished),
}

impl fmt::Debug for Next {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "Line({line:?})"),
            Self::Rest(unfinished) => write!(f, "Rest({:?}, ..)", unfinished.line),
        }
    }
}

/// What came of a slice.
#[derive(Debug)]
pub enum Advanced {
    /// The command is not done yet.
    More(Running),
    /// It is done, or was refused and has changed nothing.
    Done(Document, Result<(), CommandError>),
}

impl Document {
    /// Begins the command of a line, to be done slice by slice: [`Running::advance`] does the first.
    #[must_use]
    pub fn begin(self, line: &str) -> Running {
        Running { document: self, next: Next::Line(line.to_owned()) }
    }
}

impl Running {
    /// Does the next slice. Where the interface says that somebody has cancelled, the command is taken back and done.
    pub fn advance(self, interface: &mut dyn Interface) -> Advanced {
        let Self { mut document, next } = self;
        let done = match next {
            Next::Line(line) => document.start(&line, interface),
            Next::Rest(unfinished) => document.go_on(unfinished, interface),
        };
        match done {
            Ok(Some(unfinished)) => Advanced::More(Self { document, next: Next::Rest(unfinished) }),
            Ok(None) => Advanced::Done(document, Ok(())),
            Err(error) => Advanced::Done(document, Err(error)),
        }
    }
}
