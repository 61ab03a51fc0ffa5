//! Inserting a segment: piece by piece between the vertices on it; crossings are handled as [`Crossings`] says.
//!
//! 1. Survey the whole way, from vertex to vertex on it, before anything changes: free, in pieces, or along others.
//! 2. A free way is one plan, which is carried out. Otherwise pieces go in one after the other (`split_crossings.rs`),
//!    and only where no segment on the same line is there already (`overlaps.rs`).

use super::constrained_triangulation::ConstrainedTriangulation;
use super::crossing_pairs::crossing_pairs;
use super::edit::Edit;
use super::error::{ConstraintError, CrossingPair};
use super::input_sides::Beside;
use super::plan::SegmentPlan;
use super::split_crossings::Piece;
use crate::delaunay::BuildError;
use crate::drawing::SegmentId;
use crate::geometry::{Point, Segment};
use crate::half_edge::{Journal, VertexId};

/// What to do where segments cross inside both.
#[doc(alias = "intersections")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Crossings {
    /// Refuse, naming every pair.
    #[default]
    Refuse,
    /// Split both at the crossing point, rounded.
    Split,
}

impl Crossings {
    /// Every choice.
    pub const ALL: [Self; 2] = [Self::Refuse, Self::Split];

    /// The key, as the program spells it.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Refuse => "refuse",
            Self::Split => "split",
        }
    }

    /// One line on what it does.
    #[must_use]
    pub const fn summary(self) -> &'static str {
        match self {
            Self::Refuse => "names every pair of segments that cross, and stops",
            Self::Split => "puts a vertex at each crossing and splits both segments",
        }
    }
}

serialized_by_key!(Crossings);

impl<J: Journal> Edit<'_, J> {
    /// Inserts segments, one after the other; with crossings refused, an error names all pairs that cross. After an
    /// error the caller takes the changes back.
    ///
    /// # Errors
    /// See [`ConstraintError`].
    pub fn insert_segments(&mut self, segments: &[[u32; 2]], crossings: Crossings) -> Result<(), ConstraintError> {
        let points = self.points().len();
        for (i, ends) in segments.iter().enumerate() {
            if let Some(&v) = ends.iter().find(|&&v| v as usize >= points) {
                return Err(ConstraintError::NoSuchVertex { segment: i, vertex: VertexId(v), points });
            }
        }
        let first = self.segments().len();
        if first == 0 {
            // Reserved for all at once, so that no capacity is left over.
            self.data.reserve_segments(segments.len());
        }
        for (i, &[a, b]) in segments.iter().enumerate() {
            match self.insert_segment(VertexId(a), VertexId(b), crossings) {
                Ok(_) => {}
                Err(ConstraintError::Crossing(pairs)) if first == 0 => {
                    let all = crossing_pairs(self.points(), segments);
                    return Err(ConstraintError::Crossing(if all.is_empty() { pairs } else { all }));
                }
                Err(ConstraintError::UnusedVertex { vertex, .. }) => {
                    return Err(ConstraintError::UnusedVertex { segment: i, vertex });
                }
                Err(e) => return Err(e),
            }
        }
        Ok(())
    }

    /// Inserts the segment between two used vertices (or duplicates of such).
    ///
    /// # Errors
    /// See [`ConstrainedDelaunay::insert_segment`](super::ConstrainedDelaunay::insert_segment); where crossings are
    /// split, the caller takes the changes back after an error.
    pub fn insert_segment(
        &mut self,
        a: VertexId,
        b: VertexId,
        crossings: Crossings,
    ) -> Result<SegmentId, ConstraintError> {
        let ends @ [a, b] = [a, b].map(|v| self.representative(v));
        let segment = self.next_segment(ends)?;
        if a == b {
            self.data.name_segment(ends, self.j);
            return Ok(segment);
        }
        let mut plan = self.work.plan.take().unwrap_or_default();
        let inserted = self.insert_along(segment, ends, crossings, &mut plan);
        self.work.plan = Some(plan);
        inserted.map(|()| segment)
    }

    /// The id of a new segment between two vertices, or why there can be none.
    fn next_segment(&self, ends: [VertexId; 2]) -> Result<SegmentId, ConstraintError> {
        let count = self.segments().len();
        if count >= ConstraintError::MAX_SEGMENTS {
            return Err(ConstraintError::TooManySegments(count + 1));
        }
        let is_unused = |v: &VertexId| v.index() >= self.points().len() || !self.is_used(*v);
        match ends.into_iter().find(is_unused) {
            Some(vertex) => Err(ConstraintError::UnusedVertex { segment: count, vertex }),
            None => Ok(SegmentId::from_index(count)),
        }
    }

    /// Inserts a segment between two different vertices; `plan` is room for plans.
    fn insert_along(
        &mut self,
        segment: SegmentId,
        ends @ [from, to]: [VertexId; 2],
        crossings: Crossings,
        plan: &mut SegmentPlan,
    ) -> Result<(), ConstraintError> {
        let way = self.data.survey(segment, ends, crossings, plan)?;
        self.data.name_segment(ends, self.j);
        if way == Way::Overlaps {
            // A segment that joins a line needs no class of its own.
            if let Some(gaps) = self.join_line(segment, plan) {
                return self.fill_gaps(segment, gaps, plan);
            }
        }
        let mark = self.mark_of_list(&[segment], []);
        if way == Way::Free {
            self.apply_plan(plan, mark);
            return Ok(());
        }
        // The first edges that are split here are straight: their segments cross.
        self.insert_pieces(Piece { from, to, mark }, segment, (plan, &mut Some(Beside::Allowed)))
    }

    /// Carries out a plan that crosses no constraint.
    pub(super) fn apply_plan(&mut self, plan: &SegmentPlan, mark: u32) {
        let mark = match plan.existing {
            Some(h) => self.joined(self.mark(h), mark),
            None => mark,
        };
        let (work, t) = (&mut *self.work, self.data.triangulation_mut());
        let applied = work.corridor.apply(t, plan, mark, work.filling, &mut work.lawson, self.j);
        debug_assert!(applied, "a plan that crosses no constraint can be carried out");
    }

    /// The mark of an edge of two marks: all segments of either.
    pub(super) fn joined(&mut self, a: u32, b: u32) -> u32 {
        if a == 0 || a == b {
            return b;
        }
        let classes = [a, b].map(|mark| (mark, self.classes().line_of_mark(mark).is_some()));
        let [one, two] = [a, b].map(|mark| self.segments_of_class(mark));
        let mut list = [&one[..], &two[..]].concat();
        list.sort_unstable();
        list.dedup();
        let is_whole = |mark: u32| self.segments_of_class(mark).len() == list.len();
        match classes {
            [(span, true), (_, false)] | [(_, false), (span, true)] if is_whole(span) => return span,
            [(_, false), (_, false)] => {}
            // Segments that join a line later would run along the span that the edge had, not along the edge.
            _ => [a, b].into_iter().for_each(|mark| self.data.classes_mut().close_line_of(mark, self.j)),
        }
        self.mark_of_list(&list, [])
    }

    /// The mark of a list of segments, which edges of these marks get instead.
    pub(super) fn mark_of_list(&mut self, list: &[SegmentId], instead: impl IntoIterator<Item = u32>) -> u32 {
        // The segments of a line would go on without these edges.
        for mark in instead {
            self.data.classes_mut().close_line_of(mark, self.j);
        }
        self.data.classes_mut().mark_of(list, self.j)
    }

    /// Unmarks an edge and legalises it.
    pub(super) fn release(&mut self, x: VertexId, y: VertexId) {
        if let Some(h) = self.half_edge_between(x, y) {
            self.data.set_mark(h, 0, self.j);
            self.push(h);
            self.legalise();
        }
    }
}

