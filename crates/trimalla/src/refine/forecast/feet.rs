//! A triangulation whose edge lengths show how close features are: vertices near segments have feet on them.
//!
//! In a constrained Delaunay triangulation a vertex may be close to the middle of a long segment although no edge is
//! short. So each segment that is close to an input vertex gets a vertex at the foot of the perpendicular from that
//! vertex:
//!
//! ```text
//!            v                         v
//!         /     \                   /  |  \        v─f is as long as v is far from the segment
//!      a ═════════ b     ──>     a ═══ f ═══ b
//! ```
//!
//! 1. Every constrained edge is queued.
//! 2. An edge is taken from the queue. If the apex of a triangle at it is an input vertex that is nearer to the edge
//!    than its foot is to the ends, the edge is split at the foot. The apex then lies above an end of both halves, and
//!    needs no further foot there.
//! 3. The halves and the constrained edges around the foot are queued.
//!
//! A vertex whose own segment meets the edge at a common end is skipped: at a small input angle refinement stops at
//! shells, and the two sides do not count as close.

use std::collections::VecDeque;

use crate::constrained::{ConstrainedTriangulation, Workspace};
use crate::half_edge::{EdgeKey, FaceId, HalfEdgeId, NoJournal, VertexId};
use crate::refine::measure::joints::{Piece, common_end};
use crate::refine::measure::ruler::Ruler;

/// Feet for each vertex and constrained edge, at most; drawings need fewer than one for each.
const MOST_FEET: usize = 4;

/// The triangulation with its feet.
#[derive(Debug)]
pub(super) struct Footed {
    pub(super) cdt: ConstrainedTriangulation,
    work: Workspace,
    pub(super) ruler: Ruler,
    /// The piece that a foot lies on; none for other vertices.
    foot_on: Vec<Option<Piece>>,
    /// Every piece, sorted.
    pieces: Vec<Piece>,
}

impl Footed {
    /// Inserts feet into a copy of a triangulation.
    ///
    /// # Complexity
    /// One insertion a foot; the number of feet is bounded by a multiple of vertices and pieces.
    pub(super) fn of(cdt: &ConstrainedTriangulation) -> Self {
        let mut pieces: Vec<Piece> =
            cdt.edges().filter(|&h| cdt.is_marked(h)).map(|h| cdt.edge_key(h).ends()).collect();
        pieces.sort_unstable();
        let ruler = Ruler::for_box(cdt.bounding_box());
        let foot_on = vec![None; cdt.points().len()];
        let mut footed = Self { cdt: cdt.clone(), work: Workspace::default(), ruler, foot_on, pieces };
        footed.insert_feet();
        footed
    }

    fn insert_feet(&mut self) {
        let cdt = &self.cdt;
        let mut waiting: Vec<(Piece, HalfEdgeId)> =
            cdt.edges().filter(|&h| cdt.is_marked(h)).map(|h| (cdt.edge_key(h).ends(), h)).collect();
        waiting.sort_unstable();
        let mut waiting = VecDeque::from(waiting);
        let mut left = MOST_FEET * (self.cdt.points().len() + self.pieces.len());
        while let Some((subsegment, slot)) = waiting.pop_front() {
            let Some(h) = self.find(subsegment, slot) else { continue };
            let Some((h, t)) = self.foot_of_an_apex(h).filter(|_| left > 0) else { continue };
            let piece = self.piece_of(h);
            let (point, provenance) = self.cdt.point_on_subsegment(h, t);
            // If rounding leaves no room for a foot, the vertex is practically on the segment, which edge lengths show.
            let mut journal = NoJournal;
            let mut edit = self.cdt.edit(&mut self.work, &mut journal);
            let Ok(foot) = edit.split_subsegment(h, point, provenance) else { continue };
            left -= 1;
            if self.foot_on.len() <= foot.index() {
                self.foot_on.resize(foot.index() + 1, None);
            }
            self.foot_on[foot.index()] = Some(piece);
            let around = self.cdt.faces_around(foot).flat_map(FaceId::half_edges);
            let mut around: Vec<_> =
                around.filter(|&g| self.cdt.is_marked(g)).map(|g| (self.cdt.edge_key(g).ends(), g)).collect();
            around.sort_unstable();
            waiting.extend(around);
        }
    }

    /// The half-edge of a subsegment, which usually is still in the slot where it was when it was queued.
    fn find(&self, [a, b]: Piece, slot: HalfEdgeId) -> Option<HalfEdgeId> {
        let there = self.cdt.is_real(slot.face()) && self.cdt.edge_key(slot).ends() == [a, b];
        if there { Some(slot) } else { self.cdt.half_edge_between(a, b) }
    }

    /// The foot of the nearer apex that needs one, as a parameter of `h` or its twin.
    fn foot_of_an_apex(&self, h: HalfEdgeId) -> Option<(HalfEdgeId, f64)> {
        let sides = [h, self.cdt.twin(h)].into_iter().filter_map(|h| Some((h, self.foot_of_apex(h)?)));
        sides.min_by(|(_, (_, one)), (_, (_, two))| one.total_cmp(two)).map(|(h, (t, _))| (h, t))
    }

    /// The parameter of the foot of the apex of `h` if it needs one, and the apex' distance.
    fn foot_of_apex(&self, h: HalfEdgeId) -> Option<(f64, f64)> {
        let apex = self.cdt.apex(h);
        if !self.cdt.is_real(h.face()) || self.foot_on[apex.index()].is_some() {
            return None;
        }
        let [a, b] = self.cdt.edge_points(h);
        let (along, to_apex) = (self.ruler.vector(a, b), self.ruler.vector(a, self.cdt.point(apex)));
        let length = along.length_sq().sqrt();
        let (t, distance) = (to_apex.dot(along) / along.length_sq(), along.cross(to_apex).abs() / length);
        let near = distance < length * t.min(1.0 - t);
        (near && !self.meets(apex, self.piece_of(h))).then_some((t, distance))
    }

    /// The piece that a subsegment is part of.
    pub(super) fn piece_of(&self, h: HalfEdgeId) -> Piece {
        let [a, b] = self.cdt.edge_key(h).ends();
        self.foot_on[a.index()].or(self.foot_on[b.index()]).unwrap_or([a, b])
    }

    /// The piece that a vertex is a foot on.
    pub(super) fn foot_on(&self, v: VertexId) -> Option<Piece> {
        self.foot_on[v.index()]
    }

    /// Whether a vertex is an end of a piece, or joined by another piece to one.
    fn meets(&self, v: VertexId, piece: Piece) -> bool {
        let joined = |end: VertexId| v == end || self.joins(v, end);
        piece.into_iter().any(joined)
    }

    /// Whether a piece joins two vertices.
    pub(super) fn joins(&self, u: VertexId, v: VertexId) -> bool {
        self.pieces.binary_search(&EdgeKey::of([u, v]).ends()).is_ok()
    }

    /// Whether the distance between two vertices is a feature, not just where segments meet or a foot happens to lie.
    pub(super) fn is_feature(&self, u: VertexId, v: VertexId) -> bool {
        match (self.foot_on(u), self.foot_on(v)) {
            (None, None) => true,
            (Some(piece), None) => !self.meets(v, piece),
            (None, Some(piece)) => !self.meets(u, piece),
            (Some(one), Some(two)) => one != two && common_end(one, two).is_none(),
        }
    }
}
