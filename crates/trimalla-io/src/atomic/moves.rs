//! A temporary file or folder, and its rename onto the target.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::UNIX_EPOCH;

use super::claim::Claim;
use super::pictures;

/// A temporary file or folder, removed unless it was renamed.
#[derive(Debug)]
pub(super) struct Temporary {
    path: PathBuf,
    /// The claim lasts as long as the temporary does; `None` where a dead process had it.
    _claim: Option<Arc<Claim>>,
}

impl Temporary {
    pub(super) fn new(path: PathBuf, claim: Option<Arc<Claim>>) -> Self {
        Self { path, _claim: claim }
    }

    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// The name under which the replaced file is kept for a moment.
    pub(super) fn aside(&self) -> PathBuf {
        self.path.with_extension("old")
    }
}

impl Drop for Temporary {
    /// Removes what is still under its two names; after the rename the first is free.
    fn drop(&mut self) {
        remove(&self.path);
        remove(&self.aside());
    }
}

/// Removes a temporary file, or a temporary folder with the pictures in it.
pub(super) fn remove(path: &Path) {
    match fs::symlink_metadata(path) {
        Ok(found) if found.is_dir() => pictures::remove(path),
        _ => drop(fs::remove_file(path)),
    }
}

/// The properties of a file that show whether it was changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stamp {
    Absent,
    Present { length: u64, nanoseconds: u128 },
}

impl Stamp {
    pub(super) fn of(path: &Path) -> Self {
        let Ok(found) = fs::symlink_metadata(path) else { return Self::Absent };
        let modified = found.modified().ok().and_then(|time| time.duration_since(UNIX_EPOCH).ok());
        Self::Present { length: found.len(), nanoseconds: modified.map_or(0, |time| time.as_nanos()) }
    }
}

/// A complete temporary and where it goes.
#[derive(Debug)]
pub(super) struct Move {
    temporary: Temporary,
    target: PathBuf,
    /// The target as it was before.
    before: Stamp,
}

impl Move {
    pub(super) fn new(temporary: Temporary, target: PathBuf) -> Self {
        let before = Stamp::of(&target);
        Self::again(temporary, target, before)
    }

    /// A move of a process that has ended.
    pub(super) fn again(temporary: Temporary, target: PathBuf, before: Stamp) -> Self {
        Self { temporary, target, before }
    }

    pub(super) fn temporary(&self) -> &Path {
        self.temporary.path()
    }

    pub(super) fn target(&self) -> &Path {
        &self.target
    }

    pub(super) fn before(&self) -> Stamp {
        self.before
    }

    /// Whether a folder moves, not a file.
    pub(super) fn is_folder(&self) -> bool {
        self.temporary().is_dir()
    }

    /// Whether the target is unchanged, or the rename is done, so that no change by others is lost.
    pub(super) fn is_still_right(&self) -> bool {
        !exists(self.temporary()) || Stamp::of(&self.target) == self.before || self.is_halfway()
    }

    /// Whether the old folder is aside and the new one not yet in its place.
    fn is_halfway(&self) -> bool {
        !exists(&self.target) && exists(&self.temporary.aside())
    }

    /// Gives the old file a second name. Not every file system can; then a rename that fails cannot be undone.
    fn keep(&self) {
        if !self.is_folder() && self.before != Stamp::Absent {
            let _ = fs::hard_link(&self.target, self.temporary.aside());
        }
    }

    /// Puts the new one in its place; nothing to do where that is done.
    ///
    /// A file takes the place of another in one step. A folder cannot: the old one is renamed first.
    fn replace(&self) -> io::Result<()> {
        if !exists(self.temporary()) {
            return Ok(());
        }
        if !self.is_folder() {
            return fs::rename(self.temporary(), &self.target);
        }
        if exists(&self.target) {
            if let Some(name) = pictures::strange_entry(&self.target)? {
                let text = format!("the folder holds something else than pictures of steps: {}", name.escape_debug());
                return Err(io::Error::new(io::ErrorKind::PermissionDenied, text));
            }
            fs::rename(&self.target, self.temporary.aside())?;
        }
        fs::rename(self.temporary(), &self.target)
    }

    /// Puts the old one back, as far as it is there.
    pub(super) fn undo(&self) {
        let is_done = !exists(self.temporary());
        if is_done && self.target.is_dir() {
            let _ = fs::rename(&self.target, self.temporary());
        }
        if exists(&self.temporary.aside()) && (is_done || self.is_halfway()) {
            let _ = fs::rename(self.temporary.aside(), &self.target);
        } else if is_done && self.before == Stamp::Absent {
            let _ = fs::rename(&self.target, self.temporary());
        }
    }
}

/// Moves everything to its target, or nothing: a rename that fails undoes those before it.
pub(super) fn carry_out(moves: &[Move]) -> Result<(), (&Move, io::Error)> {
    moves.iter().for_each(Move::keep);
    for (i, one) in moves.iter().enumerate() {
        if let Err(source) = one.replace() {
            moves[..=i].iter().rev().for_each(Move::undo);
            return Err((one, source));
        }
    }
    Ok(())
}

/// Whether there is anything under a name, be it a link to nothing.
pub(super) fn exists(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok()
}
