//! Removing a segment, and walking along one.

use super::constrained_triangulation::ConstrainedTriangulation;
use super::edit::Edit;
use crate::drawing::SegmentId;
use crate::half_edge::{HalfEdgeId, Journal, VertexId};
use crate::triangulation::Closure;

impl ConstrainedTriangulation {
    /// The half-edges along an input segment, from its start to its end.
    ///
    /// Empty for a segment that was removed, whose ends are one vertex, or that lies outside the domain; parts
    /// outside a domain are missing from its chain.
    ///
    /// # Complexity
    /// The degrees of the vertices along it.
    #[must_use]
    pub fn chain(&self, segment: SegmentId) -> Vec<HalfEdgeId> {
        let Some(&[a, b]) = self.segments().get(segment.index()) else { return Vec::new() };
        let mut chain: Vec<HalfEdgeId> = Vec::new();
        let (mut at, mut before) = (a, None);
        while at != b && chain.len() < self.face_slots() * 3 {
            let Some(h) = self.step_along(segment, at, before) else { break };
            chain.push(h);
            (before, at) = (Some(at), self.dest(h));
        }
        chain
    }

    /// The edge of a segment at a vertex that does not lead back.
    fn step_along(&self, segment: SegmentId, at: VertexId, before: Option<VertexId>) -> Option<HalfEdgeId> {
        self.edges_around(at).find(|&h| Some(self.dest(h)) != before && self.runs_along(self.mark(h), segment))
    }
}

impl<J: Journal> Edit<'_, J> {
    /// Removes a segment: edges that only it constrained are free again, and legalised.
    ///
    /// Vertices on it stay. Edges that bound a carved domain stay constrained. Returns whether there was anything
    /// to remove.
    pub fn remove_segment(&mut self, segment: SegmentId) -> bool {
        let chain = self.chain(segment);
        if !chain.is_empty() {
            self.data.classes_mut().lines.remove(segment, self.j);
        }
        self.detach_segment(&chain, segment);
        !chain.is_empty()
    }

    /// Detaches a segment from edges; those that only it constrained are free again, and legalised.
    fn detach_segment(&mut self, edges: &[HalfEdgeId], segment: SegmentId) {
        for &h in edges {
            let mut mark = self.without_segment(self.mark(h), segment);
            if mark == 0 && self.closure() == Closure::Domain && self.is_boundary_edge(h) {
                mark = self.mark_of_list(&[], []);
            }
            self.data.set_mark(h, mark, self.j);
        }
        edges.iter().for_each(|&h| self.push(h));
        self.legalise();
    }

    /// The mark of an edge that has mark `mark` and is no longer part of `segment`; 0 where it is part of none.
    fn without_segment(&mut self, mark: u32, segment: SegmentId) -> u32 {
        if self.classes().lines.is_removed(segment) && self.classes().line_of_mark(mark).is_some() {
            // The line no longer lists it.
            return if self.first_segment(mark).is_some() { mark } else { 0 };
        }
        let list: Vec<SegmentId> = self.segments_of_class(mark).iter().copied().filter(|&s| s != segment).collect();
        if list.is_empty() { 0 } else { self.mark_of_list(&list, [mark]) }
    }
}
