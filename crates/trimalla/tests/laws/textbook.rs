//! The chapter on triangulations has a section and a figure for each algorithm.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use trimalla::Method;

#[test]
fn every_algorithm_is_in_the_chapter() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/textbook");
    let page = fs::read_to_string(folder.join("README.md")).expect("the chapter");
    for method in Method::all().filter(|&method| method != Method::Conforming) {
        let (key, summary) = (method.key(), method.row().summary);
        let line = format!("- `trimalla triangulate --algorithm {key}`: {summary}.");
        assert!(page.contains(&line), "no section has the line: {line}");
        assert!(folder.join(format!("{key}.svg")).is_file(), "{key} has no figure");
    }
    let pictures = page.split("](").skip(1).filter_map(|rest| rest.split_once(')')).map(|(target, _)| target);
    for target in pictures.filter(|target| target.ends_with(".svg")) {
        assert!(folder.join(target).is_file(), "there is no figure {target}");
    }
}

#[test]
fn keys_are_told_apart() {
    let keys: BTreeSet<&str> = Method::all().map(Method::key).collect();
    assert_eq!(keys.len(), Method::all().count());
    for method in Method::all() {
        assert_eq!(method.key().parse(), Ok(method));
    }
}
