//! The experiment journal: outcomes so far, one JSON object a line, so that an experiment can go on after a stop.
//!
//! A line is written when a run ends. A line that a stop has torn has no end and is taken away; any other line that is
//! no outcome is an error, so that no foreign file is written to. What a line says is believed only if its digest is
//! that of the run: another drawing, recipe, angle, limit or version of the program is another run.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use trimalla_io::{IoError, read_bytes};

use crate::error::CompareError;
use crate::experiment::Task;
use crate::outcome::Outcome;
use crate::sheet::Times;

/// A journal that is open for more.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    file: File,
    known: BTreeMap<String, Outcome>,
}

impl Journal {
    /// Opens a journal and reads what is in it; it need not exist.
    ///
    /// # Errors
    /// [`CompareError::Journal`] and [`CompareError::NotAJournal`]; [`CompareError::Io`] where it is no file.
    pub fn open(path: &Path) -> Result<Self, CompareError> {
        let fail = |source: io::Error| CompareError::Journal { path: path.to_owned(), source };
        let bytes = bytes_of(path)?;
        let whole = bytes.iter().rposition(|&b| b == b'\n').map_or(0, |end| end + 1);
        let known = outcomes(&bytes[..whole], path)?;
        if !(bytes[whole..].is_empty() || is_torn(&bytes[whole..], !known.is_empty())) {
            return Err(foreign(path, known.len() + 1));
        }
        let file = OpenOptions::new().append(true).create(true).open(path).map_err(fail)?;
        file.set_len(whole as u64).map_err(fail)?;
        Ok(Self { path: path.to_owned(), file, known })
    }

    /// The outcome of a run, if it is known.
    pub(crate) fn find(&self, task: &Task<'_>) -> Option<Outcome> {
        let known = self.known.get(&task.digest());
        let needs_steps = task.experiment.times == Times::BySteps && task.contender.peer().is_none();
        known.filter(|outcome| outcome.step_times.is_some() || !needs_steps).cloned()
    }

    /// Adds the outcome of a run.
    pub(crate) fn add(&mut self, task: &Task<'_>, outcome: &Outcome) -> Result<(), CompareError> {
        let mut line = json!({
            "run": task.digest(),
            "input": task.drawing.name,
            "recipe": task.contender.label(),
            "angle": task.angle_deg,
        });
        if let (Value::Object(line), Value::Object(outcome)) = (&mut line, outcome.to_json()) {
            line.extend(outcome);
        }
        let written = self.file.write_all(format!("{line}\n").as_bytes());
        written.map_err(|source| CompareError::Journal { path: self.path.clone(), source })
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }
}

/// What is in a journal; nothing if there is no such file. What is no file cannot be one: a pipe and a device keep
/// nothing.
fn bytes_of(path: &Path) -> Result<Vec<u8>, CompareError> {
    let unreadable = |source| IoError::Unreadable { path: path.to_owned(), source };
    match fs::metadata(path) {
        Ok(found) if found.is_dir() => Err(unreadable(io::ErrorKind::IsADirectory.into()).into()),
        Ok(found) if !found.is_file() => {
            Err(unreadable(io::Error::new(io::ErrorKind::InvalidInput, "a journal must be a file")).into())
        }
        Ok(_) => Ok(read_bytes(path, LONGEST)?),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Vec::new()),
        Err(error) => Err(unreadable(error).into()),
    }
}

/// Whether what has no end of line is a line of ours that was not written to its end, and not a file of somebody
/// else's.
fn is_torn(tail: &[u8], is_journal: bool) -> bool {
    let begins_so = tail.starts_with(LINE) || LINE.starts_with(tail) || is_journal && tail.starts_with(b"{");
    match serde_json::from_slice(tail) {
        Ok(value) => entry(&value).is_some(), // All of it but the end of the line.
        Err(_) => begins_so,
    }
}

/// How a line of a journal begins: its keys are in the order of the alphabet.
const LINE: &[u8] = b"{\"angle\":";

/// No journal is longer.
const LONGEST: u64 = 1 << 32;

fn outcomes(bytes: &[u8], path: &Path) -> Result<BTreeMap<String, Outcome>, CompareError> {
    let mut known = BTreeMap::new();
    for (i, line) in bytes.split_inclusive(|&b| b == b'\n').enumerate() {
        let value: Option<Value> = serde_json::from_slice(line).ok();
        let (run, outcome) = value.as_ref().and_then(entry).ok_or_else(|| foreign(path, i + 1))?;
        known.insert(run, outcome);
    }
    Ok(known)
}

/// The digest of a run, and its outcome.
fn entry(line: &Value) -> Option<(String, Outcome)> {
    Some((line.get("run")?.as_str()?.to_owned(), Outcome::from_json(line)?))
}

fn foreign(path: &Path, line: usize) -> CompareError {
    CompareError::NotAJournal { path: path.to_owned(), line }
}
