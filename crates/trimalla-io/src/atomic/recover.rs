//! Completes or removes what killed processes have left in a directory.
//!
//! A lock file that can be locked has no owner any more. Its record decides:
//! ```text
//!   none, or without an end    no rename had begun     the temporaries are removed: all files are old
//!   head                       renames had begun       those left are done: all files are new
//!   member                     the head decides        the record of the group is settled first, in its directory
//! ```
//! A record is followed only if it belongs to whoever runs this process, as it says which files are replaced, and only
//! if no target has changed since.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::Read as _;
use std::path::{Path, PathBuf};

use super::claim::{Claim, Lock, PREFIX, is_still_there, lock_directories, try_lock};
use super::moves::{Move, carry_out, exists, remove};
use super::place::directory_of;
use super::record::Record;

/// No record of a group is longer.
const LONGEST: u64 = 1 << 26;

/// The files of killed processes that were completed or removed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Recovered {
    /// Files of groups that were being put in their places, and are whole and new now.
    pub completed: Vec<PathBuf>,
    /// Temporary files that were removed.
    pub removed: Vec<PathBuf>,
}

/// Finds what processes that were killed while writing have left in a directory: completes the groups that they were
/// putting in their places, and removes their temporary files. What belongs to a process that lives is left alone.
///
/// # Guarantees
/// Two processes may do this at the same time. A target that was changed after the kill is not replaced. What another
/// user's process has left stays, except temporary files without a lock file. Where the file system has no locks,
/// nothing is done, as nobody can tell who lives.
///
/// # Examples
/// ```
/// let left = trimalla_io::recover(std::env::temp_dir());
/// for file in left.completed {
///     eprintln!("{} is new now", file.display());
/// }
/// ```
pub fn recover(directory: impl AsRef<Path>) -> Recovered {
    let mut recovered = Recovered::default();
    let Ok(directory) = directory.as_ref().canonicalize() else { return recovered };
    let names = our_names(&directory);
    let locks: Vec<&String> = names.iter().filter(|name| name.ends_with(".lock")).collect();
    if !locks.is_empty() {
        if let Ok(own) = Claim::on(&directory) {
            locks.iter().for_each(|lock| recovered.settle(&directory.join(lock), &own));
        }
    }
    for name in our_names(&directory).iter().filter(|name| !name.ends_with(".lock")) {
        let lock = name.rsplit_once('-').map(|(stem, _)| directory.join(format!("{stem}.lock")));
        if lock.is_some_and(|lock| !exists(&lock)) {
            recovered.remove(directory.join(name)); // A temporary file goes before its lock file does.
        }
    }
    recovered
}

/// The names in a directory that groups give, in order.
fn our_names(directory: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(directory).into_iter().flatten().flatten();
    entries.filter_map(|entry| entry.file_name().into_string().ok()).filter(|name| is_ours(name)).collect()
}

/// Whether a name is one of `.trimalla-77-0.lock`, `.trimalla-77-0-1.tmp` and `.trimalla-77-0-1.old`.
fn is_ours(name: &str) -> bool {
    let Some((numbers, ending)) = name.strip_prefix(PREFIX).and_then(|rest| rest.rsplit_once('.')) else {
        return false;
    };
    let are_numbers = numbers.split('-').all(|n| !n.is_empty() && n.bytes().all(|digit| digit.is_ascii_digit()));
    are_numbers
        && match ending {
            "lock" => numbers.split('-').count() == 2,
            "tmp" | "old" => numbers.split('-').count() == 3,
            _ => false,
        }
}

/// A lock file whose owner has ended; locked, so that no other process settles it meanwhile.
struct Orphan {
    path: PathBuf,
    file: File,
}

impl Orphan {
    /// Locks the file, if no process holds the lock.
    fn take(path: &Path) -> Option<Self> {
        if !fs::symlink_metadata(path).is_ok_and(|found| found.is_file()) {
            return None;
        }
        let file = File::open(path).ok()?;
        let is_taken = try_lock(&file) == Lock::Taken && is_still_there(path, &file);
        is_taken.then(|| Self { path: path.to_owned(), file })
    }

    fn directory(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new("."))
    }

    fn record(&self) -> Record {
        let mut bytes = Vec::new();
        match (&self.file).take(LONGEST).read_to_end(&mut bytes) {
            Ok(_) => Record::parse(&bytes, self.directory()),
            Err(_) => Record::Nothing,
        }
    }

    /// Whether it belongs to whoever owns the other file.
    #[cfg(unix)]
    fn has_owner_of(&self, own: &Claim) -> bool {
        use std::os::unix::fs::MetadataExt as _;
        let owner = |file: &File| file.metadata().map(|found| found.uid()).ok();
        owner(&self.file).is_some_and(|uid| owner(own.file()) == Some(uid))
    }

    #[cfg(not(unix))]
    fn has_owner_of(&self, _: &Claim) -> bool {
        true
    }
}

impl Recovered {
    /// Settles the group of a lock file, if its owner is no more.
    fn settle(&mut self, lock: &Path, own: &Claim) {
        let Some(orphan) = Orphan::take(lock).filter(|orphan| orphan.has_owner_of(own)) else { return };
        match orphan.record() {
            Record::Nothing => {}
            Record::Head { others, moves } => return self.settle_group(&orphan, &others, moves, own),
            Record::Member { head } => {
                if let Some(head) = Orphan::take(&head).filter(|head| head.has_owner_of(own)) {
                    if let Record::Head { others, moves } = head.record() {
                        self.complete(moves);
                        drop(orphan);
                        return self.clear(&head, &others, own);
                    }
                } else if exists(&head) {
                    return; // Somebody else settles the group.
                }
            }
        }
        self.sweep(&orphan);
    }

    /// Completes a group and clears all its directories.
    fn settle_group(&mut self, head: &Orphan, others: &[PathBuf], moves: Vec<Move>, own: &Claim) {
        self.complete(moves);
        self.clear(head, others, own);
    }

    /// Does what is left to do of a group; or nothing, if a target has changed since.
    fn complete(&mut self, moves: Vec<Move>) {
        let targets = moves.iter().map(|one| one.target().to_owned());
        let _locked = lock_directories(moves.iter().map(|one| directory_of(one.target()).to_owned()));
        if moves.iter().all(Move::is_still_right) && carry_out(&moves).is_ok() {
            self.completed.extend(targets);
        } else {
            // A folder may be aside: it goes back.
            moves.iter().filter(|one| exists(one.temporary())).for_each(Move::undo);
        }
    }

    /// Removes what a settled group has left, the head's lock file last: as long as it is there, the others are not
    /// settled alone.
    fn clear(&mut self, head: &Orphan, others: &[PathBuf], own: &Claim) {
        let others = others.iter().filter_map(|other| Orphan::take(other));
        others.filter(|other| other.has_owner_of(own)).for_each(|other| self.sweep(&other));
        self.sweep(head);
    }

    /// Removes the temporary files of a lock file, and then itself.
    fn sweep(&mut self, orphan: &Orphan) {
        let stem = orphan.path.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
        let directory = orphan.directory().to_owned();
        for name in our_names(&directory) {
            if name.rsplit_once('-').is_some_and(|(other, _)| other == stem) && !name.ends_with(".lock") {
                self.remove(directory.join(name));
            }
        }
        let _ = fs::remove_file(&orphan.path);
    }

    fn remove(&mut self, path: PathBuf) {
        remove(&path);
        self.removed.extend((!exists(&path)).then_some(path));
    }
}
