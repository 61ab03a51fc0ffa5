//! Why an experiment ends before it is done.

use std::fmt;
use std::io;
use std::path::PathBuf;

use trimalla::domain::DomainError;
use trimalla::refine::OptionError;
use trimalla_io::IoError;

/// Why an experiment ends before it is done.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CompareError {
    /// A published table cannot be read.
    #[error(transparent)]
    Io(#[from] IoError),
    /// The journal cannot be opened or written.
    #[error("cannot write the journal {}: {source}", Shown(path))]
    Journal {
        /// Where it is.
        path: PathBuf,
        /// Why not.
        source: io::Error,
    },
    /// A file that is no journal; it was not touched.
    #[error("{}:{line}: expected the outcome of a run", Shown(path))]
    NotAJournal {
        /// Where it is.
        path: PathBuf,
        /// The first line that is no outcome.
        line: usize,
    },
    /// A drawing cannot be triangulated.
    #[error("{drawing}: {source}")]
    Drawing {
        /// Its name.
        drawing: String,
        /// What is wrong with it.
        source: DomainError,
    },
    /// What is given as a drawing is none: columns have wrong lengths, or an index has no vertex.
    #[error("{drawing}: {source}")]
    NoDrawing {
        /// Its name.
        drawing: String,
        /// What is wrong with it.
        source: io::Error,
    },
    /// A recipe asks for what cannot be.
    #[error("{contender}: {source}")]
    Option {
        /// Its column.
        contender: String,
        /// What cannot be.
        source: OptionError,
    },
    /// The caller ended it; what was done is in the journal, if there is one.
    #[error("interrupted; no table was written")]
    Interrupted,
}

/// A path for messages: control characters in a name shall not reach a terminal.
struct Shown<'a>(&'a PathBuf);

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for c in self.0.to_string_lossy().chars() {
            if c.is_control() {
                write!(f, "{}", c.escape_default())?;
            } else {
                write!(f, "{c}")?;
            }
        }
        Ok(())
    }
}
