//! Splitting segments where they cross.
//!
//! The work is a list of pieces still to be put in:
//!
//! 1. Take a piece. Plan it up to the first vertex exactly on its way; the rest goes back on the list. So vertices
//!    exactly on a segment split it before any crossing does, and what crosses it between two of them bends no more
//!    than that part.
//! 2. If the plan crosses no constraint, apply it.
//! 3. Otherwise look at the first constraint crossed. If one of the four ends lies within the reach of rounding of the
//!    other edge, that vertex is where they meet: the other edge is led through it.
//! 4. Else compute the crossing point, rounded, release the constraint and insert the point where it lies. Both the
//!    constraint and the piece go back on the list, split at that vertex.
//!
//! Rounding bends a split piece by an ulp, and the bent piece may cross what the straight one did not: such crossings
//! go through the list, too. Step 3 keeps this from going on: no vertex is made nearer than that reach to an edge that
//! already has a vertex there, so crossings of nearly parallel pieces do not creep along them. A bound on the steps
//! ends the work in any case.
//!
//! # Invariants
//! A vertex splits a piece only if it lies in the strip of [`Strip::PARTING_PLACES`] of every input segment of its
//! class, and its foot strictly between those of the ends: see [`Strip`] for the rule. So bends do not add up, and the
//! pieces of a segment are always one monotone path from its start to its end. Where no vertex and no rounded point
//! satisfies this, the segments are too close to one another for coordinates, and an error names the pair.
//!
//! # Source
//! Leading an edge through a vertex within rounding of it is the hot-pixel rule of snap rounding `[Hobby99]`, used here
//! for edges that cross, and never moving a vertex.

use super::constrained_triangulation::ConstrainedTriangulation;
use super::edit::Edit;
use super::error::{ConstraintError, CrossingPair};
use super::input_sides::Beside;
use super::insert_segment::crossing_of;
use super::plan::SegmentPlan;
use super::provenance::Provenance;
use crate::drawing::SegmentId;
use crate::geometry::last_places::COMPUTED_CROSSING;
use crate::geometry::{BoundingBox, Point, Segment, Strip};
use crate::half_edge::{HalfEdgeId, Journal, VertexId};
use crate::locate::Locus;

/// A stretch of constraint that is still to be put in.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub(crate) from: VertexId,
    pub(crate) to: VertexId,
    /// The mark of its class.
    pub(crate) mark: u32,
}

/// Where two edges that cross are split.
enum Meeting {
    /// At an end of the constraint: the piece is led through it.
    EndOfConstraint(VertexId),
    /// At an end of the piece: the constraint is led through it.
    EndOfPiece(VertexId),
    /// At a point far from all four ends.
    Point(Point),
}

impl<J: Journal> Edit<'_, J> {
    /// Puts a piece of `segment` in, splitting whatever it crosses; `plan` is room for plans, and `beside` tells
    /// whether at input vertices, too, as soon as that is known.
    pub(super) fn insert_pieces(
        &mut self,
        first: Piece,
        segment: SegmentId,
        (plan, beside): (&mut SegmentPlan, &mut Option<Beside>),
    ) -> Result<(), ConstraintError> {
        let bound = self.step_bound();
        let mut work = vec![first];
        let mut steps = 0;
        while let Some(piece) = work.pop() {
            steps += 1;
            if piece.from == piece.to {
                continue;
            }
            let leaves = ConstraintError::LeavesDomain {
                segment: segment.index(),
                from: self.point(piece.from),
                to: self.point(piece.to),
            };
            self.plan_into(plan, piece.from, piece.to).map_err(|_| leaves)?;
            let first_stop = plan.to;
            work.push(Piece { from: first_stop, ..piece });
            let may_stop =
                first_stop == piece.to || self.may_pass_through(first_stop, piece.mark, || self.known_beside(beside));
            if !may_stop {
                let pair = CrossingPair { segments: [segment.index(); 2], at: self.point(first_stop) };
                return Err(ConstraintError::CrossingsExhausted { pair, steps });
            }
            let piece = Piece { to: first_stop, ..piece };
            match plan.constrained.first() {
                None => self.apply_plan(plan, piece.mark),
                Some(&h) => {
                    let meeting = self.meeting(h, piece, plan, self.known_beside(beside)).filter(|_| steps <= bound);
                    let pair = || ConstraintError::CrossingsExhausted { pair: self.pair_at(h, piece), steps };
                    let meeting = meeting.ok_or_else(pair)?;
                    self.split_at_meeting(h, piece, meeting, &mut work);
                }
            }
        }
        Ok(())
    }

    /// Splits constraint `h` and the piece that crosses it at one vertex; what is split goes back on the list.
    ///
    /// ```text
    ///            y                       y
    ///            |                       |
    ///     from ──┼──── to     ──>  from ─ v ─── to      v: the crossing point, rounded, or the end that
    ///            | h                     |                 is as good as on the other edge
    ///            x                       x
    /// ```
    fn split_at_meeting(&mut self, h: HalfEdgeId, piece: Piece, meeting: Meeting, work: &mut Vec<Piece>) {
        let [x, y] = [self.origin(h), self.dest(h)];
        let mark = self.mark(h);
        let v = match meeting {
            Meeting::EndOfConstraint(v) => v,
            Meeting::EndOfPiece(v) => {
                self.release(x, y);
                v
            }
            Meeting::Point(at) => self.vertex_at_crossing(h, piece, at),
        };
        let pieces = [(x, v, mark), (v, y, mark), (v, piece.to, piece.mark), (piece.from, v, piece.mark)];
        let whole = |&(from, to, _): &(VertexId, VertexId, u32)| [from, to] == [x, y];
        work.extend(pieces.into_iter().filter(|p| !whole(p)).map(|(from, to, mark)| Piece { from, to, mark }));
    }

    /// The vertex at a crossing point: the one that is there, or a new one. Constraint `h` is released.
    fn vertex_at_crossing(&mut self, h: HalfEdgeId, piece: Piece, at: Point) -> VertexId {
        let x = self.origin(h);
        let pair = self.pair_at(h, piece);
        let there = self.locate_from(h.face(), at);
        self.release(x, self.dest(h));
        if let Locus::Vertex(v) = there {
            return v;
        }
        let start = self.outgoing(x).map_or(h.face(), HalfEdgeId::face);
        let locus = self.locate_from(start, at);
        let v = self.insert_vertex_at(at, locus);
        let segments = pair.segments.map(SegmentId::from_index);
        self.data.set_provenance(v, Provenance::Crossing { segments }, self.j);
        v
    }
}

