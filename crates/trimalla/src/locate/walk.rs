//! The exact walk, and its results.

use crate::geometry::{Orientation, Point, Triangle, lexicographic, orient2d, strictly_between};
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};
use crate::triangulation::{Closure, Triangulation};

/// Where a point lies in a triangulation, exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Locus {
    /// On a vertex.
    Vertex(VertexId),
    /// Strictly inside an edge; in dimension 2 with a real face on the left.
    Edge(HalfEdgeId),
    /// Strictly inside a real face.
    Face(FaceId),
    /// Outside; the finite half-edge of a ghost that has the point strictly on its left.
    ///
    /// Of a domain: outside it, beyond some boundary edge (not always one that sees the point).
    Outside(HalfEdgeId),
    /// Dimension 1: on the line, beyond `dest` of this last edge.
    Beyond(HalfEdgeId),
    /// Dimension 1: off the line, strictly left of this edge.
    OffLine(HalfEdgeId),
    /// Dimension −1 or 0: there is no edge to say anything about.
    Nowhere,
}

/// How a walk that may not cross constraints ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Walk {
    /// It arrived.
    Arrived(Locus),
    /// It would have had to cross this constrained edge, from its left to its right.
    Blocked(HalfEdgeId),
}

/// After this many steps the edge to cross, where there are two, is drawn.
const CALM_STEPS: usize = 1 << 10;
impl Triangulation {
    /// Where `p` lies.
    ///
    /// # Guarantees
    /// Exact, for every finite point, also in dimension −1 to 1 and in domains with holes.
    ///
    /// # Complexity
    /// About √n steps on evenly spread points; linear at worst.
    #[doc(alias = "point location")]
    #[doc(alias = "find_triangle")]
    #[doc(alias = "localizar")]
    #[must_use]
    pub fn locate(&self, p: Point) -> Locus {
        let start = (0..self.face_slots()).rev().map(FaceId::from_index).find(|&f| self.is_real(f));
        self.locate_from(start.unwrap_or(FaceId(0)), p)
    }

    /// Where `p` lies, walking from a face near it.
    #[must_use]
    #[inline]
    pub fn locate_from(&self, start: FaceId, p: Point) -> Locus {
        if self.dimension < 2 {
            return self.locate_low(p);
        }
        match self.locate_by_walk(start, p) {
            Some(Locus::Outside(h)) if self.closure == Closure::Domain => self.scan(p).unwrap_or(Locus::Outside(h)),
            Some(locus) => locus,
            None => self.scan_or_outside(p),
        }
    }

    /// Where `p` lies by a walk alone, in dimension 2; `None` where it takes too many steps.
    ///
    /// Of a domain `Outside` says only that the walk came to a boundary edge with `p` beyond: `p` may still lie in the
    /// domain, on the other side of a bay or a hole.
    #[inline]
    pub(crate) fn locate_by_walk(&self, start: FaceId, p: Point) -> Option<Locus> {
        self.float_walk(start, p).or_else(|near| self.walk(near, p).ok_or(near)).ok()
    }

    /// Walks towards `p` without crossing constrained edges, along the straight line from the middle of `start` as far
    /// as the triangles allow.
    ///
    /// A walk that leaves the domain is blocked by the boundary edge it meets, constrained or not. Which way it
    /// takes does not depend on slots.
    #[must_use]
    pub fn walk_within(&self, start: FaceId, p: Point) -> Walk {
        let arrived = self.float_walk_within(start, p).map(|f| Walk::Arrived(Locus::Face(f)));
        // Without a bound of its own the walk ends.
        arrived.or_else(|| self.walk_within_exactly(start, p, usize::MAX)).unwrap_or(Walk::Arrived(Locus::Nowhere))
    }

