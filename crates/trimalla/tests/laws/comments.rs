//! Comments keep within the width that `rustfmt.toml` gives to code: rustfmt leaves comments alone.

use std::fs;
use std::path::{Path, PathBuf};

const WIDTH: usize = 120;

#[test]
fn no_line_of_a_comment_is_wider_than_code() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the folder of crates");
    let mut files = Vec::new();
    rust_files(crates, &mut files);
    assert!(files.len() > 100, "only {} files were found", files.len());
    let mut wide = Vec::new();
    for file in files {
        let text = fs::read_to_string(&file).expect("a source file");
        let mut is_fenced = false;
        for (number, line) in (1..).zip(text.lines()) {
            let prose = line.trim_start().strip_prefix("//").map(|rest| rest.trim_start_matches(['/', '!', ' ']));
            is_fenced ^= prose.is_some_and(|prose| prose.starts_with("```"));
            // A row of a table is one line; drawings and examples stand in fences.
            if prose.is_some_and(|prose| !is_fenced && !prose.starts_with('|')) && line.chars().count() > WIDTH {
                wide.push(format!("{}:{number}", file.display()));
            }
        }
    }
    assert!(wide.is_empty(), "{wide:#?}");
}

/// Adds the Rust files below a folder.
pub(crate) fn rust_files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            rust_files(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}
