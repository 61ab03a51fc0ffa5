//! What the README shows.

use std::fs;
use std::path::Path;

use crate::common::Scratch;

#[test]
fn the_picture_is_what_its_command_draws() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let readme = fs::read_to_string(root.join("README.md")).unwrap();
    let command = readme.lines().find(|line| line.starts_with("cargo run") && line.ends_with("-o guitar.svg")).unwrap();
    let (_, arguments) = command.split_once(" -- ").unwrap();
    let scratch = Scratch::new("readme-picture");
    fs::create_dir_all(scratch.path().join("data/shapes")).unwrap();
    fs::copy(root.join("data/shapes/guitar.poly"), scratch.path().join("data/shapes/guitar.poly")).unwrap();
    scratch.run(arguments).expect(0);
    let shown = fs::read_to_string(root.join("docs/guitar.svg")).unwrap();
    assert!(scratch.read("guitar.svg") == shown, "{arguments} does not draw docs/guitar.svg");
}
