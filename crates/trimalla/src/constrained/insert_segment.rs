//! Inserting a segment: piece by piece between the vertices on it, crossings as told.
//!
//! Where crossings are split, the work is a list of pieces still to be put in:
//!
//! 1. Take a piece. Plan it up to the first vertex on its way; the rest goes back on the list.
//! 2. If the plan crosses no constraint, apply it.
//! 3. Otherwise take the first constraint crossed, compute the crossing point, rounded. If that is a
//!    vertex, use the vertex. Else release the constraint and insert the point where it lies.
//!    Both the constraint and the piece go back on the list, parted at that vertex.
//!
//! Rounding bends what is parted by an ulp, and a bent piece may cross what its straight one did
//! not: the list takes care of that too. A bound on its steps ends it in any case.

use super::apply::apply;
use super::constrained::{ConstrainedDelaunay, SegmentId};
use super::error::{ConstraintError, CrossingPair};
use super::plan::SegmentPlan;
use super::provenance::Provenance;
use crate::geometry::{BoundingBox, Orientation, Point, Segment, lexicographic, orient2d};
use crate::locate::Locus;
use crate::mesh::{Column, HalfEdgeId, Journal, NoJournal, VertexId};

/// What to do where segments cross inside both.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Crossings {
    /// Refuse, naming every pair.
    #[default]
    Refuse,
    /// Split both at the crossing point, rounded.
    Split,
}

/// A stretch of constraint that is still to be put in.
#[derive(Clone, Copy, Debug)]
struct Piece {
    from: VertexId,
    to: VertexId,
    /// Its class.
    mark: u32,
}

impl ConstrainedDelaunay {
    /// Inserts the segment between two used vertices (or duplicates of such).
    ///
    /// A segment between a vertex and itself is nothing, and gets a name all the same.
    ///
    /// # Errors
    /// [`ConstraintError::Crossing`] names the segments crossed, and nothing has changed;
    /// [`ConstraintError::UnusedVertex`], [`ConstraintError::LeavesDomain`] likewise.
    ///
    /// # Complexity
    /// Expected linear in the edges crossed, and in the degrees of the vertices on the way.
    pub fn insert_segment(
        &mut self,
        a: VertexId,
        b: VertexId,
        crossings: Crossings,
    ) -> Result<SegmentId, ConstraintError> {
        self.insert_segment_with(a, b, crossings, &mut NoJournal)
    }

    /// [`insert_segment`](Self::insert_segment), noting what is overwritten.
    ///
    /// # Errors
    /// See [`insert_segment`](Self::insert_segment).
    pub fn insert_segment_with<J: Journal>(
        &mut self,
        a: VertexId,
        b: VertexId,
        crossings: Crossings,
        j: &mut J,
    ) -> Result<SegmentId, ConstraintError> {
        let [a, b] = [a, b].map(|v| self.t.representative(v));
        let segment = self.segments.len() as SegmentId;
        if let Some(vertex) = [a, b].into_iter().find(|&v| v.index() >= self.t.points().len() || !self.t.is_used(v)) {
            return Err(ConstraintError::UnusedVertex { segment: segment as usize, vertex });
        }
        if a != b {
            let plans = self.plans(segment, a, b)?;
            if crossings == Crossings::Refuse {
                let pairs = self.pairs_in(segment, [a, b], &plans);
                if !pairs.is_empty() {
                    return Err(ConstraintError::Crossing(pairs));
                }
            }
            self.begin_segment([a, b], j);
            match &plans[..] {
                [plan] if plan.constrained.is_empty() => self.apply_piece(plan, self.class_of(segment), j),
                _ => self.work_off(Piece { from: a, to: b, mark: self.class_of(segment) }, segment, j)?,
            }
        } else {
            self.begin_segment([a, b], j);
        }
        Ok(segment)
    }

    /// Names a segment and makes its class; returns the mark.
    pub(crate) fn begin_segment<J: Journal>(&mut self, ends: [VertexId; 2], j: &mut J) -> u32 {
        let segment = self.segments.len() as SegmentId;
        if J::ACTIVE {
            j.note(Column::Segment, segment, 0);
        }
        self.segments.push(ends);
        let before = self.constraints.len();
        let mark = self.constraints.mark_of(&[segment]);
        self.note_classes(before, j);
        mark
    }

    fn class_of(&self, segment: SegmentId) -> u32 {
        self.constraints.existing_mark_of(&[segment])
    }

