//! Standard output and standard error.
//!
//! A reader that closes its pipe early (`trimalla list | head -1`) is no failure, and nothing panics. A full
//! disk behind standard output is a failure.

use std::fmt::Display;
use std::io::{self, ErrorKind, Write};
use std::path::Path;

use crate::exit::{Failure, Status};

/// Where a report goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stream {
    Stdout,
    /// Where a mesh occupies standard output.
    Stderr,
    /// `--quiet` suppresses the report.
    Nowhere,
}

/// Writes text to a stream.
pub(crate) fn write(stream: Stream, text: &str) -> Result<(), Failure> {
    let written = match stream {
        Stream::Stdout => write_all(io::stdout().lock(), text),
        Stream::Stderr => write_all(io::stderr().lock(), text),
        Stream::Nowhere => Ok(()),
    };
    match written {
        Err(e) if e.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::new(Status::Unwritable, format!("cannot write the report: {e}")))
        }
        _ => Ok(()),
    }
}

/// Writes text to standard output.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    write(Stream::Stdout, text)
}

/// Writes a line such as `warning: …` to standard error; ignores a failure, which could not be reported.
pub(crate) fn note(kind: &str, message: &str) {
    let _ = writeln!(io::stderr(), "{kind}: {message}");
}

/// Prints the messages and hints of a failure, and returns the status to end with.
pub(crate) fn report(failure: Failure) -> Status {
    let (messages, hints, status) = failure.into_parts();
    messages.iter().for_each(|message| note("error", message));
    hints.iter().for_each(|hint| note("hint", hint));
    status
}

/// Writes text to standard error as it is.
pub(crate) fn note_plain(text: &str) {
    let _ = write_all(io::stderr().lock(), text);
}

/// Writes a line that belongs to the note before it.
pub(crate) fn note_more(line: impl Display) {
    let _ = writeln!(io::stderr(), "  {line}");
}

fn write_all(mut out: impl Write, text: &str) -> io::Result<()> {
    out.write_all(text.as_bytes())?;
    out.flush()
}

/// A path for messages: control characters in a name shall not reach a terminal.
pub(crate) fn shown(path: &Path) -> String {
    let mut text = String::new();
    for c in path.to_string_lossy().chars() {
        if c.is_control() {
            text.extend(c.escape_default());
        } else {
            text.push(c);
        }
    }
    text
}
