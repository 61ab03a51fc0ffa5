//! The checker of the constrained layer.

use super::constrained::{ConstrainedDelaunay, SegmentId};
use crate::geometry::{Orientation, Point, Segment, math, orient2d};
use crate::mesh::VertexId;
use crate::triangulation::{Closure, Fault};

/// Splits and crossings bend a segment by their rounding: this many units in the last place of its largest coordinate are
/// allowed.
const BEND_ULPS: f64 = 16.0;

impl ConstrainedDelaunay {
    /// Every broken invariant: those of the triangulation, the constrained circle test, and the chains of segments.
    ///
    /// # Complexity
    /// Linear, and the degrees of the vertices on segments.
    #[must_use]
    pub fn check(&self) -> Vec<Fault> {
        let mut faults = self.t.check_delaunay();
        if faults.is_empty() {
            for segment in 0..self.segments.len() as SegmentId {
                faults.extend(self.segment_fault(segment));
            }
        }
        faults
    }

    /// Every broken invariant but the circle test: what holds also where vertices went in without flips.
    #[must_use]
    pub fn triangulation_faults(&self) -> Vec<Fault> {
        self.t.check()
    }

    /// I13: a segment is a chain of edges from its start to its end, along it. In a carved domain parts may be missing.
    fn segment_fault(&self, segment: SegmentId) -> Option<Fault> {
        let [a, b] = self.segments[segment as usize];
        let chain = self.chain(segment);
        let end = chain.last().map_or(a, |&h| self.dest(h));
        if end != b && self.closure() == Closure::Hull && !chain.is_empty() {
            return Some(Fault::SegmentBroken(segment));
        }
        let ends = [a, b].map(|v| self.point(v));
        let inner = chain.iter().map(|&h| self.dest(h)).filter(|&v| v != b);
        let off = inner.into_iter().find(|&v| !self.lies_along(ends, v));
        off.map(|vertex| Fault::OffSegment { segment, vertex })
    }

    /// Exactly on the segment, or as near as the rounding of a split or crossing allows (which may fall on a vertex).
    fn lies_along(&self, ends: [Point; 2], v: VertexId) -> bool {
        let p = self.point(v);
        let segment = Segment::new(ends[0], ends[1]);
        orient2d(ends[0], ends[1], p) == Orientation::Collinear
            || segment.distance(p) <= BEND_ULPS * math::last_place(segment.largest_coordinate())
    }
}
