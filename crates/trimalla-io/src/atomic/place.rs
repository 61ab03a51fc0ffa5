//! The file behind a path, and whether it may be replaced.

use std::fs::{self, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

const MOST_LINKS: usize = 40;

/// Where output goes.
pub(super) enum Destination {
    Stdout,
    /// What is no regular file, and is written directly.
    Special,
    /// The file to be replaced, behind all symbolic links.
    File(PathBuf),
}

/// Whether a path is written directly, and which file is behind it if not.
pub(super) fn destination(path: &Path) -> io::Result<Destination> {
    if path == Path::new("-") || path == Path::new("/dev/stdout") {
        return Ok(Destination::Stdout);
    }
    match fs::metadata(path) {
        Ok(found) if found.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
        Ok(found) if !found.is_file() => Ok(Destination::Special),
        Ok(found) if found.permissions().readonly() => {
            Err(io::Error::new(io::ErrorKind::PermissionDenied, "the file is read-only"))
        }
        Ok(_) => {
            OpenOptions::new().write(true).open(path)?; // A rename asks for no permission on the old file.
            follow_links(path).map(Destination::File)
        }
        Err(_) => follow_links(path).map(Destination::File),
    }
}

/// The file behind a chain of symbolic links, whether it exists or not.
pub(super) fn follow_links(path: &Path) -> io::Result<PathBuf> {
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

/// The directory that a path lies in.
pub(super) fn directory_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    }
}
