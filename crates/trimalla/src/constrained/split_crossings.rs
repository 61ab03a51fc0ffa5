//! Splitting segments where they cross.
//!
//! The work is a list of pieces still to be put in:
//!
//! 1. Take a piece. Plan it up to the first vertex on its way; the rest goes back on the list.
//! 2. If the plan crosses no constraint, apply it.
//! 3. Otherwise look at the first constraint crossed. If one of the four ends lies within the reach of rounding of the
//!    other edge, that vertex is where they meet: the other edge is led through it.
//! 4. Else compute the crossing point, rounded, release the constraint and insert the point where it lies. Both the
//!    constraint and the piece go back on the list, parted at that vertex.
//!
//! Rounding bends what is parted by an ulp, and a bent piece may cross what its straight one did not: the list takes
//! care of that too. Step 3 keeps this from going on: no vertex is made nearer than that reach to an edge that already
//! has a vertex there, so crossings of nearly parallel pieces do not creep along them. A bound on the steps ends the
//! work in any case.
//!
//! # Source
//! Leading an edge through a vertex within rounding of it is the hot-pixel rule of snap rounding `[Hobby99]`, used here
//! for edges that cross, and never moving a vertex.

use std::collections::BTreeSet;

use super::apply::Before;
use super::constrained::{ConstrainedDelaunay, SegmentId};
use super::error::{ConstraintError, CrossingPair};
use super::insert_segment::crossing_of;
use super::provenance::Provenance;
use crate::geometry::{BoundingBox, Point, Segment, math};
use crate::locate::Locus;
use crate::mesh::{HalfEdgeId, Journal, VertexId};

/// The reach of rounding, in units of the largest coordinate's last place: twice the error of a crossing point.
const REACH_ULPS: f64 = 4.0;

/// A stretch of constraint that is still to be put in.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub(crate) from: VertexId,
    pub(crate) to: VertexId,
    /// Its class.
    pub(crate) mark: u32,
}

/// Where two edges that cross are parted.
enum Meeting {
    /// At an end of the constraint: the piece is led through it.
    EndOfConstraint(VertexId),
    /// At an end of the piece: the constraint is led through it.
    EndOfPiece(VertexId),
    /// At a point far from all four ends.
    Point(Point),
}

/// Whether a vertex was there before.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Vertex {
    Old,
    New,
}

