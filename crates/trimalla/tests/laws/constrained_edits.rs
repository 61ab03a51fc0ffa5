//! A constrained triangulation survives a hundred thousand random edits, and every edit can be taken back.
//!
//! *Edits*: insertion of points (on a constrained edge they split it), removal of vertices, moves (removal and
//! insertion, and as one edit with the segments at the vertex), segments in with crossings refused and split, segments
//! out and back in, subsegments merged, and carving of a random subset of the faces, followed by edits inside the
//! domain, one of which carves once more, and a rollback.
//!
//! *Claims*
//! 1. The full check is silent after every edit while the triangulation is small, now and then while it is large.
//! 2. A rollback to any remembered state restores the whole struct: arrays, free lists, classes, segments,
//!    provenances. Some of the edits taken back are made once more and lead to the same triangulation.
//! 3. What is refused (a crossing segment, the removal of a vertex at which constraints end, a merge without room)
//!    has changed nothing.
//! 4. Every segment in force is a chain of constrained edges from its start to its end.
//!
//! Where a claim fails the edits that led there are printed as Rust.

#![allow(clippy::print_stdout, reason = "tables for those who look")]

use std::cell::Cell;
use std::rc::Rc;

use crate::common::editing::{Plan, Subject, Tally, drive};
use trimalla::constrained::{ConstrainedDelaunay, ConstraintError, Crossings};
use trimalla::delaunay::{BuildError, Inserted};
use trimalla::drawing::SegmentId;
use trimalla::geometry::Point;
use trimalla::half_edge::{Checkpoint, UndoLog, VertexId};
use trimalla_testkit::generators::{PointSetKind, SplitMix64, point_set};

/// The sorts of edit, as they are counted.
const SORTS: [&str; 18] = [
    "insert free",
    "insert on a segment",
    "remove",
    "removal refused",
    "segment in",
    "segment split in",
    "crossing refused",
    "segment out",
    "merge",
    "merge refused",
    "carve",
    "move",
    "moved with its segments",
    "move refused",
    "removed with its segments",
    "segment back in",
    "carved once more",
    "crossings exhausted",
];

/// A constrained triangulation and the places that edits choose from.
#[derive(Clone)]
struct Edited {
    cdt: ConstrainedDelaunay,
    places: Rc<[Point]>,
    /// Above this many vertices removals become likelier than insertions.
    crowded: usize,
    /// How often each sort of edit was made; shared by all clones.
    counts: Rc<Cell<[usize; SORTS.len()]>>,
}

/// Every array, class, segment and provenance.
impl PartialEq for Edited {
    fn eq(&self, other: &Self) -> bool {
        self.cdt == other.cdt
    }
}

impl Edited {
    fn new(start: usize, places: Vec<Point>, crowded: usize) -> Self {
        let cdt = ConstrainedDelaunay::new(&places[..start], &[], Crossings::Refuse).expect("finite points");
        Self { cdt, places: places.into(), crowded, counts: Rc::default() }
    }

    fn note(&self, sort: usize) {
        let mut counts = self.counts.get();
        counts[sort] += 1;
        self.counts.set(counts);
    }

    /// A place, the place an ulp away, one halfway to another, or the middle of a constrained edge.
    fn draw_point(&self, random: &mut SplitMix64) -> Point {
        let draw = |random: &mut SplitMix64| self.places[random.below(self.places.len())];
        let p = draw(random);
        match random.below(10) {
            0 => Point::new(f64::from_bits(p.x.to_bits() ^ 1), p.y),
            1 => Point::midpoint(p, draw(random)),
            2..=4 => {
                let mut edges: Vec<[VertexId; 2]> = self.constrained_edges();
                edges.sort_unstable();
                if edges.is_empty() {
                    return p;
                }
                let [a, b] = edges[random.below(edges.len())].map(|v| self.cdt.point(v));
                Point::midpoint(a, b)
            }
            _ => p,
        }
    }

    /// Ends of the constrained edges, lower ones first.
    fn constrained_edges(&self) -> Vec<[VertexId; 2]> {
        let marked = self.cdt.edges().filter(|&h| self.cdt.is_marked(h));
        marked.map(|h| [self.cdt.origin(h).min(self.cdt.dest(h)), self.cdt.origin(h).max(self.cdt.dest(h))]).collect()
    }

    fn draw_vertex(&self, random: &mut SplitMix64) -> Option<VertexId> {
        let used: Vec<VertexId> = self.cdt.used_vertices().collect();
        (!used.is_empty()).then(|| used[random.below(used.len())])
    }

