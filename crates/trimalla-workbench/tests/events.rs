//! The two events of a document.

use trimalla_workbench::{Document, Interface, MessageKind, script};

/// Counts events, and keeps messages.
#[derive(Default)]
struct Counts {
    resets: usize,
    updates: usize,
    messages: Vec<(MessageKind, String)>,
}

impl Interface for Counts {
    fn message(&mut self, kind: MessageKind, text: &str) {
        self.messages.push((kind, text.to_owned()));
    }

    fn reset(&mut self) {
        self.resets += 1;
    }

    fn update(&mut self) {
        self.updates += 1;
    }
}

#[test]
fn the_two_events_come_when_something_has_changed() {
    let (mut document, mut counts) = (Document::new(), Counts::default());
    let mut run = |line: &str| {
        let _ = document.run(line, &mut counts);
        (std::mem::take(&mut counts.resets), std::mem::take(&mut counts.updates))
    };
    for line in ["V 0 0 0", "V 1 4 0", "V 2 0 4"] {
        run(line);
    }
    assert_eq!(run("Triangulate"), (1, 0), "ids that were kept are void");
    assert_eq!(run("V 3 1 1"), (0, 1));
    assert_eq!(run("Flip 0 1"), (0, 0), "nothing has changed");
    assert_eq!(run("Show 3"), (0, 0));
    assert_eq!(run("Undo"), (1, 0));
    assert_eq!(run("Clear"), (1, 0));
}

#[test]
fn messages_are_of_three_kinds() {
    let (mut document, mut counts) = (Document::new(), Counts::default());
    let _ = document.run("Insert 1 2", &mut counts);
    let _ = document.run("Insert 1", &mut counts);
    let kinds: Vec<MessageKind> = counts.messages.iter().map(|(kind, _)| *kind).collect();
    assert_eq!(kinds, [MessageKind::Command, MessageKind::Information, MessageKind::Command, MessageKind::Error]);
    assert_eq!(counts.messages[1].1, "vertex 0 at (1, 2)");
}

#[test]
fn what_is_cancelled_changes_nothing() {
    struct Impatient;
    impl Interface for Impatient {
        fn message(&mut self, _: MessageKind, _: &str) {}

        fn is_cancelled(&self) -> bool {
            true
        }
    }
    let mut document = Document::new();
    for line in ["Generate polygon 40", "Triangulate"] {
        document.run(line, &mut Counts::default()).expect("sound");
    }
    let before = document.indexed();
    let refused = script::run(&mut document, "Clear\nClear\n", true, &mut Impatient);
    assert!(refused.is_empty() && document.indexed() == before, "no line of a script is begun");
    for line in ["LEPP 25", "Refine", "Step 3", "Player nowhere/run.html"] {
        let error = document.run(line, &mut Impatient).expect_err("cancelled");
        assert!(error.message().contains("cancelled"), "{line}: {error}");
        assert_eq!(document.indexed(), before, "{line}");
    }
}

#[test]
fn a_history_over_its_budget_forgets_the_oldest() {
    let (mut document, mut counts) = (Document::with_history(20_000), Counts::default());
    for line in ["Generate random 100", "Triangulate"] {
        document.run(line, &mut counts).expect("points");
    }
    for i in 0..100 {
        document.run(&format!("Insert 0.5 {}", 0.001 * f64::from(i)), &mut counts).expect("a point");
    }
    let told = counts.messages.iter().filter(|(_, text)| text.contains("can no longer be undone")).count();
    assert_eq!(told, 1, "it is said when it begins");
    let (undoable, _) = document.undoable();
    assert!((1..100).contains(&undoable), "{undoable}");
    let error = document.run(&format!("Undo {}", undoable + 1), &mut counts).expect_err("too many");
    assert!(error.message().contains("dropped"), "{error}");
    document.run(&format!("Undo {undoable}"), &mut counts).expect("undone");
    assert_eq!(document.triangulation().expect("a triangulation").check(), []);
}
