//! Strategies that break a law, and the suite that notices.

use super::*;
use crate::constrained::{Edit, Provenance, SplitError};
use crate::geometry::{Point, Triangle};
use crate::half_edge::{HalfEdgeId, UndoLog};
use crate::locate::Locus;
use crate::refine::recipe::{Insert, PlacePoint, Preset};
use crate::refine::steps::{InsertStep, PointStep, PrepareStep, Proposal, SelectStep};

/// The breach that a suite finds.
fn breach(found: Result<(), Breach>) -> String {
    found.expect_err("a broken strategy is noticed").to_string()
}

struct OneSided;

impl PrepareStep for OneSided {
    fn needs_split(&self, view: View<'_>, h: HalfEdgeId) -> bool {
        view.cdt.origin(h) < view.cdt.dest(h)
    }
}

/// Wants long subsegments split once there are some new vertices: by then most of them are never looked at again.
struct ChangeOfMind {
    after: usize,
}

impl PrepareStep for ChangeOfMind {
    fn needs_split(&self, view: View<'_>, h: HalfEdgeId) -> bool {
        let [a, b] = view.cdt.edge_points(h);
        view.cdt.steiner_vertices() >= self.after && Point::distance_sq(a, b) >= 16.0
    }
}

#[test]
fn a_step_1_of_two_minds_is_noticed() {
    let subject = Subject::default().with_steps(|_, steps| steps.prepare = Arc::new(OneSided));
    assert!(breach(prepare(&subject)).contains("on one side and not on the other"));
    let found = (MOST_VERTICES / 4..MOST_VERTICES).find_map(|after| {
        let with = move |_: &RefineOptions, steps: &mut Steps| steps.prepare = Arc::new(ChangeOfMind { after });
        prepare(&Subject::default().with_steps(with)).err()
    });
    assert!(found.is_some_and(|breach| breach.to_string().contains("is whole in the end")));
}

struct NoNumber;

impl SelectStep for NoNumber {
    fn patience(&self, _: View<'_>, _: FaceId, _: u64) -> f64 {
        f64::NAN
    }
}

struct BySlot;

impl SelectStep for BySlot {
    fn patience(&self, _: View<'_>, face: FaceId, _: u64) -> f64 {
        face.index() as f64
    }
}

#[test]
fn a_step_2_without_order_is_noticed() {
    let subject = Subject::default().with_steps(|_, steps| steps.select = Arc::new(NoNumber));
    assert!(breach(select(&subject)).contains("NaN"));
    let subject = Subject::default().with_steps(|_, steps| steps.select = Arc::new(BySlot));
    let found = breach(select(&subject));
    assert!(found.contains("where a triangle is stored") || found.contains("another mesh"), "{found}");
}

/// Says that its point is inside the triangle, which it need not be.
struct Liar;

impl PointStep for Liar {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Vec<Proposal>) {
        let [a, b, c] = view.cdt.corners(face);
        let point = Triangle::new(a, b, c).circumcenter().unwrap_or(a);
        places.push(Proposal::Free { point, locus: Locus::Face(face) });
    }
}

/// Proposes splits of edges that are no segments.
struct Vandal;

impl PointStep for Vandal {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Vec<Proposal>) {
        places.extend(face.half_edges().into_iter().filter(|&h| !view.cdt.is_marked(h)).map(Proposal::Split));
    }
}

/// Starts from the corner that happens to be stored first.
struct FirstStored;

impl PointStep for FirstStored {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Vec<Proposal>) {
        let [a, b, c] = view.cdt.face_points(face);
        let point = Point::lerp(Point::midpoint(b, c), a, 0.25);
        places.extend(Proposal::towards(view, face, point));
    }
}

#[test]
fn a_step_3_that_does_not_say_where_is_noticed() {
    let with = |step: Arc<dyn PointStep + Send + Sync>| {
        breach(point(&Subject::default().with_steps(move |_, steps| steps.point = Arc::clone(&step))))
    };
    assert!(with(Arc::new(Liar)).contains("not inside the face that it names"));
    assert!(with(Arc::new(Vandal)).contains("what is no subsegment"));
    assert!(with(Arc::new(FirstStored)).contains("where a triangle is stored"));
}

