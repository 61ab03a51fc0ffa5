//! A file that is being written.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, IntoInnerError, Stdout, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::claim::Claim;
use super::moves::{Move, Temporary};

const BUFFER: usize = 1 << 16;

/// A file that is written piece by piece. It appears when the [`Outputs`](crate::Outputs) that it is
/// [handed back](crate::Outputs::end) to are committed; dropped before, it leaves nothing behind.
///
/// A pipe, a device and standard output are written directly, and what they were given cannot be taken back.
#[derive(Debug)]
pub struct Draft {
    /// As the caller named it.
    path: PathBuf,
    buffer: BufWriter<Sink>,
    /// The temporary file and its target; none if the file is written directly.
    staged: Option<(Temporary, PathBuf)>,
}

#[derive(Debug)]
enum Sink {
    Stdout(Stdout),
    File(File),
}

impl Draft {
    pub(super) fn stdout(path: &Path) -> Self {
        Self::of(path, Sink::Stdout(io::stdout()), None)
    }

    /// Opens a pipe or a device.
    pub(super) fn special(path: &Path) -> io::Result<Self> {
        let file = OpenOptions::new().write(true).open(path)?;
        Ok(Self::of(path, Sink::File(file), None))
    }

    /// Begins a temporary file next to its target, with the permissions of the file that it replaces.
    pub(super) fn file(path: &Path, claim: Arc<Claim>, target: PathBuf) -> io::Result<Self> {
        let (temporary, file) = claim.create_file()?;
        if let Ok(old) = fs::metadata(&target) {
            file.set_permissions(old.permissions())?; // At once, so that a private file is never readable by others.
        }
        Ok(Self::of(path, Sink::File(file), Some((Temporary::new(temporary, Some(claim)), target))))
    }

    fn of(path: &Path, sink: Sink, staged: Option<(Temporary, PathBuf)>) -> Self {
        Self { path: path.to_owned(), buffer: BufWriter::with_capacity(BUFFER, sink), staged }
    }

    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Flushes it; a temporary file is synced.
    pub(super) fn finish(self) -> io::Result<Option<Move>> {
        let Self { buffer, staged, .. } = self;
        let mut sink = buffer.into_inner().map_err(IntoInnerError::into_error)?;
        sink.flush()?;
        let (Some((temporary, target)), Sink::File(file)) = (staged, sink) else { return Ok(None) };
        file.sync_all()?;
        Ok(Some(Move::new(temporary, target)))
    }
}

impl Write for Draft {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.buffer.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.buffer.flush()
    }
}

impl Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Stdout(out) => out.write(bytes),
            Self::File(out) => out.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Stdout(out) => out.flush(),
            Self::File(out) => out.flush(),
        }
    }
}
