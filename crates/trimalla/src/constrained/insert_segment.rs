//! Inserting a segment: piece by piece between the vertices on it, crossings as told.
//!
//! Where crossings are split, `split_crossings` takes over.

use super::apply::apply;
use super::constrained::{ConstrainedDelaunay, SegmentId};
use super::error::{ConstraintError, CrossingPair};
use super::plan::SegmentPlan;
use super::split_crossings::Piece;
use crate::geometry::{Point, Segment};
use crate::mesh::{Column, Journal, NoJournal, UndoLog, VertexId};

/// What to do where segments cross inside both.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Crossings {
    /// Refuse, naming every pair.
    #[default]
    Refuse,
    /// Split both at the crossing point, rounded.
    Split,
}

impl ConstrainedDelaunay {
    /// Inserts the segment between two used vertices (or duplicates of such).
    ///
    /// A segment between a vertex and itself is nothing, and gets a name all the same.
    ///
    /// # Errors
    /// [`ConstraintError::Crossing`] names the segments crossed; [`ConstraintError::UnusedVertex`],
    /// [`ConstraintError::LeavesDomain`], [`ConstraintError::CrossingsExhausted`]. Nothing has changed then.
    ///
    /// # Complexity
    /// Expected linear in the edges crossed, and in the degrees of the vertices on the way.
    pub fn insert_segment(
        &mut self,
        a: VertexId,
        b: VertexId,
        crossings: Crossings,
    ) -> Result<SegmentId, ConstraintError> {
        match crossings {
            Crossings::Refuse => self.insert_segment_with(a, b, crossings, &mut NoJournal),
            // Splitting may end in an error midway: what was done by then is taken back.
            Crossings::Split => self.or_as_before(|cdt, log| cdt.insert_segment_with(a, b, crossings, log)),
        }
    }

    /// Does something that is taken back if it ends in an error.
    pub(super) fn or_as_before<T>(
        &mut self,
        act: impl FnOnce(&mut Self, &mut UndoLog) -> Result<T, ConstraintError>,
    ) -> Result<T, ConstraintError> {
        let mut log = UndoLog::new();
        let here = log.checkpoint();
        let result = act(self, &mut log);
        if result.is_err() {
            self.rollback(&mut log, here);
        }
        result
    }

    /// [`insert_segment`](Self::insert_segment), noting what is overwritten.
    ///
    /// # Errors
    /// See [`insert_segment`](Self::insert_segment); but where crossings are split, taking back what was done is the
    /// caller's.
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
    pub(super) fn apply_piece<J: Journal>(&mut self, plan: &SegmentPlan, mark: u32, j: &mut J) {
        let mark = match plan.existing {
            Some(h) => self.joined(self.t.mark(h), mark, j),
            None => mark,
        };
        apply(&mut self.t, plan, mark, self.filling, &mut self.lawson, j);
    }

    /// The class of an edge of two classes.
    pub(super) fn joined<J: Journal>(&mut self, a: u32, b: u32, j: &mut J) -> u32 {
        let before = self.constraints.len();
        let mark = self.constraints.joined(a, b);
        self.note_classes(before, j);
        mark
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
pub(super) fn crossing_of([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Point {
    Segment::new(a, b).crossing_point(Segment::new(c, d)).unwrap_or_else(|| Point::midpoint(c, d))
}