    /// Notes that classes were added since there were `before`.
    pub(crate) fn note_classes<J: Journal>(&self, before: usize, j: &mut J) {
        if J::ACTIVE && self.constraints.len() > before {
            j.note(Column::Constraint, before as u32, 0);
        }
    }

    /// The plans of all pieces of a segment, as long as nothing changes.
    fn plans(&self, segment: SegmentId, a: VertexId, b: VertexId) -> Result<Vec<SegmentPlan>, ConstraintError> {
        let mut plans = Vec::with_capacity(1);
        let mut from = a;
        while from != b {
            let plan = self.t.plan_towards(from, b).map_err(|_| ConstraintError::LeavesDomain {
                segment: segment as usize,
                from: self.t.point(a),
                to: self.t.point(b),
            })?;
            from = plan.to;
            plans.push(plan);
        }
        Ok(plans)
    }

    /// The input segments that the plans cross.
    fn pairs_in(&self, segment: SegmentId, ends: [VertexId; 2], plans: &[SegmentPlan]) -> Vec<CrossingPair> {
        let line = ends.map(|v| self.t.point(v));
        let mut pairs: Vec<CrossingPair> = Vec::new();
        for &h in plans.iter().flat_map(|p| &p.constrained) {
            let at = crossing_of(line, self.t.edge_points(h));
            let others = self.constraints.segments(self.t.mark(h));
            pairs.extend(others.iter().map(|&o| CrossingPair { segments: [o as usize, segment as usize], at }));
        }
        pairs
    }

    /// Puts one uncrossed piece in.
    fn apply_piece<J: Journal>(&mut self, plan: &SegmentPlan, mark: u32, j: &mut J) {
        let mark = match plan.existing {
            Some(h) => self.joined(self.t.mark(h), mark, j),
            None => mark,
        };
        apply(&mut self.t, plan, mark, self.filling, &mut self.lawson, j);
    }

    /// The class of an edge of two classes.
    fn joined<J: Journal>(&mut self, a: u32, b: u32, j: &mut J) -> u32 {
        let before = self.constraints.len();
        let mark = self.constraints.joined(a, b);
        self.note_classes(before, j);
        mark
    }

    /// The list of pieces, worked off.
    fn work_off<J: Journal>(&mut self, first: Piece, segment: SegmentId, j: &mut J) -> Result<(), ConstraintError> {
        let bound = self.step_bound();
        let mut work = vec![first];
        let mut steps = 0;
        while let Some(piece) = work.pop() {
            steps += 1;
            if piece.from == piece.to {
                continue;
            }
            let leaves = ConstraintError::LeavesDomain {
                segment: segment as usize,
                from: self.t.point(piece.from),
                to: self.t.point(piece.to),
            };
            let plan = self.t.plan_towards(piece.from, piece.to).map_err(|_| leaves)?;
            match plan.constrained.first() {
                None => {
                    work.push(Piece { from: plan.to, ..piece });
                    self.apply_piece(&plan, piece.mark, j);
                }
                Some(&h) => {
                    if steps > bound {
                        return Err(ConstraintError::CrossingsExhausted { pair: self.pair_at(h, piece), steps });
                    }
                    self.split_crossing(h, piece, &mut work, j);
                }
            }
        }
        Ok(())
    }

    /// Every two segments cross once; the rest is for rounding.
    fn step_bound(&self) -> u64 {
        let n = self.segments.len() as u64 + 16;
        n.saturating_mul(n).saturating_mul(16)
    }

    fn pair_at(&self, h: HalfEdgeId, piece: Piece) -> CrossingPair {
        let name = |mark| self.constraints.segments(mark).first().copied().unwrap_or(0) as usize;
        let at = crossing_of([piece.from, piece.to].map(|v| self.t.point(v)), self.t.edge_points(h));
        let (a, b) = (name(self.t.mark(h)), name(piece.mark));
        CrossingPair { segments: [a.min(b), a.max(b)], at }
    }

