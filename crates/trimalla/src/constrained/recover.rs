//! Segments inside the domain: released, and recovered by splitting.
//!
//! ```text
//!      x ─── y            a ─ ─ ─ ─ b crosses x–y: the segment is not there.
//!     / ╲   / ╲           Its middle goes in; of its halves, those that are no edges are halved again,
//!    a ─ ╲ ─ ─ b          until the segment is a chain of edges.
//!     ╲   ╲ / ╱
//! ```
//!
//! Where two segments meet at a small angle, the caller names the place of the split in the place of the middle: halves
//! of unequal lengths would put vertices into each other's circles for ever.
//!
//! The new edges need no mark to stay: the triangulation is *conforming* Delaunay. A vertex that goes in for one
//! segment may flip an edge of another away, so all are tested until a round finds nothing missing.
//!
//! # Source
//! `[MeshSuite]` 2.6.1, recovery by unions.

use super::constrained_triangulation::ConstrainedTriangulation;
use super::edit::Edit;
use super::input_sides::Beside;
use super::plan::SegmentPlan;
use super::split_crossings::Piece;
use crate::delaunay::Lawson;
use crate::drawing::SegmentId;
use crate::geometry::{CircleSide, Point, in_circle_perturbed};
use crate::half_edge::{HalfEdgeId, Journal, UndoLog, VertexId};
use crate::locate::Locus;

/// A released stretch of segments.
pub(crate) type Released = Piece;

/// Where splitting stops.
pub(crate) struct SplitLimits<'a> {
    /// No more vertices than this.
    pub(crate) vertices: usize,
    /// No more pieces than this in one go.
    pub(crate) pieces: usize,
    /// Whether two ends are far enough apart for a vertex between them.
    pub(crate) may_part: &'a dyn Fn(Point, Point) -> bool,
    /// The parameter, from its start to its end, at which a stretch that crosses edges is split.
    pub(crate) place: &'a dyn Fn(&ConstrainedTriangulation, Released, &SegmentPlan) -> f64,
}

/// A recovery in progress, so that the work can be done in slices.
#[derive(Clone, Debug)]
pub(crate) struct Recovery {
    /// Pieces still to be treated, the next one last.
    waiting: Vec<Piece>,
    /// Pieces for the next round, in order.
    next: Vec<Piece>,
    stage: Stage,
    /// Pieces for which there was no room: they are not edges.
    lost: Vec<Piece>,
    /// Whether pieces may be led through input vertices beside them, once that was computed.
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
    /// Pieces that the limits left missing go in as whole edges.
    Whole,
    Done,
}

impl Recovery {
    /// The recovery of released segments.
    pub(crate) fn of(released: Vec<Released>) -> Self {
        let waiting = released.into_iter().rev().collect();
        Self { waiting, next: Vec::new(), stage: Stage::Halving { has_grown: false }, lost: Vec::new(), beside: None }
    }

    /// The recovery of released segments as whole edges.
    pub(crate) fn as_whole_edges(released: Vec<Released>) -> Self {
        Self { next: released, ..Self::of(Vec::new()) }
    }

    /// Whether nothing is left to do.
    pub(crate) fn is_done(&self) -> bool {
        self.stage == Stage::Done
    }

    /// The stretches that are no chains of edges, for want of room.
    pub(crate) fn into_lost(self) -> Vec<Released> {
        self.lost
    }
}

impl<J: Journal> Edit<'_, J> {
    /// Releases every segment inside the domain: its edges lose their marks. Segments between two regions stay.
    ///
    /// Returns the released stretches, in the order of their vertices, and the edges that may fail the circle test now
    /// ([`legalise_some`](Self::legalise_some)).
    pub(crate) fn release_inner_segments(&mut self) -> (Vec<Released>, Lawson) {
        let inner: Vec<HalfEdgeId> = self.edges().filter(|&h| self.is_inner(h)).collect();
        let mut released: Vec<Released> = Vec::with_capacity(inner.len());
        let mut waiting = Lawson::default();
        for &h in &inner {
            let [from, to] = self.edge_key(h).ends();
            released.push(Piece { from, to, mark: self.mark(h) });
            self.data.set_mark(h, 0, self.j);
            waiting.push(h);
        }
        released.sort_unstable_by_key(|piece| [piece.from, piece.to]);
        (released, waiting)
    }

    /// Legalises up to `most` of the waiting edges, and those beside flipped ones; returns how many flips it took.
    pub(crate) fn legalise_some(&mut self, waiting: &mut Lawson, most: usize) -> u64 {
        waiting.legalise_some(self.data.triangulation_mut(), most, self.j)
    }

    /// Marks the released pieces that are edges; returns the others.
    pub(crate) fn mark_present(&mut self, released: &[Released]) -> Vec<Released> {
        let mut missing = Vec::new();
        for &piece in released {
            match self.half_edge_between(piece.from, piece.to) {
                Some(h) => {
                    let mark = self.joined(self.mark(h), piece.mark);
                    self.data.set_mark(h, mark, self.j);
                }
                None => missing.push(piece),
            }
        }
        missing
    }

    /// The vertex that splits a piece which is no edge, and whether it is new; `None` for edges and where limits
    /// forbid.
    fn split_piece(
        &mut self,
        piece: Piece,
        room: bool,
        (limits, beside): (&SplitLimits<'_>, &mut Option<Beside>),
    ) -> Option<(VertexId, bool)> {
        if self.half_edge_between(piece.from, piece.to).is_some() {
            return None;
        }
        // A vertex exactly on the way splits it without a new one.
        let plan = self.plan_towards(piece.from, piece.to).ok()?;
        if plan.to != piece.to {
            let may_pass = self.may_pass_through(plan.to, piece.mark, || self.known_beside(beside));
            return may_pass.then_some((plan.to, false));
        }
        let (p, provenance) = self.point_between(piece.from, piece.to, piece.mark, (limits.place)(self, piece, &plan));
        let [a, b] = [piece.from, piece.to].map(|v| self.point(v));
        if !room || !(limits.may_part)(a, p) || !(limits.may_part)(p, b) || self.changes_sides(&plan, p) {
            return None;
        }
        let start = self.outgoing(piece.from).map_or(self.work.hint, HalfEdgeId::face);
        match self.locate_from(start, p) {
            // An input vertex that is not exactly on the way, or the plan had ended there, is not on the segment.
            Locus::Vertex(v) => {
                let may_part = v != piece.from && v != piece.to && !self.is_of_input(v);
                may_part.then_some((v, false))
            }
            Locus::Edge(h) if self.is_marked(h) => None,
            locus @ (Locus::Face(_) | Locus::Edge(_)) => {
                let v = self.insert_vertex_at(p, locus);
                self.data.set_provenance(v, provenance, self.j);
                Some((v, true))
            }
            _ => None,
        }
    }
}

