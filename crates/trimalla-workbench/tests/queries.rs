//! What a document tells of the steps of a refinement, and of its history.

use trimalla_workbench::{Document, Quiet};

/// A document after these commands.
fn after(lines: &[&str]) -> Document {
    let mut document = Document::new();
    run(&mut document, lines);
    document
}

fn run(document: &mut Document, lines: &[&str]) {
    for line in lines {
        document.run(line, &mut Quiet).unwrap_or_else(|error| panic!("{line}: {error}"));
    }
}

/// The number of the last step, if the last command made one.
fn number(document: &Document) -> Option<u64> {
    document.last_step().map(|event| event.number)
}

#[test]
fn the_last_step_is_that_of_the_last_command() {
    let mut document = after(&["Generate polygon 12 5", "Triangulate"]);
    assert_eq!(number(&document), None);
    // The first one begins the refinement, so that it replaces everything.
    let mut events = Vec::new();
    for line in ["Step", "Step 3", "Step"] {
        run(&mut document, &[line]);
        events.push(document.last_step().expect("a step").clone());
    }
    assert_eq!(events.iter().map(|event| event.number).collect::<Vec<_>>(), [1, 4, 5]);
    for back in (0..2).rev() {
        run(&mut document, &["Undo"]);
        assert_eq!(document.last_step(), Some(&events[back]));
    }
    run(&mut document, &["Undo"]);
    assert_eq!(number(&document), None);
    for event in &events {
        run(&mut document, &["Redo"]);
        assert_eq!(document.last_step(), Some(event));
    }
    run(&mut document, &["Set min-angle 20"]);
    assert_eq!(number(&document), None, "the last command made no step");
    run(&mut document, &["Undo 2", "Redo"]);
    assert_eq!(document.last_step(), events.last());
}

#[test]
fn the_refinement_at_work_is_told() {
    let mut document = after(&["Generate polygon 40 5", "Triangulate", "Set min-angle 25"]);
    assert!(!document.is_refining() && document.options_in_force().is_none());
    run(&mut document, &["Step 7", "Set min-angle 33"]);
    assert!(document.is_refining());
    assert_eq!(document.steps_made(), 7);
    assert_eq!(document.options_in_force().and_then(|options| options.min_angle_deg), Some(25.0));
    assert_eq!(document.options().min_angle_deg, Some(33.0));
    run(&mut document, &["Undo 2", "Redo"]);
    assert_eq!(document.steps_made(), 7);
    run(&mut document, &["Insert 0.5 0.5"]);
    assert!(!document.is_refining());
    assert_eq!(document.steps_made(), 0);
}

#[test]
fn the_history_has_what_was_taken_back() {
    let lines = ["V 0 0 0", "V 1 4 0", "V 2 0 4", "Triangulate"];
    let mut document = after(&lines);
    run(&mut document, &["Show 0", "Undo 2"]);
    assert_eq!(document.history().collect::<Vec<_>>(), lines);
    assert_eq!(document.position(), 2);
    run(&mut document, &["Redo", "Insert 1 1"]);
    assert_eq!(document.history().collect::<Vec<_>>(), ["V 0 0 0", "V 1 4 0", "V 2 0 4", "Insert 1 1"]);
    assert_eq!(document.position(), 4);
}

#[test]
fn steps_that_are_dropped_are_gone_and_the_others_are_undone() {
    let mut document = Document::with_history(60_000);
    run(&mut document, &["Generate polygon 40 5", "Triangulate", "Set max-area 0.001"]);
    for _ in 0..200 {
        run(&mut document, &["Step"]);
    }
    let (undoable, _) = document.undoable();
    assert!((10..200).contains(&undoable), "{undoable}");
    let after = document.indexed();
    run(&mut document, &[&format!("Undo {undoable}")]);
    assert_eq!(document.steps_made(), 200 - undoable as u64);
    assert!(document.run("Undo", &mut Quiet).is_err());
    run(&mut document, &[&format!("Redo {undoable}")]);
    assert_eq!(document.indexed(), after);
    // Another refinement takes its place, and its steps are dropped first.
    run(&mut document, &["Insert 0.5 0.5"]);
    for _ in 0..200 {
        run(&mut document, &["Step"]);
    }
    let (undoable, _) = document.undoable();
    run(&mut document, &[&format!("Undo {undoable}")]);
    assert_eq!(document.triangulation().expect("a triangulation").check(), []);
}