    /// [`walk_within`](Self::walk_within) without rounded products, in no more than so many steps; `None` where it
    /// takes more.
    pub(crate) fn walk_within_exactly(&self, start: FaceId, p: Point, steps: usize) -> Option<Walk> {
        let Some(start) = self.real_face_near(start) else { return Some(Walk::Arrived(Locus::Nowhere)) };
        let mut e = start.half_edge(0);
        let [mut a, mut b] = self.edge_points(e);
        let mut side = orient2d(a, b, p);
        let most = CALM_STEPS + self.face_slots();
        for _ in 0..most.min(steps) {
            let (next, prev) = e.next_and_prev();
            let c = self.point(self.origin(prev));
            let sides = [side, orient2d(b, c, p), orient2d(c, a, p)];
            let is_beyond = sides.map(|side| side == Orientation::Clockwise);
            let Some(exit) = self.exit(start, p, [e, next, prev], is_beyond) else {
                return Some(Walk::Arrived(self.locus_in(e, sides)));
            };
            if self.is_marked(exit) || self.is_ghost(self.twin(exit).face()) {
                return Some(Walk::Blocked(exit));
            }
            (a, b) = match exit {
                _ if exit == e => (b, a),
                _ if exit == next => (c, b),
                _ => (a, c),
            };
            (e, side) = (self.twin(exit), Orientation::CounterClockwise);
        }
        (steps >= most).then(|| Walk::Arrived(self.scan_or_outside(p)))
    }

    /// The edge of a face by which to leave it for `p`, on the way from the middle of `start`; `None` where `p` is
    /// beyond none.
    #[inline(always)] // At each step.
    pub(super) fn exit(
        &self,
        start: FaceId,
        p: Point,
        [e, next, prev]: [HalfEdgeId; 3],
        is_beyond: [bool; 3],
    ) -> Option<HalfEdgeId> {
        Some(match is_beyond {
            [false, false, false] => return None,
            [true, false, false] => e,
            [false, true, false] => next,
            [false, false, true] => prev,
            [true, true, _] => self.exit_towards(start, p, e),
            [_, true, true] => self.exit_towards(start, p, next),
            [true, _, true] => self.exit_towards(start, p, prev),
        })
    }

    /// Of the edges `first` and the next one around their face, which both have `p` beyond them, the one that the line
    /// from the middle of `start` to `p` crosses: it passes the vertex they share on one side or the other.
    fn exit_towards(&self, start: FaceId, p: Point, first: HalfEdgeId) -> HalfEdgeId {
        let [a, b, c] = self.corners(start);
        let source = Triangle::new(a, b, c).centroid();
        let second = first.next();
        let passes_left = orient2d(source, p, self.point(self.origin(second))) == Orientation::Clockwise;
        if passes_left { second } else { first }
    }

    /// The exact visibility walk; `None` when it met the bound on steps.
    ///
    /// ```text
    ///          c           p lies left of e, or on its line: where it lies
    ///        /   \         in the face is a matter of the two other edges
    ///     ca       bc
    ///    /           \
    ///   a ──── e ────> b
    /// ```
    #[inline]
    fn walk(&self, start: FaceId, p: Point) -> Option<Locus> {
        let mut e = self.real_face_near(start)?.half_edge(0);
        let [mut a, mut b] = self.edge_points(e);
        let mut side = orient2d(a, b, p);
        if side == Orientation::Clockwise {
            (e, side) = (self.twin(e), Orientation::CounterClockwise);
            (a, b) = (b, a);
        }
        let bound = CALM_STEPS + 4 * self.face_slots();
        for step in 0..bound {
            let (bc, ca) = (e.next(), e.prev());
            let Some(&c) = self.points.get(self.origin(ca).index()) else {
                return Some(Locus::Outside(e)); // The face is a ghost.
            };
            let (beyond_bc, beyond_ca) = (orient2d(b, c, p), orient2d(c, a, p));
            let cross_ca = match (beyond_bc, beyond_ca) {
                (Orientation::Clockwise, Orientation::Clockwise) => step >= CALM_STEPS && vary(step),
                (Orientation::Clockwise, _) => false,
                (_, Orientation::Clockwise) => true,
                _ => return Some(self.locus_in(e, [side, beyond_bc, beyond_ca])),
            };
            let crossed = if cross_ca { ca } else { bc };
            (a, b) = if cross_ca { (a, c) } else { (c, b) };
            (e, side) = (self.twin(crossed), Orientation::CounterClockwise);
        }
        None
    }

    /// The locus of a point in the face of `e`, by its sides of `e` and the edges that follow, none of them clockwise.
    #[inline]
    fn locus_in(&self, e: HalfEdgeId, sides: [Orientation; 3]) -> Locus {
        match sides.map(|side| side == Orientation::Collinear) {
            [false, false, false] => Locus::Face(e.face()),
            [true, false, false] => Locus::Edge(e),
            [false, true, false] => Locus::Edge(e.next()),
            [false, false, true] => Locus::Edge(e.prev()),
            [true, _, true] => Locus::Vertex(self.origin(e)),
            [true, true, _] => Locus::Vertex(self.dest(e)),
            [_, true, true] => Locus::Vertex(self.apex(e)),
        }
    }

