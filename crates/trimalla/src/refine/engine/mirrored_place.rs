//! Where a subsegment is split beside a very small input angle: see `mirror.rs`.

use super::Refinement;
use crate::geometry::{CircleSide, in_diametral_disk};
use crate::half_edge::{HalfEdgeId, VertexId};
use crate::refine::measure::joints::common_end;
use crate::refine::measure::mirror::{SMALL_SINE_SQ, Wedge};

impl Refinement {
    /// The parameter at which subsegment `h` mirrors a vertex in its disk, which lies on another segment at an angle of
    /// less than a degree; `None` where no such vertex is beside it.
    pub(super) fn mirrored_place(&self, h: HalfEdgeId) -> Option<f64> {
        if !self.problem.has_small_wedge {
            return None;
        }
        let [left, right] = [h, self.cdt.twin(h)].map(|side| (self.cdt.apex(side), side));
        let sides = if left.0 < right.0 { [left, right] } else { [right, left] };
        sides.into_iter().find_map(|(vertex, side)| self.mirror_of(h, side, vertex))
    }

    fn mirror_of(&self, h: HalfEdgeId, side: HalfEdgeId, vertex: VertexId) -> Option<f64> {
        if !vertex.is_finite() || self.cdt.provenance(vertex).is_free() {
            return None;
        }
        let ends = self.cdt.edge_points(h);
        let at = self.cdt.point(vertex);
        if in_diametral_disk(ends[0], ends[1], at) != CircleSide::Inside {
            return None;
        }
        let piece = self.problem.joints.whole_of(&self.cdt, h);
        let spoke = side.prev();
        let beside = [
            self.first_marked(spoke, |spoke| self.cdt.cw(spoke)),
            self.first_marked(self.cdt.ccw(spoke), |spoke| self.cdt.ccw(spoke)),
        ];
        let apex =
            beside.into_iter().flatten().find_map(|g| common_end(piece, self.problem.joints.whole_of(&self.cdt, g)))?;
        let wedge = Wedge { apex: self.cdt.point(apex), ends, vertex: at };
        if wedge.is_below(SMALL_SINE_SQ, self.problem.ruler) { wedge.mirrored(self.problem.ruler) } else { None }
    }

    /// The first subsegment among `spoke` and the spokes that `turn` leads to, once around.
    fn first_marked(&self, spoke: HalfEdgeId, turn: impl Fn(HalfEdgeId) -> HalfEdgeId) -> Option<HalfEdgeId> {
        let next = |&at: &HalfEdgeId| Some(turn(at)).filter(|&next| next != spoke);
        std::iter::successors(Some(spoke), next).find(|&spoke| self.cdt.is_marked(spoke))
    }
}
