//! Exit statuses, and failures on their way to the user.

use std::process::ExitCode;

use trimalla::refine::OptionError;
use trimalla_compare::CompareError;
use trimalla_io::IoError;

/// How the program ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Status {
    /// All is done; every triangle left below the bound is forced by the input's own angles or gaps.
    Done = 0,
    /// A check failed, or limits left triangles below the bound.
    Unmet = 1,
    /// The command line asks for what cannot be.
    WrongUse = 2,
    /// The input cannot be read, or is no valid drawing or mesh.
    BadInput = 3,
    /// An output cannot be written.
    Unwritable = 4,
    /// Ctrl-C: 128 and the number of the signal, as shells do.
    Interrupted = 130,
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> Self {
        Self::from(status as u8)
    }
}

/// What every `--help` says at its end.
pub(crate) const STATUSES: &str = "\
Exit status:
  0    done; a triangle below the bound is forced by the input's own angles or gaps
  1    a check failed, or the vertex budget, the length floor or protected segments
       left triangles below the bound (the mesh is written all the same)
  2    wrong use
  3    the input cannot be read, or is not valid
  4    an output cannot be written
  130  interrupted by Ctrl-C
On 2, 3, 4 and 130 no file is changed.

Outputs, traces, frames and players among them, appear together when all are complete. Files that are
read are never replaced, whatever their names. A run that is killed, or aborted when memory runs out
(134), leaves whole files: all old, or, if it was killed while they appeared, some old and some new
until the next run that writes into the same directories. That run puts the others in their places too,
unless one was changed meanwhile, and removes the temporary files, which are called .trimalla-*.";

/// Why the program ends before it is done: a status, one `error:` line each message, one `hint:` line each hint.
#[derive(Debug)]
pub(crate) struct Failure {
    status: Status,
    messages: Vec<String>,
    hints: Vec<String>,
}

impl Failure {
    pub(crate) fn new(status: Status, message: impl Into<String>) -> Self {
        Self::of_many(status, vec![message.into()])
    }

    /// A failure that takes several lines to say.
    pub(crate) fn of_many(status: Status, messages: Vec<String>) -> Self {
        Self { status, messages, hints: Vec::new() }
    }

    pub(crate) fn wrong_use(message: impl Into<String>) -> Self {
        Self::new(Status::WrongUse, message)
    }

    pub(crate) fn bad_input(message: impl Into<String>) -> Self {
        Self::new(Status::BadInput, message)
    }

    /// Adds a hint on what the user may do about it.
    #[must_use]
    pub(crate) fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hints.push(hint.into());
        self
    }

    /// The messages, for a caller that reports them elsewhere.
    pub(crate) fn into_messages(self) -> Vec<String> {
        self.messages
    }

    /// Messages, hints, and the status to end with.
    pub(crate) fn into_parts(self) -> (Vec<String>, Vec<String>, Status) {
        (self.messages, self.hints, self.status)
    }
}

impl From<OptionError> for Failure {
    fn from(error: OptionError) -> Self {
        Self::wrong_use(error.to_string())
    }
}

impl From<CompareError> for Failure {
    fn from(error: CompareError) -> Self {
        let message = error.to_string();
        match error {
            CompareError::Io(error) => error.into(),
            CompareError::Journal { .. } => Self::new(Status::Unwritable, message),
            CompareError::NotAJournal { .. } => Self::bad_input(message)
                .hint("a journal is written by 'trimalla compare'; give --resume another name, or delete the file"),
            CompareError::Option { source, .. } => source.into(),
            CompareError::Interrupted => Self::new(Status::Interrupted, message),
            _ => Self::bad_input(message),
        }
    }
}

impl From<IoError> for Failure {
    fn from(error: IoError) -> Self {
        let status = if error.is_output() { Status::Unwritable } else { Status::BadInput };
        let failure = Self::new(status, error.to_string());
        match error {
            IoError::UnknownOutput { .. } => {
                failure.hint("'trimalla list' names the formats; --format names that of an output")
            }
            IoError::Missing { needed_by: Some(_), .. } => {
                failure.hint("both files are needed, side by side and with the same stem")
            }
            _ => failure,
        }
    }
}
