//! Segments that run along others on one line.
//!
//! 1. On the way of a new segment the survey meets an edge of a segment, or of a line of segments, that is exactly on
//!    one line with it ([`overlap_at`](ConstrainedTriangulation::overlap_at)).
//! 2. If that is a segment which overlapped none so far, a line is made of it, and its edges become spans of that line
//!    ([`line_of_alone`](Edit::line_of_alone)).
//! 3. The new segment joins the line. Stretches that the line covers need no work at all, however many edges they have;
//!    the gaps before, between and behind them are filled as new pieces ([`fill_gaps`](Edit::fill_gaps)).
//!
//! Degenerate cases: crossings bend a segment by their rounding, and a vertex off its line is none at which a span
//! could end: both edges beside it get the span between the nearest input vertices exactly on the line. Where such a
//! chain does not run straight forward, where the line is closed, or where the new segment starts beside the chain,
//! nothing is joined, and each edge lists its segments instead.

use std::borrow::Cow;

use super::classes::Class;
use super::constrained_triangulation::ConstrainedTriangulation;
use super::edit::Edit;
use super::error::ConstraintError;
use super::input_sides::Beside;
use super::lines::Span;
use super::plan::{FirstStep, SegmentPlan};
use super::split_crossings::Piece;
use crate::drawing::SegmentId;
use crate::geometry::{Orientation, lexicographically_less, orient2d};
use crate::half_edge::{HalfEdgeId, Journal, VertexId};
use crate::triangulation::Closure;

/// Spokes of a vertex among which the edge of a bent segment is looked for.
const MOST_SPOKES: usize = 64;

/// Reading classes.
impl ConstrainedTriangulation {
    /// The input segments of a class of edges, sorted.
    pub(crate) fn segments_of_class(&self, mark: u32) -> Cow<'_, [SegmentId]> {
        match self.class(mark) {
            Class::List(list) => Cow::Borrowed(list),
            Class::Span(span) => {
                let mut list: Vec<SegmentId> = self.covering(span).collect();
                list.sort_unstable();
                Cow::Owned(list)
            }
        }
    }

    /// The input segments of a class, sorted; `None` where it is a span of a line, so that they are computed.
    #[inline]
    pub(crate) fn listed_segments(&self, mark: u32) -> Option<&[SegmentId]> {
        match self.class(mark) {
            Class::List(list) => Some(list),
            Class::Span(_) => None,
        }
    }

    /// The lowest of the input segments that an edge is part of.
    pub(crate) fn first_segment_of(&self, h: HalfEdgeId) -> Option<SegmentId> {
        self.first_segment(self.mark(h))
    }

    /// The lowest of the input segments of a class.
    pub(super) fn first_segment(&self, mark: u32) -> Option<SegmentId> {
        match self.class(mark) {
            Class::List(list) => list.first().copied(),
            Class::Span(span) if !self.classes().lines.is_removed(span.first) => Some(span.first),
            Class::Span(span) => self.covering(span).min(),
        }
    }

    /// Whether edges of a class are part of a segment.
    pub(super) fn runs_along(&self, mark: u32, segment: SegmentId) -> bool {
        match self.class(mark) {
            Class::List(list) => list.binary_search(&segment).is_ok(),
            Class::Span(span) => {
                let lines = &self.classes().lines;
                lines.line_of_segment(segment) == Some(lines.line_of_span(span))
                    && !lines.is_removed(segment)
                    && self.covers(segment, span)
            }
        }
    }

    /// The segments of a line that cover a span, in no order.
    pub(super) fn covering(&self, span: Span) -> impl Iterator<Item = SegmentId> + '_ {
        let lines = &self.classes().lines;
        lines.members(lines.line_of_span(span)).filter(move |&segment| self.covers(segment, span))
    }

    /// Whether a segment of a line reaches from one end of a span to the other.
    fn covers(&self, segment: SegmentId, span: Span) -> bool {
        let [low, high] = self.in_order(self.segments()[segment.index()]);
        !self.is_before(span.ends[0], low) && !self.is_before(high, span.ends[1])
    }

    /// Whether a vertex comes before another one along a line of both.
    fn is_before(&self, a: VertexId, b: VertexId) -> bool {
        a != b && lexicographically_less(self.point(a), self.point(b))
    }

    /// Two vertices in their order along a line.
    fn in_order(&self, [a, b]: [VertexId; 2]) -> [VertexId; 2] {
        if self.is_before(b, a) { [b, a] } else { [a, b] }
    }
}

/// Step 1: finding overlaps, nothing changed.
impl ConstrainedTriangulation {
    /// The edge at a vertex from which a segment that is exactly on one line with `[from, to]` runs on towards `to`.
    pub(super) fn overlap_at(&self, from: VertexId, [start, to]: [VertexId; 2]) -> Option<HalfEdgeId> {
        if self.closure() != Closure::Hull {
            return None; // Parts of segments may be missing.
        }
        if ![start, to].into_iter().all(|v| self.may_end_span(v)) {
            return None;
        }
        let fits = |&h: &HalfEdgeId| self.is_marked(h) && self.runs_on_one_line(h, [start, to]);
        match self.first_step(from, to) {
            Ok(FirstStep::Along(h)) if fits(&h) => Some(h),
            // Crossings may have bent the edge off the line, and a vertex put in later may be exactly on it.
            Ok(_) => self.edges_around(from).take(MOST_SPOKES).find(fits),
            Err(_) => None,
        }
    }

