//! Places for new vertices.

use super::view::View;
use crate::constrained::ConstrainedTriangulation;
use crate::geometry::{Orientation, Point, on_segment};
use crate::half_edge::{FaceId, HalfEdgeId};
use crate::locate::{Locus, Walk};

/// A place that step 3 proposes for a new vertex, with its locus, so that no rounded number decides where it lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Proposal {
    /// A free point exactly at its locus: inside a face, or on an unconstrained edge.
    Free {
        /// The point.
        point: Point,
        /// Where it lies.
        locus: Locus,
    },
    /// A point on this unconstrained edge, up to rounding.
    OnEdge {
        /// The edge.
        edge: HalfEdgeId,
        /// The point.
        point: Point,
    },
    /// The split of this subsegment.
    Split(HalfEdgeId),
}

impl Proposal {
    /// Proposes a point near a face, by a walk to the point. If a segment is in the way, proposes its split instead.
    /// `None` if there is a vertex at the point, if the point is not finite, or if it is too far away in a mesh that
    /// does not keep the circle test.
    #[must_use]
    pub fn towards(view: View<'_>, from: FaceId, point: Point) -> Option<Self> {
        if !point.is_finite() {
            return None;
        }
        // Most walks meet no segment, and rounded arithmetic decides them.
        if let Some(f) = view.cdt.float_walk_within(from, point) {
            return Some(Self::Free { point, locus: Locus::Face(f) });
        }
        Self::towards_exactly(view, from, point)
    }

    /// [`towards`](Self::towards) a finite point, if rounded arithmetic does not decide the walk, or a segment is in
    /// the way.
    #[inline(never)]
    fn towards_exactly(view: View<'_>, from: FaceId, point: Point) -> Option<Self> {
        match view.cdt.walk_within_exactly(from, point, view.longest_walk)? {
            Walk::Blocked(h) => Some(Self::Split(h)),
            Walk::Arrived(Locus::Edge(h)) if view.cdt.is_marked(h) => Some(Self::Split(h)),
            Walk::Arrived(locus @ (Locus::Face(_) | Locus::Edge(_))) => Some(Self::Free { point, locus }),
            Walk::Arrived(_) => None,
        }
    }
}

impl Proposal {
    /// Whether the proposal is valid: its edge exists, and its point is finite and lies exactly at its locus.
    ///
    /// The loop verifies every proposal, whoever made it, before it uses one.
    #[must_use]
    pub fn is_true(self, cdt: &ConstrainedTriangulation) -> bool {
        self.is_there(cdt) && self.is_in_its_face(cdt)
    }

    /// Whether a point inside a face lies left of its three sides; true for other places.
    fn is_in_its_face(self, cdt: &ConstrainedTriangulation) -> bool {
        let Self::Free { point, locus: Locus::Face(f) } = self else { return true };
        f.half_edges().into_iter().all(|h| cdt.side_of(h, point) == Orientation::CounterClockwise)
    }

    /// [`is_true`](Self::is_true) for a place that a step of the library proposes: a point inside a face is not tested,
    /// since the walk that found the face has proved it.
    #[inline(always)] // Before each insertion.
    pub(in crate::refine) fn is_true_after_walk(self, cdt: &ConstrainedTriangulation) -> bool {
        let is_walked_to = matches!(self, Self::Free { locus: Locus::Face(_), .. });
        debug_assert!(!is_walked_to || self.is_true(cdt), "a walk ends where the point is");
        is_walked_to || self.is_there(cdt)
    }

    /// [`is_true`](Self::is_true) without the test whether a point lies left of the sides of its face.
    #[inline(never)]
    fn is_there(self, cdt: &ConstrainedTriangulation) -> bool {
        let is_free_edge = |h: HalfEdgeId| {
            let faces = [h.face(), cdt.twin(h).face()];
            faces.into_iter().all(|f| cdt.is_real(f)) && !cdt.is_marked(h)
        };
        match self {
            Self::Free { point, locus: Locus::Face(f) } => point.is_finite() && cdt.is_alive(f) && cdt.is_real(f),
            Self::Free { point, locus: Locus::Edge(h) } => {
                let is_on = |[a, b]: [Point; 2]| on_segment(a, b, point) && point != a && point != b;
                point.is_finite() && cdt.is_alive(h.face()) && is_free_edge(h) && is_on(cdt.edge_points(h))
            }
            Self::Free { .. } => false,
            Self::OnEdge { edge, point } => point.is_finite() && cdt.is_alive(edge.face()) && is_free_edge(edge),
            Self::Split(h) => cdt.is_alive(h.face()) && (cdt.is_boundary_edge(h) || cdt.is_marked(h)),
        }
    }
}

/// The places that step 3 proposes for a triangle, the best first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Places {
    proposals: Vec<Proposal>,
    /// Points that are inserted after the proposal of that number.
    others: Vec<(usize, Point)>,
}

impl Places {
    /// No place yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { proposals: Vec::new(), others: Vec::new() }
    }

    /// Adds a place.
    #[inline]
    pub fn push(&mut self, place: Proposal) {
        self.proposals.push(place);
    }

    /// Adds a place for several vertices: if a vertex is inserted at `first`, the other points are inserted, too, in
    /// turn, each where a walk from the previous vertex ends. A point for which there is no room, or that encroaches
    /// upon a subsegment, is skipped.
    pub fn push_together(&mut self, first: Proposal, others: impl IntoIterator<Item = Point>) {
        let number = self.proposals.len();
        self.push(first);
        self.others.extend(others.into_iter().map(|point| (number, point)));
    }

    /// The places, the best first.
    #[must_use]
    pub fn proposals(&self) -> &[Proposal] {
        &self.proposals
    }

    /// The points that are inserted after a vertex at the place of that number, in order.
    pub fn together_with(&self, number: usize) -> impl Iterator<Item = Point> + '_ {
        self.others.iter().filter(move |other| other.0 == number).map(|other| other.1)
    }

    /// Removes all places.
    pub fn clear(&mut self) {
        self.proposals.clear();
        self.others.clear();
    }
}

impl Extend<Proposal> for Places {
    #[inline]
    fn extend<T: IntoIterator<Item = Proposal>>(&mut self, places: T) {
        self.proposals.extend(places);
    }
}
