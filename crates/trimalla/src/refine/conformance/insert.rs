//! The suite of step 4.

use std::sync::Arc;

use super::{Breach, Subject, by_key, carved, drawings, ensure, laws, view};
use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, Edit, Provenance, Workspace};
use crate::delaunay::AlgorithmKey;
use crate::drawing::Pslg;
use crate::geometry::{Point, Triangle};
use crate::half_edge::{HalfEdgeId, UndoLog, VertexId};
use crate::locate::Locus;
use crate::refine::engine::insertion::{Site, carry_out};
use crate::refine::recipe::options::RefineOptions;
use crate::refine::recipe::{Insert, Recipe};
use crate::refine::steps::{InsertStep, Plan, Proposal};

/// Puts a step 4 through its suite.
///
/// # Errors
/// The first [`Breach`].
pub fn insert(subject: &Subject) -> Result<(), Breach> {
    for (drawing, pslg) in drawings::all() {
        of_drawing(subject, &pslg).map_err(|Breach(breach)| Breach(format!("{drawing}: {breach}")))?;
    }
    laws(subject)
}

fn of_drawing(subject: &Subject, pslg: &Pslg) -> Result<(), Breach> {
    let step = subject.steps().insert;
    let start = carved(pslg, AlgorithmKey::Incremental)?;
    for place in places(&start) {
        goes_in_and_comes_out(&*step, &start, place)?;
        flips_only_what_can_be(subject, &start, place)?;
    }
    if !step.traits().keeps_delaunay {
        return Ok(());
    }
    let flips = Subject::of(Recipe { insert: Insert::Flip, ..Recipe::default() }).steps().insert;
    let [own, reference] = [&step, &flips].map(|step| all_in(step, start.clone()));
    ensure(own == reference, || "one after the other, they make another mesh than Lawson's flips".to_owned())
}

/// The middle of every triangle and of every edge.
fn places(cdt: &ConstrainedTriangulation) -> Vec<Proposal> {
    let middles = by_key(cdt).into_iter().map(|f| {
        let [a, b, c] = cdt.corners(f);
        (f, Triangle::new(a, b, c).centroid())
    });
    let inside = middles.filter(|&(f, p)| cdt.locate_from(f, p) == Locus::Face(f));
    let inside = inside.map(|(f, point)| Proposal::Free { point, locus: Locus::Face(f) });
    let on_edge = |edge: HalfEdgeId| {
        let [a, b] = cdt.edge_points(edge);
        if cdt.is_marked(edge) {
            Proposal::Split(edge)
        } else {
            Proposal::OnEdge { edge, point: Point::midpoint(a, b) }
        }
    };
    inside.chain(cdt.edges().map(on_edge)).collect()
}

/// Inserts a vertex at a place as the step plans it; `None` if the place was refused.
fn put_in(step: &dyn InsertStep, edit: &mut Edit<'_, UndoLog>, place: Proposal) -> (Point, Option<VertexId>) {
    let site = match place {
        Proposal::Free { point, locus } => Site::Free(point, locus),
        Proposal::OnEdge { edge, point } => Site::Edge(edge, point, Provenance::Free),
        Proposal::Split(h) => {
            let (point, provenance) = edit.point_on_subsegment(h, 0.5);
            Site::Edge(h, point, provenance)
        }
    };
    (site.point(), carried_out(step, edit, place, site))
}

/// Executes the plan of the step for a place, at a site.
fn carried_out(step: &dyn InsertStep, edit: &mut Edit<'_, UndoLog>, place: Proposal, site: Site) -> Option<VertexId> {
    let (mut faces, options) = (Vec::new(), RefineOptions::default());
    let plan = step.plan(view(edit, &options), place, &mut faces);
    carry_out(edit, (plan, &faces), site, step.traits().keeps_delaunay)
}

/// The vertex lies where it was inserted, the triangulation is sound, segments are whole, and rollback restores
/// everything.
fn goes_in_and_comes_out(
    step: &dyn InsertStep,
    start: &ConstrainedTriangulation,
    place: Proposal,
) -> Result<(), Breach> {
    let (mut cdt, mut work, mut log) = (start.clone(), Workspace::default(), UndoLog::new());
    let here = log.checkpoint();
    let (point, inserted) = put_in(step, &mut cdt.edit(&mut work, &mut log), place);
    let Some(v) = inserted else {
        return ensure(cdt == *start, || format!("{point} is refused, and yet something has changed"));
    };
    ensure(cdt.point(v) == point && cdt.is_used(v), || format!("{point} is put in and is not there"))?;
    let faults = if step.traits().keeps_delaunay { cdt.check_delaunay() } else { cdt.check() };
    ensure(faults.is_empty(), || format!("{point} leaves {} faults, the first: {:?}", faults.len(), faults[0]))?;
    let marks = |cdt: &ConstrainedTriangulation| cdt.edges().filter(|&h| cdt.is_marked(h)).count();
    let expected = marks(start) + usize::from(matches!(place, Proposal::Split(_)));
    ensure(marks(&cdt) == expected, || format!("{point} leaves {} subsegments, not {expected}", marks(&cdt)))?;
    cdt.rollback(&mut log, here);
    ensure(cdt == *start, || format!("{point} taken out, it is not what it was"))
}

/// An edge that is flipped instead of an insertion is no segment, and fails the circle test if that is kept.
fn flips_only_what_can_be(subject: &Subject, cdt: &ConstrainedTriangulation, place: Proposal) -> Result<(), Breach> {
    let (step, options) = (subject.steps().insert, subject.options());
    let Plan::Flip(h) = step.plan(view(cdt, &options), place, &mut Vec::new()) else { return Ok(()) };
    let is_inner = cdt.is_alive(h.face()) && !cdt.is_marked(h) && !cdt.is_boundary_edge(h);
    let is_fine = is_inner && (!step.traits().keeps_delaunay || cdt.fails_circle_test(h));
    ensure(is_fine, || format!("half-edge {h} is to be flipped, and must not be"))
}

/// The mesh after inserting all middles in turn, each at its locus by then.
fn all_in(step: &Arc<dyn InsertStep + Send + Sync>, mut cdt: ConstrainedDelaunay) -> (Vec<Point>, Vec<[VertexId; 3]>) {
    let mut log = UndoLog::new();
    let middles: Vec<Point> = places(&cdt)
        .into_iter()
        .filter_map(|place| if let Proposal::Free { point, .. } = place { Some(point) } else { None })
        .collect();
    for point in middles {
        let locus = cdt.locate(point);
        let is_free = match locus {
            Locus::Face(f) => cdt.is_real(f),
            Locus::Edge(h) => !cdt.is_marked(h),
            _ => false,
        };
        if is_free {
            let place = Proposal::Free { point, locus };
            carried_out(&**step, &mut cdt.edit(&mut log), place, Site::Free(point, locus));
        }
    }
    (cdt.points().to_vec(), cdt.canonical())
}
