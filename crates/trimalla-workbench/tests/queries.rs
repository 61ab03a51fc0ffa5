//! What a document tells: the steps of a refinement, its runs, its history, histograms, and what an edge would do.

use trimalla_workbench::{Construction, Document, Interface, MessageKind, NamedPoint, Quiet, script};

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

/// Keeps what the document says.
#[derive(Default)]
struct Said(Vec<String>);

impl Interface for Said {
    fn message(&mut self, kind: MessageKind, text: &str) {
        if kind == MessageKind::Information {
            self.0.push(text.to_owned());
        }
    }
}

/// What the document says of a command.
fn said(document: &mut Document, line: &str) -> Vec<String> {
    let mut said = Said::default();
    document.run(line, &mut said).unwrap_or_else(|error| panic!("{line}: {error}"));
    said.0
}

#[test]
fn a_plan_tells_the_recursion_on_both_sides() {
    let begin = ["V 0 0 0", "V 1 9 0", "V 2 1 1", "V 3 4 3", "V 4 8 1", "V 5 4 -1", "Triangulate"];
    let mut document = after(&begin);
    let plan = document.edge_plan(0, 1).expect("a plan");
    let names = |vertices: &[NamedPoint]| vertices.iter().map(|v| v.name).collect::<Vec<_>>();
    assert_eq!(names(&plan.right.boundary), [1, 5, 0]);
    assert_eq!(names(&plan.left.boundary).first(), Some(&0));
    assert_eq!(plan.left.calls.len() + 2, plan.left.boundary.len());
    assert_eq!(plan.crossed.len(), plan.left.boundary.len() + plan.right.boundary.len() - 5);
    let said = said(&mut document, "Plan 0 1");
    assert_eq!(said.iter().filter(|line| line.contains("chosen")).count(), plan.left.calls.len() + 1);
    assert!(said.contains(&"  right: base 1-0, tried 5, chosen 5, left 1 5 and 5 0".to_owned()), "{said:#?}");
    run(&mut document, &["Edge 0 1"]);
    for side in [&plan.left, &plan.right] {
        for call in &side.calls {
            let triangle = [call.first, call.last, call.chosen].map(|i| side.boundary[i].name);
            assert!(document.face(triangle).is_some(), "{triangle:?} is there");
        }
    }
    let there = document.edge_plan(1, 0).expect("a plan");
    assert!(there.is_there && there.left.boundary.is_empty() && there.right.calls.is_empty());
    assert!(document.edge_plan(0, 0).is_err() && document.edge_plan(0, 77).is_err());
    assert!(Document::new().edge_plan(0, 1).is_err());
}

#[test]
fn a_long_side_of_a_plan_is_told_without_calls() {
    let mut document = Document::new();
    // Two rows of points, between which the edge leads.
    let row = |document: &mut Document, y: f64| {
        for i in 0..2500 {
            run(document, &[&format!("Insert {} {}", 0.001 * f64::from(i), y * (1.0 + 1e-9 * f64::from(i * i)))]);
        }
    };
    run(&mut document, &["V 0 -1 0", "V 1 4 0"]);
    row(&mut document, 0.01);
    row(&mut document, -0.01);
    run(&mut document, &["Triangulate DAC"]);
    let plan = document.edge_plan(0, 1).expect("a plan");
    assert_eq!((plan.left.boundary.len(), plan.right.boundary.len()), (2502, 2502));
    assert!(plan.left.calls.is_empty() && plan.right.calls.is_empty());
}

