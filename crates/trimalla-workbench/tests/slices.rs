//! Commands that are done slice by slice: the same documents, one command each in the history, stopped at once.

use std::cell::Cell;

use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build_exactly};
use trimalla::geometry::math;
use trimalla_io::{Files, Memory};
use trimalla_workbench::{Advanced, CommandError, Document, Interface, MessageKind, Quiet, script};

/// Does a command slice by slice; how many slices there were.
fn advance_all(
    document: Document,
    line: &str,
    interface: &mut dyn Interface,
) -> (Document, Result<(), CommandError>, usize) {
    let mut running = document.begin(line);
    for slices in 1.. {
        match running.advance(interface) {
            Advanced::More(rest) => running = rest,
            Advanced::Done(document, outcome) => return (document, outcome, slices),
        }
    }
    unreachable!("a command ends")
}

fn drawn(text: &str) -> Document {
    let mut document = Document::new();
    assert_eq!(script::run(&mut document, text, false, &mut Quiet), []);
    document
}

const DRAWINGS: [&str; 4] = [
    "Generate polygon 40 3\nTriangulate\nSet max-area 0.0002",
    "Generate random 900 2\nTriangulate\nSet min-angle 30",
    "Generate polygon 12 5\nTriangulate\nSet preset lepp-centroid\nSet min-angle 25\nStep 3",
    "Generate grid 2500\nTriangulate\nFlip 52 101\nSet max-area 0.0001",
];

#[test]
fn a_refinement_in_slices_is_the_refinement() {
    let mut most = 0;
    for text in DRAWINGS {
        let mut whole = drawn(text);
        whole.run("Refine", &mut Quiet).expect("refined");
        let (mut sliced, outcome, slices) = advance_all(drawn(text), "Refine", &mut Quiet);
        assert_eq!((outcome, &sliced), (Ok(()), &whole), "{text}");
        assert_eq!(sliced.script(), whole.script());
        assert_eq!(sliced.undoable(), whole.undoable());
        most = most.max(slices);
        sliced.run("Undo", &mut Quiet).expect("undone");
        assert_eq!(sliced, drawn(text));
        sliced.run("Redo", &mut Quiet).expect("done again");
        assert_eq!(sliced, whole);
    }
    assert!(most > 10, "{most} slices at most: none of them is long");
}

#[test]
fn a_refinement_does_not_depend_on_where_it_is_cut() {
    // The library's own loop, uncut.
    use trimalla::refine::{Observer, Progress, Refinement};
    struct Uncut;
    impl Observer for Uncut {
        fn progress(&mut self, _: Progress) -> bool {
            true
        }
    }
    let document = drawn(DRAWINGS[0]);
    let t = document.triangulation().expect("triangulated").clone();
    let cdt = ConstrainedDelaunay::from(t);
    let mut refinement = Refinement::new(cdt, document.options().refine_options()).expect("options");
    refinement.run(&mut Uncut);
    let (uncut, _) = refinement.finish();
    let (sliced, ..) = advance_all(document, "Refine", &mut Quiet);
    assert_eq!(sliced.triangulation(), Some(&uncut));
}

#[test]
fn steps_in_slices_are_the_steps() {
    let text = "Generate polygon 20 2\nTriangulate";
    for line in ["Step 0", "Step", "Step 7", "Step 100000"] {
        let mut whole = drawn(text);
        whole.run(line, &mut Quiet).expect("stepped");
        let (mut sliced, outcome, _) = advance_all(drawn(text), line, &mut Quiet);
        assert_eq!((outcome, &sliced), (Ok(()), &whole), "{line}");
        sliced.run("Undo", &mut Quiet).expect("undone");
        assert_eq!(sliced, drawn(text), "{line}");
        sliced.run("Redo", &mut Quiet).expect("done again");
        assert_eq!(sliced, whole, "{line}");
    }
}

/// A drawing in memory: a star of so many corners, and two segments that cross.
fn star(corners: usize) -> Files {
    let at = |i: usize| {
        let (turn, radius) = (i as f64 / corners as f64 * std::f64::consts::TAU, if i % 2 == 0 { 1.0 } else { 0.9 });
        format!("{i} {} {}\n", radius * math::cos(turn), radius * math::sin(turn))
    };
    let side = |i: usize| format!("{i} {i} {}\n", (i + 1) % corners);
    let mut text = format!("{corners} 2 0 0\n") + &(0..corners).map(at).collect::<String>();
    text += &format!("{} 0\n", corners + 2);
    text.extend((0..corners).map(side));
    text += &format!("{corners} 0 {}\n{} {} {}\n0\n", corners / 2, corners + 1, corners / 4, 3 * corners / 4);
    let memory = Memory::default();
    memory.put("star.poly", text.as_bytes());
    Files::Memory(memory)
}

/// Commands with slices besides those of refinements, each behind what comes before it; how many slices they take at
/// least.
const OTHERS: [(&str, &str, usize); 9] = [
    ("", "Generate random 70000 3", 5),
    ("", "Generate grid 20000", 2),
    ("", "Generate polygon 30", 1),
    ("Generate random 40000 2", "Triangulate", 10),
    ("Generate grid 2500", "Triangulate DAC", 3),
    ("Generate polygon 400 4", "Triangulate", 2),
    ("Generate polygon 40 4", "Triangulate ears", 2),
    ("Generate random 900 2\nTriangulate", "LEPP 28", 5),
    ("Generate grid 900\nTriangulate\nFlip 32 61", "LEPP 28 MID", 2),
];

