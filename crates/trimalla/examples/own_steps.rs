//! One strategy of our own for each of the five steps, written with nothing but what the library shows.
//!
//! `cargo run --release -p trimalla --example own_steps`
#![allow(clippy::print_stdout, reason = "an example talks")]

use std::sync::Arc;

use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build};
use trimalla::drawing::Pslg;
use trimalla::geometry::{CircleSide, Point, Triangle, in_circle, in_diametral_disk};
use trimalla::half_edge::{FaceId, HalfEdgeId, VertexId};
use trimalla::locate::Locus;
use trimalla::quality::against_input;
use trimalla::refine::lepp::longest_edge;
use trimalla::refine::steps::{
    InsertStep, Places, Plan, PointStep, PrepareStep, Proposal, RecoverStep, RecoverTraits, SelectStep, StepEdit,
    Steps, View,
};
use trimalla::refine::{NoObserver, RefineOptions, Refinement, Start};

/// Step 1: subsegments longer than this are halved before the first point goes in; after that, those with a vertex in
/// the disk of which they are a diameter are, too.
pub(crate) struct NoneLonger(pub(crate) f64);

impl NoneLonger {
    fn is_too_long(&self, view: View<'_>, h: HalfEdgeId) -> bool {
        let [a, b] = view.cdt.edge_points(h);
        Point::distance_sq(a, b) > self.0 * self.0
    }
}

impl PrepareStep for NoneLonger {
    /// The triangulation is in hand here: everything that is too long is split.
    fn begin(&self, edit: &mut dyn StepEdit) -> bool {
        let view = edit.view();
        let marked = view.cdt.edges().filter(|&h| view.cdt.is_marked(h));
        let too_long: Vec<HalfEdgeId> = marked.filter(|&h| self.is_too_long(view, h)).collect();
        for h in too_long {
            edit.put(Proposal::Split(h));
        }
        false
    }

    fn needs_split(&self, view: View<'_>, h: HalfEdgeId) -> bool {
        let [a, b] = view.cdt.edge_points(h);
        let mut apexes = [h, view.cdt.twin(h)].map(|side| view.cdt.apex(side)).into_iter().filter(|v| v.is_finite());
        let is_inside = |v: VertexId| in_diametral_disk(a, b, view.cdt.point(v)) == CircleSide::Inside;
        self.is_too_long(view, h) || apexes.any(is_inside)
    }
}

/// Step 2: the largest bad triangle first.
pub(crate) struct LargestFirst;

impl SelectStep for LargestFirst {
    fn priority(&self, view: View<'_>, face: FaceId, _: u64) -> f64 {
        let [a, b, c] = view.cdt.corners(face);
        1.0 / (b - a).cross(c - a)
    }
}

/// Step 3: two points at a time, the circumcenters of a bad triangle and of the triangle across its longest edge.
///
/// The second is for a triangle that is bad, too, and that the first one leaves as it is.
pub(crate) struct BothCenters;

impl BothCenters {
    fn triangle(view: View<'_>, face: FaceId) -> Triangle {
        let [a, b, c] = view.cdt.corners(face);
        Triangle::new(a, b, c)
    }

    /// The circumcenter of a bad triangle, if a point elsewhere is outside of the circle.
    fn center_beside(view: View<'_>, face: FaceId, first: Point) -> Option<Point> {
        let triangle = Self::triangle(view, face);
        let is_bad = triangle.min_angle().degrees() < view.criteria.min_angle.degrees();
        let center = triangle.circumcenter().filter(|_| is_bad)?;
        (Point::distance_sq(center, first) > triangle.circumradius_sq()?).then_some(center)
    }
}

impl PointStep for BothCenters {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places) {
        let Some(center) = Self::triangle(view, face).circumcenter() else { return };
        let across = view.cdt.twin(longest_edge(view.cdt, view.ruler, face)).face();
        let other = if view.cdt.is_real(across) { Self::center_beside(view, across, center) } else { None };
        // The walk to the first ends at its place, or at a segment in the way, which is split instead.
        if let Some(first) = Proposal::towards(view, face, center) {
            places.push_together(first, other);
        }
    }
}

/// Step 4: the face in which the point lies goes, and those beside it whose circles hold the point.
///
/// The cavity may be larger than that; edges around the vertex are flipped until the circle test holds.
pub(crate) struct FirstRing;

impl InsertStep for FirstRing {
    fn plan(&self, view: View<'_>, place: Proposal, faces: &mut Vec<FaceId>) -> Plan {
        let Proposal::Free { point, locus: Locus::Face(inner) } = place else { return Plan::Flips };
        let holds = |f: &FaceId| {
            let [a, b, c] = view.cdt.corners(*f);
            view.cdt.is_real(*f) && in_circle(a, b, c, point) == CircleSide::Inside
        };
        let beside = inner.half_edges().into_iter().filter(|&h| !view.cdt.is_marked(h));
        faces.push(inner);
        faces.extend(beside.map(|h| view.cdt.twin(h).face()).filter(holds));
        Plan::Faces
    }
}

/// Step 5: *complete recovery*. Segments inside are free to go while points go in; what is missing in the end goes in
/// as whole edges.
///
/// # Source
/// `[MeshSuite]` 2.6.2.
pub(crate) struct CompleteRecovery;

impl RecoverStep for CompleteRecovery {
    fn traits(&self) -> RecoverTraits {
        RecoverTraits { locks_segments: false, restores_segments: true }
    }

    fn recover(&self, edit: &mut dyn StepEdit) {
        let missing = edit.missing();
        edit.bring_back(&missing);
    }
}

/// The recipe's steps, all five exchanged.
pub(crate) fn own_steps() -> Steps {
    Steps {
        prepare: Arc::new(NoneLonger(2.0)),
        select: Arc::new(LargestFirst),
        point: Arc::new(BothCenters),
        insert: Arc::new(FirstRing),
        recover: Arc::new(CompleteRecovery),
    }
}

/// A square with a long segment inside, between two rows of vertices: it is no edge of the Delaunay triangulation.
pub(crate) fn fenced() -> Pslg {
    let mut fenced = Pslg::of_ring([[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]]);
    fenced.points.extend([[1.0, 4.0], [7.0, 4.5]].map(Point::from));
    fenced.points.extend((2..7).flat_map(|i| [Point::new(f64::from(i), 3.9), Point::new(f64::from(i) + 0.3, 4.8)]));
    fenced.segments.push([4, 5]);
    fenced
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let drawing = fenced();
    let options = RefineOptions::default().with_min_angle_deg(25.0).with_max_vertices(5000);
    for (name, steps) in [("the recipe's steps", Steps::of(&options)), ("our own", own_steps())] {
        let (cdt, _) = build(&drawing, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default())?;
        let mut refinement = Refinement::new(Start::from(cdt).with_steps(steps), options)?;
        refinement.run(&mut NoObserver);
        let (cdt, report) = refinement.finish();
        let faults = against_input(&cdt.to_indexed(&drawing), &drawing).faults;
        println!(
            "{name}: {} vertices, {} triangles, smallest angle {:.1} degrees, {} segments missing",
            report.vertices,
            report.triangles,
            report.min_angle_deg,
            faults.len()
        );
    }
    Ok(())
}
