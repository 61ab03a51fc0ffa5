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
use super::plan::SegmentPlan;
use super::split_crossings::Piece;
use crate::geometry::{CircleSide, Point, in_circle_perturbed};
use crate::locate::Locus;
use crate::mesh::{HalfEdgeId, Journal, NoJournal, VertexId};

/// A stretch of segments that was let go.
pub(crate) type Released = Piece;

/// Where splitting stops.
pub(crate) struct SplitLimits<'a> {
    /// No more vertices than this.
    pub(crate) vertices: usize,
    /// Whether two ends are far enough apart to be parted.
    pub(crate) may_part: &'a dyn Fn(Point, Point) -> bool,
    /// The parameter, from its start to its end, at which a stretch that crosses edges is split.
    pub(crate) place: &'a dyn Fn(&ConstrainedDelaunay, Released, &SegmentPlan) -> f64,
}

impl ConstrainedDelaunay {
    /// Lets go of every segment inside the domain; those that part two regions stay.
    ///
    /// Returns what was let go, in the order of its vertices. The triangulation is Delaunay across it afterwards.
    pub(crate) fn release_inner_segments(&mut self) -> Vec<Released> {
        let inner = self.t.edges().filter(|&h| self.is_inner(h)).collect();
        self.release_edges(inner)
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

    /// Lets go of edges that are parts of segments, and makes the triangulation Delaunay across them.
    fn release_edges(&mut self, inner: Vec<HalfEdgeId>) -> Vec<Released> {
        let mut released: Vec<Released> = Vec::with_capacity(inner.len());
        for &h in &inner {
            let (a, b) = (self.t.origin(h), self.t.dest(h));
            released.push(Piece { from: a.min(b), to: a.max(b), mark: self.t.mark(h) });
            self.t.mesh.set_mark(h, 0, &mut NoJournal);
        }
        for h in inner {
            self.lawson.push(h);
        }
        self.lawson.legalise_all(&mut self.t, &mut NoJournal);
        released.sort_unstable_by_key(|piece| [piece.from, piece.to]);
        released
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

    /// Splits what was let go until it is edges, and marks those; returns how many vertices went in.
    ///
    /// What the limits leave missing goes in as whole edges, so that in the end every segment is a chain of edges.
    pub(crate) fn recover_by_splitting<J: Journal>(
        &mut self,
        released: Vec<Released>,
        limits: &SplitLimits<'_>,
        j: &mut J,
    ) -> usize {
        let (mut pieces, mut inserted) = (released, 0);
        // Each round but the last puts a vertex in.
        loop {
            let before = inserted;
            let mut next = Vec::with_capacity(pieces.len());
            for piece in pieces {
                let room = inserted < limits.vertices;
                match self.parted(piece, room, limits, j) {
                    Some((v, is_new)) => {
                        inserted += usize::from(is_new);
                        next.extend([Piece { to: v, ..piece }, Piece { from: v, ..piece }]);
                    }
                    None => next.push(piece),
                }
            }
            pieces = next;
            if inserted == before {
                break;
            }
        }
        for piece in self.claim(&pieces, j) {
            // Nothing crosses it that it did not cross before it was let go, but for rounding.
            let _ = self.work_off(piece, 0, j);
        }
        inserted
    }

    /// The vertex that parts a piece which is no edge, and whether it is new; `None` for edges and where limits forbid.
    fn parted<J: Journal>(
        &mut self,
        piece: Piece,
        room: bool,
        limits: &SplitLimits<'_>,
        j: &mut J,
    ) -> Option<(VertexId, bool)> {
        if self.t.half_edge_between(piece.from, piece.to).is_some() {
            return None;
        }
        // A vertex exactly on the way parts it for nothing.
        let plan = self.t.plan_towards(piece.from, piece.to).ok()?;
        if plan.to != piece.to {
            return Some((plan.to, false));
        }
        let (p, provenance) = self.point_between(piece.from, piece.to, piece.mark, (limits.place)(self, piece, &plan));
        let [a, b] = [piece.from, piece.to].map(|v| self.t.point(v));
        if !room || !(limits.may_part)(a, p) || !(limits.may_part)(p, b) {
            return None;
        }
        let start = self.t.outgoing(piece.from).map_or(self.last, HalfEdgeId::face);
        match self.t.locate_from(start, p) {
            // An input vertex that is not exactly on the way, or the plan had ended there, is not on the segment.
            Locus::Vertex(v) => {
                let may_part = v != piece.from && v != piece.to && v.index() >= self.input_points;
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
