//! A place in a text, by byte, line and column: what the readers of records and of words share.
//!
//! Lines end with LF, CR LF or a lone CR. Blanks are space, tab, vertical tab and form feed. A byte order mark at the
//! start is skipped.

use crate::error::{Fault, IoError, Place};

const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// A cursor over one file.
#[derive(Clone, Debug)]
pub(crate) struct Cursor<'a> {
    name: &'a str,
    pub(crate) bytes: &'a [u8],
    pub(crate) pos: usize,
    pub(crate) line: u64,
    pub(crate) line_start: usize,
}

impl<'a> Cursor<'a> {
    /// A cursor at the start of `bytes`, which must be text; `name` is what errors call the file.
    pub(crate) fn new(bytes: &'a [u8], name: &'a str) -> Result<Self, IoError> {
        let start = if bytes.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len() } else { 0 };
        let mut cursor = Self { name, bytes, pos: start, line: 1, line_start: start };
        match not_text(bytes) {
            None => Ok(cursor),
            Some((offset, found)) => {
                cursor.seek(offset);
                Err(IoError::Syntax(cursor.fault_here("text", found)))
            }
        }
    }

    /// How many bytes are still to be read: an upper bound for all that a header may promise.
    pub(crate) fn remaining(&self) -> usize {
        self.bytes.len() - self.pos
    }

    /// The byte under the cursor.
    pub(crate) fn byte(&self) -> Option<u8> {
        self.bytes.get(self.pos).copied()
    }

    /// What is still to be read.
    pub(crate) fn rest(&self) -> &'a [u8] {
        &self.bytes[self.pos..]
    }

    /// The column of the cursor, counted in bytes from 1.
    pub(crate) fn column(&self) -> u64 {
        (self.pos - self.line_start) as u64 + 1
    }

    /// Passes over the rest of this line.
    pub(crate) fn skip_line(&mut self) {
        let rest = self.rest();
        self.pos += rest.iter().position(|&b| ends_line(b)).unwrap_or(rest.len());
    }

    /// Steps over the line end under the cursor; CR LF is one.
    pub(crate) fn end_line(&mut self) {
        self.pos += if self.rest().starts_with(b"\r\n") { 2 } else { 1 };
        self.line += 1;
        self.line_start = self.pos;
    }

    /// Moves to a byte offset, counting the lines on the way.
    pub(crate) fn seek(&mut self, offset: usize) {
        while self.pos < offset {
            if ends_line(self.bytes[self.pos]) {
                self.end_line();
            } else {
                self.pos += 1;
            }
        }
    }

    /// The place of a line and a column.
    pub(crate) fn place(&self, line: u64, column: u64) -> Place {
        Place { file: self.name.to_owned(), line, column }
    }

    /// The fault of a line and a column.
    pub(crate) fn fault(&self, line: u64, column: u64, expected: &str, found: String) -> Box<Fault> {
        Box::new(Fault { place: self.place(line, column), expected: expected.to_owned(), found })
    }

    /// The fault of what stands at the cursor.
    pub(crate) fn fault_here(&self, expected: &str, found: &str) -> Box<Fault> {
        self.fault(self.line, self.column(), expected, found.to_owned())
    }
}

pub(crate) fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | 0x0b | 0x0c)
}

pub(crate) fn ends_line(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

/// The offset and description of what shows that `bytes` are no text.
pub(crate) fn not_text(bytes: &[u8]) -> Option<(usize, &'static str)> {
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return Some((0, "UTF-16"));
    }
    if bytes.starts_with(b"\x1f\x8b") {
        return Some((0, "gzip-compressed data"));
    }
    if !bytes.contains(&0) {
        return None; // At many bytes a step, which a search for the place is not.
    }
    bytes.iter().position(|&b| b == 0).map(|offset| (offset, "a NUL byte"))
}