    fn insert(&mut self, random: &mut SplitMix64, log: &mut UndoLog) -> String {
        let p = self.draw_point(random);
        let before = self.constrained_edges().len();
        let inserted = self.cdt.insert_with(p, log).expect("a finite point");
        assert_eq!(self.cdt.point(inserted.vertex()), p, "the vertex lies at the point");
        if matches!(inserted, Inserted::New(_)) {
            self.note(usize::from(self.constrained_edges().len() > before));
        }
        format!("d.insert_with(Point::new({:?}, {:?}), &mut log)?;", p.x, p.y)
    }

    fn remove(&mut self, v: VertexId, log: &mut UndoLog) -> String {
        let constrained = self.cdt.star(v).any(|h| self.cdt.dest(h).is_finite() && self.cdt.is_marked(h));
        if constrained {
            let before = self.cdt.clone();
            assert!(self.cdt.remove_with(v, log).is_err(), "a constrained edge ends at {v}");
            assert!(self.cdt == before, "the refused removal of {v} changed something");
            self.note(3);
        } else {
            self.cdt.remove_with(v, log).expect("a free vertex");
            assert!(!self.cdt.is_used(v), "vertex {v} is gone");
            self.note(2);
        }
        format!("d.remove_with(VertexId({v}), &mut log);")
    }

    fn shift(&mut self, v: VertexId, random: &mut SplitMix64, log: &mut UndoLog) -> String {
        let removed = self.remove(v, log);
        self.note(11);
        format!("{removed}\n{}", self.insert(random, log))
    }

    /// Moves a vertex as an editor of drawings does, or removes it, with the segments at it.
    fn drag(&mut self, v: VertexId, random: &mut SplitMix64, log: &mut UndoLog) -> String {
        let before = self.cdt.clone();
        let p = self.draw_point(random);
        let is_removal = random.below(4) == 0;
        let line = if is_removal {
            format!("d.remove_with_segments(VertexId({v}), &mut log);")
        } else {
            format!("d.move_vertex_with(VertexId({v}), Point::new({:?}, {:?}), &mut log);", p.x, p.y)
        };
        let done = if is_removal {
            self.cdt.remove_with_segments(v, log).map(|()| {
                assert!(!self.cdt.is_used(v), "{line}: gone");
                14
            })
        } else {
            self.cdt.move_vertex_with(v, p, log).map(|moved| {
                assert_eq!(self.cdt.point(moved.vertex()), p, "{line}: there");
                assert!(matches!(moved, Inserted::New(_)) || self.cdt == before, "{line}: a place that is taken");
                12
            })
        };
        self.note(done.unwrap_or_else(|error| {
            assert!(self.cdt == before, "{line}: refused with {error}, something changed");
            13
        }));
        line
    }

    /// Puts a segment back in, if there is one that was removed.
    fn segment_back(&mut self, random: &mut SplitMix64, log: &mut UndoLog) -> String {
        let n = self.cdt.segments().len();
        let Some(last) = n.checked_sub(1) else { return String::new() };
        let s = SegmentId::from_index(last - random.below(n.min(8)));
        let before = self.cdt.clone();
        match self.cdt.restore_segment(s, Crossings::Refuse, log) {
            Ok(()) if self.cdt == before => {}
            Ok(()) => {
                assert!(!self.cdt.chain(s).is_empty(), "segment {s} is back");
                self.note(15);
            }
            Err(error) => assert!(self.cdt == before, "segment {s} is refused with {error}, something changed"),
        }
        format!("d.restore_segment(SegmentId({s}), Crossings::Refuse, &mut log);")
    }

    fn segment_in(&mut self, random: &mut SplitMix64, log: &mut UndoLog) -> String {
        let [Some(a), Some(b)] = [self.draw_vertex(random), self.draw_vertex(random)] else { return String::new() };
        let crossings = if random.below(3) == 0 { Crossings::Split } else { Crossings::Refuse };
        let line = format!("d.insert_segment_with(VertexId({a}), VertexId({b}), Crossings::{crossings:?}, &mut log);");
        let before = (crossings == Crossings::Refuse).then(|| self.cdt.clone());
        let as_it_was = self.clone();
        let here = log.checkpoint();
        match self.cdt.insert_segment_with(a, b, crossings, log) {
            Ok(_) => self.note(if crossings == Crossings::Split { 5 } else { 4 }),
            Err(ConstraintError::Crossing(pairs)) => {
                assert!(!pairs.is_empty() && before.is_some(), "{line} named {pairs:?}");
                assert!(before.is_some_and(|b| b == self.cdt), "the refused {line} changed something");
                self.note(6);
            }
            // Counted here, judged at the end: what comes after is worth driving too.
            Err(ConstraintError::CrossingsExhausted { .. }) => {
                self.cdt.rollback(log, here);
                self.note(SORTS.len() - 1);
            }
            Err(e) => panic!("{line} said {e}"),
        }
        let faults = self.cdt.check();
        assert!(faults.is_empty(), "{line}: {faults:?}, begun with\n{}", as_it_was.rebuilding([a, b]));
        line
    }