    /// Whether an edge belongs to a segment or an open line exactly on one line with a new segment, and leads the way
    /// that the segment has from its start to its end.
    fn runs_on_one_line(&self, h: HalfEdgeId, [start, to]: [VertexId; 2]) -> bool {
        let forward = self.is_before(start, to);
        match self.class(self.mark(h)) {
            Class::List(&[other]) if self.classes().lines.line_of_segment(other).is_none() => {
                let [p, q, x, y] = [self.origin(h), self.dest(h), start, to].map(|v| self.point(v));
                self.are_on_one_line(self.segments()[other.index()], [start, to]) && (q - p).dot(y - x) > 0.0
            }
            Class::List(_) => false,
            Class::Span(span) => {
                let line = self.classes().lines.line_of_span(span);
                self.classes().lines.is_open(line)
                    && span.ends[usize::from(!forward)] == self.origin(h)
                    && self.are_on_one_line(self.classes().lines.ends(line), [start, to])
            }
        }
    }

    /// Whether a span may end at a vertex: an input vertex, which is never merged away or moved.
    fn may_end_span(&self, v: VertexId) -> bool {
        v.index() < self.input_points()
    }

    fn are_on_one_line(&self, [a, b]: [VertexId; 2], others: [VertexId; 2]) -> bool {
        others.into_iter().all(|v| self.is_on_line([a, b], v))
    }

    fn is_on_line(&self, [a, b]: [VertexId; 2], v: VertexId) -> bool {
        let [a, b, p] = [a, b, v].map(|v| self.point(v));
        orient2d(a, b, p) == Orientation::Collinear
    }

    /// How far a line covers the way of a segment from a vertex on: the line, and the end of what it covers or of the
    /// segment, whichever comes first. `None` where no line does.
    pub(super) fn covered(&self, from: VertexId, [start, to]: [VertexId; 2]) -> Option<(u32, VertexId)> {
        let h = self.overlap_at(from, [start, to])?;
        let line = self.classes().line_of_mark(self.mark(h))?;
        let [low, high] = self.classes().lines.ends(line);
        let (end, goes_on) =
            if self.is_before(start, to) { (high, self.is_before(high, to)) } else { (low, self.is_before(to, low)) };
        if goes_on || end == to {
            return Some((line, end));
        }
        // Inside the stretch: a vertex of its chain, or one beside it?
        let back = self.overlap_at(to, [to, from])?;
        (self.classes().line_of_mark(self.mark(back)) == Some(line)).then_some((line, to))
    }
}

/// Step 2: reading chains.
impl ConstrainedTriangulation {
    /// From the first to the last of the ends of two stretches of a line.
    fn reach(&self, [[a, b], [c, d]]: [[VertexId; 2]; 2]) -> [VertexId; 2] {
        [if self.is_before(c, a) { c } else { a }, if self.is_before(b, d) { d } else { b }]
    }

    /// The edge at an end of a segment from which its chain leads to `h`, whose mark names only that segment; `None`
    /// where the edges with that mark are not one path.
    fn first_of_chain(&self, h: HalfEdgeId, ends: [VertexId; 2]) -> Option<HalfEdgeId> {
        let mut last = self.twin(h);
        for _ in 0..self.face_slots() {
            if ends.contains(&self.dest(last)) {
                return Some(self.twin(last));
            }
            last = self.next_of_chain(last, self.mark(h), ends)?;
        }
        None
    }

    /// The edge with a mark that follows another one; `None` where that one leads to an end of the segment.
    fn next_of_chain(&self, last: HalfEdgeId, mark: u32, ends: [VertexId; 2]) -> Option<HalfEdgeId> {
        if ends.contains(&self.dest(last)) {
            return None;
        }
        let back = self.twin(last);
        self.star_from(back).find(|&g| self.mark(g) == mark && g != back)
    }

    /// Whether a chain that begins with an edge at one end of its segment ends at the other, and the vertices at which
    /// spans end come one after the other along the line of both.
    fn runs_straight(&self, first: HalfEdgeId, ends: [VertexId; 2]) -> bool {
        let mark = self.mark(first);
        let is_forward = self.is_before(ends[0], ends[1]) == (self.origin(first) == ends[0]);
        let (mut stop, mut last) = (self.origin(first), first);
        for _ in 0..self.face_slots() {
            let v = self.dest(last);
            if self.is_stop(v, ends) {
                let [low, high] = if is_forward { [stop, v] } else { [v, stop] };
                if !self.is_before(low, high) {
                    return false;
                }
                stop = v;
            }
            match self.next_of_chain(last, mark, ends) {
                Some(next) => last = next,
                None => return ends.contains(&v) && v != self.origin(first),
            }
        }
        false
    }

