//! The experiment journal: outcomes so far, one JSON object a line, so that an experiment can go on after a stop.
//!
//! A line is written when a run ends. A line that a stop has torn has no end and is taken away; any other line that is no outcome
//! is an error, so that no foreign file is written to. What a line says is believed only if its digest is that of the run: another
//! drawing, recipe, angle, limit or version of the program is another run.

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io::{ErrorKind, Read as _, Write as _};
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

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
    /// [`CompareError::Journal`] and [`CompareError::NotAJournal`].
    pub fn open(path: &Path) -> Result<Self, CompareError> {
        let fail = |source: std::io::Error| CompareError::Journal { path: path.to_owned(), source };
        if path.is_dir() {
            return Err(fail(ErrorKind::IsADirectory.into()));
        }
        let mut file = OpenOptions::new().read(true).append(true).create(true).open(path).map_err(fail)?;
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(fail)?;
        let whole = bytes.iter().rposition(|&b| b == b'\n').map_or(0, |end| end + 1);
        let known = outcomes(&bytes[..whole], path)?;
        if !bytes[whole..].is_empty() && !bytes[whole..].starts_with(b"{") {
            return Err(foreign(path, known.len() + 1));
        }
        file.set_len(whole as u64).map_err(fail)?;
        Ok(Self { path: path.to_owned(), file, known })
    }

    /// What came of a run, if it is known.
    pub(crate) fn find(&self, task: &Task<'_>) -> Option<Outcome> {
        let known = self.known.get(&task.digest());
        known.filter(|outcome| outcome.step_times.is_some() || task.experiment.times != Times::BySteps).cloned()
    }

    /// Adds what came of a run.
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

fn outcomes(bytes: &[u8], path: &Path) -> Result<BTreeMap<String, Outcome>, CompareError> {
    let mut known = BTreeMap::new();
    for (i, line) in bytes.split_inclusive(|&b| b == b'\n').enumerate() {
        let value: Option<Value> = serde_json::from_slice(line).ok();
        let entry = value.as_ref().and_then(|v| Some((v.get("run")?.as_str()?.to_owned(), Outcome::from_json(v)?)));
        let (run, outcome) = entry.ok_or_else(|| foreign(path, i + 1))?;
        known.insert(run, outcome);
    }
    Ok(known)
}

fn foreign(path: &Path, line: usize) -> CompareError {
    CompareError::NotAJournal { path: path.to_owned(), line }
}
