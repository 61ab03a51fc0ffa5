//! A folder of numbered pictures that is being written.

use std::fs::{self, File};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::claim::Claim;
use super::moves::{Move, Temporary};
use super::place::{directory_of, follow_links};
use super::{sync_directory, unwritable};
use crate::error::IoError;

/// A folder of pictures, `000001.svg` and so on, that appears as a whole when the [`Outputs`](crate::Outputs) that it
/// is [handed back](crate::Outputs::end_pictures) to are committed; dropped before, it leaves nothing behind.
///
/// A folder that exists is replaced by it, and only if it is empty or holds nothing but such pictures. Pictures are not
/// synced one by one, as a thousand of them would wait seconds for the disk: after a power failure some may be empty.
#[derive(Debug)]
pub struct Pictures {
    /// As the caller named it.
    path: PathBuf,
    temporary: Temporary,
    target: PathBuf,
}

impl Pictures {
    pub(super) fn new(path: &Path, claim: Arc<Claim>, target: PathBuf) -> io::Result<Self> {
        let temporary = Temporary::new(claim.create_folder()?, Some(claim));
        Ok(Self { path: path.to_owned(), temporary, target })
    }

    /// Finds out whether pictures may go to a folder, before any are made.
    ///
    /// # Errors
    /// [`IoError::Unwritable`]: it is no folder, holds anything else than such pictures, may not be written, has the
    /// process in it, or the folder around it does not exist.
    pub fn check(path: impl AsRef<Path>) -> Result<(), IoError> {
        let path = path.as_ref();
        let around = |target: PathBuf| match directory_of(&target).is_dir() {
            true => Ok(()),
            false => Err(io::Error::new(io::ErrorKind::NotFound, "there is no such directory")),
        };
        target(path).and_then(around).map_err(|source| unwritable(path, source))
    }

    /// The folder as the caller named it.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes the picture with this number.
    ///
    /// # Errors
    /// Those of the file system; a number that was there already is one.
    pub fn add(&mut self, number: u64, svg: &str) -> io::Result<()> {
        let file = self.temporary.path().join(format!("{number:06}.svg"));
        File::create_new(&file)?.write_all(svg.as_bytes())
    }

    /// Syncs the folder, and gives it the permissions of the one that it replaces.
    pub(super) fn finish(self) -> io::Result<Move> {
        if let Ok(old) = fs::metadata(&self.target) {
            fs::set_permissions(self.temporary.path(), old.permissions())?;
        }
        sync_directory(self.temporary.path());
        Ok(Move::new(self.temporary, self.target))
    }
}

/// The folder behind a path, if pictures may replace it.
pub(super) fn target(path: &Path) -> io::Result<PathBuf> {
    let denied = |text: String| Err(io::Error::new(io::ErrorKind::PermissionDenied, text));
    let target = match fs::canonicalize(path) {
        Ok(found) => found,
        Err(_) => follow_links(path)?,
    };
    match fs::metadata(&target) {
        Ok(found) if !found.is_dir() => return Err(io::ErrorKind::NotADirectory.into()),
        Ok(found) if found.permissions().readonly() => return denied("the folder is read-only".to_owned()),
        Ok(_) => {}
        Err(_) => return Ok(target),
    }
    if fs::canonicalize(".").is_ok_and(|here| here.starts_with(&target)) {
        return denied("the folder is the current one, or around it".to_owned());
    }
    match strange_entry(&target)? {
        Some(name) => {
            denied(format!("the folder holds something else than pictures of steps: {}", name.escape_debug()))
        }
        None => Ok(target),
    }
}

/// The first entry of a folder that is no picture of ours.
pub(super) fn strange_entry(folder: &Path) -> io::Result<Option<String>> {
    let mut strange: Vec<String> = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if !(is_picture(&name) && entry.file_type()?.is_file()) {
            strange.push(name);
        }
    }
    Ok(strange.into_iter().min())
}

/// Whether a file is called like a picture of ours.
fn is_picture(name: &str) -> bool {
    let digits = name.strip_suffix(".svg").unwrap_or_default();
    digits.len() >= 6 && digits.bytes().all(|digit| digit.is_ascii_digit())
}

/// Removes a folder that was replaced, but no file that is no picture.
pub(super) fn remove(folder: &Path) {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    for entry in entries.filter(|entry| is_picture(&entry.file_name().to_string_lossy())) {
        let _ = fs::remove_file(entry.path());
    }
    let _ = fs::remove_dir(folder);
}
