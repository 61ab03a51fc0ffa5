//! From a path to bytes, within bounds of memory and time.
//!
//! | what is behind the path | bound |
//! |---|---|
//! | a file | the length that it has when it is opened, and what the caller allows |
//! | a pipe, a device | [`LONGEST_STREAM`] or what the caller allows; [`TIMEOUT`] until the next bytes come |
//! | standard input | [`LONGEST_STREAM`]; no limit of time |
//! | anything with a NUL byte | the block in which it comes: no text has one, and it may be a device without end; drawings excepted that begin like a format that is no text |

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{RecvTimeoutError, SyncSender, sync_channel};
use std::thread;
use std::time::Duration;

use crate::drawings::DrawingFormat;
use crate::error::IoError;
use crate::files::Files;

const BLOCK: usize = 1 << 16;

/// No text that 32-bit indices can describe comes near this many bytes.
pub(crate) const LONGEST_FILE: u64 = 1 << 38;

/// A pipe or device that has not ended here is taken for one that never will.
const LONGEST_STREAM: u64 = 1 << 31;

/// A named pipe or device that delivers nothing for so long is taken for one that never will.
const TIMEOUT: Duration = Duration::from_secs(10);

/// Reads a text file of at most `longest` bytes.
///
/// Memory stays below twice what is there, whatever the file system says about it.
///
/// # Errors
/// [`IoError::Missing`] where there is no such file. [`IoError::Unreadable`] where it is a directory, is longer, grows
/// while it is read, has a NUL byte, or is a pipe or device that delivers nothing for ten seconds.
pub fn read_bytes(path: impl AsRef<Path>, longest: u64) -> Result<Vec<u8>, IoError> {
    read_text(&Files::Disk, path.as_ref(), longest)
}

/// Reads a text file of at most `longest` bytes; one with a NUL byte is a fault.
pub(crate) fn read_text(files: &Files, path: &Path, longest: u64) -> Result<Vec<u8>, IoError> {
    let bytes = read(files, path, None, longest)?;
    if bytes.contains(&0) {
        let source = io::Error::new(io::ErrorKind::InvalidData, "it is no text: it has a NUL byte");
        return Err(IoError::Unreadable { path: path.to_owned(), source });
    }
    Ok(bytes)
}

/// Reads a file that another one may refer to; what has a NUL byte ends with the block in which it stands.
pub(crate) fn read(files: &Files, path: &Path, needed_by: Option<&Path>, longest: u64) -> Result<Vec<u8>, IoError> {
    of_files(files, path, needed_by, longest, Content::Text)
}

/// Reads a drawing, whose format may be one that is no text.
pub(crate) fn read_drawing(files: &Files, path: &Path) -> Result<Vec<u8>, IoError> {
    of_files(files, path, None, LONGEST_FILE, Content::Any)
}

fn of_files(
    files: &Files,
    path: &Path,
    needed_by: Option<&Path>,
    longest: u64,
    content: Content,
) -> Result<Vec<u8>, IoError> {
    files.read(path, longest, content).map_err(|source| match source.kind() {
        io::ErrorKind::NotFound => IoError::Missing { path: path.to_owned(), needed_by: needed_by.map(Path::to_owned) },
        _ => IoError::Unreadable { path: path.to_owned(), source },
    })
}

/// Reads a stream to its end.
pub(crate) fn of_stream(mut stream: impl Read) -> io::Result<Vec<u8>> {
    gather(LONGEST_STREAM, too_long(LONGEST_STREAM), Content::Any, |block| block_of(&mut stream, block))
}

/// What is expected behind a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Content {
    /// Text: reading ends with the block in which a NUL byte comes.
    Text,
    /// Any bytes, if they begin like one of the formats that are no text; otherwise text.
    Any,
    /// Bytes of a file that another one needs.
    Binary,
}

