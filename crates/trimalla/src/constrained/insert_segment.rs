//! Inserting a segment: piece by piece between the vertices on it, crossings as told.
//!
//! Where crossings are split, `split_crossings` takes over.

use super::apply::Before;
use super::constrained::{ConstrainedDelaunay, SegmentId};
use super::constraints::ClassCount;
use super::error::{ConstraintError, CrossingPair};
use super::input_sides::Beside;
use super::split_crossings::Piece;
use crate::delaunay::BuildError;
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
    /// [`ConstraintError::LeavesDomain`], [`ConstraintError::CrossingsExhausted`], [`ConstraintError::TooManySegments`],
    /// [`BuildError::TooManyPoints`]. Nothing has changed then.
    ///
    /// # Complexity
    /// Expected linear in the edges crossed, and in the degree of either end or those of the vertices on the way, whichever
    /// is less. Stretches that overlapping segments cover on the same line cost nothing.
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
        if self.segments.len() >= ConstraintError::MAX_SEGMENTS {
            return Err(ConstraintError::TooManySegments(self.segments.len() + 1));
        }
        let segment = self.segments.len() as SegmentId;
        if let Some(vertex) = [a, b].into_iter().find(|&v| v.index() >= self.t.points().len() || !self.t.is_used(v)) {
            return Err(ConstraintError::UnusedVertex { segment: segment as usize, vertex });
        }
        if a == b {
            self.name_segment([a, b], j);
            return Ok(segment);
        }
        let way = self.survey(segment, [a, b], crossings)?;
        if way == Way::Overlaps {
            self.name_segment([a, b], j);
            // What joins a line needs no class of its own.
            match self.join_line(segment, j) {
                Some(gaps) => self.fill_gaps(segment, gaps, j)?,
                None => {
                    let mark = self.mark_of_list(&[segment], [], j);
                    self.work_off(Piece { from: a, to: b, mark }, segment, &mut Some(Beside::Allowed), j)?;
                }
            }
            return Ok(segment);
        }
        let mark = self.begin_segment([a, b], j);
        if way == Way::Free {
            let before = if self.as_given { Before::Any } else { Before::Delaunay };
            self.apply_plan(mark, before, j);
        } else {
            // The first edges that are split here are straight: their segments cross.
            self.work_off(Piece { from: a, to: b, mark }, segment, &mut Some(Beside::Allowed), j)?;
        }
        Ok(segment)
    }

    /// Names a segment and makes its class; returns the mark.
    pub(crate) fn begin_segment<J: Journal>(&mut self, ends: [VertexId; 2], j: &mut J) -> u32 {
        let segment = self.name_segment(ends, j);
        self.mark_of_list(&[segment], [], j)
    }

    /// Names a segment, which has no class so far.
    fn name_segment<J: Journal>(&mut self, ends: [VertexId; 2], j: &mut J) -> SegmentId {
        let segment = self.segments.len() as SegmentId;
        if J::ACTIVE {
            j.note(Column::Segment, segment, 0);
        }
        self.segments.push(ends);
        segment
    }

    /// Notes that classes were added since there were `before`.
    pub(super) fn note_classes<J: Journal>(&self, before: ClassCount, j: &mut J) {
        if J::ACTIVE && self.constraints.count() > before {
            j.note(Column::Constraint, before.lists, u64::from(before.spans));
        }
    }

    /// Looks at the whole way of a segment before anything changes. Where it is free, the plan made last is that of the
    /// segment.
    fn survey(
        &mut self,
        segment: SegmentId,
        [a, b]: [VertexId; 2],
        crossings: Crossings,
    ) -> Result<Way, ConstraintError> {
        let (mut from, mut way, mut crossed) = (a, Way::Free, 0);
        let mut pairs: Vec<CrossingPair> = Vec::new();
        while from != b {
            self.t.plan_into(&mut self.plan, from, b).map_err(|_| ConstraintError::LeavesDomain {
                segment: segment as usize,
                from: self.t.point(a),
                to: self.t.point(b),
            })?;
            let is_marked = self.plan.existing.is_some_and(|h| self.t.is_marked(h));
            if is_marked || !self.plan.constrained.is_empty() {
                way = way.max(Way::Pieces);
                crossed += self.plan.constrained.len();
                if self.overlap_at(from, [a, b]).is_some() {
                    way = Way::Overlaps;
                    if let Some((_, to)) = self.covered(from, [a, b]) {
                        from = to;
                        continue;
                    }
                }
            }
            if crossings == Crossings::Refuse {
                self.add_pairs(segment, [a, b], &mut pairs);
            }
            from = self.plan.to;
            if from != b {
                way = way.max(Way::Pieces);
            }
        }
        if !pairs.is_empty() {
            return Err(ConstraintError::Crossing(pairs));
        }
        BuildError::if_too_many(self.t.points.len(), crossed)?;
        Ok(way)
    }

    /// Adds the input segments that the plan crosses.
    fn add_pairs(&self, segment: SegmentId, ends: [VertexId; 2], pairs: &mut Vec<CrossingPair>) {
        for &h in &self.plan.constrained {
            let at = crossing_of(ends.map(|v| self.t.point(v)), self.t.edge_points(h));
            let others = self.segments_of_class(self.t.mark(h));
            pairs.extend(others.iter().map(|&o| CrossingPair { segments: [o as usize, segment as usize], at }));
        }
    }

    /// Carries the plan out, which crosses no constraint.
    pub(super) fn apply_plan<J: Journal>(&mut self, mark: u32, before: Before, j: &mut J) {
        let mark = match self.plan.existing {
            Some(h) => self.joined(self.t.mark(h), mark, j),
            None => mark,
        };
        let how = (self.filling, before);
        let applied = self.corridor.apply(&mut self.t, &self.plan, mark, how, &mut self.lawson, j);
        debug_assert!(applied, "a plan that crosses no constraint can be carried out");
    }

    /// The mark of an edge of two marks: all segments of either.
    pub(super) fn joined<J: Journal>(&mut self, a: u32, b: u32, j: &mut J) -> u32 {
        if a == 0 || a == b {
            return b;
        }
        let classes = [a, b].map(|mark| (mark, self.constraints.line_of_mark(mark).is_some()));
        let [one, two] = [a, b].map(|mark| self.segments_of_class(mark));
        let mut list = [&one[..], &two[..]].concat();
        list.sort_unstable();
        list.dedup();
        let is_whole = |mark: u32| self.segments_of_class(mark).len() == list.len();
        match classes {
            [(span, true), (_, false)] | [(_, false), (span, true)] if is_whole(span) => return span,
            [(_, false), (_, false)] => {}
            // Segments that join a line later would run along the span that the edge had, not along the edge.
            _ => [a, b].into_iter().for_each(|mark| self.constraints.close_line_of(mark, j)),
        }
        self.mark_of_list(&list, [], j)
    }

    /// The mark of a list of segments, which edges of these marks get instead.
    pub(super) fn mark_of_list<J: Journal>(
        &mut self,
        list: &[SegmentId],
        instead: impl IntoIterator<Item = u32>,
        j: &mut J,
    ) -> u32 {
        // The segments of a line would go on without these edges.
        for mark in instead {
            self.constraints.close_line_of(mark, j);
        }
        let before = self.constraints.count();
        let mark = self.constraints.mark_of(list);
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

/// What lies on the way of a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Way {
    /// A single piece that crosses no constraint and is none yet.
    Free,
    /// Several pieces, or constraints.
    Pieces,
    /// Edges of segments on the same line.
    Overlaps,
}

/// The point where two lines cross that are known to, rounded; the middle of the second where they are too close to
/// parallel for numbers.
pub(super) fn crossing_of([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Point {
    Segment::new(a, b).crossing_point(Segment::new(c, d)).unwrap_or_else(|| Point::midpoint(c, d))
}