    /// Parts constraint `h` and the piece that crosses it at one vertex; both go back on the list.
    ///
    /// ```text
    ///            y                       y
    ///            |                       |  c
    ///     from ──┼──── to     ──>  from ─ v ─── to      v: the crossing point, rounded, or the vertex there
    ///            | h                     |
    ///            x                       x
    /// ```
    fn split_crossing<J: Journal>(&mut self, h: HalfEdgeId, piece: Piece, work: &mut Vec<Piece>, j: &mut J) {
        let (x, y) = (self.t.origin(h), self.t.dest(h));
        let mark = self.t.mark(h);
        let line =
            |m: u32| self.constraints.segments(m).first().map(|&s| self.segments[s as usize].map(|v| self.t.point(v)));
        if let (Some([a, b]), Some([c, d])) = (line(piece.mark), line(mark))
            && orient2d(a, b, c) == Orientation::Collinear
            && orient2d(a, b, d) == Orientation::Collinear
        {
            let [p, q] = [piece.from, piece.to].map(|v| self.t.point(v));
            let between = |v: &VertexId| {
                let r = self.t.point(*v);
                lexicographic(p, r) == lexicographic(p, q) && lexicographic(r, q) == lexicographic(p, q)
            };
            if let Some(v) = [x, y].into_iter().find(between) {
                work.push(Piece { from: v, to: piece.to, mark: piece.mark });
                work.push(Piece { from: piece.from, to: v, mark: piece.mark });
                return;
            }
        }
        let at = self.crossing_at(h, piece);
        let ulp = 4.0 * f64::EPSILON * at.x.abs().max(at.y.abs());
        let far = |v: VertexId| {
            let p = self.t.point(v);
            (p.x - at.x).abs().max((p.y - at.y).abs())
        };
        let near = [x, y, piece.from, piece.to]
            .into_iter()
            .filter(|&v| far(v) <= ulp)
            .min_by(|&v, &w| far(v).total_cmp(&far(w)).then(v.cmp(&w)));
        let v = match self.t.locate_from(h.face(), at) {
            Locus::Vertex(v) => v,
            _ if near.is_some() => near.unwrap_or(x),
            _ => self.insert_crossing(h, piece, at, j),
        };
        if v != x && v != y {
            if self.t.half_edge_between(x, y).is_some() {
                self.release(x, y, j);
            }
            work.push(Piece { from: x, to: v, mark });
            work.push(Piece { from: v, to: y, mark });
        }
        work.push(Piece { from: v, to: piece.to, mark: piece.mark });
        work.push(Piece { from: piece.from, to: v, mark: piece.mark });
    }

    /// Where a piece and constraint `h` cross, rounded: the crossing of the input segments that they are part of, as long
    /// as that is within both.
    ///
    /// Pieces are bent by rounding. Crossings computed from pieces of pieces creep along them; those of the segments
    /// themselves are one point each.
    fn crossing_at(&self, h: HalfEdgeId, piece: Piece) -> Point {
        let ends = [piece.from, piece.to].map(|v| self.t.point(v));
        let edge = self.t.edge_points(h);
        let whole =
            |mark| self.constraints.segments(mark).first().map(|&s| self.segments[s as usize].map(|v| self.t.point(v)));
        let within = |[a, b]: [Point; 2], p| BoundingBox::of([a, b]).is_some_and(|bounds| bounds.contains(p));
        let of_segments = match (whole(piece.mark), whole(self.t.mark(h))) {
            (Some([a, b]), Some([c, d])) => Segment::new(a, b).crossing_point(Segment::new(c, d)),
            _ => None,
        };
        of_segments.filter(|&p| within(ends, p) && within(edge, p)).unwrap_or_else(|| crossing_of(ends, edge))
    }

    /// Releases constraint `h` and inserts a vertex at `at`, where it lies.
    fn insert_crossing<J: Journal>(&mut self, h: HalfEdgeId, piece: Piece, at: Point, j: &mut J) -> VertexId {
        let pair = self.pair_at(h, piece);
        let near = self.t.outgoing(self.t.origin(h));
        self.release(self.t.origin(h), self.t.dest(h), j);
        let start = near.map_or(h.face(), HalfEdgeId::face);
        let locus = self.t.locate_from(start, at);
        let v = self.insert_vertex_at(at, locus, j);
        self.set_provenance(v, Provenance::Crossing { segments: pair.segments.map(|s| s as u32) }, j);
        v
    }

    /// Unmarks an edge and legalises it.
    pub(super) fn release<J: Journal>(&mut self, x: VertexId, y: VertexId, j: &mut J) {
        if let Some(h) = self.t.half_edge_between(x, y) {
            self.t.mesh.set_mark(h, 0, j);
            self.lawson.push(h);
            self.lawson.legalise_all(&mut self.t, j);
        }
    }
}

/// The point where two lines cross that are known to, rounded; the middle of the second where they are too close to
/// parallel for numbers.
fn crossing_of([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Point {
    Segment::new(a, b).crossing_point(Segment::new(c, d)).unwrap_or_else(|| Point::midpoint(c, d))
}
