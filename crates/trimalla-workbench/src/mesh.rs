//! The triangulation of a document: at rest, or under refinement.

use std::fmt;

use trimalla::constrained::{ConstrainedDelaunay, ConstrainedTriangulation};
use trimalla::half_edge::{FaceId, HalfEdgeId, VertexId};
use trimalla::refine::{NamedOptions, Overview, Refinement};
use trimalla::triangulation::Triangulation;

/// The triangulation of a document.
#[derive(Clone)]
pub(crate) enum Mesh {
    /// Nothing is at work on it.
    AtRest(Box<AtRest>),
    /// It is refined step by step.
    Refining(Box<Refining>),
}

/// A triangulation that is refined step by step.
#[derive(Clone)]
pub(crate) struct Refining {
    pub(crate) refinement: Refinement,
    /// What the refinement was asked when it began.
    pub(crate) options: NamedOptions,
    /// Size and smallest angle when it began.
    pub(crate) before: Overview,
    /// Whether it has come to its end, and its run was noted.
    pub(crate) is_noted: bool,
}

/// A triangulation at rest.
#[derive(Clone)]
pub(crate) struct AtRest {
    pub(crate) t: ConstrainedTriangulation,
    /// Whether it is known to be constrained Delaunay.
    pub(crate) is_delaunay: bool,
}

impl Mesh {
    /// A constrained Delaunay triangulation.
    pub(crate) fn of_delaunay(cdt: ConstrainedDelaunay) -> Self {
        Self::AtRest(Box::new(AtRest { t: cdt.into(), is_delaunay: true }))
    }

    /// A triangulation as it was given.
    pub(crate) fn given(t: ConstrainedTriangulation) -> Self {
        Self::AtRest(Box::new(AtRest { t, is_delaunay: false }))
    }

    /// The triangulation.
    pub(crate) fn triangulation(&self) -> &ConstrainedTriangulation {
        match self {
            Self::AtRest(at_rest) => &at_rest.t,
            Self::Refining(refining) => refining.refinement.triangulation(),
        }
    }

    /// The refinement that goes step by step, if there is one.
    pub(crate) fn refining(&self) -> Option<&Refining> {
        match self {
            Self::AtRest(_) => None,
            Self::Refining(refining) => Some(refining),
        }
    }

    /// The same triangulation at rest, without the refinement at work on it.
    pub(crate) fn stopped(&self) -> Self {
        match self {
            Self::AtRest(_) => self.clone(),
            Self::Refining(refining) => Self::given(refining.refinement.without_history().finish().0),
        }
    }
}

/// Triangulations are compared; how far a refinement is follows from the commands.
impl PartialEq for Mesh {
    fn eq(&self, other: &Self) -> bool {
        let steps = |mesh: &Self| mesh.refining().map(|refining| refining.refinement.step_number());
        steps(self) == steps(other) && self.triangulation() == other.triangulation()
    }
}

impl fmt::Debug for Mesh {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = if matches!(self, Self::AtRest(_)) { "AtRest" } else { "Refining" };
        f.debug_struct(kind).field("vertices", &self.triangulation().points().len()).finish_non_exhaustive()
    }
}

/// The real face with three corners.
pub(crate) fn face_of(t: &Triangulation, [a, b, c]: [VertexId; 3]) -> Option<FaceId> {
    let h = edge_of(t, a, b)?;
    [h, t.twin(h)].into_iter().find(|&h| t.apex(h) == c && t.is_real(h.face())).map(HalfEdgeId::face)
}

/// The half-edge from one vertex to another, if both are in use and there is one.
pub(crate) fn edge_of(t: &Triangulation, a: VertexId, b: VertexId) -> Option<HalfEdgeId> {
    (t.is_used(a) && t.is_used(b)).then(|| t.half_edge_between(a, b))?
}
