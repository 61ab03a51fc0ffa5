//! The walk, and what it finds.

use crate::geometry::{Orientation, Point, Triangle, lexicographic, orient2d, strictly_between};
use crate::mesh::{FaceId, HalfEdgeId, VertexId};
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

/// After this many steps the order in which edges are looked at is varied.
const CALM_STEPS: usize = 1 << 10;

impl Triangulation {
    /// Where `p` lies.
    ///
    /// # Guarantees
    /// Exact, for every finite point, also in dimension −1 to 1 and in domains with holes.
    ///
    /// # Complexity
    /// About √n steps on evenly spread points; linear at worst.
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
        match self.walk(start, p) {
            Some(Locus::Outside(h)) if self.closure == Closure::Domain => self.scan(p).unwrap_or(Locus::Outside(h)),
            Some(locus) => locus,
            None => self.scan_or_outside(p),
        }
    }

    /// Walks towards `p` without crossing constrained edges, along the straight line from the middle of `start` as far as
    /// triangles allow.
    ///
    /// A walk that leaves the domain is blocked by the boundary edge it meets, constrained or not. Which way it
    /// takes does not depend on slots.
    #[must_use]
    pub fn walk_within(&self, start: FaceId, p: Point) -> Walk {
        let Some(mut face) = self.real_face_near(start) else { return Walk::Arrived(Locus::Nowhere) };
        let [a, b, c] = self.corners(face);
        let source = Triangle::new(a, b, c).centroid();
        let mut entered = HalfEdgeId::NONE;
        for _ in 0..CALM_STEPS + self.face_slots() {
            let Some(h) = self.exit_towards(face, entered, source, p) else { return Walk::Arrived(self.locus_at(face, p)) };
            if self.is_marked(h) || self.is_ghost(self.twin(h).face()) {
                return Walk::Blocked(h);
            }
            entered = self.twin(h);
            face = entered.face();
        }
        Walk::Arrived(self.scan_or_outside(p))
    }

    /// The edge of a face by which to go on towards `p`; `None` where the face contains it.
    ///
    /// Of two edges that have `p` beyond them it is the one that the line from `source` to `p` crosses.
    fn exit_towards(&self, face: FaceId, entered: HalfEdgeId, source: Point, p: Point) -> Option<HalfEdgeId> {
        let beyond = |h: &HalfEdgeId| *h != entered && self.side_of(*h, p) == Orientation::Clockwise;
        let mut exits = face.half_edges().into_iter().filter(beyond);
        let (first, second) = (exits.next()?, exits.next());
        let Some(second) = second else { return Some(first) };
        // They share a vertex; the line passes it on one side or the other.
        let (before, after) = if second == first.next() { (first, second) } else { (second, first) };
        let passes_left = orient2d(source, p, self.point(self.origin(after))) == Orientation::Clockwise;
        Some(if passes_left { after } else { before })
    }

    /// The visibility walk. `None` when the bound on steps was met.
    #[inline]
    fn walk(&self, start: FaceId, p: Point) -> Option<Locus> {
        let mut face = self.real_face_near(start)?;
        let mut entered = HalfEdgeId::NONE;
        let mut spin = 0;
        let bound = CALM_STEPS + 4 * self.face_slots();
        'steps: for step in 0..bound {
            if step >= CALM_STEPS {
                spin = vary(step);
            }
            let mut flat = [HalfEdgeId::NONE; 2];
            for k in 0..3 {
                let h = face.half_edge((k + spin) % 3);
                if h == entered {
                    continue;
                }
                match self.side_of(h, p) {
                    Orientation::CounterClockwise => {}
                    Orientation::Collinear => flat = [h, flat[0]],
                    Orientation::Clockwise => {
                        entered = self.twin(h);
                        if !self.apex(entered).is_finite() {
                            return Some(Locus::Outside(entered));
                        }
                        face = entered.face();
                        continue 'steps;
                    }
                }
            }
            return Some(self.locus_in(face, flat));
        }
        None
    }

    /// The locus of a point in a face, given the edges it is collinear with.
    #[inline]
    fn locus_in(&self, face: FaceId, flat: [HalfEdgeId; 2]) -> Locus {
        match flat {
            [HalfEdgeId::NONE, _] => Locus::Face(face),
            [h, HalfEdgeId::NONE] => Locus::Edge(h),
            [h, g] if g == h.next() => Locus::Vertex(self.origin(g)),
            [h, _] => Locus::Vertex(self.origin(h)),
        }
    }

    /// A real face at or beside a slot.
    #[inline]
    fn real_face_near(&self, f: FaceId) -> Option<FaceId> {
        if self.is_alive(f) {
            if !self.is_ghost(f) {
                return Some(f);
            }
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

    /// Looks at every real face.
    fn scan(&self, p: Point) -> Option<Locus> {
        let f = self.real_faces().find(|&f| self.face_contains(f, p))?;
        Some(self.locus_at(f, p))
    }

    /// The locus of a point in a face that contains it.
    fn locus_at(&self, f: FaceId, p: Point) -> Locus {
        let mut flat = [HalfEdgeId::NONE; 2];
        for h in f.half_edges() {
            if self.side_of(h, p) == Orientation::Collinear {
                flat = [h, flat[0]];
            }
        }
        self.locus_in(f, flat)
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

/// A fixed sequence of 0, 1, 2 without pattern.
fn vary(step: usize) -> u32 {
    let x = (step as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    ((x >> 33) % 3) as u32
}
