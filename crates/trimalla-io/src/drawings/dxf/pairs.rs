//! The pairs of a DXF file.

use super::super::sketch::fault_at;
use crate::error::{IoError, quote};

/// A code and its value; `line` is that of the code.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair<'a> {
    pub(super) code: i32,
    pub(super) value: &'a str,
    pub(super) line: u32,
}

impl Pair<'_> {
    pub(super) fn is(&self, code: i32, value: &str) -> bool {
        self.code == code && self.value == value
    }
}

/// All pairs of a file.
#[derive(Debug)]
pub(super) struct Pairs<'a> {
    name: &'a str,
    pairs: Vec<Pair<'a>>,
}

impl<'a> Pairs<'a> {
    /// Splits a file into its pairs.
    pub(super) fn read(bytes: &'a [u8], name: &'a str) -> Result<Self, IoError> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let mut lines = bytes.split(|&b| b == b'\n').map(<[u8]>::trim_ascii).zip(1_u32..);
        let mut pairs = Vec::new();
        while let Some((code, line)) = lines.next() {
            let Some((value, _)) = lines.next() else {
                if code.is_empty() {
                    break;
                }
                return Err(fault_at(name, u64::from(line), 1, "a value after the last code", "the end of the file"));
            };
            let number = std::str::from_utf8(code).ok().and_then(|text| text.parse::<i32>().ok());
            let code = number
                .ok_or_else(|| fault_at(name, u64::from(line), 1, "a code, which is a whole number", quote(code)))?;
            // Values that are no UTF-8 are names in older encodings, of which the readable part is kept.
            let value = std::str::from_utf8(value)
                .unwrap_or_else(|error| std::str::from_utf8(&value[..error.valid_up_to()]).unwrap_or_default());
            pairs.push(Pair { code, value, line });
            if code == 0 && value == "EOF" {
                break;
            }
        }
        Ok(Self { name, pairs })
    }

    pub(super) fn len(&self) -> usize {
        self.pairs.len()
    }

    pub(super) fn get(&self, at: usize) -> Pair<'a> {
        self.pairs[at]
    }

    pub(super) fn range(&self, from: usize, to: usize) -> &[Pair<'a>] {
        &self.pairs[from..to]
    }

    pub(super) fn fault(&self, line: u32, expected: impl Into<String>, found: impl Into<String>) -> IoError {
        fault_at(self.name, u64::from(line), 1, expected, found)
    }
}