    /// Rust that builds these points and constrained edges anew, and the ends of the segment to insert.
    fn rebuilding(&self, ends: [VertexId; 2]) -> String {
        let used: Vec<VertexId> = self.cdt.used_vertices().collect();
        let new = |v: VertexId| used.binary_search(&v).unwrap_or(usize::MAX);
        let points: Vec<String> =
            used.iter().map(|&v| self.cdt.point(v)).map(|p| format!("[{:?}, {:?}]", p.x, p.y)).collect();
        let edges: Vec<[usize; 2]> = self.constrained_edges().iter().map(|e| e.map(new)).collect();
        format!(
            "let points = [{}].map(Point::from);\nlet segments = {edges:?};\n// then {:?}",
            points.join(", "),
            ends.map(new)
        )
    }

    fn segment_out(&mut self, random: &mut SplitMix64, log: &mut UndoLog) -> String {
        let n = self.cdt.segments().len();
        if n == 0 {
            return String::new();
        }
        // The newest ones are likelier: most of the old ones are out already.
        let s = if random.below(3) == 0 { random.below(n) } else { n - 1 - random.below(n.min(8)) };
        let s = SegmentId::from_index(s);
        if self.cdt.remove_segment_with(s, log) {
            self.note(7);
        }
        assert!(self.cdt.chain(s).is_empty(), "segment {s} is out");
        format!("d.remove_segment_with(SegmentId({s}), &mut log);")
    }

    fn merge(&mut self, random: &mut SplitMix64, log: &mut UndoLog) -> String {
        let steiner: Vec<VertexId> =
            self.cdt.used_vertices().filter(|v| v.index() >= self.cdt.input_points()).collect();
        let degree =
            |v: &VertexId| self.cdt.star(*v).filter(|&h| self.cdt.dest(h).is_finite() && self.cdt.is_marked(h)).count();
        let on: Vec<VertexId> = steiner.into_iter().filter(|v| degree(v) > 0).collect();
        if on.is_empty() {
            return String::new();
        }
        let v = on[random.below(on.len())];
        let before = self.cdt.clone();
        if self.cdt.merge_subsegments(v, log).is_ok() {
            assert!(!self.cdt.is_used(v), "vertex {v} is gone");
            self.note(8);
        } else {
            assert!(self.cdt == before, "the refused merge at {v} changed something");
            self.note(9);
        }
        format!("d.merge_subsegments(VertexId({v}), &mut log);")
    }

    /// Carves, edits inside, rolls back, all in one.
    fn carve(&mut self, random: &mut SplitMix64, log: &mut UndoLog) -> String {
        let seed = random.next_u64();
        if self.cdt.dimension() < 2 {
            return String::new();
        }
        let before = self.cdt.clone();
        let here = log.checkpoint();
        let mut own = SplitMix64::new(seed);
        let share = 1 + own.below(6);
        let keep: Vec<bool> = (0..self.cdt.face_slots()).map(|_| own.below(share + 1) > 0).collect();
        let line = format!("// carve, edits and rollback, seed {seed}");
        if !self.cdt.carve(&keep, log) {
            assert!(self.cdt == before, "nothing was kept, something changed");
            return line;
        }
        self.note(10);
        assert_eq!(self.cdt.check(), [], "{line}: carved");
        for step in 0..own.below(6) {
            match own.below(6) {
                0 | 1 => match self.cdt.insert_with(self.draw_point(&mut own), log) {
                    Ok(_) | Err(BuildError::OutsideDomain(_)) => {}
                    Err(e) => panic!("{line}: {e}"),
                },
                2 => {
                    if let Some(v) = self.draw_vertex(&mut own) {
                        // Refused where constraints end at it, as on the whole boundary.
                        let _ = self.cdt.remove_with(v, log);
                    }
                }
                3 => {
                    if let Some(v) = self.draw_vertex(&mut own) {
                        // Refused on the whole boundary.
                        let _ = self.cdt.move_vertex_with(v, self.draw_point(&mut own), log);
                    }
                }
                4 => {
                    let keep: Vec<bool> = (0..self.cdt.face_slots()).map(|_| own.below(5) > 0).collect();
                    if self.cdt.carve(&keep, log) {
                        self.note(16);
                    }
                }
                _ => {
                    if let (Some(a), Some(b)) = (self.draw_vertex(&mut own), self.draw_vertex(&mut own)) {
                        match self.cdt.insert_segment_with(a, b, Crossings::Refuse, log) {
                            Ok(_) | Err(ConstraintError::Crossing(_) | ConstraintError::LeavesDomain { .. }) => {}
                            Err(e) => panic!("{line}: {e}"),
                        }
                    }
                }
            }
            assert_eq!(self.cdt.check(), [], "{line}: step {step} inside");
        }
        self.cdt.rollback(log, here);
        assert!(self.cdt == before, "{line}: not restored");
        line
    }

