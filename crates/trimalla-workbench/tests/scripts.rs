//! Every script of `data/scripts` does what it says it does, leads there again from its own record, and can be undone.

use std::fs;
use std::path::{Path, PathBuf};

use trimalla_workbench::{COMMANDS, Document, Quiet, script};

fn scripts() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().expect("the project");
    // Files are named from there.
    std::env::set_current_dir(&root).expect("a folder");
    let mut found = Vec::new();
    for folder in fs::read_dir(root.join("data/scripts")).expect("scripts") {
        let folder = folder.expect("an entry").path();
        if folder.is_dir() {
            found.extend(fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()));
        }
    }
    found.sort();
    found
}

#[test]
fn every_script_passes_leads_there_again_and_is_undone() {
    let all = scripts();
    assert!(all.len() > 50, "{} scripts", all.len());
    let mut wrong = Vec::new();
    for path in &all {
        let text = fs::read_to_string(path).expect("a script");
        let mut document = Document::new();
        let refused = script::run(&mut document, &text, false, &mut Quiet);
        wrong.extend(refused.iter().map(|error| format!("{}:{error}", path.display())));
        let mut again = Document::new();
        assert_eq!(script::run(&mut again, &document.script(), false, &mut Quiet), [], "{}", path.display());
        if again != document {
            wrong.push(format!("{}: its record leads elsewhere", path.display()));
        }
        let (undoable, _) = document.undoable();
        document.run(&format!("Undo {undoable}"), &mut Quiet).expect("undone");
        if document != Document::new() {
            wrong.push(format!("{}: undone, it is not empty", path.display()));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn each_command_has_a_script_or_writes_files() {
    let text: String = scripts().iter().map(|path| fs::read_to_string(path).expect("a script")).collect();
    let words: Vec<&str> = text.lines().filter_map(|line| line.split_whitespace().next()).collect();
    let missing: Vec<&str> = COMMANDS.iter().map(|row| row.name).filter(|name| !words.contains(name)).collect();
    assert_eq!(missing, ["Save", "SaveRecipe", "Export", "Player"], "these have tests of their own");
}
