//! A hundred thousand random edits of Delaunay triangulations, taken back at random.
//!
//! Points are inserted, removed and moved among hostile places: those of the testkit's kinds, again
//! and again the same ones, their neighbours one ulp away and points halfway between two of them.
//! After every edit of a small triangulation every invariant is checked, the circle test with ties
//! included; rollback restores every array; at the end the triangulation is the one that is built
//! at once from the points that are left.

use std::cell::Cell;
use std::rc::Rc;

use crate::common::editing::{Plan, Subject, Tally, drive};
use trimalla::delaunay::{Algorithm, Delaunay, DivideAndConquer, Incremental, Inserted};
use trimalla::geometry::Point;
use trimalla::half_edge::{Checkpoint, UndoLog, VertexId};
use trimalla_testkit::generators::{PointSetKind, SplitMix64, point_set};

/// How many edits of small triangulations there are for each kind of point set.
const SMALL_EDITS: usize = 2200;
/// How many edits of triangulations of some hundreds of points.
const MEDIUM_EDITS: usize = 3000;
/// How many edits of triangulations of thousands of points.
const LARGE_EDITS: usize = 4000;

/// A Delaunay triangulation and the places that edits choose from.
#[derive(Clone)]
struct Edited {
    delaunay: Delaunay,
    places: Rc<[Point]>,
    /// Above this size removals become likelier than insertions.
    crowded: usize,
    /// How often each sort of edit changed something; shared by all clones.
    changed: Rc<Cell<[usize; 3]>>,
}

/// Every array of the triangulation, dead slots and free lists included.
impl PartialEq for Edited {
    fn eq(&self, other: &Self) -> bool {
        self.delaunay == other.delaunay
    }
}

impl Edited {
    /// Starts from the first so many places.
    fn new(start: usize, places: Vec<Point>, crowded: usize) -> Self {
        Self {
            delaunay: Delaunay::new(&places[..start]).expect("finite points"),
            places: places.into(),
            crowded,
            changed: Rc::default(),
        }
    }

    /// A place, the place an ulp away, or one halfway to another.
    fn draw_point(&self, random: &mut SplitMix64) -> Point {
        let draw = |random: &mut SplitMix64| self.places[random.below(self.places.len())];
        let p = draw(random);
        match random.below(8) {
            0 => Point::new(f64::from_bits(p.x.to_bits() ^ 1), p.y),
            1 => Point::new(p.x, f64::from_bits(p.y.to_bits() ^ 1)),
            2 => Point::midpoint(p, draw(random)),
            _ => p,
        }
    }

    /// A used vertex; all are equally likely.
    fn draw_vertex(&self, random: &mut SplitMix64) -> Option<VertexId> {
        let used: Vec<VertexId> = self.delaunay.used_vertices().collect();
        (!used.is_empty()).then(|| used[random.below(used.len())])
    }

    fn note(&self, sort: usize, changed: bool) {
        let mut counts = self.changed.get();
        counts[sort] += usize::from(changed);
        self.changed.set(counts);
    }

    fn insert(&mut self, random: &mut SplitMix64, log: &mut UndoLog) -> String {
        let p = self.draw_point(random);
        let inserted = self.delaunay.insert_with(p, log).expect("a finite point");
        self.note(0, matches!(inserted, Inserted::New(_)));
        assert_eq!(self.delaunay.point(inserted.vertex()), p, "the vertex lies at the point");
        format!("d.insert_with(Point::new({:?}, {:?}), &mut log)?;", p.x, p.y)
    }

    fn remove(&mut self, v: VertexId, log: &mut UndoLog) -> String {
        self.delaunay.remove_with(v, log).expect("a used vertex");
        self.note(1, true);
        assert!(!self.delaunay.is_used(v), "vertex {v} is gone");
        format!("d.remove_with(VertexId({v}), &mut log)?;")
    }

    fn shift(&mut self, v: VertexId, random: &mut SplitMix64, log: &mut UndoLog) -> String {
        let p = self.draw_point(random);
        let moved = self.delaunay.move_vertex_with(v, p, log).expect("a used vertex");
        self.note(2, moved == Inserted::New(v));
        assert_eq!(self.delaunay.point(moved.vertex()), p, "the vertex lies at the point");
        format!("d.move_vertex_with(VertexId({v}), Point::new({:?}, {:?}), &mut log)?;", p.x, p.y)
    }
}

impl Subject for Edited {
    fn edit(&mut self, random: &mut SplitMix64, log: &mut UndoLog) -> String {
        let crowded = self.size() > self.crowded;
        match (random.below(10), self.draw_vertex(random)) {
            (0 | 1, Some(v)) => self.remove(v, log),
            (2..=4, Some(v)) if crowded => self.remove(v, log),
            (8 | 9, Some(v)) => self.shift(v, random, log),
            _ => self.insert(random, log),
        }
    }

