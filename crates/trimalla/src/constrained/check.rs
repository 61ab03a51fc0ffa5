//! The checker of the constrained layer.

use super::constrained_triangulation::ConstrainedTriangulation;
use crate::drawing::SegmentId;
use crate::geometry::{BoundingBox, BoxTree, Point, Segment, Strip, on_segment};
use crate::half_edge::VertexId;
use crate::triangulation::{Closure, Fault, Triangulation};

impl ConstrainedTriangulation {
    /// Every broken invariant: those of the triangulation, and the chains of segments. Edges may fail the circle test.
    ///
    /// # Complexity
    /// Linear, n log n in the input vertices, and the degrees of the vertices on segments.
    #[must_use]
    pub fn check(&self) -> Vec<Fault> {
        self.with_segment_faults(Triangulation::check(self))
    }

    /// Every broken invariant, and every edge that fails the constrained circle test.
    ///
    /// # Complexity
    /// See [`check`](Self::check).
    #[must_use]
    pub fn check_delaunay(&self) -> Vec<Fault> {
        self.with_segment_faults(Triangulation::check_delaunay(self))
    }

    /// Adds the faults of segments, where the triangulation has none.
    fn with_segment_faults(&self, mut faults: Vec<Fault>) -> Vec<Fault> {
        if faults.is_empty() {
            let places = InputPlaces::of(self);
            for segment in self.segment_ids() {
                faults.extend(self.segment_fault(segment, &places));
            }
        }
        faults
    }

    /// I13: a segment is a chain of edges from its start to its end, by the rule of [`Strip`]. In a carved domain parts
    /// may be missing.
    fn segment_fault(&self, segment: SegmentId, places: &InputPlaces) -> Option<Fault> {
        let [a, b] = self.segments()[segment.index()];
        let chain = self.chain(segment);
        let mut vertices = vec![a];
        vertices.extend(chain.iter().map(|&h| self.dest(h)));
        let is_whole = vertices.last() == Some(&b);
        if !is_whole && self.closure() == Closure::Hull && !chain.is_empty() {
            return Some(Fault::SegmentBroken(segment));
        }
        let line = self.segment_points(segment);
        let strip = Strip::new(line, Strip::LAST_PLACES);
        // Two segments within rounding of each other, of a mesh that was taken up, may share edges beyond a gap.
        let may_branch = self.is_of_mesh() && !is_whole;
        let ahead = |pair: &[VertexId]| may_branch || strip.order(self.point(pair[0]), self.point(pair[1])).is_lt();
        let off = vertices.windows(2).find(|pair| !ahead(pair) || pair[1] != b && !strip.contains(self.point(pair[1])));
        if let Some(pair) = off {
            return Some(Fault::OffSegment { segment, vertex: pair[1] });
        }
        // Of a mesh that was taken up, subsegments may have been joined without a drawing to tell which vertices were
        // on them.
        if !is_whole || a == b || self.is_of_mesh() {
            return None;
        }
        vertices.sort_unstable();
        let passed_by = places.exactly_on(line).find(|v| vertices.binary_search(v).is_err());
        passed_by.map(|vertex| Fault::PassesBy { segment, vertex })
    }
}

/// The places of the used input vertices.
struct InputPlaces {
    vertices: Vec<(VertexId, Point)>,
    tree: BoxTree,
}

impl InputPlaces {
    fn of(cdt: &ConstrainedTriangulation) -> Self {
        let used = cdt.used_vertices().filter(|v| v.index() < cdt.input_points());
        let vertices: Vec<_> = used.map(|v| (v, cdt.point(v))).collect();
        let tree = BoxTree::new(vertices.iter().map(|&(_, p)| BoundingBox::around(p)).collect());
        Self { vertices, tree }
    }

    /// The used input vertices exactly on a segment, its ends included.
    fn exactly_on(&self, line: Segment) -> impl Iterator<Item = VertexId> + '_ {
        let near = self.tree.near(line, [0.0, 0.0]).into_iter().map(|i| self.vertices[i as usize]);
        near.filter(move |&(_, p)| on_segment(line.start, line.end, p)).map(|(v, _)| v)
    }
}
