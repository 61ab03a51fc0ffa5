//! Segments inside the domain let go, and brought back by splitting.
//!
//! ```text
//!      x ─── y            a ─ ─ ─ ─ b crosses x–y: the segment is not there.
//!     / ╲   / ╲           Its middle goes in; of its halves, those that are no edges are halved again,
//!    a ─ ╲ ─ ─ b          until the segment is a chain of edges.
//!     ╲   ╲ / ╱
//! ```
//!
//! Where two segments meet at a small angle, the caller names the place of the split in the place of the middle: halves of
//! unequal lengths would put vertices into each other's circles for ever.
//!
//! The edges that come to be need no mark to stay: the triangulation is *conforming* Delaunay. A vertex that goes in for one
//! segment may flip an edge of another away, so all are looked at until a round finds nothing missing.
//!
//! # Source
//! `[MeshSuite]` 2.6.1, recovery by unions.

use super::constrained::ConstrainedDelaunay;
use super::input_sides::Beside;
use super::plan::SegmentPlan;
use super::split_crossings::Piece;
use crate::geometry::{CircleSide, Point, in_circle_perturbed};
use crate::locate::Locus;
use crate::mesh::{HalfEdgeId, Journal, UndoLog, VertexId};

/// A stretch of segments that was let go.
pub(crate) type Released = Piece;

/// Where splitting stops.
pub(crate) struct SplitLimits<'a> {
    /// No more vertices than this.
    pub(crate) vertices: usize,
    /// No more pieces than this in one go.
    pub(crate) pieces: usize,
    /// Whether two ends are far enough apart to be parted.
    pub(crate) may_part: &'a dyn Fn(Point, Point) -> bool,
    /// The parameter, from its start to its end, at which a stretch that crosses edges is split.
    pub(crate) place: &'a dyn Fn(&ConstrainedDelaunay, Released, &SegmentPlan) -> f64,
}

/// Segments on their way back, so that the work can be done in slices.
#[derive(Clone, Debug)]
pub(crate) struct Recovery {
    /// Pieces still to be looked at, the next one last.
    waiting: Vec<Piece>,
    /// Pieces for the next round, in order.
    next: Vec<Piece>,
    stage: Stage,
    /// Pieces for which there was no room: they are no edges.
    lost: Vec<Piece>,
    /// Whether pieces may be led through input vertices beside them, once that was asked.
    beside: Option<Beside>,
}

/// How many vertices went in, and how many out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Changed {
    pub(crate) inserted: usize,
    pub(crate) removed: usize,
}

/// How far a recovery is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    /// Pieces are halved, round by round; whether a vertex went in during this one.
    Halving {
        has_grown: bool,
    },
    /// What the limits left missing goes in as whole edges.
    Whole,
    Done,
}

impl Recovery {
    /// The recovery of segments that were let go.
    pub(crate) fn of(released: Vec<Released>) -> Self {
        let waiting = released.into_iter().rev().collect();
        Self { waiting, next: Vec::new(), stage: Stage::Halving { has_grown: false }, lost: Vec::new(), beside: None }
    }

    /// Whether nothing is left to do.
    pub(crate) fn is_done(&self) -> bool {
        self.stage == Stage::Done
    }

    /// What is no chain of edges, for want of room.
    pub(crate) fn into_lost(self) -> Vec<Released> {
        self.lost
    }
}

impl ConstrainedDelaunay {
    /// Lets go of every segment inside the domain; those that part two regions stay.
    ///
    /// Returns what was let go, in the order of its vertices. The edges wait for [`legalise_some`](Self::legalise_some), after
    /// which the triangulation is Delaunay across them.
    pub(crate) fn release_inner_segments<J: Journal>(&mut self, j: &mut J) -> Vec<Released> {
        let inner: Vec<HalfEdgeId> = self.t.edges().filter(|&h| self.is_inner(h)).collect();
        let mut released: Vec<Released> = Vec::with_capacity(inner.len());
        for &h in &inner {
            let (a, b) = (self.t.origin(h), self.t.dest(h));
            released.push(Piece { from: a.min(b), to: a.max(b), mark: self.t.mark(h) });
            self.t.mesh.set_mark(h, 0, j);
        }
        for h in inner {
            self.lawson.push(h);
        }
        released.sort_unstable_by_key(|piece| [piece.from, piece.to]);
        released
    }

    /// Whether an edge is part of a segment with one region on both sides.
    fn is_inner(&self, h: HalfEdgeId) -> bool {
        let (f, g) = (h.face(), self.t.twin(h).face());
        self.t.is_marked(h) && self.t.is_real(f) && self.t.is_real(g) && self.t.region(f) == self.t.region(g)
    }

    /// How many pieces of segments inside are edges only because they are constrained.
    pub(crate) fn pieces_held_by_marks(&self) -> usize {
        self.t.edges().filter(|&h| self.is_inner(h) && self.is_held_by_its_mark(h)).count()
    }

    /// Whether an edge between two faces fails the circle test, marked or not.
    fn is_held_by_its_mark(&self, h: HalfEdgeId) -> bool {
        let corners = [self.t.origin(h), self.t.dest(h), self.t.apex(h), self.t.apex(self.t.twin(h))];
        let [a, b, c, d] = corners.map(|v| self.t.point(v));
        in_circle_perturbed(a, b, c, d) == CircleSide::Inside
    }

    /// Marks what is there of the segments let go; returns the pieces that are no edges.
    pub(crate) fn claim<J: Journal>(&mut self, released: &[Released], j: &mut J) -> Vec<Released> {
        let mut missing = Vec::new();
        for &piece in released {
            match self.t.half_edge_between(piece.from, piece.to) {
                Some(h) => {
                    let mark = self.joined(self.t.mark(h), piece.mark, j);
                    self.t.mesh.set_mark(h, mark, j);
                }
                None => missing.push(piece),
            }
        }
        missing
    }

