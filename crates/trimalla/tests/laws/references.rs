//! Every source that the code names by a key stands in REFERENCES.md.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

#[test]
fn every_key_in_the_code_is_in_the_list() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let list = fs::read_to_string(root.join("REFERENCES.md")).expect("the list of references");
    let mut files = Vec::new();
    for part in ["trimalla", "trimalla-io", "trimalla-cli"] {
        sources(&root.join("crates").join(part).join("src"), &mut files);
    }
    let mut missing = BTreeSet::new();
    let mut found = 0;
    for file in files {
        for key in keys(&fs::read_to_string(&file).expect("a source file")) {
            found += 1;
            if !list.contains(&format!("**[{key}]**")) {
                missing.insert(format!("{key} in {}", file.display()));
            }
        }
    }
    assert!(found > 40, "only {found} keys were found: the pattern no longer fits");
    assert!(missing.is_empty(), "not in REFERENCES.md: {missing:?}");
}

/// Keys between "`[" and "]`", and the sources of registry rows.
fn keys(text: &str) -> Vec<String> {
    let in_prose = text.split("`[").skip(1).filter_map(|rest| rest.split_once("]`")).map(|(key, _)| key);
    let in_rows = text.lines().filter(|l| l.trim_end().ends_with("\";")).filter_map(|l| {
        let mut strings = l.split('"').skip(1).step_by(2).collect::<Vec<_>>();
        (strings.len() == 3).then(|| strings.pop()).flatten()
    });
    let is_key = |k: &&str| k.starts_with(char::is_uppercase) && k.chars().all(char::is_alphanumeric) && !k.is_empty();
    in_prose
        .chain(in_rows)
        .filter(is_key)
        .filter(|k| *k == "MeshSuite" || k.ends_with(char::is_numeric))
        .map(str::to_owned)
        .collect()
}

fn sources(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a source folder").flatten() {
        let path = entry.path();
        if path.is_dir() {
            sources(&path, files);
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
}
