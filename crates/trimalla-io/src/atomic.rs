//! Files written whole or not at all.
//!
//! Each file of a group is first written to a temporary file in the directory of its target, flushed and synced. Only
//! when all of them are complete are they renamed onto their targets. Until then every error, and a panic too, removes the
//! temporary files and leaves the old files as they were. A rename that fails after another of the same group has succeeded,
//! or a machine that stops between two renames, leaves each file whole, though some of them old and some new.
//!
//! Symbolic links are followed, so the link stays and the file behind it is replaced. The permissions of a replaced
//! file are kept, and one that is marked read-only is not replaced. What is no regular file (a pipe, a device, `-` for standard
//! output) is written directly.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::error::IoError;

const BUFFER: usize = 1 << 16;
const MOST_LINKS: usize = 40;
const MOST_NAMES: usize = 1000;

/// Files that appear together or not at all.
#[derive(Debug, Default)]
pub(crate) struct Group {
    staged: Vec<Staged>,
}

/// A complete temporary file and where it shall go.
#[derive(Debug)]
struct Staged {
    temporary: PathBuf,
    target: PathBuf,
}

impl Drop for Staged {
    /// Removes what has not been renamed; after the rename there is nothing under this name.
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.temporary);
    }
}

/// Where output goes.
enum Destination {
    Stdout,
    Special,
    File(PathBuf),
}

impl Group {
    /// Writes one file of the group next to its target.
    pub(crate) fn add(
        &mut self,
        path: &Path,
        write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), IoError> {
        self.try_add(path, write).map_err(|source| unwritable(path, source))
    }

    fn try_add(&mut self, path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
        match destination(path)? {
            Destination::Stdout => write_through(io::stdout().lock(), write),
            Destination::Special => write_through(OpenOptions::new().write(true).open(path)?, write),
            Destination::File(target) => {
                self.staged.push(stage(target, write)?);
                Ok(())
            }
        }
    }

    /// Moves all files to their targets.
    pub(crate) fn commit(self) -> Result<(), IoError> {
        for staged in &self.staged {
            fs::rename(&staged.temporary, &staged.target).map_err(|source| unwritable(&staged.target, source))?;
            sync_directory(&staged.target);
        }
        Ok(())
    }
}

fn unwritable(path: &Path, source: io::Error) -> IoError {
    IoError::Unwritable { path: path.to_owned(), source }
}

/// Whether a path is written directly, and which file is behind it if not.
fn destination(path: &Path) -> io::Result<Destination> {
    if path == Path::new("-") || path == Path::new("/dev/stdout") {
        return Ok(Destination::Stdout);
    }
    match fs::metadata(path) {
        Ok(found) if found.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
        Ok(found) if !found.is_file() => Ok(Destination::Special),
        Ok(found) if found.permissions().readonly() => {
            Err(io::Error::new(io::ErrorKind::PermissionDenied, "the file is read-only"))
        }
        _ => follow_links(path).map(Destination::File),
    }
}

/// The file behind a chain of symbolic links, whether it exists or not.
fn follow_links(path: &Path) -> io::Result<PathBuf> {
    let mut target = path.to_owned();
    for _ in 0..MOST_LINKS {
        match fs::symlink_metadata(&target) {
            Ok(found) if found.file_type().is_symlink() => {
                let next = fs::read_link(&target)?;
                target = directory_of(&target).join(next);
            }
            _ => return Ok(target),
        }
    }
    Err(io::Error::other("too many symbolic links"))
}

fn directory_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    }
}

/// Writes, flushes and syncs a temporary file in the directory of `target`.
fn stage(target: PathBuf, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<Staged> {
    if target.file_name().is_none() {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "the path names no file"));
    }
    let (temporary, file) = create_temporary(directory_of(&target))?;
    let staged = Staged { temporary, target };
    let mut buffer = BufWriter::with_capacity(BUFFER, file);
    write(&mut buffer)?;
    let file = buffer.into_inner().map_err(io::IntoInnerError::into_error)?;
    if let Ok(old) = fs::metadata(&staged.target) {
        file.set_permissions(old.permissions())?;
    }
    file.sync_all()?;
    Ok(staged)
}

/// Creates a file under a name that no other file, thread or process has.
fn create_temporary(directory: &Path) -> io::Result<(PathBuf, File)> {
    static COUNTER: AtomicU64 = AtomicU64::new(0);
    for _ in 0..MOST_NAMES {
        let number = COUNTER.fetch_add(1, Ordering::Relaxed);
        let path = directory.join(format!(".trimalla-{}-{number}.tmp", process::id()));
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Ok(file) => return Ok((path, file)),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
    Err(io::Error::new(io::ErrorKind::AlreadyExists, "no free name for a temporary file"))
}

fn write_through(out: impl Write, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let mut buffer = BufWriter::with_capacity(BUFFER, out);
    write(&mut buffer)?;
    buffer.flush()
}

/// Makes a rename last. Not every system can sync a directory, and the file is whole either way, so failure is no error.
fn sync_directory(target: &Path) {
    if let Ok(directory) = File::open(directory_of(target)) {
        let _ = directory.sync_all();
    }
}
