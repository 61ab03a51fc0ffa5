//! Features of a drawing that nearly touch across what is outside the domain.
//!
//! ```text
//!        inside  ║ outside ║  inside         Two parts were meant to share a side. The mesh keeps both sides as they are,
//!                ║ <─────> ║                 and nothing refines the outside, so that the gap would not be seen.
//! ```
//!
//! Gaps inside the domain show in its mesh, and the forecast names those.

use super::error::{NearFeature, Warning};
use crate::constrained::ConstrainedTriangulation;
use crate::geometry::{BoundingBox, Point, Vector, math};
use crate::half_edge::{FaceId, HalfEdgeId};

/// A gap narrower than this part of the drawing's extent is named.
const NARROW: f64 = 1e-6;

/// The nearest two features that nearly touch: a vertex, and another one or a segment, that no segment joins, with
/// their distance; of equally near ones those of the lowest vertices.
///
/// They are the corners of one of the faces outside, or a corner and the side opposite.
///
/// # Complexity
/// Linear in the faces outside, and in the vertices where there are any.
pub(super) fn nearest_outside(cdt: &ConstrainedTriangulation, outside: &[FaceId]) -> Option<Warning> {
    if outside.is_empty() {
        return None;
    }
    let bounds = BoundingBox::of_finite(cdt.points().iter().copied())?;
    let scale = math::power_of_two_scale(bounds.largest_coordinate());
    let extent = ((bounds.max.x - bounds.min.x) * scale).max((bounds.max.y - bounds.min.y) * scale);
    let limit = NARROW * extent / scale;
    let limit_sq = limit * limit;
    let narrow = outside.iter().copied().filter(|&f| is_narrow(cdt, limit_sq, f));
    let found = narrow.flat_map(FaceId::half_edges).filter_map(|h| near_miss(cdt, scale, h));
    let found = found.filter(|near| near.distance < NARROW * extent);
    let less = |a: &NearMiss, b: &NearMiss| {
        a.distance.total_cmp(&b.distance).then_with(|| (a.vertex, a.other).cmp(&(b.vertex, b.other)))
    };
    let NearMiss { distance, vertex, other } = found.min_by(less)?;
    Some(Warning::NearlyTouching { vertex, other, distance: distance / scale, at: cdt.points()[vertex as usize] })
}

#[derive(Clone, Copy, Debug)]
struct NearMiss {
    /// In units of the scale.
    distance: f64,
    vertex: u32,
    other: NearFeature,
}

/// Whether the height of a face over its longest side, which is less than all distances between features of it, may be
/// below a limit, given as its square; with a factor of two to spare, far above rounding. Yes where products overflow
/// or vanish.
#[inline]
fn is_narrow(cdt: &ConstrainedTriangulation, limit_sq: f64, f: FaceId) -> bool {
    let [a, b, c] = cdt.face_points(f);
    let (ab, bc, ca) = (b - a, c - b, a - c);
    let doubled_area = ab.cross(bc);
    let longest_sq = ab.length_sq().max(bc.length_sq()).max(ca.length_sq());
    let is_wide = doubled_area * doubled_area > 4.0 * limit_sq * longest_sq && longest_sq < f64::INFINITY;
    !is_wide || limit_sq < f64::MIN_POSITIVE
}

/// The two ends of an edge that is no subsegment; or the vertex opposite a subsegment and its segment, if the vertex
/// lies beside the subsegment and no segment joins it to an end of that.
fn near_miss(cdt: &ConstrainedTriangulation, scale: f64, h: HalfEdgeId) -> Option<NearMiss> {
    let [a, b] = cdt.edge_points(h);
    let vector = |p: Point, q: Point| Vector::new(q.x * scale - p.x * scale, q.y * scale - p.y * scale);
    let along = vector(a, b);
    if !cdt.is_marked(h) {
        let (v, w) = (cdt.origin(h).0, cdt.dest(h).0);
        return Some(NearMiss {
            distance: along.length_sq().sqrt(),
            vertex: v.min(w),
            other: NearFeature::Vertex(v.max(w)),
        });
    }
    if cdt.is_marked(h.next()) || cdt.is_marked(h.prev()) {
        return None;
    }
    let to_apex = vector(a, cdt.point(cdt.apex(h)));
    let (length_sq, dot) = (along.length_sq(), along.dot(to_apex));
    let segment = cdt.first_segment_of(h)?;
    (0.0 < dot && dot < length_sq).then(|| NearMiss {
        distance: along.cross(to_apex).abs() / length_sq.sqrt(),
        vertex: cdt.apex(h).0,
        other: NearFeature::Segment(segment.0),
    })
}
