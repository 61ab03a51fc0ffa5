//! Scripts: the commands of a document as a text, one a line.

use std::path::Path;
use std::{fmt, io};

use trimalla_io::{Files, IoError};

use crate::commands::COMMANDS;
use crate::document::Document;
use crate::error::CommandError;
pub use crate::lessons::{LEARN, Lesson, Scene, scenes};
use crate::messages::Interface;

/// A command of a script that was refused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ScriptError {
    /// The line, counted from 1.
    pub line: usize,
    /// The text of that line.
    pub text: String,
    /// What is wrong with it.
    pub error: CommandError,
}

impl fmt::Display for ScriptError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", self.line)?;
        if let Some((column, _)) = self.error.place() {
            write!(f, "{column}:")?;
        }
        write!(f, " {}", self.error)
    }
}

impl std::error::Error for ScriptError {}

/// A script is no longer than this, in bytes.
pub const LONGEST: u64 = 64 << 20;

/// Reads a script.
///
/// # Errors
/// Those of [`trimalla_io::read_bytes`] with [`LONGEST`], and for what is no text in UTF-8.
pub fn read(path: impl AsRef<Path>) -> Result<String, IoError> {
    read_in(&Files::Disk, path)
}

/// Reads a script that is among some files.
///
/// # Errors
/// Those of [`Files::read_bytes`] with [`LONGEST`], and for what is no text in UTF-8.
pub fn read_in(files: &Files, path: impl AsRef<Path>) -> Result<String, IoError> {
    let path = path.as_ref();
    let no_text = |error| IoError::Unreadable {
        path: path.to_owned(),
        source: io::Error::new(io::ErrorKind::InvalidData, error),
    };
    String::from_utf8(files.read_bytes(path, LONGEST)?).map_err(no_text)
}

/// A word as it is written into a command: in quotes where it has blanks or begins as a comment.
#[must_use]
pub fn word(text: &str) -> String {
    let needs_quotes = text.is_empty() || text.starts_with('#') || text.contains(char::is_whitespace);
    if needs_quotes { format!("\"{text}\"") } else { text.to_owned() }
}

/// The names of commands that begin with some letters, whatever their case.
pub fn completions(begun: &str) -> impl Iterator<Item = &'static str> {
    let begun = begun.to_ascii_lowercase();
    COMMANDS.iter().map(|row| row.name).filter(move |name| name.to_ascii_lowercase().starts_with(&begun))
}

/// Runs the lines of a script up to the first that is refused, or with `keeps_going` all of them, or until somebody
/// cancels; returns those that were refused.
///
/// # Examples
/// ```
/// use trimalla_workbench::{Document, Quiet, script};
///
/// let mut document = Document::new();
/// let refused = script::run(&mut document, "V 0 0 0 # a corner\n\nV 0 1 1\n", false, &mut Quiet);
/// assert_eq!(refused[0].to_string(), "3:3: the index must be above 0, the highest there is");
/// ```
pub fn run(document: &mut Document, text: &str, keeps_going: bool, interface: &mut dyn Interface) -> Vec<ScriptError> {
    let mut refused = Vec::new();
    for (line, text) in (1..).zip(text.lines()) {
        if interface.is_cancelled() {
            break;
        }
        if let Err(error) = document.run(text, interface) {
            refused.push(ScriptError { line, text: text.to_owned(), error });
            if !keeps_going {
                break;
            }
        }
    }
    refused
}