    /// Splits what was let go until it is edges, and marks those: one slice of that work.
    ///
    /// What the limits leave missing goes in as whole edges. Where those cross, but for rounding, what they did not cross before
    /// they were let go, that takes vertices too, and free vertices make room for them. A piece that cannot be put in is lost.
    pub(crate) fn recover_some(
        &mut self,
        recovery: &mut Recovery,
        limits: &SplitLimits<'_>,
        log: &mut UndoLog,
    ) -> Changed {
        let mut changed = Changed::default();
        for _ in 0..limits.pieces {
            let room = (limits.vertices + changed.removed).saturating_sub(changed.inserted);
            let piece = recovery.waiting.pop();
            match (recovery.stage, piece) {
                (Stage::Halving { .. }, Some(piece)) => {
                    match self.parted(piece, room > 0, (limits, &mut recovery.beside), log) {
                        Some((v, is_new)) => {
                            changed.inserted += usize::from(is_new);
                            if is_new {
                                recovery.stage = Stage::Halving { has_grown: true };
                            }
                            recovery.next.extend([Piece { to: v, ..piece }, Piece { from: v, ..piece }]);
                        }
                        None => recovery.next.push(piece),
                    }
                }
                // Each round but the last puts a vertex in.
                (Stage::Halving { has_grown: true }, None) => {
                    recovery.waiting = recovery.next.drain(..).rev().collect();
                    recovery.stage = Stage::Halving { has_grown: false };
                }
                (Stage::Halving { has_grown: false }, None) => {
                    let missing = self.claim(&recovery.next, log);
                    recovery.next.clear();
                    recovery.waiting = missing.into_iter().rev().collect();
                    recovery.stage = Stage::Whole;
                }
                (Stage::Whole, Some(piece)) => match self.made_whole(piece, room, &mut recovery.beside, log) {
                    Some(Changed { inserted, removed }) => {
                        changed.inserted += inserted;
                        changed.removed += removed;
                    }
                    None => recovery.lost.push(piece),
                },
                (Stage::Whole | Stage::Done, None) | (Stage::Done, Some(_)) => {
                    recovery.stage = Stage::Done;
                    break;
                }
            }
        }
        changed
    }

    /// Puts a piece in as a whole edge; `None`, and nothing changed, where that is not possible. Where it takes more vertices
    /// than there is room for, the newest free ones make room.
    fn made_whole(
        &mut self,
        piece: Piece,
        room: usize,
        beside: &mut Option<Beside>,
        log: &mut UndoLog,
    ) -> Option<Changed> {
        let count = |t: &Self| t.t.points().len() - t.t.free_vertices().len();
        let start = log.checkpoint();
        let mut removed = 0;
        // Each round but the last removes a vertex.
        loop {
            let (here, before) = (log.checkpoint(), count(self));
            let is_in = self.work_off(piece, 0, beside, log).is_ok();
            let inserted = count(self).saturating_sub(before);
            if is_in && inserted <= room + removed {
                return Some(Changed { inserted, removed });
            }
            self.rollback(log, here);
            if !(is_in && self.remove_newest_free(log)) {
                self.rollback(log, start);
                return None;
            }
            removed += 1;
        }
    }

    /// Removes the newest vertex that was inserted freely; says whether there was one.
    fn remove_newest_free(&mut self, log: &mut UndoLog) -> bool {
        let newest = (self.given_points..self.t.points().len()).rev().map(VertexId::from_index);
        let mut free = newest.filter(|&v| self.t.is_used(v) && self.is_deletable(v));
        let newest = free.next();
        newest.is_some_and(|v| self.remove_with(v, log).is_ok())
    }

    /// The vertex that parts a piece which is no edge, and whether it is new; `None` for edges and where limits forbid.
    fn parted<J: Journal>(
        &mut self,
        piece: Piece,
        room: bool,
        (limits, beside): (&SplitLimits<'_>, &mut Option<Beside>),
        j: &mut J,
    ) -> Option<(VertexId, bool)> {
        if self.t.half_edge_between(piece.from, piece.to).is_some() {
            return None;
        }
        // A vertex exactly on the way parts it for nothing.
        let plan = self.t.plan_towards(piece.from, piece.to).ok()?;
        if plan.to != piece.to {
            let may_pass = self.may_pass_through(plan.to, piece.mark, || self.known_beside(beside));
            return may_pass.then_some((plan.to, false));
        }
        let (p, provenance) = self.point_between(piece.from, piece.to, piece.mark, (limits.place)(self, piece, &plan));
        let [a, b] = [piece.from, piece.to].map(|v| self.t.point(v));
        if !room || !(limits.may_part)(a, p) || !(limits.may_part)(p, b) || self.changes_sides(&plan, p) {
            return None;
        }
        let start = self.t.outgoing(piece.from).map_or(self.last, HalfEdgeId::face);
        match self.t.locate_from(start, p) {
            // An input vertex that is not exactly on the way, or the plan had ended there, is not on the segment.
            Locus::Vertex(v) => {
                let may_part = v != piece.from && v != piece.to && !self.is_of_input(v);
                may_part.then_some((v, false))
            }
            Locus::Edge(h) if self.t.is_marked(h) => None,
            locus @ (Locus::Face(_) | Locus::Edge(_)) => {
                let v = self.insert_vertex_at(p, locus, j);
                self.set_provenance(v, provenance, j);
                Some((v, true))
            }
            _ => None,
        }
    }
}
