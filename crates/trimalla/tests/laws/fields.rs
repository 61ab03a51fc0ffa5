//! Types of a few parts: one of many fields says why beside it, and those of the constrained triangulation and of the
//! refinement are private.

use std::fs;
use std::path::{Path, PathBuf};

use crate::comments::rust_files;

/// More fields than this want a reason.
const MANY: usize = 12;

#[test]
fn a_type_of_many_fields_says_why() {
    let mut silent = Vec::new();
    for (file, text) in sources() {
        let lines: Vec<&str> = text.lines().collect();
        for (at, name) in structs(&lines) {
            let docs = lines[..at].iter().rev().take_while(|line| line.trim_start().starts_with(['/', '#']));
            let says_why = docs.into_iter().any(|line| line.contains("One field for each"));
            if fields(&lines[at..]).count() > MANY && !says_why {
                silent.push(format!("{name} in {}", file.display()));
            }
        }
    }
    assert!(silent.is_empty(), "{silent:#?}");
}

#[test]
fn the_fields_of_the_central_types_are_private() {
    let central = ["ConstrainedTriangulation", "ConstrainedDelaunay", "Refinement"];
    let mut found = 0;
    for (file, text) in sources() {
        let lines: Vec<&str> = text.lines().collect();
        for (at, name) in structs(&lines).filter(|(_, name)| central.contains(name)) {
            found += 1;
            let open: Vec<&str> = fields(&lines[at..]).filter(|line| line.trim_start().starts_with("pub")).collect();
            assert!(open.is_empty(), "{name} in {}: {open:#?}", file.display());
        }
    }
    assert_eq!(found, central.len(), "each is there once");
}

/// The source files of the library, with their text.
fn sources() -> Vec<(PathBuf, String)> {
    let mut files = Vec::new();
    rust_files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut files);
    assert!(files.len() > 100, "only {} files were found", files.len());
    files.into_iter().map(|file| (file.clone(), fs::read_to_string(file).expect("a source file"))).collect()
}

/// The structs with named fields: the number of the line where each begins, and its name.
fn structs<'a>(lines: &'a [&'a str]) -> impl Iterator<Item = (usize, &'a str)> {
    lines.iter().enumerate().filter_map(|(at, line)| {
        let (before, after) = line.split_once("struct ")?;
        let is_item = before.is_empty() || before.starts_with("pub");
        let name = after.split(|c: char| !c.is_alphanumeric()).next()?;
        (is_item && line.ends_with('{')).then_some((at, name))
    })
}

/// The lines of the fields of the struct that begins on the first line.
fn fields<'a>(lines: &'a [&'a str]) -> impl Iterator<Item = &'a str> {
    let body = lines.iter().skip(1).take_while(|line| **line != "}").copied();
    body.filter(|line| {
        let is_comment = line.trim_start().starts_with(['/', '#']);
        !is_comment && line.starts_with("    ") && !line.starts_with("     ") && line.contains(": ")
    })
}
