//! The suite of step 3.

use super::{Breach, Subject, by_key, drawings, ensure, laws, view};
use crate::constrained::ConstrainedTriangulation;
use crate::delaunay::AlgorithmKey;
use crate::drawing::Pslg;
use crate::geometry::{Orientation, Point, Segment, last_places, orient2d};
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};
use crate::locate::Locus;
use crate::refine::steps::{Places, Proposal};

/// No strategy needs more places than this for one triangle.
const MOST_PLACES: usize = 16;

/// Puts a step 3 through its suite.
///
/// # Errors
/// The first [`Breach`].
pub fn point(subject: &Subject) -> Result<(), Breach> {
    // A false locus would break a triangulation, so the proposals at the start are tested before anything is inserted.
    for (drawing, pslg) in drawings::all() {
        at_the_start(subject, &pslg).map_err(|Breach(breach)| Breach(format!("{drawing}: {breach}")))?;
    }
    for (drawing, pslg) in drawings::all() {
        on_the_way(subject, &pslg).map_err(|Breach(breach)| Breach(format!("{drawing}: {breach}")))?;
    }
    laws(subject)
}

fn at_the_start(subject: &Subject, pslg: &Pslg) -> Result<(), Breach> {
    let starts = [AlgorithmKey::Incremental, AlgorithmKey::DivideAndConquer].map(|a| subject.begin(pslg, a));
    let [one, other] = starts;
    let [one, other] = [one?, other?].map(|refinement| described(subject, refinement.triangulation()));
    ensure(one? == other?, || "places depend on where a triangle is stored".to_owned())
}

fn on_the_way(subject: &Subject, pslg: &Pslg) -> Result<(), Breach> {
    let mut refinement = subject.begin(pslg, AlgorithmKey::Incremental)?;
    laws::run(subject, pslg, &mut refinement, |refinement, _| {
        described(subject, refinement.triangulation()).map(|_| ())
    })?;
    Ok(())
}

/// A description of a place that does not depend on slots: kind, edge, point.
type Description = (&'static str, Option<[VertexId; 2]>, Option<[u64; 2]>);

/// The places of every triangle; each must lie at its locus.
fn described(subject: &Subject, cdt: &ConstrainedTriangulation) -> Result<Vec<Vec<Description>>, Breach> {
    let (step, options) = (subject.steps().point, subject.options());
    let of_face = |face: FaceId| {
        let mut places = Places::new();
        step.propose(view(cdt, &options), face, &mut places);
        let at = |breach: &str| Breach(format!("{breach}, proposed for {:?}", cdt.face_key(face)));
        if places.proposals().len() > MOST_PLACES {
            return Err(at("more places than anyone can try"));
        }
        places
            .proposals()
            .iter()
            .try_for_each(|&place| is_where_it_says(cdt, place))
            .map_err(|Breach(breach)| at(&breach))?;
        let before = places.clone();
        places.clear();
        step.propose(view(cdt, &options), face, &mut places);
        if places != before {
            return Err(at("other places when asked again"));
        }
        Ok(places.proposals().iter().map(|&place| description(cdt, place)).collect())
    };
    by_key(cdt).into_iter().map(of_face).collect()
}

fn is_where_it_says(cdt: &ConstrainedTriangulation, place: Proposal) -> Result<(), Breach> {
    let inside = |f: FaceId, p: Point| {
        let sides = f.half_edges().map(|h| cdt.side_of(h, p));
        cdt.is_real(f) && sides == [Orientation::CounterClockwise; 3]
    };
    match place {
        Proposal::Split(h) => {
            ensure(is_edge(cdt, h) && cdt.is_marked(h), || "the split of what is no subsegment".to_owned())
        }
        Proposal::Free { point, locus: Locus::Face(f) } => {
            ensure(inside(f, point), || format!("{point}, which is not inside the face that it names"))
        }
        Proposal::Free { point, locus: Locus::Edge(h) } => {
            ensure(is_free_edge(cdt, h) && is_on(cdt, h, point, 0.0), || format!("{point}, not exactly on a free edge"))
        }
        Proposal::Free { point, .. } => Err(Breach(format!("{point}, at a vertex or outside"))),
        Proposal::OnEdge { edge, point } => {
            ensure(is_free_edge(cdt, edge) && is_on(cdt, edge, point, last_places::PROPOSED_ON_EDGE), || {
                format!("{point}, off its edge or on a segment")
            })
        }
    }
}

fn is_edge(cdt: &ConstrainedTriangulation, h: HalfEdgeId) -> bool {
    h.index() < 3 * cdt.face_slots() && [h, cdt.twin(h)].into_iter().any(|side| cdt.is_real(side.face()))
}

/// An edge between two triangles that no segment runs along.
fn is_free_edge(cdt: &ConstrainedTriangulation, h: HalfEdgeId) -> bool {
    is_edge(cdt, h) && !cdt.is_marked(h) && [h, cdt.twin(h)].into_iter().all(|side| cdt.is_real(side.face()))
}

/// Whether a point lies on an edge and not at its ends, to within some last places.
fn is_on(cdt: &ConstrainedTriangulation, h: HalfEdgeId, p: Point, last_places: f64) -> bool {
    let [a, b] = cdt.edge_points(h);
    let is_near = last_places > 0.0 && Segment::new(a, b).passes_within(last_places, p);
    let is_between = p != a && p != b && (p - a).dot(b - a) > 0.0 && (p - b).dot(a - b) > 0.0;
    is_between && (orient2d(a, b, p) == Orientation::Collinear || is_near)
}

fn description(cdt: &ConstrainedTriangulation, place: Proposal) -> Description {
    let ends = |h: HalfEdgeId| Some(cdt.edge_key(h).ends());
    let bits = |p: Point| Some([p.x.to_bits(), p.y.to_bits()]);
    match place {
        Proposal::Free { point, .. } => ("free", None, bits(point)),
        Proposal::OnEdge { edge, point } => ("on edge", ends(edge), bits(point)),
        Proposal::Split(h) => ("split", ends(h), None),
    }
}
