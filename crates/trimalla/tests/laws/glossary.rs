//! GLOSSARY.md and the code use the same words: names of types stand in it, and synonyms are not used.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// The rooms whose public types stand in the glossary, or below.
const ROOMS: [&str; 11] = [
    "constrained",
    "delaunay",
    "domain",
    "drawing",
    "geometry",
    "half_edge",
    "locate",
    "quality",
    "refine",
    "size",
    "triangulation",
];

/// Public types whose name says all, and is no term: besides errors, which end in `Error`.
const PLAIN: [&str; 38] = [
    "Algorithm",
    "AlgorithmKey",
    "Angle",
    "AngleAt",
    "Beginning",
    "Bins",
    "Circle",
    "Classes",
    "Clock",
    "CompactMap",
    "Comparison",
    "GivenAreas",
    "Group",
    "Histogram",
    "Inserted",
    "InsertedKind",
    "InsertedVertex",
    "MeshVertex",
    "Missed",
    "NearFeature",
    "NoObserver",
    "Overview",
    "Point",
    "Progress",
    "Row",
    "Short",
    "Spread",
    "Statistics",
    "StepTimes",
    "TableIndex",
    "Triangle",
    "Triangulator",
    "UnknownKey",
    "Value",
    "Values",
    "Vector",
    "Warning",
    "WrongValue",
];

/// Words that are not used, each with the standard term for it: synonyms of words in the glossary, and images.
const REPLACED: [(&str, &str); 5] = [
    ("border", "boundary"),
    ("court", "failures"),
    ("drawer", "bucket"),
    ("glance", "filter"),
    ("patience", "priority, or timeout"),
];

#[test]
fn every_public_type_is_in_the_glossary_or_has_a_plain_name() {
    let named = names_in_the_glossary();
    let mut found = 0;
    let mut missing = Vec::new();
    for room in ROOMS {
        for (file, text) in files(&root().join("crates/trimalla/src").join(room), &["rs"]) {
            for name in text.lines().filter_map(public_type) {
                found += 1;
                if !named.contains(name) && !PLAIN.contains(&name) && !name.ends_with("Error") {
                    missing.push(format!("{name} in {}", file.display()));
                }
            }
        }
    }
    assert!(found > 70, "only {found} public types were found: the pattern no longer fits");
    assert!(missing.is_empty(), "neither in GLOSSARY.md nor in PLAIN: {missing:#?}");
}

#[test]
fn every_name_in_the_glossary_is_in_the_code() {
    let mut words = BTreeSet::new();
    for (_, text) in files(&root().join("crates/trimalla/src"), &["rs"]) {
        words.extend(text.split(|c: char| !c.is_alphanumeric() && c != '_').map(str::to_owned));
    }
    let named = names_in_the_glossary();
    assert!(named.len() > 40, "only {} names were found: the pattern no longer fits", named.len());
    let unknown: Vec<_> =
        named.iter().chain(PLAIN.map(str::to_owned).iter()).filter(|n| !words.contains(*n)).cloned().collect();
    assert!(unknown.is_empty(), "no such types: {unknown:#?}");
}

#[test]
fn words_that_have_a_standard_term_are_not_used() {
    let mut texts = Vec::new();
    for folder in ["crates", "docs", "bench", "fuzz", "data", "scripts"] {
        texts.extend(files(&root().join(folder), &["rs", "md", "py", "sh", "toml"]));
    }
    for page in ["ARCHITECTURE", "CHANGELOG", "CONTRIBUTING", "GLOSSARY", "README", "REFERENCES"] {
        let file = root().join(page).with_extension("md");
        let text = fs::read_to_string(&file).expect("a page");
        texts.push((file, without_code(&text)));
    }
    let mut found = Vec::new();
    for (file, text) in texts.iter().filter(|(file, _)| !file.ends_with("laws/glossary.rs")) {
        for (word, instead) in REPLACED {
            found.extend(lines_with(word, text).map(|line| format!("{}:{line}: {word}: {instead}", file.display())));
        }
    }
    assert!(texts.len() > 300, "only {} texts were found", texts.len());
    assert!(found.is_empty(), "words to be replaced: {found:#?}");
}

#[test]
fn words_are_found_in_prose_and_in_names() {
    let text = "a border\nBorders are lines\nfn is_on_border()\nstruct MeshBorder;\nborderline\nsideboard er";
    assert_eq!(lines_with("border", text).collect::<Vec<_>>(), [1, 2, 3, 4]);
}

/// The lines, counted from 1, in which a word or its plural stands: alone, or as part of a name.
fn lines_with<'a>(word: &'a str, text: &'a str) -> impl Iterator<Item = usize> + 'a {
    let is_word = move |w: &str| w.strip_suffix('s').unwrap_or(w) == word || w == word;
    let has = move |line: &str| line.to_lowercase().contains(word) && words_of(line).iter().any(|w| is_word(w));
    (1..).zip(text.lines()).filter(move |(_, line)| has(line)).map(|(number, _)| number)
}

/// A page without the names of code: the changelog names what there is no more.
fn without_code(page: &str) -> String {
    let prose = |line: &str| line.split('`').step_by(2).collect::<Vec<_>>().join(" ");
    page.lines().map(prose).collect::<Vec<_>>().join("\n")
}

/// The words of a line in lower case; `snake_case` and `CamelCase` names are taken apart.
fn words_of(line: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut before = ' ';
    for c in line.chars() {
        if !c.is_alphabetic() || c.is_uppercase() && before.is_lowercase() {
            words.push(String::new());
        }
        if let (true, Some(word)) = (c.is_alphabetic(), words.last_mut()) {
            word.extend(c.to_lowercase());
        }
        before = c;
    }
    words
}

/// The name of the public type that a line declares.
fn public_type(line: &str) -> Option<&str> {
    let line = line.trim_start();
    let rest =
        ["pub struct ", "pub enum ", "pub trait ", "pub type "].iter().find_map(|kind| line.strip_prefix(kind))?;
    rest.split(|c: char| !c.is_alphanumeric()).next().filter(|name| !name.is_empty())
}

/// The names of types in the first column of the tables.
fn names_in_the_glossary() -> BTreeSet<String> {
    let text = fs::read_to_string(root().join("GLOSSARY.md")).expect("the glossary");
    let cells = text.lines().filter_map(|line| line.strip_prefix("| ")?.split(" | ").next());
    cells.flat_map(|cell| cell.split('`').skip(1).step_by(2)).map(str::to_owned).collect()
}

/// The files of a folder and of those in it that end so, with their text; what was built is left out.
fn files(folder: &Path, endings: &[&str]) -> Vec<(PathBuf, String)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() && !path.ends_with("target") && !path.ends_with("corpus") {
            found.extend(files(&path, endings));
        } else if path.extension().is_some_and(|e| endings.iter().any(|ending| e == *ending)) {
            let text = fs::read_to_string(&path).expect("a text");
            found.push((path, text));
        }
    }
    found
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}
