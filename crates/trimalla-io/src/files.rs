//! Where files are: on the disk, or in memory.
//!
//! A page in a browser has no disk, and a test needs none. [`Memory`] stands for one there: a table of names and
//! contents. Names are compared as text, but for `.` in them. There are no folders, links, pipes or devices, and `-` is
//! a name as any other.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use trimalla::drawing::{IndexedMesh, Pslg};

use crate::atomic::recover;
use crate::bytes::{self, Content};
use crate::drawings::DrawingOptions;
use crate::error::IoError;
use crate::read;
use crate::write::Outputs;

/// Where files are read from and written to.
///
/// # Examples
/// ```
/// use trimalla_io::{Files, Memory, WriteOptions};
///
/// let memory = Memory::default();
/// memory.put("three.node", "3 2 0 0\n1 0 0\n2 4 0\n3 0 3\n");
/// let files = Files::Memory(memory.clone());
/// let drawing = files.read_pslg("three.node")?;
/// let mut outputs = files.outputs("three.poly");
/// outputs.add_pslg("three.poly", &drawing, &WriteOptions::default())?;
/// outputs.commit()?;
/// assert_eq!(memory.names().len(), 2);
/// # Ok::<(), trimalla_io::IoError>(())
/// ```
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub enum Files {
    /// On the disk.
    #[default]
    Disk,
    /// In memory.
    Memory(Memory),
}

impl Files {
    /// Reads a drawing, as the function [`read_pslg`](crate::read_pslg) does from the disk.
    ///
    /// # Errors
    /// Every [`IoError`] that is not about output.
    pub fn read_pslg(&self, path: impl AsRef<Path>) -> Result<Pslg, IoError> {
        read::pslg(self, path.as_ref(), &DrawingOptions::default()).map(|drawing| drawing.value)
    }

    /// Reads a mesh, as the function [`read_mesh`](crate::read_mesh) does from the disk.
    ///
    /// # Errors
    /// Every [`IoError`] that is not about output.
    pub fn read_mesh(&self, path: impl AsRef<Path>) -> Result<IndexedMesh, IoError> {
        read::mesh(self, path.as_ref()).map(|mesh| mesh.value)
    }

    /// Reads a text file of at most `longest` bytes, as the function [`read_bytes`](crate::read_bytes) does from the
    /// disk.
    ///
    /// # Errors
    /// [`IoError::Missing`], and [`IoError::Unreadable`] for what is longer or has a NUL byte.
    pub fn read_bytes(&self, path: impl AsRef<Path>, longest: u64) -> Result<Vec<u8>, IoError> {
        bytes::read_text(self, path.as_ref(), longest)
    }

    /// The bytes behind a path.
    pub(crate) fn read(&self, path: &Path, longest: u64, content: Content) -> io::Result<Vec<u8>> {
        match self {
            Self::Disk => bytes::of_disk(path, longest, content),
            Self::Memory(memory) => memory.read(path, longest),
        }
    }

    /// Whether something has this name: a file, or a link that leads nowhere.
    #[must_use]
    pub fn is_there(&self, path: &Path) -> bool {
        match self {
            Self::Disk => fs::symlink_metadata(path).is_ok(),
            Self::Memory(memory) => memory.table().contains_key(&plain(path)),
        }
    }

    /// Whether two names stand for the same file.
    #[must_use]
    pub fn is_same(&self, a: &Path, b: &Path) -> bool {
        a == b
            || match self {
                Self::Disk => is_same_on_disk(a, b),
                Self::Memory(_) => plain(a) == plain(b),
            }
    }

    /// Outputs that appear together or not at all, of which `path` is one. What a killed process has left in its folder
    /// is put in its place or removed first.
    pub fn outputs(&self, path: impl AsRef<Path>) -> Outputs {
        match self {
            Self::Disk => {
                let folder = path.as_ref().parent().filter(|folder| !folder.as_os_str().is_empty());
                recover(folder.unwrap_or(Path::new(".")));
                Outputs::default()
            }
            Self::Memory(memory) => Outputs::in_memory(memory.clone()),
        }
    }
}

#[cfg(any(unix, windows))]
fn is_same_on_disk(a: &Path, b: &Path) -> bool {
    same_file::is_same_file(a, b).unwrap_or(false)
}

#[cfg(not(any(unix, windows)))]
fn is_same_on_disk(_: &Path, _: &Path) -> bool {
    false
}

/// Files in memory; a clone stands for the same files.
#[derive(Clone, Debug, Default)]
pub struct Memory {
    files: Arc<Mutex<BTreeMap<PathBuf, Arc<[u8]>>>>,
}

impl Memory {
    /// Adds a file, or replaces it.
    pub fn put(&self, name: impl AsRef<Path>, content: impl AsRef<[u8]>) {
        self.table().insert(plain(name.as_ref()), content.as_ref().into());
    }

    /// The content of a file.
    #[must_use]
    pub fn get(&self, name: impl AsRef<Path>) -> Option<Arc<[u8]>> {
        self.table().get(&plain(name.as_ref())).cloned()
    }

    /// The names of all files, ascending.
    #[must_use]
    pub fn names(&self) -> Vec<PathBuf> {
        self.table().keys().cloned().collect()
    }

    /// Adds files, or replaces them, all at once.
    pub(crate) fn put_all(&self, files: Vec<(PathBuf, Vec<u8>)>) {
        self.table().extend(files.into_iter().map(|(name, content)| (plain(&name), content.into())));
    }

    fn read(&self, path: &Path, longest: u64) -> io::Result<Vec<u8>> {
        let content = self.get(path).ok_or(io::ErrorKind::NotFound)?;
        if content.len() as u64 > longest {
            return Err(bytes::too_long(longest));
        }
        Ok(content.to_vec())
    }

    fn table(&self) -> MutexGuard<'_, BTreeMap<PathBuf, Arc<[u8]>>> {
        // Each change is one call of the table, so that a panic elsewhere leaves it whole.
        self.files.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A name without `.` in it.
fn plain(path: &Path) -> PathBuf {
    path.components().filter(|part| !matches!(part, Component::CurDir)).collect()
}
