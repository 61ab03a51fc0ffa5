//! The pieces of input segments: where another segment meets one, or the drawing lists a vertex on it, a piece ends.
//!
//! ```text
//!                 c                 segment a–b, its ends aside, has the joints v and w: a segment from c ends at v, and
//!                 |                 the drawing lists w. Its pieces are a–v, v–w and w–b, as if it had been written so.
//!     a ══ p ════ v ══════ w ══ b   A split at p lies on the piece a–v.
//! ```
//!
//! Segments keep their ids, and this table holds their pieces: a split is computed from the ends of its piece, and
//! shells lie around those. So the mesh is that of the drawing with its pieces listed, bit for bit if that drawing
//! lists the same vertices.

use crate::constrained::{ConstrainedTriangulation, Provenance};
use crate::drawing::SegmentId;
use crate::half_edge::{EdgeKey, HalfEdgeId, VertexId};

/// A piece of an input segment, by its two ends in the order of the segment.
pub(in crate::refine) type Piece = [VertexId; 2];

/// The common end of two different pieces of segments.
pub(in crate::refine) fn common_end(one: Piece, other: Piece) -> Option<VertexId> {
    one.into_iter().find(|v| one != other && other.contains(v))
}

/// A joint inside a segment.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Joint {
    segment: SegmentId,
    /// Its parameter on the segment.
    t: f64,
    vertex: VertexId,
}

/// The joints inside segments, along each segment in turn.
#[derive(Clone, Debug, Default)]
pub(in crate::refine) struct Joints {
    sorted: Vec<Joint>,
}

impl Joints {
    /// Finds the joints of a triangulation whose segments are all marked.
    ///
    /// Where segments overlap, only the joints of the segment from which splits are computed are found; others are
    /// never needed.
    ///
    /// # Complexity
    /// Linear in the marked edges and the degrees of the vertices that were put on segments before, and a sort.
    pub(in crate::refine) fn of(cdt: &ConstrainedTriangulation) -> Self {
        Self::along(cdt, &marked_edges(cdt))
    }

    /// Like [`of`](Self::of), for a caller that has all marked edges.
    pub(in crate::refine) fn along(cdt: &ConstrainedTriangulation, marked: &[HalfEdgeId]) -> Self {
        let mut sorted = Vec::new();
        for &h in marked {
            let Some(segment) = cdt.finest_segment(cdt.mark(h)) else { continue };
            let ends = cdt.segments()[segment.index()];
            for vertex in [cdt.origin(h), cdt.dest(h)] {
                if !ends.contains(&vertex) && ends_pieces(cdt, vertex) {
                    sorted.push(Joint { segment, t: cdt.parameter(segment, vertex), vertex });
                }
            }
        }
        sorted.sort_unstable_by(|a, b| {
            a.segment.cmp(&b.segment).then(a.t.total_cmp(&b.t)).then_with(|| a.vertex.cmp(&b.vertex))
        });
        sorted.dedup();
        Self { sorted }
    }

    /// The piece inside which a vertex was inserted; `None` for vertices inside no piece.
    pub(in crate::refine) fn piece_of(&self, cdt: &ConstrainedTriangulation, v: VertexId) -> Option<Piece> {
        let (Provenance::OnSegment { segment, t } | Provenance::Shell { segment, t, .. }) = cdt.provenance(v) else {
            return None;
        };
        let piece = self.piece_at(segment, t);
        let [start, end] = cdt.segments()[segment.index()];
        let is_end = piece[1] == Some(v);
        (!is_end).then(|| [piece[0].unwrap_or(start), piece[1].unwrap_or(end)])
    }

    /// The piece that a subsegment is part of, if a joint ends it; `None` where that is the whole segment.
    pub(in crate::refine) fn piece_along(&self, cdt: &ConstrainedTriangulation, h: HalfEdgeId) -> Option<Piece> {
        if self.sorted.is_empty() {
            return None;
        }
        let piece = self.piece_between(cdt, cdt.mark(h), [cdt.origin(h), cdt.dest(h)])?;
        let segment = cdt.finest_segment(cdt.mark(h))?;
        (piece != cdt.segments()[segment.index()]).then_some(piece)
    }