/// Reads a file, a pipe or a device.
pub(crate) fn of_disk(path: &Path, longest: u64, content: Content) -> io::Result<Vec<u8>> {
    let found = fs::metadata(path)?;
    if found.is_dir() {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    if !found.is_file() {
        return read_with_timeout(path, longest.min(LONGEST_STREAM), content);
    }
    let mut file = File::open(path)?;
    match file.metadata()?.len() {
        // Files of the system's own have no length before they are read.
        0 => gather(longest.min(LONGEST_STREAM), too_long(longest), content, |block| block_of(&mut file, block)),
        length if length > longest => Err(too_long(longest)),
        length => gather(length, grows(), content, |block| block_of(&mut file, block)),
    }
}

pub(crate) fn too_long(longest: u64) -> io::Error {
    io::Error::new(io::ErrorKind::FileTooLarge, format!("it is longer than the {longest} bytes that are read at most"))
}

fn grows() -> io::Error {
    io::Error::new(io::ErrorKind::FileTooLarge, "it grows while it is read")
}

/// Joins blocks until an empty one, or in text one with a NUL byte. More than `longest` bytes are a fault, and so is
/// memory that is not there.
fn gather(
    longest: u64,
    fault: io::Error,
    content: Content,
    mut next: impl FnMut(&mut Vec<u8>) -> io::Result<()>,
) -> io::Result<Vec<u8>> {
    let (mut block, mut bytes) = (Vec::new(), Vec::new());
    loop {
        next(&mut block)?;
        if block.is_empty() {
            return Ok(bytes);
        }
        if (bytes.len() + block.len()) as u64 > longest {
            return Err(fault);
        }
        bytes.try_reserve(block.len()).map_err(|_| io::Error::from(io::ErrorKind::OutOfMemory))?;
        bytes.extend_from_slice(&block);
        let may_be_binary = || match content {
            Content::Text => false,
            Content::Any => DrawingFormat::of_content(&bytes).is_some_and(DrawingFormat::is_binary),
            Content::Binary => true,
        };
        if block.contains(&0) && !may_be_binary() {
            return Ok(bytes);
        }
    }
}

/// Fills a block with the next bytes; at the end it stays empty.
fn block_of(stream: &mut impl Read, block: &mut Vec<u8>) -> io::Result<()> {
    block.resize(BLOCK, 0);
    loop {
        match stream.read(block) {
            Ok(length) => {
                block.truncate(length);
                return Ok(());
            }
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
}

/// Reads a pipe or device on a thread of its own: both opening it and reading it may block for ever. Then the thread is
/// left blocked.
fn read_with_timeout(path: &Path, longest: u64, content: Content) -> io::Result<Vec<u8>> {
    let (sender, receiver) = sync_channel(1);
    let of_thread = path.to_owned();
    thread::Builder::new().spawn(move || deliver(&of_thread, &sender))?;
    gather(longest, too_long(longest), content, |block| {
        *block = receiver.recv_timeout(TIMEOUT).unwrap_or_else(|error| match error {
            RecvTimeoutError::Timeout => Err(nothing_comes()),
            RecvTimeoutError::Disconnected => Ok(Vec::new()),
        })?;
        Ok(())
    })
}

fn nothing_comes() -> io::Error {
    let seconds = TIMEOUT.as_secs();
    io::Error::new(io::ErrorKind::TimedOut, format!("it is no file, and nothing comes from it for {seconds} seconds"))
}

/// Sends block after block, the empty one at the end too, until nobody listens.
fn deliver(path: &PathBuf, sender: &SyncSender<io::Result<Vec<u8>>>) {
    let opened = File::open(path);
    let next = move |block: &mut Vec<u8>| match &opened {
        Ok(file) => block_of(&mut &*file, block),
        Err(error) => Err(io::Error::from(error.kind())),
    };
    loop {
        let mut block = Vec::new();
        let read = next(&mut block);
        let is_last = read.is_err() || block.is_empty();
        if sender.send(read.map(|()| block)).is_err() || is_last {
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_too_long_or_binary_ends_early() {
        let longest = |text: &[u8], longest| {
            let mut text = text;
            gather(longest, too_long(longest), Content::Text, |block| block_of(&mut text, block))
        };
        assert_eq!(longest(b"abc", 3).unwrap(), b"abc");
        assert_eq!(longest(b"abcd", 3).unwrap_err().kind(), io::ErrorKind::FileTooLarge);
        let zeros = of_stream(io::repeat(0)).unwrap();
        assert_eq!(zeros.len(), BLOCK);
    }
}
