//! What segments do to each other, and to vertices that are not their ends.

use super::graph::Graph;
use super::near::distance;
use super::pieces::Pieces;
use crate::geometry::{Point, Segment, SegmentContact, on_segment, segment_contact};

/// A vertex on a segment or beside it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Beside {
    pub(super) vertex: u32,
    pub(super) segment: u32,
    /// 0 exactly if the vertex lies on the segment.
    pub(super) distance: f64,
}

/// All contacts of a drawing but common ends.
#[derive(Debug, Default)]
pub(super) struct Contacts {
    /// Pairs that cross inside both, and where.
    pub(super) crossings: Vec<([u32; 2], Point)>,
    /// Pairs with more than one common point, and one of those that is an end.
    pub(super) overlaps: Vec<([u32; 2], Point)>,
    /// Vertices within the tolerance of a segment, and further from its ends.
    pub(super) beside: Vec<Beside>,
}

impl Contacts {
    /// Finds them.
    ///
    /// # Complexity
    /// n log n and the pairs of segments whose pieces are near.
    pub(super) fn of(graph: &Graph<'_>, pieces: &Pieces, tolerance: f64) -> Self {
        let mut contacts = Self::default();
        for s in graph.kept() {
            let line = graph.line(s);
            for other in pieces.near(line, tolerance) {
                contacts.add_ends(graph, s, other, tolerance);
                if other > s {
                    contacts.add_pair(graph, [s, other]);
                }
            }
        }
        for v in graph.places().filter(|&v| graph.at(v).is_empty()) {
            let p = graph.point(v);
            for s in pieces.near(Segment::new(p, p), tolerance) {
                contacts.add_if_beside(graph, v, s, tolerance);
            }
        }
        contacts.beside.sort_unstable_by_key(|beside| (beside.vertex, beside.segment));
        contacts.beside.dedup_by_key(|beside| (beside.vertex, beside.segment));
        contacts
    }

    /// The ends of one segment that lie beside another.
    fn add_ends(&mut self, graph: &Graph<'_>, of: u32, segment: u32, tolerance: f64) {
        if of != segment {
            graph.ends(of).into_iter().for_each(|v| self.add_if_beside(graph, v, segment, tolerance));
        }
    }

    fn add_if_beside(&mut self, graph: &Graph<'_>, vertex: u32, segment: u32, tolerance: f64) {
        let ends = graph.ends(segment);
        if ends.contains(&vertex) {
            return;
        }
        let (p, line) = (graph.point(vertex), graph.line(segment));
        let is_on = on_segment(line.start, line.end, p);
        let measured = if is_on { 0.0 } else { line.distance(p).max(f64::MIN_POSITIVE) };
        // What is near an end is a pair of vertices, not a vertex beside a segment.
        if measured <= tolerance && line.ends().into_iter().all(|end| distance(end, p) > tolerance) {
            self.beside.push(Beside { vertex, segment, distance: measured });
        }
    }

    fn add_pair(&mut self, graph: &Graph<'_>, pair: [u32; 2]) {
        let [one, other] = pair.map(|s| graph.line(s));
        match segment_contact(one.start, one.end, other.start, other.end) {
            SegmentContact::Crossing => {
                let at = one.crossing_point(other).unwrap_or_else(|| one.midpoint());
                self.crossings.push((pair, at));
            }
            SegmentContact::Overlapping => {
                let shared = other.ends().into_iter().find(|&p| on_segment(one.start, one.end, p));
                self.overlaps.push((pair, shared.unwrap_or(one.start)));
            }
            SegmentContact::Apart | SegmentContact::Touching => {}
        }
    }

    /// Whether a vertex lies on a segment or beside it.
    pub(super) fn is_beside_any(&self, vertex: u32) -> bool {
        self.beside.binary_search_by_key(&vertex, |beside| beside.vertex).is_ok()
    }

    /// Whether a vertex lies on this segment or beside it.
    pub(super) fn is_beside(&self, vertex: u32, segment: u32) -> bool {
        self.beside.binary_search_by_key(&(vertex, segment), |beside| (beside.vertex, beside.segment)).is_ok()
    }
}