#[test]
fn other_commands_in_slices_are_the_commands() {
    for (text, line, least) in OTHERS {
        let mut whole = drawn(text);
        whole.run(line, &mut Quiet).expect("done");
        let (mut sliced, outcome, slices) = advance_all(drawn(text), line, &mut Quiet);
        assert_eq!((outcome, &sliced), (Ok(()), &whole), "{line}");
        assert!(slices >= least, "{line}: {slices} slices");
        assert_eq!((sliced.undoable(), sliced.script()), (whole.undoable(), whole.script()), "{line}");
        sliced.run("Undo", &mut Quiet).expect("undone");
        assert_eq!(sliced, drawn(text), "{line}");
        sliced.run("Redo", &mut Quiet).expect("done again");
        assert_eq!(sliced, whole, "{line}");
    }
}

#[test]
fn other_commands_stop_between_slices() {
    for (text, line, least) in OTHERS.into_iter().filter(|(.., least)| *least > 1) {
        let mut interface = Impatient { left: Cell::new(least - 1), error: String::new() };
        let (document, outcome, slices) = advance_all(drawn(text), line, &mut interface);
        // One more parses the line.
        assert!(outcome.is_err() && slices <= least + 1, "{line}: {slices} slices, {outcome:?}");
        assert!(interface.error.contains("cancelled"), "{line}: {}", interface.error);
        assert_eq!(document, drawn(text), "{line}");
        assert_eq!(document.undoable(), drawn(text).undoable(), "{line}");
    }
}

#[test]
fn a_triangulation_in_slices_is_that_of_the_library() {
    // A file with segments that cross.
    let document = Document::new().with_files(star(5000));
    let (document, loaded, slices) = advance_all(document, "Load star.poly", &mut Quiet);
    assert_eq!((loaded, slices), (Ok(()), 3), "parsed, read, put in place");
    let drawing = document.drawing().clone();
    let (document, triangulated, slices) = advance_all(document, "Triangulate", &mut Quiet);
    assert!(triangulated.is_ok() && slices > 6, "{slices} slices");
    let whole = build_exactly(&drawing, DomainRule::Seeds, Crossings::Split, AlgorithmKey::Incremental);
    let (whole, _) = whole.expect("triangulated");
    assert_eq!(document.triangulation(), Some(&*whole));
    assert_eq!(whole.steiner_vertices(), 1, "the crossing");
    // Points alone, some of them twice, and points on a line.
    for text in ["Generate random 9000 7\nGenerate grid 900\nGenerate grid 400", "V 0 0 0\nV 1 2 2\nV 2 1 1\nV 3 1 1"] {
        let document = drawn(text);
        let points = document.drawing().points.clone();
        let (document, ..) = advance_all(document, "Triangulate INC", &mut Quiet);
        let whole = ConstrainedDelaunay::new(&points, &[], Crossings::Refuse).expect("triangulated");
        assert_eq!(document.triangulation(), Some(&*whole), "{text}");
    }
}

/// Cancels after so many questions, and keeps the last error.
struct Impatient {
    left: Cell<usize>,
    error: String,
}

impl Interface for Impatient {
    fn message(&mut self, kind: MessageKind, text: &str) {
        if kind == MessageKind::Error {
            self.error = text.to_owned();
        }
    }

    fn is_cancelled(&self) -> bool {
        let left = self.left.get();
        self.left.set(left.saturating_sub(1));
        left == 0
    }
}

#[test]
fn what_is_cancelled_between_slices_has_changed_nothing() {
    let mut cancelled = 0;
    for (text, line) in DRAWINGS.into_iter().flat_map(|text| [(text, "Refine"), (text, "Step 50")]) {
        for left in [0, 1, 2, 5] {
            let mut interface = Impatient { left: Cell::new(left), error: String::new() };
            let (document, outcome, slices) = advance_all(drawn(text), line, &mut interface);
            // Small ones are done before so many questions.
            let Err(error) = outcome else { continue };
            let error = error.to_string();
            cancelled += 1;
            assert!(error.contains("cancelled"), "{error}");
            assert_eq!(interface.error, error, "the error is shown");
            assert!(slices <= left + 3, "{line}: stopped after {slices} slices for {left} questions");
            assert_eq!(document, drawn(text), "{line}");
            assert_eq!(document.undoable(), drawn(text).undoable());
        }
    }
    assert!(cancelled >= 20, "only {cancelled} of 32 were cancelled");
}

#[test]
fn what_has_no_slices_or_is_refused_is_done_at_once() {
    for (line, is_fine) in [("", true), ("# nothing", true), ("V 0 0 0", true), ("Nonsense", false), ("Refine", false)]
    {
        let (document, outcome, slices) = advance_all(Document::new(), line, &mut Quiet);
        assert_eq!(outcome.is_ok(), is_fine, "{line}");
        assert!(slices <= 2, "{line}: {slices} slices");
        assert_eq!(document.figures().vertices, usize::from(line.starts_with('V')));
    }
}

#[test]
fn a_long_command_shows_the_triangulation_while_it_works() {
    #[derive(Default)]
    struct Growing(Vec<usize>);
    impl Interface for Growing {
        fn message(&mut self, _: MessageKind, _: &str) {}

        fn progress(&mut self, triangulation: &trimalla::constrained::ConstrainedTriangulation) {
            self.0.push(triangulation.real_faces().count());
        }
    }
    let mut document = drawn(DRAWINGS[0]);
    let mut growing = Growing::default();
    document.run("Refine", &mut growing).expect("refined");
    assert!(growing.0.len() > 3 && growing.0.is_sorted(), "{:?}", growing.0);
    assert!(growing.0[0] < document.figures().triangles);
}