impl ConstrainedDelaunay {
    /// Puts a piece of `segment` in, splitting whatever it crosses.
    pub(super) fn work_off<J: Journal>(
        &mut self,
        first: Piece,
        segment: SegmentId,
        j: &mut J,
    ) -> Result<(), ConstraintError> {
        let bound = self.step_bound();
        let mut work = vec![first];
        let mut steps = 0;
        // Classes led through a vertex beside them: they may have come by it twice.
        let mut led: BTreeSet<u32> = BTreeSet::new();
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
            self.t.plan_into(&mut self.plan, piece.from, piece.to).map_err(|_| leaves)?;
            match self.plan.constrained.first() {
                None => {
                    work.push(Piece { from: self.plan.to, ..piece });
                    self.apply_plan(piece.mark, Before::Any, j);
                }
                Some(&h) => {
                    if steps > bound {
                        return Err(ConstraintError::CrossingsExhausted { pair: self.pair_at(h, piece), steps });
                    }
                    let marks = [self.t.mark(h), piece.mark];
                    if self.part(h, piece, &mut work, j) == Vertex::Old {
                        led.extend(marks);
                    }
                }
            }
        }
        let segments: BTreeSet<SegmentId> =
            led.into_iter().flat_map(|mark| self.constraints.segments(mark)).copied().collect();
        segments.into_iter().for_each(|s| self.straighten(s, j));
        Ok(())
    }

    /// A segment crosses every piece of constraint once, and each vertex lies on few of them; the rest is for rounding.
    fn step_bound(&self) -> u64 {
        1024 + 64 * (self.segments.len() + self.t.points().len()) as u64
    }

    fn pair_at(&self, h: HalfEdgeId, piece: Piece) -> CrossingPair {
        let name = |mark| self.constraints.segments(mark).first().copied().unwrap_or(0) as usize;
        let at = crossing_of([piece.from, piece.to].map(|v| self.t.point(v)), self.t.edge_points(h));
        let (a, b) = (name(self.t.mark(h)), name(piece.mark));
        CrossingPair { segments: [a.min(b), a.max(b)], at }
    }

    /// Parts constraint `h` and the piece that crosses it at one vertex; what is parted goes back on the list.
    ///
    /// Says whether the vertex was there already.
    ///
    /// ```text
    ///            y                       y
    ///            |                       |
    ///     from ──┼──── to     ──>  from ─ v ─── to      v: the crossing point, rounded, or the end that
    ///            | h                     |                 is as good as on the other edge
    ///            x                       x
    /// ```
    fn part<J: Journal>(&mut self, h: HalfEdgeId, piece: Piece, work: &mut Vec<Piece>, j: &mut J) -> Vertex {
        let [x, y] = [self.t.origin(h), self.t.dest(h)];
        let mark = self.t.mark(h);
        let (v, age) = match self.meeting(h, piece) {
            Meeting::EndOfConstraint(v) => (v, Vertex::Old),
            Meeting::EndOfPiece(v) => {
                self.release(x, y, j);
                (v, Vertex::Old)
            }
            Meeting::Point(at) => self.part_at(h, piece, at, j),
        };
        let pieces = [(x, v, mark), (v, y, mark), (v, piece.to, piece.mark), (piece.from, v, piece.mark)];
        let whole = |&(from, to, _): &(VertexId, VertexId, u32)| [from, to] == [x, y];
        work.extend(pieces.into_iter().filter(|p| !whole(p)).map(|(from, to, mark)| Piece { from, to, mark }));
        age
    }

    /// Where constraint `h` and the piece that crosses it are parted: the nearest of the four ends, if rounding reaches
    /// from it to the other edge.
    fn meeting(&self, h: HalfEdgeId, piece: Piece) -> Meeting {
        let at = |v| self.t.point(v);
        let (edge, line) = ([self.t.origin(h), self.t.dest(h)], [piece.from, piece.to]);
        let [p, q] = edge.map(at);
        let [a, b] = line.map(at);
        let reach =
            |ends: [Point; 2]| REACH_ULPS * math::last_place(Segment::new(ends[0], ends[1]).largest_coordinate());
        let nearest = |ends: [VertexId; 2], line: [Point; 2]| {
            let [d, e] = ends.map(|v| Segment::new(line[0], line[1]).distance(at(v)));
            let (d, v) = if e < d || e == d && ends[1] < ends[0] { (e, ends[1]) } else { (d, ends[0]) };
            (d <= reach(line)).then_some((d, v))
        };
        // Leading an edge through a vertex bends it: by no more than its own rounding.
        match (nearest(edge, [a, b]), nearest(line, [p, q])) {
            (Some((d, v)), Some((e, _))) if d <= e => Meeting::EndOfConstraint(v),
            (Some((_, v)), None) => Meeting::EndOfConstraint(v),
            (_, Some((_, w))) => Meeting::EndOfPiece(w),
            (None, None) => Meeting::Point(self.crossing_at(h, piece)),
        }
    }

    /// Where a piece and constraint `h` cross, rounded: the crossing of the input segments that they are part of, as long
    /// as that is within both.
    ///
    /// Pieces are bent by rounding. Crossings computed from pieces of pieces drift; those of the segments themselves are
    /// one point each.
    fn crossing_at(&self, h: HalfEdgeId, piece: Piece) -> Point {
        let ends = [piece.from, piece.to].map(|v| self.t.point(v));
        let edge = self.t.edge_points(h);
        let whole = |mark| self.finest_segment(mark).map(|s| self.segments[s as usize].map(|v| self.t.point(v)));
        let within = |[a, b]: [Point; 2], p| BoundingBox::of([a, b]).is_some_and(|bounds| bounds.contains(p));
        let of_segments = match (whole(piece.mark), whole(self.t.mark(h))) {
            (Some([a, b]), Some([c, d])) => Segment::new(a, b).crossing_point(Segment::new(c, d)),
            _ => None,
        };
        of_segments.filter(|&p| within(ends, p) && within(edge, p)).unwrap_or_else(|| crossing_of(ends, edge))
    }

    /// The vertex at a crossing point: the one that is there, or a new one. Constraint `h` is released, as long as the
    /// vertex is none of its ends.
    fn part_at<J: Journal>(&mut self, h: HalfEdgeId, piece: Piece, at: Point, j: &mut J) -> (VertexId, Vertex) {
        let [x, y] = [self.t.origin(h), self.t.dest(h)];
        let pair = self.pair_at(h, piece);
        let there = match self.t.locate_from(h.face(), at) {
            Locus::Vertex(v) => Some(v),
            _ => None,
        };
        if there.is_none_or(|v| v != x && v != y) {
            self.release(x, y, j);
        }
        if let Some(v) = there {
            return (v, Vertex::Old);
        }
        let start = self.t.outgoing(x).map_or(h.face(), HalfEdgeId::face);
        let locus = self.t.locate_from(start, at);
        let v = self.insert_vertex_at(at, locus, j);
        self.set_provenance(v, Provenance::Crossing { segments: pair.segments.map(|s| s as u32) }, j);
        (v, Vertex::New)
    }
}