impl ConstrainedTriangulation {
    /// A segment crosses every piece of constraint once, and each vertex lies on few of them; the rest is for rounding.
    fn step_bound(&self) -> u64 {
        1024 + 64 * (self.segments().len() + self.points().len()) as u64
    }

    fn pair_at(&self, h: HalfEdgeId, piece: Piece) -> CrossingPair {
        let name = |mark| self.first_segment(mark).map_or(0, SegmentId::index);
        let at = self.crossing_of_edges(h, piece);
        let (a, b) = (name(self.mark(h)), name(piece.mark));
        CrossingPair { segments: [a.min(b), a.max(b)], at }
    }

    /// Where constraint `h` and the piece that crosses it are split: at the nearest of the four ends, if rounding
    /// reaches from it to the other edge, or where they cross. `None` where every such place would break the rule.
    ///
    /// `beside` tells whether input vertices count, and whether edges may be bent over them.
    fn meeting(&self, h: HalfEdgeId, piece: Piece, plan: &SegmentPlan, beside: Beside) -> Option<Meeting> {
        let [edge, line] = [[self.origin(h), self.dest(h)], [piece.from, piece.to]];
        let [of_edge, of_line] = [Stretch::new(self, edge, self.mark(h)), Stretch::new(self, line, piece.mark)];
        let keeps_sides =
            |p: Point| beside == Beside::Allowed || !self.edge_changes_sides(h, p) && !self.changes_sides(plan, p);
        let nearest = |ends: [VertexId; 2], other: &Stretch, reach: Option<f64>| {
            let may_meet = |&v: &VertexId| {
                let p = self.point(v);
                (beside == Beside::Allowed || !self.is_of_input(v))
                    && other.is_split_by(p)
                    && other.reaches(reach, p)
                    && keeps_sides(p)
            };
            let good = ends.into_iter().filter(may_meet);
            let measured = good.map(|v| (other.ends.distance(self.point(v)), v));
            measured.min_by(|(d, v), (e, w)| d.total_cmp(e).then(v.cmp(w)))
        };
        let at_an_end = |reach| match (nearest(edge, &of_line, reach), nearest(line, &of_edge, reach)) {
            (Some((d, v)), Some((e, _))) if d <= e => Some(Meeting::EndOfConstraint(v)),
            (Some((_, v)), None) => Some(Meeting::EndOfConstraint(v)),
            (_, Some((_, w))) => Some(Meeting::EndOfPiece(w)),
            (None, None) => None,
        };
        let splits_both = |p: &Point| of_edge.is_split_by(*p) && of_line.is_split_by(*p) && keeps_sides(*p);
        at_an_end(Some(COMPUTED_CROSSING))
            .or_else(|| self.crossing_of_segments(h, piece).filter(splits_both).map(Meeting::Point))
            .or_else(|| Some(self.crossing_of_edges(h, piece)).filter(splits_both).map(Meeting::Point))
            .or_else(|| at_an_end(None))
    }

    /// Where the input segments cross that a piece and constraint `h` are part of, rounded, if that is within both.
    ///
    /// Pieces are bent by rounding. Crossings computed from pieces of pieces drift; those of the segments themselves
    /// are one point each.
    fn crossing_of_segments(&self, h: HalfEdgeId, piece: Piece) -> Option<Point> {
        let whole = |mark| self.finest_segment(mark).map(|s| self.segment_points(s));
        let within = |[a, b]: [Point; 2], p| BoundingBox::around(a).including(b).contains(p);
        let crossing = whole(piece.mark)?.crossing_point(whole(self.mark(h))?)?;
        let ends = [piece.from, piece.to].map(|v| self.point(v));
        (within(ends, crossing) && within(self.edge_points(h), crossing)).then_some(crossing)
    }

    /// Where a piece and constraint `h` cross themselves, rounded.
    fn crossing_of_edges(&self, h: HalfEdgeId, piece: Piece) -> Point {
        crossing_of([piece.from, piece.to].map(|v| self.point(v)), self.edge_points(h))
    }
}

/// An edge or piece, and the strips of the input segments that it is part of.
struct Stretch {
    ends: Segment,
    strips: Vec<Strip>,
}

impl Stretch {
    fn new(cdt: &ConstrainedTriangulation, ends: [VertexId; 2], mark: u32) -> Self {
        let [a, b] = ends.map(|v| cdt.point(v));
        Self { ends: Segment::new(a, b), strips: cdt.strips(mark, Strip::PARTING_PLACES).collect() }
    }

    /// Whether a vertex at `p` may split it.
    fn is_split_by(&self, p: Point) -> bool {
        let Segment { start, end } = self.ends;
        self.strips.iter().all(|strip| strip.is_between(start, p, end) && strip.contains(p))
    }

    /// Whether a point is within `places` last places, if there is such a limit.
    fn reaches(&self, places: Option<f64>, p: Point) -> bool {
        places.is_none_or(|places| Strip::new(self.ends, places).contains(p))
    }
}