/// Lawson's flips, but for what is broken.
struct Broken {
    good: Arc<dyn InsertStep + Send + Sync>,
    /// Puts the vertex next to where it belongs.
    is_shifted: bool,
    /// Inserts what cannot be taken back.
    is_unlogged: bool,
    keeps_delaunay: bool,
}

impl InsertStep for Broken {
    fn insert(&self, edit: &mut Edit<'_, UndoLog>, p: Point, locus: Locus) -> Option<VertexId> {
        let point = if self.is_shifted { Point::new(p.x + 1e-9, p.y) } else { p };
        if !self.is_unlogged {
            return self.good.insert(edit, point, locus);
        }
        edit.with_log(&mut UndoLog::new(), |edit| self.good.insert(edit, point, locus))
    }

    fn split(
        &self,
        edit: &mut Edit<'_, UndoLog>,
        h: HalfEdgeId,
        p: Point,
        provenance: Provenance,
    ) -> Result<VertexId, SplitError> {
        self.good.split(edit, h, p, provenance)
    }

    fn keeps_delaunay(&self) -> bool {
        self.keeps_delaunay
    }
}

#[test]
fn a_step_4_that_spoils_is_noticed() {
    let with = |key: Insert, broken: fn(&mut Broken)| {
        breach(insert(&Subject::default().with_steps(move |_, steps| {
            let recipe = Recipe { insert: key, ..Recipe::default() };
            let good = Subject::of(recipe).steps().insert;
            let mut own = Broken { good, is_shifted: false, is_unlogged: false, keeps_delaunay: true };
            broken(&mut own);
            steps.insert = Arc::new(own);
        })))
    };
    assert!(with(Insert::Flip, |b| b.is_shifted = true).contains("is not there"));
    assert!(with(Insert::Flip, |b| b.is_unlogged = true).contains("it is not what it was"));
    assert!(with(Insert::Partition, |b| b.keeps_delaunay = true).contains("faults"));
}

/// Lets go of a segment inside with every insertion.
struct Thief(Arc<dyn InsertStep + Send + Sync>);

impl InsertStep for Thief {
    fn insert(&self, edit: &mut Edit<'_, UndoLog>, p: Point, locus: Locus) -> Option<VertexId> {
        let inner = edit.segment_ids().rev().find(|&s| {
            let chain = edit.chain(s);
            !chain.is_empty() && chain.iter().all(|&h| edit.is_real(h.face()) && edit.is_real(edit.twin(h).face()))
        });
        match inner {
            Some(segment) if edit.remove_segment(segment) => edit.insert(p).ok().map(|i| i.vertex()),
            _ => self.0.insert(edit, p, locus),
        }
    }

    fn split(
        &self,
        edit: &mut Edit<'_, UndoLog>,
        h: HalfEdgeId,
        p: Point,
        provenance: Provenance,
    ) -> Result<VertexId, SplitError> {
        self.0.split(edit, h, p, provenance)
    }
}

#[test]
fn a_segment_that_is_lost_without_a_word_is_noticed() {
    let subject = Subject::default().with_steps(|_, steps| {
        steps.insert = Arc::new(Thief(Arc::clone(&steps.insert)));
    });
    let found = breach(recover(&subject));
    assert!(found.contains("a segment is gone that is locked") || found.contains("are missing in the end"), "{found}");
    assert!(breach(insert(&subject)).contains("subsegments, not"));
}

#[test]
fn every_preset_obeys_the_laws() {
    for preset in Preset::ALL {
        laws(&Subject::of(preset.recipe())).unwrap_or_else(|breach| panic!("{preset}: {breach}"));
    }
}

#[test]
fn every_order_obeys_the_laws_until_destroyed() {
    for &select in Select::ALL {
        let recipe = Recipe { select, point: PlacePoint::LeppCentroid, until_destroyed: true, ..Recipe::default() };
        laws(&Subject::of(recipe)).unwrap_or_else(|breach| panic!("{select}: {breach}"));
    }
}
