//! Strategies that break a law, and the suites that detect them.

use super::*;
use crate::geometry::{Point, Triangle};
use crate::half_edge::HalfEdgeId;
use crate::locate::Locus;
use crate::refine::recipe::{PlacePoint, Preset};
use crate::refine::steps::{InsertStep, Places, Plan, PointStep, PrepareStep, Proposal, SelectStep};

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

/// Needs long subsegments split once there are some new vertices: by then most of them are never tested again.
struct LateDemand {
    after: usize,
}

impl PrepareStep for LateDemand {
    fn needs_split(&self, view: View<'_>, h: HalfEdgeId) -> bool {
        let [a, b] = view.cdt.edge_points(h);
        view.cdt.steiner_vertices() >= self.after && Point::distance_sq(a, b) >= 16.0
    }
}

#[test]
fn a_step_1_without_one_answer_is_detected() {
    let subject = Subject::default().with_steps(|_, steps| steps.prepare = Arc::new(OneSided));
    assert!(breach(prepare(&subject)).contains("on one side and not on the other"));
    let found = (MOST_VERTICES / 4..MOST_VERTICES).find_map(|after| {
        let with = move |_: &RefineOptions, steps: &mut Steps| steps.prepare = Arc::new(LateDemand { after });
        prepare(&Subject::default().with_steps(with)).err()
    });
    assert!(found.is_some_and(|breach| breach.to_string().contains("is whole in the end")));
}

struct NoNumber;

impl SelectStep for NoNumber {
    fn priority(&self, _: View<'_>, _: FaceId, _: u64) -> f64 {
        f64::NAN
    }
}

struct BySlot;

impl SelectStep for BySlot {
    fn priority(&self, _: View<'_>, face: FaceId, _: u64) -> f64 {
        face.index() as f64
    }
}

#[test]
fn a_step_2_without_order_is_detected() {
    let subject = Subject::default().with_steps(|_, steps| steps.select = Arc::new(NoNumber));
    assert!(breach(select(&subject)).contains("NaN"));
    let subject = Subject::default().with_steps(|_, steps| steps.select = Arc::new(BySlot));
    let found = breach(select(&subject));
    assert!(found.contains("where a triangle is stored") || found.contains("another mesh"), "{found}");
}

/// Claims that its point is inside the triangle, which need not be so.
struct FalseLocus;

impl PointStep for FalseLocus {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places) {
        let [a, b, c] = view.cdt.corners(face);
        let point = Triangle::new(a, b, c).circumcenter().unwrap_or(a);
        places.push(Proposal::Free { point, locus: Locus::Face(face) });
    }
}

/// Proposes splits of edges that are no segments.
struct FreeEdgeSplitter;

impl PointStep for FreeEdgeSplitter {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places) {
        places.extend(face.half_edges().into_iter().filter(|&h| !view.cdt.is_marked(h)).map(Proposal::Split));
    }
}

/// Starts from the corner that happens to be stored first.
struct FirstStored;

impl PointStep for FirstStored {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places) {
        let [a, b, c] = view.cdt.face_points(face);
        let point = Point::lerp(Point::midpoint(b, c), a, 0.25);
        places.extend(Proposal::towards(view, face, point));
    }
}

#[test]
fn a_step_3_that_does_not_say_where_is_detected() {
    let with = |step: Arc<dyn PointStep + Send + Sync>| {
        breach(point(&Subject::default().with_steps(move |_, steps| steps.point = Arc::clone(&step))))
    };
    assert!(with(Arc::new(FalseLocus)).contains("not inside the face that it names"));
    assert!(with(Arc::new(FreeEdgeSplitter)).contains("what is no subsegment"));
    assert!(with(Arc::new(FirstStored)).contains("where a triangle is stored"));
}

/// Replaces faces that no fan can replace: those around a corner, which would lose it.
struct CornerRemover;

impl InsertStep for CornerRemover {
    fn plan(&self, view: View<'_>, place: Proposal, faces: &mut Vec<FaceId>) -> Plan {
        if let Proposal::Free { locus: Locus::Face(f), .. } = place {
            let oldest = view.cdt.face_vertices(f).into_iter().min().expect("three corners");
            faces.extend(view.cdt.faces_around(oldest).filter(|&f| view.cdt.is_real(f)));
        }
        Plan::Faces
    }
}

/// Flips what must not be flipped.
struct Flipper;

impl InsertStep for Flipper {
    fn plan(&self, view: View<'_>, _: Proposal, _: &mut Vec<FaceId>) -> Plan {
        view.cdt.edges().find(|&h| view.cdt.is_marked(h)).map_or(Plan::Parts, Plan::Flip)
    }
}

#[test]
fn a_step_4_that_breaks_the_mesh_is_detected() {
    let with = |step: Arc<dyn InsertStep + Send + Sync>| {
        insert(&Subject::default().with_steps(move |_, steps| steps.insert = Arc::clone(&step)))
    };
    assert!(breach(with(Arc::new(CornerRemover))).contains("another mesh than Lawson's flips"));
    assert!(breach(with(Arc::new(Flipper))).contains("must not be"));
    // The loop refuses their plans, so the triangulation stays sound.
    for step in [Arc::new(CornerRemover) as Arc<dyn InsertStep + Send + Sync>, Arc::new(Flipper)] {
        laws(&Subject::default().with_steps(move |_, steps| steps.insert = Arc::clone(&step))).unwrap();
    }
}

/// Replaces the face in which a point lies and those beside it, as far as that can be.
struct Neighbourhood;

impl InsertStep for Neighbourhood {
    fn plan(&self, view: View<'_>, place: Proposal, faces: &mut Vec<FaceId>) -> Plan {
        let Proposal::Free { locus: Locus::Face(f), .. } = place else { return Plan::Parts };
        faces.push(f);
        let across = f.half_edges().into_iter().filter(|&h| !view.cdt.is_marked(h)).map(|h| view.cdt.twin(h).face());
        faces.extend(across);
        Plan::Faces
    }
}

/// If the point does not see all of the faces, its place is refused, so the mesh differs; the circle test is kept all
/// the same.
#[test]
fn faces_of_a_steps_own_are_replaced() {
    let subject = Subject::default().with_steps(|_, steps| steps.insert = Arc::new(Neighbourhood));
    assert!(breach(insert(&subject)).contains("another mesh than Lawson's flips"));
    laws(&subject).unwrap();
}

#[test]
fn every_preset_obeys_the_laws() {
    for preset in Preset::ALL {
        laws(&Subject::of(preset.recipe())).unwrap_or_else(|breach| panic!("{preset}: {breach}"));
    }
}

#[test]
fn every_order_obeys_the_laws_until_destroyed() {
    for select in Select::ALL {
        let recipe = Recipe { select, point: PlacePoint::LeppCentroid, until_destroyed: true, ..Recipe::default() };
        laws(&Subject::of(recipe)).unwrap_or_else(|breach| panic!("{select}: {breach}"));
    }
}
