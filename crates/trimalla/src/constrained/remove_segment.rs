//! Taking a segment out, and walking along one.

use super::constrained::{ConstrainedDelaunay, SegmentId};
use crate::mesh::{HalfEdgeId, Journal, NoJournal, VertexId};
use crate::triangulation::Closure;

impl ConstrainedDelaunay {
    /// The half-edges along an input segment, from its start to its end.
    ///
    /// Empty for a segment that was removed, whose ends are one vertex, or that lies outside the domain; parts
    /// outside a domain are missing from its chain.
    ///
    /// # Complexity
    /// The degrees of the vertices along it.
    #[must_use]
    pub fn chain(&self, segment: SegmentId) -> Vec<HalfEdgeId> {
        let Some(&[a, b]) = self.segments.get(segment as usize) else { return Vec::new() };
        let mut chain: Vec<HalfEdgeId> = Vec::new();
        let (mut at, mut before) = (a, None);
        while at != b && chain.len() < self.t.face_slots() * 3 {
            let Some(h) = self.step_along(segment, at, before) else { break };
            chain.push(h);
            (before, at) = (Some(at), self.t.dest(h));
        }
        chain
    }

    /// The edge of a segment at a vertex that does not lead back.
    fn step_along(&self, segment: SegmentId, at: VertexId, before: Option<VertexId>) -> Option<HalfEdgeId> {
        self.t.edges_around(at).find(|&h| Some(self.t.dest(h)) != before && self.runs_along(self.t.mark(h), segment))
    }

    /// Removes a segment: edges that only it constrained are free again, and legalised.
    ///
    /// Vertices on it stay. Edges that bound a carved domain stay constrained. Returns whether there was anything
    /// to remove.
    pub fn remove_segment(&mut self, segment: SegmentId) -> bool {
        self.remove_segment_with(segment, &mut NoJournal)
    }

    /// [`remove_segment`](Self::remove_segment), noting what is overwritten.
    pub fn remove_segment_with<J: Journal>(&mut self, segment: SegmentId, j: &mut J) -> bool {
        let chain = self.chain(segment);
        if !chain.is_empty() {
            self.constraints.lines.remove(segment, j);
        }
        self.take_name_off(&chain, segment, j);
        !chain.is_empty()
    }

    /// Takes a segment's name off edges; those that only it constrained are free again, and legalised.
    pub(super) fn take_name_off<J: Journal>(&mut self, edges: &[HalfEdgeId], segment: SegmentId, j: &mut J) {
        for &h in edges {
            let mut mark = self.without_segment(self.t.mark(h), segment, j);
            let bounds = self.t.is_on_border(h);
            if mark == 0 && self.t.closure() == Closure::Domain && bounds {
                mark = self.mark_of_list(&[], [], j);
            }
            self.t.mesh.set_mark(h, mark, j);
        }
        for &h in edges {
            self.lawson.push(h);
        }
        self.lawson.legalise_all(&mut self.t, j);
    }

    /// The mark of an edge that has mark `mark` and is no longer part of `segment`; 0 where it is part of none.
    fn without_segment<J: Journal>(&mut self, mark: u32, segment: SegmentId, j: &mut J) -> u32 {
        if self.constraints.lines.is_removed(segment) && self.constraints.line_of_mark(mark).is_some() {
            // The line no longer lists it.
            return if self.first_segment(mark).is_some() { mark } else { 0 };
        }
        let list: Vec<SegmentId> = self.segments_of_class(mark).iter().copied().filter(|&s| s != segment).collect();
        if list.is_empty() { 0 } else { self.mark_of_list(&list, [mark], j) }
    }
}