impl ConstrainedTriangulation {
    /// Plans the whole way of a segment. If it is free, `plan` is the plan of the segment.
    pub(super) fn survey(
        &self,
        segment: SegmentId,
        [a, b]: [VertexId; 2],
        crossings: Crossings,
        plan: &mut SegmentPlan,
    ) -> Result<Way, ConstraintError> {
        let (mut from, mut way, mut crossed) = (a, Way::Free, 0);
        let mut pairs: Vec<CrossingPair> = Vec::new();
        while from != b {
            self.plan_into(plan, from, b).map_err(|_| ConstraintError::LeavesDomain {
                segment: segment.index(),
                from: self.point(a),
                to: self.point(b),
            })?;
            let is_marked = plan.existing.is_some_and(|h| self.is_marked(h));
            if is_marked || !plan.constrained.is_empty() {
                way = way.max(Way::Pieces);
                crossed += plan.constrained.len();
                if self.overlap_at(from, [a, b]).is_some() {
                    way = Way::Overlaps;
                    if let Some((_, to)) = self.covered(from, [a, b]) {
                        from = to;
                        continue;
                    }
                }
            }
            if crossings == Crossings::Refuse {
                self.add_pairs(segment, plan, [a, b], &mut pairs);
            }
            from = plan.to;
            if from != b {
                way = way.max(Way::Pieces);
            }
        }
        if !pairs.is_empty() {
            return Err(ConstraintError::Crossing(pairs));
        }
        BuildError::if_too_many(self.points().len(), crossed)?;
        Ok(way)
    }

    /// Adds the input segments that a plan of `segment` crosses.
    fn add_pairs(&self, segment: SegmentId, plan: &SegmentPlan, ends: [VertexId; 2], pairs: &mut Vec<CrossingPair>) {
        for &h in &plan.constrained {
            let at = crossing_of(ends.map(|v| self.point(v)), self.edge_points(h));
            let others = self.segments_of_class(self.mark(h));
            pairs.extend(others.iter().map(|&o| CrossingPair { segments: [o.index(), segment.index()], at }));
        }
    }
}

/// What a survey found on the way of a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Way {
    /// A single piece that crosses no constraint and is none yet.
    Free,
    /// Several pieces, or constraints.
    Pieces,
    /// Edges of segments on the same line.
    Overlaps,
}

/// The point where two lines cross that are known to cross, rounded; the middle of the second if they are too close to
/// parallel for rounded arithmetic.
pub(super) fn crossing_of([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Point {
    Segment::new(a, b).crossing_point(Segment::new(c, d)).unwrap_or_else(|| Point::midpoint(c, d))
}
