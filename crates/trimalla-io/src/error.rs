//! What can go wrong between a file and a mesh.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// A place in a text file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The file as the caller named it.
    pub file: String,
    /// Line, counted from 1.
    pub line: u64,
    /// Column in bytes, counted from 1.
    pub column: u64,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_printable(f, &self.file)?;
        write!(f, ":{}:{}", self.line, self.column)
    }
}

/// A fault in a text file: where it is, what should stand there and what does.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Where the offending text starts.
    pub place: Place,
    /// What was expected, as a noun phrase.
    pub expected: String,
    /// What was found: the quoted text, shortened where it is long, or a description such as `the end of the file`.
    pub found: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: expected {}, found {}", self.place, self.expected, self.found)
    }
}

/// Something in a text file that was ignored, and where the first of its kind stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// The place of the first.
    pub place: Place,
    /// What was ignored.
    pub what: Ignored,
}

/// What a reader ignores because nothing about the rest is ambiguous.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Ignored {
    /// Numbers behind those that the header of the section declares.
    Columns {
        /// What a row of the section is: `vertex`, `segment`, `hole`, `region` or `triangle`.
        noun: &'static str,
        /// How many rows have such numbers.
        rows: u64,
    },
    /// The numbers of the rows of a section: they start at 0 where those of the vertices start at 1, or the other way
    /// round.
    Numbers {
        /// What a row of the section is: `segment` or `triangle`.
        noun: &'static str,
        /// The number of the first row.
        first: u32,
        /// The number of the first vertex.
        first_vertex: u32,
    },
    /// Shapes of a drawing that were passed over.
    Shapes {
        /// What they are, in the plural.
        what: String,
        /// How many.
        count: u64,
        /// What `first` counts: `line`, `feature` or `record`.
        noun: &'static str,
        /// Where the first of them is.
        first: u64,
    },
    /// Something unusual in a drawing, as a sentence.
    Unusual(String),
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if matches!(self.what, Ignored::Shapes { .. } | Ignored::Unusual(_)) {
            // About the file as a whole.
            write_printable(f, &self.place.file)?;
            f.write_str(": ")?;
        } else {
            write!(f, "{}: ", self.place)?;
        }
        match &self.what {
            Ignored::Shapes { what, count, noun, first } => {
                let first =
                    if *count == 1 { format!("in {noun} {first}") } else { format!("the first in {noun} {first}") };
                write!(f, "{count} {what} skipped, {first}")
            }
            Ignored::Unusual(text) => f.write_str(text),
            Ignored::Columns { noun, rows: 1 } => {
                write!(f, "1 {noun} row has more columns than its header declares; they were ignored")
            }
            Ignored::Columns { noun, rows } => {
                write!(f, "{rows} {noun} rows have more columns than their header declares; they were ignored")
            }
            Ignored::Numbers { noun, first, first_vertex } => {
                write!(
                    f,
                    "{noun} rows are numbered from {first} on, vertices from {first_vertex} on; the numbers of the rows were ignored"
                )
            }
        }
    }
}

/// Why a file could not be read or written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum IoError {
    /// The text has not the shape of the format: no number, a value missing, a value too many.
    #[error("{0}")]
    Syntax(Box<Fault>),
    /// The text is well formed but its value is not allowed: out of range, not finite, out of sequence.
    #[error("{0}")]
    Value(Box<Fault>),
    /// The content of a file is at fault where lines say nothing: a record, a feature, the file as a whole.
    #[error("{}{}: {message}", Printable(Path::new(file)), Numbered(noun, *number))]
    Content {
        /// The file as the caller named it.
        file: String,
        /// What the number counts: `line`, `feature` or `record`; empty for the file as a whole.
        noun: &'static str,
        /// The number, counted from 1.
        number: u64,
        /// What is wrong.
        message: String,
    },
    /// A file does not exist.
    #[error("{}: no such file{}", Printable(path), NeededBy(needed_by.as_deref()))]
    Missing {
        /// The file looked for.
        path: PathBuf,
        /// The file that refers to it, where there is one.
        needed_by: Option<PathBuf>,
    },
    /// A file exists but cannot be read.
    #[error("cannot read {}: {source}", Printable(path))]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: io::Error,
    },
    /// The name of an input says nothing about its format, or the format does not hold what is asked for.
    #[error("cannot read {}: expected a name that ends in {expected}", Printable(path))]
    UnknownInput {
        /// The file.
        path: PathBuf,
        /// The endings that would do.
        expected: &'static str,
    },
    /// A file cannot be written, or the mesh cannot be expressed in its format.
    #[error("cannot write {}: {source}", Printable(path))]
    Unwritable {
        /// The file.
        path: PathBuf,
        /// The system's reason, or what is wrong with the mesh (kind `InvalidInput`).
        source: io::Error,
    },
    /// The name of an output says nothing about its format, or the format does not hold what is to be written.
    #[error("cannot write {}: expected a name that ends in {expected}", Printable(path))]
    UnknownOutput {
        /// The file.
        path: PathBuf,
        /// The endings that would do.
        expected: &'static str,
    },
}

impl IoError {
    /// Whether the output is to blame (exit status 4 of the program), not the input (exit status 3).
    #[must_use]
    pub fn is_output(&self) -> bool {
        matches!(self, Self::Unwritable { .. } | Self::UnknownOutput { .. })
    }

    /// The fault and its place, where the contents of a file are to blame.
    #[must_use]
    pub fn fault(&self) -> Option<&Fault> {
        match self {
            Self::Syntax(fault) | Self::Value(fault) => Some(fault),
            _ => None,
        }
    }
}

/// Shows a path without letting control characters in its name reach a terminal.
struct Printable<'a>(&'a Path);

impl fmt::Display for Printable<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_printable(f, &self.0.to_string_lossy())
    }
}

/// The place of a fault in the content of a file.
struct Numbered<'a>(&'a str, u64);

impl fmt::Display for Numbered<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self("", _) => Ok(()),
            Self("line", number) => write!(f, ":{number}"),
            Self(noun, number) => write!(f, ": {noun} {number}"),
        }
    }
}

/// The clause that names the file which refers to a missing one.
struct NeededBy<'a>(Option<&'a Path>);

impl fmt::Display for NeededBy<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(path) => write!(f, ", needed by {}", Printable(path)),
            None => Ok(()),
        }
    }
}

fn write_printable(f: &mut fmt::Formatter<'_>, text: &str) -> fmt::Result {
    for c in text.chars() {
        if c.is_control() {
            write!(f, "{}", c.escape_default())?;
        } else {
            write!(f, "{c}")?;
        }
    }
    Ok(())
}

/// Quotes offending bytes: printable, and no longer than a line of a report can hold.
pub(crate) fn quote(bytes: &[u8]) -> String {
    const LONGEST: usize = 40;
    let shown = bytes.get(..LONGEST).unwrap_or(bytes);
    let mut text = String::from("'");
    for chunk in shown.utf8_chunks() {
        for c in chunk.valid().chars() {
            if c.is_control() {
                text.extend(c.escape_default());
            } else {
                text.push(c);
            }
        }
        for byte in chunk.invalid() {
            text.push_str(&format!("\\x{byte:02x}"));
        }
    }
    text.push('\'');
    if bytes.len() > LONGEST {
        text.push_str(&format!("… ({} bytes)", bytes.len()));
    }
    text
}