    /// The piece of a segment, of the class of a mark, between two vertices on it; `None` where the class has no
    /// segment.
    pub(in crate::refine) fn piece_between(
        &self,
        cdt: &ConstrainedTriangulation,
        mark: u32,
        ends: [VertexId; 2],
    ) -> Option<Piece> {
        let segment = cdt.finest_segment(mark)?;
        let [a, b] = ends.map(|v| cdt.parameter(segment, v));
        let piece = self.piece_at(segment, 0.5 * (a + b));
        let [start, end] = cdt.segments()[segment.index()];
        Some([piece[0].unwrap_or(start), piece[1].unwrap_or(end)])
    }

    /// The ends of the piece, or of the whole segment, that a subsegment is part of; its own ends where it is part of
    /// none.
    pub(in crate::refine) fn whole_of(&self, cdt: &ConstrainedTriangulation, h: HalfEdgeId) -> Piece {
        let segment = || cdt.finest_segment(cdt.mark(h)).map(|s| cdt.segments()[s.index()]);
        self.piece_along(cdt, h).or_else(segment).unwrap_or_else(|| [cdt.origin(h), cdt.dest(h)])
    }

    /// Every piece, the lower end first, sorted; also those that lie outside the domain.
    pub(in crate::refine) fn pieces(&self, cdt: &ConstrainedTriangulation) -> Vec<Piece> {
        let mut pieces = Vec::with_capacity(cdt.segments().len() + self.sorted.len());
        let mut at = 0;
        for (segment, &[start, end]) in cdt.segment_ids().zip(cdt.segments()) {
            let mut from = start;
            while let Some(joint) = self.sorted.get(at).filter(|joint| joint.segment == segment) {
                pieces.push(EdgeKey::of([from, joint.vertex]).ends());
                (from, at) = (joint.vertex, at + 1);
            }
            pieces.push(EdgeKey::of([from, end]).ends());
        }
        pieces.sort_unstable();
        pieces
    }

    /// The joints on both sides of a parameter of a segment; none where the segment's own end comes first.
    fn piece_at(&self, segment: SegmentId, t: f64) -> [Option<VertexId>; 2] {
        let is_before = |joint: &Joint| joint.segment < segment || joint.segment == segment && joint.t < t;
        let at = self.sorted.partition_point(is_before);
        let on_segment = |joint: Option<&Joint>| joint.filter(|j| j.segment == segment).map(|j| j.vertex);
        [on_segment(at.checked_sub(1).and_then(|i| self.sorted.get(i))), on_segment(self.sorted.get(at))]
    }
}

/// The marked edges, for callers that need them more than once: most of the cost of finding them is that of the faces
/// without any.
pub(in crate::refine) fn marked_edges(cdt: &ConstrainedTriangulation) -> Vec<HalfEdgeId> {
    let mut marked = Vec::new();
    // A loop instead of `collect`: the nested iterators would compile to a state machine.
    cdt.for_each_marked_edge(|h| marked.push(h));
    marked
}

/// Whether a vertex inside a segment ends pieces: the input lists it, or more than the two parts of the segment meet
/// there.
///
/// It does not matter whether a vertex that is not in the input is a crossing or a split: a file does not say.
fn ends_pieces(cdt: &ConstrainedTriangulation, v: VertexId) -> bool {
    let mut marks = cdt.edges_around(v).filter(|&h| cdt.is_marked(h)).map(|h| cdt.mark(h));
    let [first, second, third] = std::array::from_fn(|_| marks.next());
    let passes = first.is_some() && first == second && third.is_none();
    cdt.provenance(v) == Provenance::Input || !passes
}
