//! A robot edits, with undo and redo: what it leaves leads there again from the record, and is undone to nothing. After
//! every command the names of vertices are those that a slow reading of the whole triangulation gives.

use std::collections::BTreeMap;

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
            // One step at a time, as a vertex may come and go between two.
            28 => "Step".to_owned(),
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

/// The names of vertices, kept by looking at all of them after each command.
#[derive(Clone, Debug, Default, PartialEq)]
struct SlowNames(BTreeMap<u32, VertexId>);

impl SlowNames {
    /// The names after a command, which were these before it.
    fn after(mut self, line: &str, document: &Document) -> Self {
        let points = document.drawing().points.len();
        let words: Vec<&str> = line.split(' ').collect();
        let given = if words[0] == "V" { words[1].parse().ok() } else { None };
        let Some(t) = document.triangulation() else {
            if words[0] == "Reset" {
                self.0.retain(|_, v| v.index() < points);
            }
            let named = self.0.values().map(|v| v.index() + 1).max().unwrap_or(0);
            for v in (named..points).map(VertexId::from_index) {
                self.0.insert(given.unwrap_or_else(|| self.next()), v);
            }
            self.0.retain(|_, v| v.index() < points);
            return self;
        };
        self.0.retain(|_, v| v.index() < t.points().len() && (v.index() < points || t.is_used(*v)));
        if let Some(name) = given {
            self.0.insert(name, document.vertex(name).expect("a vertex"));
        } else if words[0] == "Insert" && !t.used_vertices().any(|v| self.is_nameless(v)) {
            // It lies on another vertex, and stands for it.
            self.0.insert(self.next(), t.used_vertices().find(|&v| at(t.point(v), &words)).expect("a vertex"));
        }
        for v in t.used_vertices() {
            if self.is_nameless(v) {
                self.0.insert(self.next(), v);
            }
        }
        self
    }

    fn next(&self) -> u32 {
        self.0.last_key_value().map_or(0, |(&name, _)| name + 1)
    }

    fn is_nameless(&self, v: VertexId) -> bool {
        !self.0.values().any(|&other| other == v)
    }

    /// Compares with the document's.
    fn assert_same(&self, document: &Document, line: &str) {
        let t = document.triangulation();
        for (&name, &v) in &self.0 {
            let v = t.map_or(v, |t| t.representative(v));
            assert_eq!(document.vertex(name), Some(v), "vertex {name} after {line}");
        }
        let mut lowest = BTreeMap::new();
        for (&name, &v) in self.0.iter().rev() {
            lowest.insert(v, name);
        }
        for (v, name) in lowest {
            assert_eq!(document.name(v), name, "the name of {v:?} after {line}");
        }
        for name in self.next()..self.next() + 3 {
            assert_eq!(document.vertex(name), None, "no vertex {name} after {line}");
        }
    }
}

/// Whether a point is that of a command.
fn at(p: trimalla::geometry::Point, words: &[&str]) -> bool {
    [p.x, p.y] == [1, 2].map(|i| words[i].parse::<f64>().expect("a coordinate"))
}

/// The names after each command that can be undone, and after each that can be done again.
#[derive(Default)]
struct SlowHistory {
    now: SlowNames,
    before: Vec<SlowNames>,
    undone: Vec<SlowNames>,
}

impl SlowHistory {
    /// Follows a command that was done; `undoable` is what the document says then.
    fn follow(&mut self, line: &str, document: &Document) {
        let (undoable, _) = document.undoable();
        match line.split(' ').next() {
            Some("Undo") => {
                while self.before.len() > undoable {
                    let before = self.before.pop().expect("a command");
                    self.undone.push(std::mem::replace(&mut self.now, before));
                }
            }
            Some("Redo") => {
                while self.before.len() < undoable {
                    let after = self.undone.pop().expect("a command that was undone");
                    self.before.push(std::mem::replace(&mut self.now, after));
                }
            }
            _ if undoable > self.before.len() => {
                self.undone.clear();
                self.before.push(self.now.clone());
                self.now = std::mem::take(&mut self.now).after(line, document);
            }
            _ => {}
        }
        self.now.assert_same(document, line);
    }
}

#[test]
fn an_edit_storm_is_recorded_and_undone_exactly() {
    let (actions, most) = (10_000, 120);
    let mut robot = Robot { random: SplitMix64::new(17), redo: 0 };
    let mut document = Document::new();
    // The mesh of a few points stays small.
    document.run("Set max-vertices 400", &mut Quiet).expect("an option");
    let (mut done, mut names) = (0, SlowHistory::default());
    names.follow("Set max-vertices 400", &document);
    for action in 0..actions {
        let line = robot.command(&document);
        if document.run(&line, &mut Quiet).is_ok() {
            done += 1;
            names.follow(&line, &document);
        }
        if let Some(t) = document.triangulation() {
            assert_eq!(t.check(), [], "after action {action}, {line}");
            if t.points().len() > most {
                for line in ["Clear", "Set max-vertices 400"] {
                    document.run(line, &mut Quiet).expect("cleared");
                    names.follow(line, &document);
                }
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
