//! Splits beside very small input angles: at the distance of the other segment's vertex, not in the middle.
//!
//! ```text
//!                         ___..q        q, on one segment from A, is in the disk of x–y, a part of the other segment. A
//!           ___...────'''''             split of x–y in the middle would be in a disk of the first segment, and so on until
//!     A ═════════ x ═══ m ═══ y         the parts are as short as the two segments are apart. After a split at m, as far
//!                                       from A as q is, no vertex is in the disk of any part.
//! ```
//!
//! Shells do this near `A`, for subsegments that end at `A`. Farther out, the vertices of both segments depend on the
//! ends of the segments and the splits of either.
//!
//! # Source
//! Our own, after the concentric shells of `[Ruppert95]` section 5.

use super::joints::{Joints, Piece, common_end};
use super::ruler::Ruler;
use crate::constrained::{ConstrainedTriangulation, Released, SegmentPlan};
use crate::geometry::{CircleSide, Point, Vector, in_diametral_disk};
use crate::half_edge::{EdgeKey, HalfEdgeId, VertexId};

/// One degree, in degrees and as the square of its sine, with room for rounding. At wider angles splits in the middle
/// cost little, and the mesh is more even.
pub(in crate::refine) const MIRRORED_DEG: f64 = 1.000_000_02;
pub(in crate::refine) const SMALL_SINE_SQ: f64 = 3.045_865e-4;
/// The squared sine of 60 degrees, below which vertices at equal distances from the apex are in no disk of the other
/// piece.
const SHELL_SINE_SQ: f64 = 0.75;

/// Whether two subsegments meet at less than two degrees somewhere, or may do so outside the domain: elsewhere nothing
/// is mirrored at less than one.
///
/// # Complexity
/// Linear in the segments, the marked edges, and the degrees of the vertices where two of those meet.
pub(in crate::refine) fn has_small_wedge(cdt: &ConstrainedTriangulation, marked: &[HalfEdgeId], ruler: Ruler) -> bool {
    if cdt.segments().iter().flatten().any(|&v| !cdt.is_used(v)) {
        return true;
    }
    let (mut ends, mut shared) = (vec![0_u8; cdt.points().len()], Vec::new());
    for v in marked.iter().flat_map(|&h| [cdt.origin(h), cdt.dest(h)]) {
        let count = &mut ends[v.index()];
        *count = count.saturating_add(1);
        if *count == 2 {
            shared.push(v);
        }
    }
    shared.into_iter().any(|v| is_small_wedge_at(cdt, ruler, v))
}

/// Whether two of the subsegments at a vertex that follow each other around it meet at less than two degrees.
fn is_small_wedge_at(cdt: &ConstrainedTriangulation, ruler: Ruler, v: VertexId) -> bool {
    let marked = cdt.edges_around(v).filter(|&h| cdt.is_marked(h));
    let along: Vec<Vector> = marked.map(|h| ruler.vector(cdt.point(v), cdt.point(cdt.dest(h)))).collect();
    (0..along.len()).any(|i| {
        let (a, b) = (along[i], along[(i + 1) % along.len()]);
        let cross = a.cross(b);
        a.dot(b) > 0.0 && cross * cross < 4.0 * SMALL_SINE_SQ * a.length_sq() * b.length_sq()
    })
}

/// A subsegment, and a vertex of another piece of a segment that meets its own at an apex.
#[derive(Clone, Copy, Debug)]
pub(in crate::refine) struct Wedge {
    /// Where the two pieces of segments meet.
    pub(in crate::refine) apex: Point,
    /// The ends of the subsegment.
    pub(in crate::refine) ends: [Point; 2],
    /// A vertex of the other piece.
    pub(in crate::refine) vertex: Point,
}

impl Wedge {
    /// The squared sine of the angle between the two pieces, where that is less than 90 degrees.
    fn sine_sq(&self, ruler: Ruler) -> Option<f64> {
        let [first, last] = self.distances(ruler);
        let far = self.ends[usize::from(first < last)];
        let (u, v) = (ruler.vector(self.apex, far), ruler.vector(self.apex, self.vertex));
        let cross = u.cross(v);
        (u.dot(v) > 0.0).then(|| cross * cross / (u.length_sq() * v.length_sq()))
    }

    /// Whether the two pieces meet at less than the angle of this squared sine.
    pub(in crate::refine) fn is_below(&self, sine_sq: f64, ruler: Ruler) -> bool {
        self.sine_sq(ruler).is_some_and(|found| found < sine_sq)
    }

    /// The parameter of the point of the subsegment that is as far from the apex as the vertex is, if that is no nearer
    /// to an end than the vertex is to the subsegment: an end as near is its mirror image already.
    pub(in crate::refine) fn mirrored(&self, ruler: Ruler) -> Option<f64> {
        let [first, last] = self.distances(ruler);
        let t = (ruler.length_sq(self.apex, self.vertex).sqrt() - first) / (last - first);
        let [start, end] = self.ends;
        let along = ruler.vector(start, end);
        let nearest = along.cross(ruler.vector(start, self.vertex)).abs() / along.length_sq();
        (t > nearest && t < 1.0 - nearest).then_some(t)
    }

    /// The distances of the ends from the apex.
    fn distances(&self, ruler: Ruler) -> [f64; 2] {
        self.ends.map(|p| ruler.length_sq(self.apex, p).sqrt())
    }
}

/// Where released segments are split: if a vertex of another piece is in the disk and the pieces meet at less than 60
/// degrees, at the distance of that vertex from the common end; else in the middle.
pub(in crate::refine) struct Mirrors<'a> {
    joints: &'a Joints,
    /// [All pieces](Joints::pieces).
    pieces: &'a [Piece],
    ruler: Ruler,
}

impl<'a> Mirrors<'a> {
    pub(in crate::refine) const fn new(joints: &'a Joints, pieces: &'a [Piece], ruler: Ruler) -> Self {
        Self { joints, pieces, ruler }
    }

    /// The parameter at which a stretch of a released segment is split, given the plan with the edges it crosses.
    pub(in crate::refine) fn place(
        &self,
        cdt: &ConstrainedTriangulation,
        stretch: Released,
        plan: &SegmentPlan,
    ) -> f64 {
        let Some(piece) = self.joints.piece_between(cdt, stretch.mark, [stretch.from, stretch.to]) else { return 0.5 };
        let ends = [stretch.from, stretch.to].map(|v| cdt.point(v));
        let beside = plan.left.iter().chain(&plan.right);
        beside.copied().find_map(|v| self.mirror_of(cdt, piece, ends, v)).unwrap_or(0.5)
    }

    fn mirror_of(&self, cdt: &ConstrainedTriangulation, piece: Piece, ends: [Point; 2], v: VertexId) -> Option<f64> {
        let at = cdt.point(v);
        if in_diametral_disk(ends[0], ends[1], at) != CircleSide::Inside {
            return None;
        }
        let apex = match self.joints.piece_of(cdt, v) {
            Some(other) => common_end(piece, other),
            None => piece.into_iter().find(|&end| self.pieces.binary_search(&EdgeKey::of([v, end]).ends()).is_ok()),
        }?;
        let wedge = Wedge { apex: cdt.point(apex), ends, vertex: at };
        if wedge.is_below(SHELL_SINE_SQ, self.ruler) { wedge.mirrored(self.ruler) } else { None }
    }
}
