//! Groups of files that appear together or not at all.
//!
//! ```text
//!   stage     .trimalla-77-0.lock     held while the group is at work; says that .trimalla-77-0-* belong to a live process
//!             .trimalla-77-0-0.tmp    the new m.node, complete and synced
//!             .trimalla-77-0-1.tmp    the new m.ele, complete and synced
//!   record    .trimalla-77-0.lock     now lists which temporary goes where: from here on the group will be whole
//!   keep      .trimalla-77-0-0.old    a second name of the old m.node, in case a rename fails
//!   rename    .tmp onto m.node, .tmp onto m.ele, one right after the other
//!   clear     .old and .lock are removed
//! ```
//! Each file of a group is written to a temporary file in the directory of its target, flushed and synced. Only when
//! all of them are complete are they renamed onto their targets.
//!
//! * An error or a panic before the renames removes the temporary files and leaves the old files as they were.
//! * A rename that fails undoes those before it, where the file system has hard links or there was no old file.
//! * A process that is killed leaves its temporary files; [`recover()`] finds them, because no process holds their lock
//!   any more. A group without a record is removed. A group with a record is completed, unless somebody has changed a
//!   target since.
//! * A machine that stops leaves each file whole, but not each of a folder of pictures. Of a group, some files may be
//!   old and others new until [`recover()`].
//!
//! Two processes that write the same files at the same time do not mix: whose renames come last has written them all.
//!
//! Symbolic links are followed, so the link stays and the file behind it is replaced. The permissions of a replaced
//! file are kept, and a file that may not be written is not replaced. What is no regular file (a pipe, a device, `-`
//! for standard output) is written directly. A folder of [`Pictures`] is replaced as a whole, and only if it holds
//! nothing else.

mod claim;
mod draft;
mod moves;
mod pictures;
mod place;
mod record;
mod recover;

use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::error::IoError;

use claim::{Claim, lock_directories};
use moves::{Move, carry_out};
use place::{Destination, destination, directory_of};

pub use draft::Draft;
pub use pictures::Pictures;
pub use recover::{Recovered, recover};

/// Files that appear together or not at all.
#[derive(Debug, Default)]
pub(crate) struct Group {
    moves: Vec<Move>,
    /// The claims on the directories of the files.
    claims: Vec<Arc<Claim>>,
}

impl Group {
    /// Writes one file of the group next to its target.
    pub(crate) fn add(
        &mut self,
        path: &Path,
        write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), IoError> {
        let mut draft = self.begin(path)?;
        write(&mut draft).map_err(|source| unwritable(path, source))?;
        self.end(draft)
    }

    /// Begins one file of the group.
    pub(crate) fn begin(&mut self, path: &Path) -> Result<Draft, IoError> {
        self.try_begin(path).map_err(|source| unwritable(path, source))
    }

    fn try_begin(&mut self, path: &Path) -> io::Result<Draft> {
        match destination(path)? {
            Destination::Stdout => Ok(Draft::stdout(path)),
            Destination::Special => Draft::special(path),
            Destination::File(target) => {
                let (claim, target) = self.claim(&target)?;
                Draft::file(path, claim, target)
            }
        }
    }

    /// Takes a file that is complete.
    pub(crate) fn end(&mut self, draft: Draft) -> Result<(), IoError> {
        let path = draft.path().to_owned();
        let finished = draft.finish().map_err(|source| unwritable(&path, source))?;
        self.moves.extend(finished);
        Ok(())
    }

    /// Begins a folder of pictures.
    pub(crate) fn begin_pictures(&mut self, path: &Path) -> Result<Pictures, IoError> {
        let claimed = pictures::target(path).and_then(|target| self.claim(&target));
        let begun = claimed.and_then(|(claim, target)| Pictures::new(path, claim, target));
        begun.map_err(|source| unwritable(path, source))
    }

    /// Takes a folder that is complete.
    pub(crate) fn end_pictures(&mut self, pictures: Pictures) -> Result<(), IoError> {
        let path = pictures.path().to_owned();
        self.moves.push(pictures.finish().map_err(|source| unwritable(&path, source))?);
        Ok(())
    }

    /// Moves everything to its target.
    pub(crate) fn commit(self) -> Result<(), IoError> {
        if let Err(source) = self.record() {
            let target = self.moves.first().map_or(Path::new(""), Move::target);
            return Err(unwritable(target, source));
        }
        let _locked = lock_directories(self.claims.iter().map(|claim| claim.directory().to_owned()));
        carry_out(&self.moves).map_err(|(failed, source)| unwritable(failed.target(), source))?;
        for claim in &self.claims {
            sync_directory(claim.directory());
        }
        Ok(())
    }

    /// Writes the list of renames into the lock files, so that a group is completed even if this process is killed
    /// between two renames. The lock file written last decides: it holds the list, and the others name it.
    fn record(&self) -> io::Result<()> {
        let is_atomic = self.moves.len() < 2 && self.moves.iter().all(|m| !m.is_folder());
        let Some((head, others)) = self.claims.split_first().filter(|_| !is_atomic) else { return Ok(()) };
        for other in others {
            other.record(&record::member(head))?;
        }
        head.record(&record::head(head, others, &self.moves))
    }

    /// The claim on the directory of a target, and the absolute name of the target.
    fn claim(&mut self, target: &Path) -> io::Result<(Arc<Claim>, PathBuf)> {
        let no_file = || io::Error::new(io::ErrorKind::InvalidInput, "the path names no file");
        let name = target.file_name().ok_or_else(no_file)?;
        let directory = directory_of(target).canonicalize()?;
        let target = directory.join(name);
        if let Some(claim) = self.claims.iter().find(|claim| claim.directory() == directory) {
            return Ok((Arc::clone(claim), target));
        }
        let claim = Arc::new(Claim::on(&directory)?);
        self.claims.push(Arc::clone(&claim));
        Ok((claim, target))
    }
}

fn unwritable(path: &Path, source: io::Error) -> IoError {
    IoError::Unwritable { path: path.to_owned(), source }
}

/// Syncs a directory, so that renames survive a power failure. Not every system can, and the files are whole either
/// way, so a failure is ignored.
fn sync_directory(directory: &Path) {
    if let Ok(directory) = File::open(directory) {
        let _ = directory.sync_all();
    }
}

#[cfg(test)]
mod tests;