    fn rollback(&mut self, log: &mut UndoLog, to: Checkpoint) {
        self.delaunay.rollback(log, to);
    }

    fn faults(&self) -> Vec<String> {
        self.delaunay.check_delaunay().iter().map(ToString::to_string).collect()
    }

    fn size(&self) -> usize {
        self.delaunay.used_vertices().count()
    }

    fn is_alike(&self, other: &Self) -> bool {
        crate::common::alike::alike(&self.delaunay, &other.delaunay).is_ok()
    }
}

/// The points that are left, triangulated at once, give the same.
fn assert_same_as_rebuilt(edited: &Edited) {
    let d = &edited.delaunay;
    let used: Vec<VertexId> = d.used_vertices().collect();
    for build in [Incremental::triangulate, DivideAndConquer::triangulate] {
        let rebuilt = build(d.points(), Some(&used)).expect("finite points");
        assert_eq!(rebuilt.dimension(), d.dimension(), "dimension");
        assert_eq!(rebuilt.canonical(), d.canonical(), "triangles");
        assert_eq!(rebuilt.canonical_edges(), d.canonical_edges(), "edges");
    }
}

/// Drives, compares with a rebuilt triangulation, counts.
fn run(edited: Edited, plan: Plan) -> Tally {
    let (edited, tally) = drive(edited, plan);
    assert_same_as_rebuilt(&edited);
    let changed = edited.changed.get();
    assert!(changed.iter().all(|&n| n > 0), "inserted, removed, moved: {changed:?}");
    tally
}

#[test]
fn a_hundred_thousand_edits_stay_delaunay_and_are_taken_back() {
    let small = PointSetKind::ALL.into_iter().zip(0..).map(|(kind, seed)| {
        let places = point_set(kind, 30, seed);
        let places = if places.is_empty() { vec![Point::default()] } else { places };
        let plan = Plan { seed, edits: SMALL_EDITS, small: 64, every: 1, rollback_in: 12 };
        run(Edited::new(0, places, 20), plan)
    });
    let medium = [PointSetKind::Uniform, PointSetKind::TenthGrid, PointSetKind::RoundedCircle];
    let medium = medium.into_iter().zip(100..).map(|(kind, seed)| {
        let places = point_set(kind, 400, seed);
        let plan = Plan { seed, edits: MEDIUM_EDITS, small: 40, every: 10, rollback_in: 30 };
        run(Edited::new(200, places, 250), plan)
    });
    let large = [PointSetKind::Uniform, PointSetKind::IntegerGrid].into_iter().zip(200..);
    let large = large.map(|(kind, seed)| {
        let places = point_set(kind, 6000, seed);
        let plan = Plan { seed, edits: LARGE_EDITS, small: 40, every: 200, rollback_in: 150 };
        run(Edited::new(4000, places, 4000), plan)
    });
    let tally = small.chain(medium).chain(large).fold(Tally::default(), Tally::plus);
    assert!(tally.edits >= 100_000, "{tally:?}");
    assert!(tally.rollbacks >= 5_000 && tally.checks >= 50_000, "{tally:?}");
}

#[test]
fn a_triangulation_built_up_and_torn_down_passes_through_every_dimension() {
    for kind in [PointSetKind::IntegerGrid, PointSetKind::CollinearExact, PointSetKind::Hub] {
        let points = point_set(kind, 36, 5);
        let mut random = SplitMix64::new(7);
        let mut d = Delaunay::new(&[]).expect("no points");
        for &p in &points {
            d.insert(p).expect("a finite point");
            assert_eq!(d.check_delaunay(), [], "{kind:?} growing");
        }
        let mut used: Vec<VertexId> = d.used_vertices().collect();
        random.shuffle(&mut used);
        for v in used {
            d.remove(v).expect("a used vertex");
            assert_eq!(d.check_delaunay(), [], "{kind:?} shrinking, {v}");
        }
        assert_eq!(d.dimension(), -1, "nothing is left of {kind:?}");
        assert_eq!(d.free_vertices().len(), d.points().len(), "every slot is free");
    }
}

/// Taking vertex 0 out flips seven of its eight spokes; the edge between two triangles that have no
/// side of the hole fails the circle test if only the sides of the hole are looked at again.
#[test]
fn every_edge_made_by_a_removal_is_looked_at() {
    let points = [
        [0.0, 0.0],
        [18.0, -9.0],
        [11.0, -10.0],
        [-5.0, 6.0],
        [-2.0, 4.0],
        [-16.0, -19.0],
        [13.0, 19.0],
        [11.0, -16.0],
        [1.0, 15.0],
    ];
    let mut d = Delaunay::new(&points.map(Point::from)).expect("finite points");
    d.remove(VertexId(0)).expect("a used vertex");
    assert_eq!(d.check_delaunay(), []);
}
