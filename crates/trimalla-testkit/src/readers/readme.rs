//! The tables of the shared `data/README.md`: counts of each input, made by others.

use std::path::{Path, PathBuf};

use super::text_of;

/// One row of a family's table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadmeRow {
    /// The folder.
    pub family: String,
    /// The file name.
    pub name: String,
    /// Points listed; nothing for predicate cases.
    pub points: Option<usize>,
    /// Segments; nothing where the file has none.
    pub segments: Option<usize>,
    /// The troubles counted, in words.
    pub notes: String,
    /// The result of the program that the input comes from, in words.
    pub peer: String,
}

impl ReadmeRow {
    /// Where the file is.
    #[must_use]
    pub fn path(&self, data: &Path) -> PathBuf {
        data.join(&self.family).join(&self.name)
    }

    /// The number before some words of the notes, as in `2 proper crossings`; 0 where the words are
    /// missing.
    #[must_use]
    pub fn counted(&self, words: &str) -> usize {
        let pieces = self.notes.split([';', ',']).filter_map(|piece| piece.trim().split_once(' '));
        pieces.filter(|&(_, said)| said == words).find_map(|(n, _)| n.parse().ok()).unwrap_or(0)
    }
}

/// Reads the table of every family.
#[must_use]
pub fn read_readme(path: &Path) -> Vec<ReadmeRow> {
    let mut rows = Vec::new();
    let mut family = String::new();
    for line in text_of(path).lines() {
        if let Some(heading) = line.strip_prefix("## ") {
            family = heading.split_once('/').map_or(String::new(), |(folder, _)| folder.to_owned());
        }
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        if family.is_empty() || cells.len() < 11 || !cells[1].starts_with('`') {
            continue;
        }
        rows.push(ReadmeRow {
            family: family.clone(),
            name: cells[1].trim_matches('`').to_owned(),
            points: cells[5].parse().ok(),
            segments: cells[6].parse().ok(),
            notes: cells[8].to_owned(),
            peer: cells[9].to_owned(),
        });
    }
    rows
}
