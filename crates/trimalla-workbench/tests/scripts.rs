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
fn every_lesson_is_a_script_whose_scenes_have_captions_and_which_needs_no_files() {
    let all = scripts();
    let files: Vec<String> = all
        .iter()
        .filter(|path| path.parent().is_some_and(|folder| folder.ends_with("learn")))
        .map(|path| fs::read_to_string(path).expect("a script"))
        .collect();
    let texts: Vec<&str> = script::LEARN.iter().map(|lesson| lesson.text).collect();
    assert_eq!(texts, files, "in the order of their names");
    for lesson in script::LEARN {
        let scenes = script::scenes(lesson.text);
        assert!(scenes.len() >= 4 && scenes.iter().all(|scene| !scene.caption.is_empty()), "{}", lesson.title);
        // The scenes have all lines, where they say.
        let lines: Vec<&str> = lesson.text.lines().collect();
        let commands = lines.iter().filter(|line| !line.is_empty() && !line.starts_with('#')).count();
        let of_scenes = scenes.iter().flat_map(|scene| &scene.lines).filter(|line| !line.is_empty()).count();
        assert_eq!(of_scenes, commands, "{}", lesson.title);
        for scene in &scenes {
            for (line, number) in scene.lines.iter().zip(scene.line_number..) {
                assert_eq!(line, lines[number - 1], "{}", lesson.title);
                let name = line.split_whitespace().next().unwrap_or_default();
                assert!(
                    !["Load", "Save", "Export", "Recipe", "SaveRecipe"].contains(&name),
                    "{}: {line}",
                    lesson.title
                );
            }
        }
        assert!(lesson.text.contains("\nExpect "), "{}", lesson.title);
    }
}

#[test]
fn scenes_are_found_in_every_script() {
    let none: [&str; 0] = [];
    assert!(script::scenes("").is_empty() && script::scenes("\n \n").is_empty());
    let scenes = script::scenes("Clear\n\n\n# a\n\n\n#b\n#  c \n  Undo # not a caption\n\n\nRedo\n\n# end");
    let captions: Vec<&str> = scenes.iter().map(|scene| scene.caption.as_str()).collect();
    assert_eq!(captions, ["", "a", "b c", "end"]);
    assert_eq!(scenes.iter().map(|scene| scene.line_number).collect::<Vec<_>>(), [1, 4, 9, 14]);
    assert_eq!(scenes[0].lines, ["Clear"]);
    assert_eq!(scenes[1].lines, none);
    assert_eq!(scenes[2].lines, ["Undo # not a caption", "", "", "Redo"]);
    assert_eq!(scenes[3].lines, none);
}

#[test]
fn each_command_has_a_script_or_writes_files() {
    let text: String = scripts().iter().map(|path| fs::read_to_string(path).expect("a script")).collect();
    let words: Vec<&str> = text.lines().filter_map(|line| line.split_whitespace().next()).collect();
    let missing: Vec<&str> = COMMANDS.iter().map(|row| row.name).filter(|name| !words.contains(name)).collect();
    assert_eq!(missing, ["Save", "SaveRecipe", "Export", "Player"], "these have tests of their own");
}