#[test]
fn runs_are_told_and_undone_with_their_commands() {
    let mut document = after(&["Generate polygon 40 5", "Triangulate", "Set min-angle 25", "Set max-vertices 400"]);
    let vertices = |document: &Document| document.runs().iter().map(|run| run.after.vertices).collect::<Vec<_>>();
    let whole = said(&mut document, "Refine");
    let run_of_refine = document.runs()[0].clone();
    assert_eq!((run_of_refine.before.vertices, run_of_refine.after.vertices), (40, document.figures().vertices));
    assert_eq!(run_of_refine.after.min_angle_deg, Some(document.figures().min_angle_deg));
    assert!(whole.iter().any(|line| line.trim() == "angle asked: 25 degrees"), "{whole:#?}");
    let told = said(&mut document, "Stats");
    assert!(run_of_refine.lines().iter().all(|line| told.contains(&format!("  {line}"))), "{told:#?}");
    run(&mut document, &["Undo"]);
    assert!(document.runs().is_empty() && document.run_so_far().is_none());

    // Step by step it is the same run, which is told once, at its end.
    run(&mut document, &["Step 3"]);
    let begun = document.run_so_far().expect("a refinement at work");
    assert_eq!(begun.before, run_of_refine.before);
    assert!(begun.after.vertices < run_of_refine.after.vertices && document.runs().is_empty());
    run(&mut document, &["Step 1000", "Step", "Step"]);
    assert_eq!(document.runs(), std::slice::from_ref(&run_of_refine));
    assert_eq!(document.history().last(), Some("Step 1000"), "steps after the end change nothing");
    run(&mut document, &["Undo", "Redo"]);
    assert_eq!(document.runs(), std::slice::from_ref(&run_of_refine));
    run(&mut document, &["Undo"]);
    assert!(document.runs().is_empty());
    run(&mut document, &["Redo"]);
    assert_eq!(document.runs(), std::slice::from_ref(&run_of_refine));

    run(&mut document, &["LEPP 27 MID"]);
    let run_of_lepp = document.runs()[1].clone();
    assert_eq!(run_of_lepp.before, run_of_refine.after);
    assert_eq!(vertices(&document), [run_of_refine.after.vertices, document.figures().vertices]);
    let added = run_of_lepp.after.vertices - run_of_lepp.before.vertices;
    let paths = run_of_lepp.path_lengths.iter().sum::<u64>();
    assert_eq!(
        paths,
        (added + run_of_lepp.leftovers) as u64,
        "a path for each vertex, and for each triangle that is left"
    );
    assert_eq!(run_of_lepp.options.min_angle_deg, Some(27.0));
    // Those that replace everything keep their run for 'Redo'.
    run(&mut document, &["Undo 4", "Redo 4"]);
    assert_eq!(document.runs(), [run_of_refine, run_of_lepp]);
}

#[test]
fn histograms_count_every_triangle() {
    let mut document = after(&["Generate random 50 4"]);
    assert_eq!(document.angle_histogram().total(), 0);
    assert!(document.path_lengths().is_empty());
    run(&mut document, &["Triangulate"]);
    let figures = document.figures();
    let histogram = document.angle_histogram();
    assert_eq!(histogram.total(), figures.triangles);
    let first = histogram.counts.iter().position(|&count| count > 0).expect("a triangle");
    assert!(
        histogram.range_deg(first)[0] <= figures.min_angle_deg && figures.min_angle_deg < histogram.range_deg(first)[1]
    );
    let lengths = document.path_lengths();
    assert_eq!(lengths.iter().sum::<u64>(), figures.triangles as u64);
    assert_eq!(lengths[0], 0, "each path has its own triangle at least");
}

#[test]
fn an_algorithm_that_tells_its_steps_is_watched() {
    let mut document = Document::new();
    let text = "Generate polygon 12 3\nTriangulate ears\n";
    assert_eq!(script::run(&mut document, text, false, &mut Quiet), []);
    let construction = document.construction().expect("ears tell their steps");
    let all = construction.steps().len();
    assert!(all >= 10, "{all} steps");
    assert_eq!(construction.shown(), all);
    let before = document.indexed();
    document.run("Watch 3", &mut Quiet).expect("three");
    assert_eq!(document.construction().map(Construction::shown), Some(3));
    assert_eq!(document.indexed(), before, "the triangulation stays");
    document.run("Undo", &mut Quiet).expect("undone");
    assert_eq!(document.construction().map(Construction::shown), Some(all));
    let corners = before.expect("it is triangulated").triangles[0].map(|v| v.to_string()).join(" ");
    document.run(&format!("Centroid {corners}"), &mut Quiet).expect("an edit");
    assert!(document.construction().is_none(), "they are steps to another triangulation");
    assert!(document.run("Watch", &mut Quiet).is_err());
    document.run("Undo", &mut Quiet).expect("undone");
    assert_eq!(document.construction().map(Construction::shown), Some(all));
    document.run("Undo", &mut Quiet).expect("undone");
    assert!(document.construction().is_none() && document.triangulation().is_none());
}