    /// Segments in force that are no chain to their end.
    fn broken_chains(&self) -> Vec<String> {
        let segments = self.cdt.segment_ids().zip(self.cdt.segments());
        let broken = segments.filter(|&(s, &[_, b])| {
            let chain = self.cdt.chain(s);
            chain.last().is_some_and(|&h| self.cdt.dest(h) != b)
        });
        broken.map(|(s, ends)| format!("the chain of segment {s} {ends:?} is broken")).collect()
    }
}

impl Subject for Edited {
    fn edit(&mut self, random: &mut SplitMix64, log: &mut UndoLog) -> String {
        let crowded = self.size() > self.crowded;
        match (random.below(22), self.draw_vertex(random)) {
            (0..=2, Some(v)) => self.remove(v, log),
            (3..=7, Some(v)) if crowded => self.remove(v, log),
            (8, Some(v)) => self.shift(v, random, log),
            (9..=11, _) => self.segment_in(random, log),
            (12 | 13, _) => self.segment_out(random, log),
            (14, _) if crowded => self.segment_out(random, log),
            (15, _) => self.merge(random, log),
            (16, _) => self.carve(random, log),
            (17, Some(v)) => self.drag(v, random, log),
            (18, _) => self.segment_back(random, log),
            _ => self.insert(random, log),
        }
    }

    fn rollback(&mut self, log: &mut UndoLog, to: Checkpoint) {
        self.cdt.rollback(log, to);
    }

    fn faults(&self) -> Vec<String> {
        let faults = self.cdt.check().iter().map(ToString::to_string).collect::<Vec<_>>();
        [faults, self.broken_chains()].concat()
    }

    fn size(&self) -> usize {
        self.cdt.used_vertices().count()
    }

    fn is_alike(&self, other: &Self) -> bool {
        crate::common::alike::alike(&self.cdt, &other.cdt).is_ok()
    }
}

/// The points and segments that are left, triangulated at once, give the same.
fn assert_same_as_rebuilt(edited: &Edited) {
    let d = &edited.cdt;
    let used: Vec<VertexId> = d.used_vertices().collect();
    let points: Vec<Point> = used.iter().map(|&v| d.point(v)).collect();
    let new = |v: VertexId| used.binary_search(&v).expect("a used vertex") as u32;
    let segments: Vec<[u32; 2]> = edited.constrained_edges().iter().map(|e| e.map(new)).collect();
    let rebuilt = ConstrainedDelaunay::new(&points, &segments, Crossings::Refuse).expect("edges do not cross");
    let old = |t: &[VertexId; 3]| t.map(|v| used[v.index()]);
    assert_eq!(rebuilt.canonical().iter().map(old).collect::<Vec<_>>(), d.canonical(), "triangles");
}

fn run(edited: Edited, plan: Plan) -> (Tally, [usize; SORTS.len()]) {
    let (edited, tally) = drive(edited, plan);
    assert_same_as_rebuilt(&edited);
    (tally, edited.counts.get())
}

#[test]
fn a_hundred_thousand_edits_stay_constrained_delaunay_and_are_taken_back() {
    // From this seed on segments are led past one of their own vertices twice, which must leave one path.
    let small = PointSetKind::ALL.into_iter().zip(1000..).map(|(kind, seed)| {
        let places = point_set(kind, 24, seed);
        let places = if places.is_empty() { vec![Point::default()] } else { places };
        let start = places.len() / 2;
        run(Edited::new(start, places, 18), Plan { seed, edits: 2300, small: 48, every: 4, rollback_in: 12 })
    });
    let medium = [PointSetKind::Uniform, PointSetKind::TenthGrid, PointSetKind::IntegerGrid].into_iter().zip(100..);
    let medium = medium.map(|(kind, seed)| {
        let places = point_set(kind, 300, seed);
        run(Edited::new(150, places, 200), Plan { seed, edits: 3500, small: 30, every: 12, rollback_in: 30 })
    });
    let mut tally = Tally::default();
    let mut counts = [0; SORTS.len()];
    for (t, c) in small.chain(medium) {
        tally = tally.plus(t);
        counts.iter_mut().zip(c).for_each(|(sum, n)| *sum += n);
    }
    println!("{tally:?}\n{:?}", SORTS.iter().zip(counts).collect::<Vec<_>>());
    assert!(tally.edits >= 100_000 && tally.rollbacks >= 5_000 && tally.checks >= 50_000, "{tally:?}");
    assert_eq!(counts[SORTS.len() - 1], 0, "crossings whose splitting did not end");
    assert!(counts[..SORTS.len() - 1].iter().all(|&n| n > 100), "{:?}", SORTS.iter().zip(counts).collect::<Vec<_>>());
}