    /// Whether spans end at a vertex of a chain: an input vertex exactly on the line of the chain's ends.
    fn is_stop(&self, v: VertexId, ends: [VertexId; 2]) -> bool {
        self.may_end_span(v) && self.is_on_line(ends, v)
    }
}

/// Steps 2 and 3.
impl<J: Journal> Edit<'_, J> {
    /// Adds a new segment to the lines that it overlaps, which become one. Returns the gaps on its way, each between
    /// two vertices exactly on it that follow one another; `None` where there is no line that it could join.
    pub(super) fn join_line(&mut self, segment: SegmentId, plan: &mut SegmentPlan) -> Option<Vec<[VertexId; 2]>> {
        let ends @ [start, to] = self.segments()[segment.index()];
        let (mut at, mut joined, mut gaps) = (start, None, Vec::<[VertexId; 2]>::new());
        while at != to {
            if let Some((line, end)) = self.covered_by_any(at, ends) {
                joined = Some(joined.map_or(line, |other| self.connect_lines(other, line)));
                at = end;
            } else {
                // The survey has been this way: it does not leave the domain.
                let is_planned = self.plan_into(plan, at, to).is_ok();
                let stop = if is_planned { plan.to } else { to };
                match gaps.last_mut() {
                    Some([_, end]) if *end == at && !self.may_end_span(at) => *end = stop,
                    _ => gaps.push([at, stop]),
                }
                at = stop;
            }
        }
        let line = joined?;
        let ends = self.in_order(ends);
        self.stretch_line(line, ends);
        self.data.classes_mut().lines.enroll(line, segment, self.j);
        Some(gaps)
    }

    /// [`covered`](ConstrainedTriangulation::covered); a segment that overlapped none so far becomes a line first.
    fn covered_by_any(&mut self, at: VertexId, ends: [VertexId; 2]) -> Option<(u32, VertexId)> {
        let h = self.overlap_at(at, ends)?;
        if let Class::List(&[alone]) = self.class(self.mark(h)) {
            self.line_of_alone(h, alone);
        }
        self.covered(at, ends)
    }

    fn connect_lines(&mut self, a: u32, b: u32) -> u32 {
        let ends = self.classes().lines.ends(b);
        let ends = if a == b { ends } else { self.reach([self.classes().lines.ends(a), ends]) };
        let line = self.data.classes_mut().lines.connect(a, b, self.j);
        self.stretch_line(line, ends);
        line
    }

    /// Extends the stretch of a line to two vertices, the lexicographically lower one first.
    fn stretch_line(&mut self, line: u32, ends: [VertexId; 2]) {
        let old = self.classes().lines.ends(line);
        let new = self.reach([old, ends]);
        if new != old {
            self.data.classes_mut().lines.set_ends(line, new, self.j);
        }
    }

    /// Makes a line of a segment to which alone half-edge `h` belongs, if its chain runs straight forward.
    fn line_of_alone(&mut self, h: HalfEdgeId, segment: SegmentId) {
        let ends = self.segments()[segment.index()];
        let mark = self.mark(h);
        let first = self.first_of_chain(h, ends).filter(|&first| self.runs_straight(first, ends));
        let Some(first) = first.filter(|_| ends.into_iter().all(|v| self.may_end_span(v))) else { return };
        let (stretch, room) = (self.in_order(ends), self.room_for_segments());
        let lines = &mut self.data.classes_mut().lines;
        let line = lines.add(stretch, self.j);
        lines.reserve(room);
        lines.enroll(line, segment, self.j);
        let (mut start, mut edges, mut next) = (self.origin(first), Vec::new(), Some(first));
        while let Some(h) = next {
            edges.push(h);
            next = self.next_of_chain(h, mark, ends);
            let v = self.dest(h);
            if self.is_stop(v, ends) {
                let span = self.mark_of_new_span([start, v], segment);
                edges.drain(..).for_each(|h| self.data.set_mark(h, span, self.j));
                start = v;
            }
        }
    }

    /// The mark of a new span, which a member of its line covers.
    fn mark_of_new_span(&mut self, ends: [VertexId; 2], first: SegmentId) -> u32 {
        let ends = self.in_order(ends);
        self.data.classes_mut().mark_of_span(ends, first, self.j)
    }

    /// Puts the pieces of a new member of a line in that no other member covers.
    ///
    /// # Errors
    /// Those of the pieces; the caller takes the changes so far back.
    pub(super) fn fill_gaps(
        &mut self,
        segment: SegmentId,
        gaps: Vec<[VertexId; 2]>,
        plan: &mut SegmentPlan,
    ) -> Result<(), ConstraintError> {
        for ends @ [from, to] in gaps {
            let mark = self.mark_of_new_span(ends, segment);
            self.insert_pieces(Piece { from, to, mark }, segment, (plan, &mut Some(Beside::Allowed)))?;
        }
        Ok(())
    }
}
