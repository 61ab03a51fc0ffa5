//! Making the edges of a segment one path again.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use super::constrained::{ConstrainedDelaunay, SegmentId};
use crate::mesh::{HalfEdgeId, Journal, VertexId};

impl ConstrainedDelaunay {
    /// Takes a segment's name off edges that are not on its shortest way from start to end.
    ///
    /// Led through vertices within rounding of it, a segment may have come by one of them twice:
    ///
    /// ```text
    ///     a ══ w ══ b              a ══ w ══ b
    ///         ║ ║         ──>          | |
    ///         p ═ q                    p ─ q
    /// ```
    ///
    /// The shortest way is the one with the fewest edges, of equal ones that through the lowest vertices.
    ///
    /// # Complexity
    /// The degrees of the vertices along the segment.
    pub(super) fn straighten<J: Journal>(&mut self, segment: SegmentId, j: &mut J) {
        let [start, end] = self.segments[segment as usize];
        let mut came_by: BTreeMap<VertexId, HalfEdgeId> = BTreeMap::new();
        let mut edges: BTreeSet<HalfEdgeId> = BTreeSet::new();
        let mut next = VecDeque::from([start]);
        while let Some(v) = next.pop_front() {
            let mut named: Vec<HalfEdgeId> = self.edges_named(v, segment).collect();
            named.sort_unstable_by_key(|&h| self.t.dest(h));
            for h in named {
                edges.insert(h.min(self.t.twin(h)));
                let w = self.t.dest(h);
                if w != start && !came_by.contains_key(&w) {
                    came_by.insert(w, h);
                    next.push_back(w);
                }
            }
        }
        let mut at = end;
        while let Some(&h) = came_by.get(&at).filter(|_| at != start) {
            edges.remove(&h.min(self.t.twin(h)));
            at = self.t.origin(h);
        }
        // An end that is not reached lies outside the domain: there is no way to tell the others from.
        if at == start && !edges.is_empty() {
            self.take_name_off(&Vec::from_iter(edges), segment, j);
        }
    }

    /// The edges at a vertex that a segment runs along.
    fn edges_named(&self, v: VertexId, segment: SegmentId) -> impl Iterator<Item = HalfEdgeId> {
        self.t.edges_around(v).filter(move |&h| self.segments_of(h).binary_search(&segment).is_ok())
    }
}
