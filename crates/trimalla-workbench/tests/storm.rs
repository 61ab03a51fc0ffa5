//! A robot edits, with undo and redo: what it leaves leads there again from the record, and is undone to nothing.

use trimalla::half_edge::VertexId;
use trimalla_testkit::generators::SplitMix64;
use trimalla_workbench::{Document, Quiet};

/// Chooses commands; half of them make no sense.
struct Robot {
    random: SplitMix64,
    /// How many commands are to be done again.
    redo: usize,
}

impl Robot {
    fn below(&mut self, n: usize) -> usize {
        (self.random.next_u64() % n.max(1) as u64) as usize
    }

    /// A coordinate on a coarse grid, so that points coincide and are collinear.
    fn coordinate(&mut self) -> f64 {
        if self.below(4) == 0 { self.random.unit() * 8.0 } else { self.below(17) as f64 * 0.5 }
    }

    /// The index of a vertex, now and then of none.
    fn index(&mut self, document: &Document) -> u32 {
        let points = document.triangulation().map_or(document.drawing().points.len(), |t| t.points().len());
        let v = VertexId::from_index(self.below(points));
        if self.below(20) == 0 { v.0 + 1000 } else { document.name(v) }
    }

    fn command(&mut self, document: &Document) -> String {
        let triangle = document.triangulation().and_then(|t| {
            let faces: Vec<_> = t.real_faces().collect();
            let f = *faces.get(self.below(faces.len()))?;
            Some(t.face_vertices(f).map(|v| document.name(v)))
        });
        let [i, j, k] = triangle.unwrap_or([0, 1, 2]);
        let (x, y, a, b) = (self.coordinate(), self.coordinate(), self.index(document), self.index(document));
        if self.redo > 0 {
            let times = std::mem::take(&mut self.redo);
            return format!("Redo {times}");
        }
        match self.below(40) {
            0..=8 => format!("Insert {x} {y}"),
            9 => format!("V {} {x} {y}", 1000 + self.below(4000)),
            10..=12 => format!("Edge {a} {b}"),
            13..=15 => "Triangulate".to_owned(),
            16..=18 => format!("Move {a} {x} {y}"),
            19 | 20 => format!("Delete {a}"),
            21 | 22 => format!("Flip {i} {j}"),
            23 => format!("Release {i} {j}"),
            24 => format!("Midpoint {i} {j} {k}"),
            25 => format!("Centroid {i} {j} {k}"),
            26 => format!("LEPP {} CEN", self.below(28)),
            27 => format!("Select {i} {j} {k}"),
            28 => format!("Step {}", self.below(6)),
            29 => "Refine".to_owned(),
            30 => format!("Set min-angle {}", self.below(25)),
            31 => "Reset".to_owned(),
            32 if self.below(8) == 0 => "Clear".to_owned(),
            33..=36 => {
                let times = 1 + self.below(4);
                self.redo = self.below(times + 1);
                format!("Undo {times}")
            }
            _ => format!("Redo {}", 1 + self.below(3)),
        }
    }
}

#[test]
fn an_edit_storm_is_recorded_and_undone_exactly() {
    let (actions, most) = (10_000, 120);
    let mut robot = Robot { random: SplitMix64::new(17), redo: 0 };
    let mut document = Document::new();
    // The mesh of a few points stays small.
    document.run("Set max-vertices 400", &mut Quiet).expect("an option");
    let mut done = 0;
    for action in 0..actions {
        let line = robot.command(&document);
        done += usize::from(document.run(&line, &mut Quiet).is_ok());
        if let Some(t) = document.triangulation() {
            assert_eq!(t.check(), [], "after action {action}, {line}");
            if t.points().len() > most {
                document.run("Clear", &mut Quiet).expect("cleared");
                document.run("Set max-vertices 400", &mut Quiet).expect("an option");
            }
        }
    }
    assert!(done > actions / 3, "only {done} commands made sense");
    let script = document.script();
    let mut again = Document::new();
    for line in script.lines() {
        again.run(line, &mut Quiet).unwrap_or_else(|error| panic!("{line}: {error}"));
    }
    assert_eq!(again.script(), script);
    assert!(again == document, "the record leads elsewhere");
    assert_eq!(again.indexed(), document.indexed());
    let (undoable, _) = document.undoable();
    document.run(&format!("Undo {undoable}"), &mut Quiet).expect("undone");
    assert!(document == Document::new(), "undone, it is not empty");
    document.run(&format!("Redo {undoable}"), &mut Quiet).expect("done again");
    assert!(document == again, "done again, it is another one");
}