    /// A real face at or beside a slot.
    #[inline]
    fn real_face_near(&self, f: FaceId) -> Option<FaceId> {
        if self.is_real(f) { Some(f) } else { self.real_face_beside(f) }
    }

    /// The face beside a ghost; for a dead slot any.
    #[cold]
    fn real_face_beside(&self, f: FaceId) -> Option<FaceId> {
        if self.is_alive(f) {
            return self.ghost_edge(f).map(|g| self.twin(g).face()).filter(|&f| self.is_real(f));
        }
        self.real_faces().next_back()
    }

    fn scan_or_outside(&self, p: Point) -> Locus {
        self.scan(p).unwrap_or_else(|| {
            let sees = |g: &HalfEdgeId| self.side_of(*g, p) == Orientation::CounterClockwise;
            let ghost_edges = || self.ghost_faces().filter_map(|f| self.ghost_edge(f));
            ghost_edges().find(sees).or_else(|| ghost_edges().next()).map_or(Locus::Nowhere, Locus::Outside)
        })
    }

    /// Tests every real face.
    fn scan(&self, p: Point) -> Option<Locus> {
        let f = self.real_faces().find(|&f| self.face_contains(f, p))?;
        Some(self.locus_at(f, p))
    }

    /// The locus of a point in a face that contains it.
    fn locus_at(&self, f: FaceId, p: Point) -> Locus {
        self.locus_in(f.half_edge(0), f.half_edges().map(|h| self.side_of(h, p)))
    }

    /// Location in dimension −1, 0 and 1.
    #[cold]
    fn locate_low(&self, p: Point) -> Locus {
        if let Some(v) = self.lone {
            return if self.point(v) == p { Locus::Vertex(v) } else { Locus::Nowhere };
        }
        let Some(first) = self.ghost_faces().next().and_then(|f| self.ghost_edge(f)) else { return Locus::Nowhere };
        match self.side_of(first, p) {
            Orientation::CounterClockwise => Locus::OffLine(first),
            Orientation::Clockwise => Locus::OffLine(self.twin(first)),
            Orientation::Collinear => self.locate_on_chain(first, p),
        }
    }

    /// Location on the line of a chain: along it, towards the point.
    fn locate_on_chain(&self, first: HalfEdgeId, p: Point) -> Locus {
        let towards = |a: Point, b: Point| lexicographic(a, b) == lexicographic(a, p) || a == p;
        let [a, b] = self.edge_points(first);
        let mut edge = if towards(a, b) { first } else { self.twin(first) };
        for _ in 0..=self.face_slots() {
            let [a, b] = self.edge_points(edge);
            if p == a {
                return Locus::Vertex(self.origin(edge));
            }
            if p == b {
                return Locus::Vertex(self.dest(edge));
            }
            if strictly_between(a, b, p) {
                return Locus::Edge(edge);
            }
            let next = self.twin(edge.next()).next();
            if next == self.twin(edge) {
                return Locus::Beyond(edge);
            }
            edge = next;
        }
        Locus::Nowhere
    }
}

/// A fixed pseudo-random sequence of choices.
fn vary(step: usize) -> bool {
    (step as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 63 == 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::delaunay::Delaunay;

    #[test]
    fn a_walk_from_any_face_ends_where_the_scan_does() {
        let points: Vec<Point> = (0..20u8).map(|i| Point::new(f64::from(i * 7 % 5), f64::from(i * 3 % 4))).collect();
        let t = Delaunay::new(&points).expect("finite");
        for (i, start) in (0..14 * 11u8).zip((0..t.face_slots()).cycle()) {
            let p = Point::new(f64::from(i % 14) * 0.5 - 1.0, f64::from(i / 14) * 0.5 - 1.0);
            for start in [start, start + 5, start + 11].map(|f| FaceId::from_index(f % t.face_slots())) {
                match (t.locate_from(start, p), t.scan(p)) {
                    (Locus::Edge(h), Some(Locus::Edge(g))) => assert!(h == g || h == t.twin(g), "{p} from {start}"),
                    (Locus::Outside(h), None) => {
                        assert!(t.is_ghost(h.face()), "{p} from {start}");
                        assert_eq!(t.side_of(h, p), Orientation::CounterClockwise, "{p} from {start}");
                    }
                    (walked, scanned) => assert_eq!(Some(walked), scanned, "{p} from {start}"),
                }
            }
        }
    }
}
