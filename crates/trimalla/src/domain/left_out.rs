//! Warnings about what a drawing has and its mesh does not.

use super::error::Warning;
use crate::constrained::ConstrainedTriangulation;
use crate::drawing::{Pslg, SegmentId};
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};

/// Whether a side of a face that will be removed is a subsegment without a kept face beside it.
///
/// Without any such face every segment keeps all of its subsegments.
#[inline]
pub(super) fn has_lost_side(cdt: &ConstrainedTriangulation, kept: &[bool], f: FaceId) -> bool {
    let is_lost = |h: HalfEdgeId| cdt.is_marked(h) && !kept[cdt.twin(h).face().index()];
    cdt.has_marked_side(f) && f.half_edges().into_iter().any(is_lost)
}

/// The warning about vertices outside a carved triangulation.
///
/// # Complexity
/// Linear.
pub(super) fn vertices_left_out(cdt: &ConstrainedTriangulation, pslg: &Pslg) -> Option<Warning> {
    let is_unused = |v: &VertexId| !cdt.is_used(*v) && cdt.representative(*v) == *v;
    let vertices = (0..pslg.points.len()).map(VertexId::from_index).filter(is_unused).map(|v| v.0);
    counted(vertices).map(|(count, first)| Warning::VerticesOutside { count, first })
}

/// Warnings about segments outside a carved triangulation, and about markers hidden by others.
///
/// # Complexity
/// Linear in the edges, a sort of the spans where segments overlap, and the segments of each.
pub(super) fn segments_left_out(cdt: &ConstrainedTriangulation, pslg: &Pslg) -> Vec<Warning> {
    let mut warnings = Vec::new();
    if !pslg.segments.is_empty() {
        let found = Found::of(cdt, pslg);
        let has_length = |s: &SegmentId| cdt.segments().get(s.index()).is_some_and(|[a, b]| a != b);
        let segments = (0..found.is_there.len()).map(SegmentId::from_index).filter(|s| !found.is_there[s.index()]);
        if let Some((count, first)) = counted(segments.filter(has_length).map(|s| s.0)) {
            warnings.push(Warning::SegmentsOutside { count, first });
        }
        let count = found.is_hidden.iter().filter(|&&is_hidden| is_hidden).count();
        warnings.extend(found.first_hidden.map(|first| Warning::MarkersHidden { count, first: first.map(|s| s.0) }));
    }
    warnings
}

/// How many there are, and the first few; `None` without any.
fn counted(all: impl Iterator<Item = u32>) -> Option<(usize, Vec<u32>)> {
    let (mut count, mut first) = (0, Vec::new());
    for id in all {
        count += 1;
        if first.len() < Warning::NAMED {
            first.push(id);
        }
    }
    (count > 0).then_some((count, first))
}

/// Which segments of a drawing, and whose markers, a mesh has.
struct Found {
    /// Whether an edge is part of each segment.
    is_there: Vec<bool>,
    /// Whether the marker of each segment is not that of an edge that is part of it.
    is_hidden: Vec<bool>,
    /// The lowest segment whose marker is hidden, and the one whose marker counts there.
    first_hidden: Option<[SegmentId; 2]>,
}

impl Found {
    fn of(cdt: &ConstrainedTriangulation, pslg: &Pslg) -> Self {
        let n = pslg.segments.len();
        let mut found = Self { is_there: vec![false; n], is_hidden: vec![false; n], first_hidden: None };
        // Edges of one span are parts of the same segments, which are computed: so once for each span.
        let mut spans = Vec::new();
        cdt.for_each_marked_edge(|h| match cdt.listed_segments(cdt.mark(h)) {
            Some(list) => found.look_at_class(list, pslg),
            None => spans.push(cdt.mark(h)),
        });
        spans.sort_unstable();
        spans.dedup();
        spans.into_iter().for_each(|mark| found.look_at_class(&cdt.segments_of_class(mark), pslg));
        found
    }

    /// Looks at the segments of one class; the lowest one with a marker gives its marker to the edges.
    fn look_at_class(&mut self, segments: &[SegmentId], pslg: &Pslg) {
        let mut shown: Option<(SegmentId, i32)> = None;
        for &s in segments.iter().filter(|&&s| s.index() < pslg.segments.len()) {
            self.is_there[s.index()] = true;
            match (shown, pslg.segment_markers.get(s.index()).copied().filter(|&marker| marker != 0)) {
                (None, Some(marker)) => shown = Some((s, marker)),
                (Some((lowest, marker)), Some(other)) if marker != other => {
                    self.is_hidden[s.index()] = true;
                    if self.first_hidden.is_none_or(|[hidden, _]| s < hidden) {
                        self.first_hidden = Some([s, lowest]);
                    }
                }
                _ => {}
            }
        }
    }
}
