//! Input vertices beside a segment stay beside it: rule 4 of [`Strip`].
//!
//! A piece a–b that is split at a rounded point p is replaced by a–p and p–b. Both have every input vertex on the side
//! where a–b has it if none lies in the closed triangle a, b, p:
//!
//! ```text
//!           . p .
//!       .     w     .         The input vertex w would change sides. It need not be next to the faces that a–b crosses:
//!     a ─ ─ ─ ─ ─ ─ ─ b       p may lie beyond the rim of these, and w behind an edge of that rim.
//! ```
//!
//! The faces that the triangle meets are searched from those that a–b crosses, or that lie beside it where it is an
//! edge, over edges that meet the triangle. Signs are exact.

use std::collections::BTreeSet;

use super::constrained_triangulation::ConstrainedTriangulation;
use super::crossing_pairs::crossing_pairs;
use super::plan::SegmentPlan;
use crate::drawing::SegmentId;
use crate::geometry::{Orientation, Point, Strip, orient2d};
use crate::half_edge::{HalfEdgeId, VertexId};

/// Whether input vertices beside a segment, within rounding, may be on its chain: see rule 4 of [`Strip`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Beside {
    /// They may not, unless they are exactly on it.
    Refused,
    /// They may, where edges that cross were led through them.
    Allowed,
}

impl Beside {
    /// The rule for a drawing: vertices beside segments are on chains only if any two segments cross where there is no
    /// vertex.
    ///
    /// # Complexity
    /// That of [`crossing_pairs`].
    pub(crate) fn of(points: &[Point], segments: &[[u32; 2]]) -> Self {
        if crossing_pairs(points, segments).is_empty() { Self::Refused } else { Self::Allowed }
    }
}

impl ConstrainedTriangulation {
    /// The rule for the segments between input vertices.
    pub(super) fn beside_of_input(&self) -> Beside {
        let segments: Vec<[u32; 2]> = self.segments().iter().map(|ends| ends.map(|v| v.0)).collect();
        // Segments of a mesh whose ends are no input vertices are out of range, and passed over.
        Beside::of(&self.points()[..self.input_points()], &segments)
    }

    /// [`beside_of_input`](Self::beside_of_input), computed once and then cached in `known`.
    pub(super) fn known_beside(&self, known: &mut Option<Beside>) -> Beside {
        *known.get_or_insert_with(|| self.beside_of_input())
    }

    /// Whether a vertex is one of the input.
    pub(super) fn is_of_input(&self, v: VertexId) -> bool {
        v.index() < self.input_points()
    }

    /// Whether the chains of a class may pass through a vertex that lies exactly on a piece of them. An input vertex
    /// may lie on a piece that rounding has bent, and beside the segment.
    pub(super) fn may_pass_through(&self, v: VertexId, mark: u32, beside: impl FnOnce() -> Beside) -> bool {
        if !self.is_of_input(v) {
            return true;
        }
        let p = self.point(v);
        let is_on = |s: SegmentId| {
            let segment = self.segment_points(s);
            orient2d(segment.start, segment.end, p) == Orientation::Collinear
        };
        let is_in_reach = |s: SegmentId| Strip::new(self.segment_points(s), Strip::PARTING_PLACES).contains(p);
        let class = self.segments_of_class(mark);
        class.iter().all(|&s| is_on(s)) || beside() == Beside::Allowed && class.iter().all(|&s| is_in_reach(s))
    }

    /// Whether a planned piece that is split at a point would have an input vertex on another side, or on it.
    pub(super) fn changes_sides(&self, plan: &SegmentPlan, p: Point) -> bool {
        let Some(swept) = Swept::new(self, [plan.from, plan.to], p) else { return false };
        let (beside, rim) = match swept.turn {
            Orientation::CounterClockwise => (&plan.left, &plan.left_rim),
            _ => (&plan.right, &plan.right_rim),
        };
        beside.iter().any(|&w| swept.holds(w)) || swept.reaches_input(rim.iter().map(|&h| self.twin(h)))
    }

    /// Whether an edge that is split at a point would have an input vertex on another side, or on it.
    pub(super) fn edge_changes_sides(&self, h: HalfEdgeId, p: Point) -> bool {
        let Some(swept) = Swept::new(self, [self.origin(h), self.dest(h)], p) else { return false };
        let first = if swept.turn == Orientation::CounterClockwise { h } else { self.twin(h) };
        swept.reaches_input(std::iter::once(first))
    }
}

/// The closed triangle between a piece and its two parts.
struct Swept<'a> {
    cdt: &'a ConstrainedTriangulation,
    ends: [VertexId; 2],
    corners: [Point; 3],
    /// The side of the piece on which the triangle lies.
    turn: Orientation,
}

impl<'a> Swept<'a> {
    /// The triangle of a piece split at `p`; `None` where `p` is exactly on its line.
    fn new(cdt: &'a ConstrainedTriangulation, ends: [VertexId; 2], p: Point) -> Option<Self> {
        let [a, b] = ends.map(|v| cdt.point(v));
        let turn = orient2d(a, b, p);
        (turn != Orientation::Collinear).then_some(Self { cdt, ends, corners: [a, b, p], turn })
    }

    fn sides(&self) -> [[Point; 2]; 3] {
        let [a, b, p] = self.corners;
        [[a, b], [b, p], [p, a]]
    }

    /// Whether an input vertex lies in the triangle, not at a corner.
    fn holds(&self, v: VertexId) -> bool {
        let w = self.cdt.point(v);
        let away = self.turn.reversed();
        self.cdt.is_of_input(v)
            && !self.ends.contains(&v)
            && w != self.corners[2]
            && self.sides().into_iter().all(|[x, y]| orient2d(x, y, w) != away)
    }

    /// Whether an edge meets the triangle: neither a side of the triangle nor the edge separates the two.
    fn meets(&self, h: HalfEdgeId) -> bool {
        let [p, q] = self.cdt.edge_points(h);
        let away = self.turn.reversed();
        let is_parted = self.sides().into_iter().any(|[x, y]| [p, q].into_iter().all(|w| orient2d(x, y, w) == away));
        let first = orient2d(p, q, self.corners[0]);
        let is_beside = first != Orientation::Collinear && self.corners.iter().all(|&w| orient2d(p, q, w) == first);
        !is_parted && !is_beside
    }

    /// Whether the triangle holds an input vertex beyond some of these half-edges, which are of the faces to be
    /// searched.
    ///
    /// # Complexity
    /// The faces that the triangle meets.
    fn reaches_input(&self, first: impl Iterator<Item = HalfEdgeId>) -> bool {
        let t = self.cdt;
        let mut open: Vec<HalfEdgeId> = first.filter(|&h| self.meets(h)).collect();
        let mut seen: BTreeSet<HalfEdgeId> = BTreeSet::new();
        while let Some(h) = open.pop() {
            if !t.is_real(h.face()) || !seen.insert(h) {
                continue;
            }
            if self.holds(t.apex(h)) {
                return true;
            }
            open.extend([h.next(), h.prev()].into_iter().filter(|&h| self.meets(h)).map(|h| t.twin(h)));
        }
        false
    }
}
