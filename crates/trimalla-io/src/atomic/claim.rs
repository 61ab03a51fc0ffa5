//! The lock file of a group in one directory.
//!
//! It is created before the first temporary file and removed after the last one, and locked all the while. A lock ends
//! with its process, however that ends: a process that can lock the file of another knows that the other has ended.
//!
//! Two processes may look at one lock file at the same time:
//! ```text
//!   owner     creates ........... locks .... is it still there? yes: the claim holds;  no: another number
//!   cleaner              opens .. locks .... is it still there? yes: the owner is no more, remove;  no: done already
//! ```
//! Only one of them gets the lock, and whoever comes second finds that the name is gone or stands for another file.

use std::collections::BTreeSet;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};

const MOST_NAMES: usize = 1000;

/// Renames take less than a millisecond; a process that has not done them in this time is taken for dead.
const TIMEOUT: Duration = Duration::from_secs(5);
const PAUSE: Duration = Duration::from_micros(200);

/// The prefix of the names of our lock and temporary files.
pub(super) const PREFIX: &str = ".trimalla-";

/// A lock file, removed when its last temporary file is gone.
#[derive(Debug)]
pub(super) struct Claim {
    directory: PathBuf,
    /// What the names of the lock file and of its temporary files begin with.
    stem: String,
    file: File,
    temporaries: AtomicU64,
}

impl Claim {
    /// Creates and locks a file under a name that no other process or thread has.
    pub(super) fn on(directory: &Path) -> io::Result<Self> {
        static GROUPS: AtomicU64 = AtomicU64::new(0);
        for _ in 0..MOST_NAMES {
            let stem = format!("{PREFIX}{}-{}", process::id(), GROUPS.fetch_add(1, Ordering::Relaxed));
            let path = directory.join(format!("{stem}.lock"));
            match OpenOptions::new().read(true).write(true).create_new(true).open(&path) {
                Ok(file) if try_lock(&file) != Lock::Held && is_still_there(&path, &file) => {
                    return Ok(Self { directory: directory.to_owned(), stem, file, temporaries: AtomicU64::new(0) });
                }
                Ok(_) => {} // A recovering process was faster, and removes it.
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Err(no_free_name())
    }

    pub(super) fn directory(&self) -> &Path {
        &self.directory
    }

    /// Where the lock file is.
    pub(super) fn path(&self) -> PathBuf {
        self.directory.join(format!("{}.lock", self.stem))
    }

    /// The lock file itself.
    #[cfg(unix)]
    pub(super) fn file(&self) -> &File {
        &self.file
    }

    /// Creates a temporary file.
    pub(super) fn create_file(&self) -> io::Result<(PathBuf, File)> {
        self.create(|path| OpenOptions::new().write(true).create_new(true).open(path))
    }

    /// Creates a temporary folder.
    pub(super) fn create_folder(&self) -> io::Result<PathBuf> {
        Ok(self.create(|path| fs::create_dir(path))?.0)
    }

    fn create<T>(&self, create: impl Fn(&Path) -> io::Result<T>) -> io::Result<(PathBuf, T)> {
        for _ in 0..MOST_NAMES {
            let number = self.temporaries.fetch_add(1, Ordering::Relaxed);
            let path = self.directory.join(format!("{}-{number}.tmp", self.stem));
            match create(&path) {
                Ok(made) => return Ok((path, made)),
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Err(no_free_name())
    }

    /// Writes into the lock file what is to be done if this process is killed.
    pub(super) fn record(&self, text: &[u8]) -> io::Result<()> {
        (&self.file).write_all(text)?;
        self.file.sync_data()
    }
}

impl Drop for Claim {
    fn drop(&mut self) {
        let _ = fs::remove_file(self.path());
    }
}

/// Locks directories for the moment in which files appear in them, so that two groups do not mix; unlocked when the
/// returned files are dropped. A directory that cannot be locked, or whose lock is not released in time, is skipped.
pub(super) fn lock_directories(directories: impl IntoIterator<Item = PathBuf>) -> Vec<File> {
    let in_order: BTreeSet<PathBuf> = directories.into_iter().collect(); // All processes use one order, so that none waits in a circle.
    let start = Instant::now();
    let mut locked = Vec::new();
    for directory in in_order {
        let Ok(file) = File::open(&directory) else { continue };
        while try_lock(&file) == Lock::Held && start.elapsed() < TIMEOUT {
            thread::sleep(PAUSE);
        }
        locked.push(file);
    }
    locked
}

fn no_free_name() -> io::Error {
    io::Error::new(io::ErrorKind::AlreadyExists, "no free name for a temporary file")
}

/// What came of trying to lock a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Lock {
    Taken,
    /// Another process or thread holds the lock.
    Held,
    /// The file system has no locks: who is alive cannot be known here.
    Unknown,
}

/// Tries to lock a file.
#[cfg(any(unix, windows))]
pub(super) fn try_lock(file: &File) -> Lock {
    match fs4::FileExt::try_lock(file) {
        Ok(()) => Lock::Taken,
        Err(fs4::TryLockError::WouldBlock) => Lock::Held,
        Err(fs4::TryLockError::Error(_)) => Lock::Unknown,
    }
}

#[cfg(not(any(unix, windows)))]
pub(super) fn try_lock(_: &File) -> Lock {
    Lock::Unknown
}

/// Whether a name still stands for a file that was opened under it.
#[cfg(any(unix, windows))]
pub(super) fn is_still_there(path: &Path, file: &File) -> bool {
    let opened = file.try_clone().and_then(same_file::Handle::from_file);
    opened.is_ok_and(|opened| same_file::Handle::from_path(path).is_ok_and(|found| found == opened))
}

#[cfg(not(any(unix, windows)))]
pub(super) fn is_still_there(path: &Path, _: &File) -> bool {
    path.exists()
}