impl Edit<'_, UndoLog> {
    /// One slice of a recovery: splits the released pieces until they are edges, and marks these.
    ///
    /// Pieces that the limits leave missing go in as whole edges. Rounding may make these cross where they did not
    /// cross before they were released; that takes vertices too, and free vertices make room for them. A piece that
    /// cannot be put in is lost.
    pub(crate) fn recover_some(&mut self, recovery: &mut Recovery, limits: &SplitLimits<'_>) -> Changed {
        let mut changed = Changed::default();
        for _ in 0..limits.pieces {
            let room = (limits.vertices + changed.removed).saturating_sub(changed.inserted);
            let piece = recovery.waiting.pop();
            match (recovery.stage, piece) {
                (Stage::Halving { .. }, Some(piece)) => {
                    match self.split_piece(piece, room > 0, (limits, &mut recovery.beside)) {
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
                    let missing = self.mark_present(&recovery.next);
                    recovery.next.clear();
                    recovery.waiting = missing.into_iter().rev().collect();
                    recovery.stage = Stage::Whole;
                }
                (Stage::Whole, Some(piece)) => match self.made_whole(piece, room, &mut recovery.beside) {
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

    /// Puts a piece in as a whole edge; `None`, and nothing changed, where that is not possible. Where it takes more
    /// vertices than there is room for, the newest free ones make room.
    fn made_whole(&mut self, piece: Piece, room: usize, beside: &mut Option<Beside>) -> Option<Changed> {
        let count = |t: &Self| t.points().len() - t.free_vertices().len();
        let start = self.j.checkpoint();
        let mut removed = 0;
        // Each round but the last removes a vertex.
        loop {
            let (here, before) = (self.j.checkpoint(), count(self));
            let is_in = self.insert_pieces(piece, SegmentId(0), (&mut SegmentPlan::default(), beside)).is_ok();
            let inserted = count(self).saturating_sub(before);
            if is_in && inserted <= room + removed {
                return Some(Changed { inserted, removed });
            }
            self.data.rollback(self.j, here);
            if !(is_in && self.remove_newest_free()) {
                self.data.rollback(self.j, start);
                return None;
            }
            removed += 1;
        }
    }

    /// Removes the newest vertex that was inserted freely; returns whether there was one.
    fn remove_newest_free(&mut self) -> bool {
        let newest = (self.given_points()..self.points().len()).rev().map(VertexId::from_index);
        let mut free = newest.filter(|&v| self.is_used(v) && self.is_deletable(v));
        let newest = free.next();
        newest.is_some_and(|v| self.remove(v).is_ok())
    }
}

impl ConstrainedTriangulation {
    /// Whether an edge is part of a segment with one region on both sides.
    fn is_inner(&self, h: HalfEdgeId) -> bool {
        let (f, g) = (h.face(), self.twin(h).face());
        self.is_marked(h) && self.is_real(f) && self.is_real(g) && self.region(f) == self.region(g)
    }

    /// The edges that fail the circle test, to be flipped.
    pub(crate) fn illegal_edges(&self) -> Lawson {
        let illegal: Vec<HalfEdgeId> = self.edges().filter(|&h| !self.is_locally_delaunay(h)).collect();
        let mut waiting = Lawson::default();
        illegal.into_iter().rev().for_each(|h| waiting.push(h));
        waiting
    }

    /// How many pieces of segments inside are edges only because they are constrained.
    pub(crate) fn pieces_held_by_marks(&self) -> usize {
        self.edges().filter(|&h| self.is_inner(h) && self.is_held_by_its_mark(h)).count()
    }

    /// Whether an edge between two faces fails the circle test, marked or not.
    fn is_held_by_its_mark(&self, h: HalfEdgeId) -> bool {
        let corners = [self.origin(h), self.dest(h), self.apex(h), self.apex(self.twin(h))];
        let [a, b, c, d] = corners.map(|v| self.point(v));
        in_circle_perturbed(a, b, c, d) == CircleSide::Inside
    }
}
