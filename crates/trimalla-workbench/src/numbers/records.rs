//! The lines of a drawing's records in its files.
//!
//! Reading keeps no lines, as good drawings need none. Where a drawing turns out to be at fault, its files are scanned
//! again: they have been read without an error, so that every line which is neither blank nor a comment is a record.
//! Its fields are separated by blanks or a comma.

use std::fs;
use std::path::Path;

use trimalla_io::read_bytes;

/// A record: its line, counted from 1, and its first word, which is its number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Record {
    /// The line.
    pub line: usize,
    /// The first word.
    pub number: String,
}

/// The records of a drawing, section by section; empty where the file cannot be read again.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Records {
    /// Vertices; empty where they are in a file of their own.
    pub vertices: Vec<Record>,
    /// Segments.
    pub segments: Vec<Record>,
    /// Hole seeds.
    pub holes: Vec<Record>,
    /// Region seeds.
    pub regions: Vec<Record>,
}

impl Records {
    /// The records of a file.
    #[must_use]
    pub fn in_file(file: &Path) -> Self {
        read(file).map_or_else(Self::default, |text| Self::in_text(&text))
    }

    /// The records of a text.
    #[must_use]
    pub fn in_text(text: &str) -> Self {
        let mut records = records(text);
        let mut next = || section(&mut records);
        Self { vertices: next(), segments: next(), holes: next(), regions: next() }
    }
}

fn read(file: &Path) -> Option<String> {
    let is_file = fs::metadata(file).ok()?.is_file(); // A pipe cannot be read twice.
    let bytes = is_file.then(|| read_bytes(file, u64::MAX).ok()).flatten()?;
    Some(String::from_utf8_lossy(&bytes).into_owned())
}

/// Every record of a text. Lines end with LF, CR LF or a lone CR.
fn records(text: &str) -> impl Iterator<Item = Record> + '_ {
    let lines = text.split('\n').flat_map(|line| line.strip_suffix('\r').unwrap_or(line).split('\r'));
    lines.enumerate().filter_map(|(index, line)| {
        let content = line.trim_start_matches('\u{feff}').split('#').next()?;
        let number = content.split(|c: char| c.is_whitespace() || c == ',').find(|word| !word.is_empty())?.to_owned();
        Some(Record { line: index + 1, number })
    })
}

/// Takes a header, which says how many records follow, and these records.
fn section(records: &mut impl Iterator<Item = Record>) -> Vec<Record> {
    let count = records.next().and_then(|header| header.number.parse().ok());
    records.take(count.unwrap_or(0)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(line: usize, number: &str) -> Record {
        Record { line, number: number.to_owned() }
    }

    #[test]
    fn records_keep_their_lines_past_comments_blanks_and_all_line_ends() {
        let text = "\u{feff}# top\r\n2, 2,0,0\r1,0 0\n\n2 1 1 # two\n1 0\n  1 1 2\n1\n0 .5 .5\n";
        let found = Records::in_text(text);
        assert_eq!(found.vertices, [record(3, "1"), record(5, "2")]);
        assert_eq!(found.segments, [record(7, "1")]);
        assert_eq!(found.holes, [record(9, "0")]);
        assert_eq!(found.regions, []);
    }

    #[test]
    fn a_text_that_ends_early_has_no_records() {
        assert!(Records::in_text("0\n5 0\n").holes.is_empty());
        assert!(Records::in_text("").segments.is_empty());
    }
}
