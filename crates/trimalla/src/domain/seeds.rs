//! The side of a segment on which a seed within rounding of it lies.
//!
//! Splits and crossings bend a segment by some last places. A seed that the drawing has beside the segment may then lie
//! exactly on an edge of it, or across. So the side is decided by the segment of the drawing, not by the edge:
//!
//! ```text
//!             v                     the seed s lies left of the segment a–b, and right of its edges, which were
//!       . ' s   ' .                 bent to v: its face is the one left of them
//!     a ─ ─ ─ ─ ─ ─ b
//! ```

use super::build::SeedPlace;
use crate::constrained::ConstrainedTriangulation;
use crate::geometry::{Orientation, Point, Segment, Strip, orient2d};
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};

/// A seed may lie across two edges of a triangle, and across those of the next triangle.
const MOST_STEPS: usize = 8;

/// On which side of the segment of a constrained edge a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    /// On the side of the half-edge's face.
    Inside,
    On,
    Outside,
}

/// The place of a seed that lies in a face, where no segment has it on its other side.
pub(super) fn in_face(cdt: &ConstrainedTriangulation, at: Point, face: FaceId) -> SeedPlace {
    let mut face = face;
    for _ in 0..MOST_STEPS {
        let across = face.half_edges().into_iter().find(|&h| side_of(cdt, h, at) == Some(Side::Outside));
        let Some(h) = across else { break };
        face = cdt.twin(h).face();
        if !cdt.is_real(face) {
            return SeedPlace::Outside;
        }
    }
    SeedPlace::Face(face)
}

/// The place of a seed on a constrained edge.
pub(super) fn on_edge(cdt: &ConstrainedTriangulation, at: Point, h: HalfEdgeId) -> SeedPlace {
    let face = match side_of(cdt, h, at) {
        Some(Side::Inside) => h.face(),
        Some(Side::Outside) => cdt.twin(h).face(),
        Some(Side::On) | None => return SeedPlace::OnSegment,
    };
    if cdt.is_real(face) { SeedPlace::Face(face) } else { SeedPlace::Outside }
}

/// The place of a seed on a vertex of segments: the face that has it on its side of all segments there.
pub(super) fn on_vertex(cdt: &ConstrainedTriangulation, at: Point, v: VertexId) -> SeedPlace {
    let spokes: Vec<HalfEdgeId> = cdt.star(v).collect();
    if spokes.iter().any(|&h| cdt.is_marked(h) && side_of(cdt, h, at).is_none_or(|side| side == Side::On)) {
        return SeedPlace::OnSegment;
    }
    // The face left of a spoke lies between it and the next one counter-clockwise.
    let is_inside = |h: &HalfEdgeId| {
        let f = h.face();
        cdt.is_real(f) && sector(cdt, *h).into_iter().all(|side| side_of(cdt, side, at) == Some(Side::Inside))
    };
    spokes.iter().find(|h| is_inside(h)).map_or(SeedPlace::OnSegment, |h| SeedPlace::Face(h.face()))
}

/// The constrained half-edges that bound the sector at its origin in which the face of `h` lies, with the sector
/// inside.
fn sector(cdt: &ConstrainedTriangulation, h: HalfEdgeId) -> Vec<HalfEdgeId> {
    let bound = cdt.face_slots();
    let clockwise = std::iter::successors(Some(h), |&g| Some(cdt.cw(g))).take(bound).find(|&g| cdt.is_marked(g));
    let counter =
        std::iter::successors(Some(cdt.ccw(h)), |&g| Some(cdt.ccw(g))).take(bound).find(|&g| cdt.is_marked(g));
    clockwise.into_iter().chain(counter.map(|g| cdt.twin(g))).collect()
}

/// On which side of the segment of a half-edge a point lies; `None` for edges of no segment.
fn side_of(cdt: &ConstrainedTriangulation, h: HalfEdgeId, at: Point) -> Option<Side> {
    let &segment = cdt.segments_of(h).first()?;
    let [a, b] = cdt.segments()[segment.index()].map(|v| cdt.point(v));
    let [p, q] = cdt.edge_points(h);
    let strip = Strip::new(Segment::new(a, b), Strip::LAST_PLACES);
    let left = if strip.order(p, q).is_lt() { Orientation::CounterClockwise } else { Orientation::Clockwise };
    Some(match orient2d(a, b, at) {
        Orientation::Collinear => Side::On,
        side if side == left => Side::Inside,
        _ => Side::Outside,
    })
}
