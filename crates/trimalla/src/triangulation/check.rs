//! The checker: every broken invariant, by name.

use std::fmt;

use super::triangulation::{Closure, Triangulation};
use crate::drawing::SegmentId;
use crate::geometry::{CircleSide, Orientation, in_circle_perturbed, orient2d};
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};

/// A broken invariant of a triangulation, with the elements concerned.
///
/// The numbers name invariants. I01: half-edges are symmetric. I02: the faces around a vertex are one cycle. I03:
/// Euler's formula holds. I04: faces are counter-clockwise. I06: the hull is convex. I07: duplicates are unused. I08:
/// vertices are finite. I09, I10 and I12: the circle test, that of constrained triangulations, and its tie rule. I13:
/// segments are chains of edges. Others, such as I05, that no two triangles overlap, follow from these or concern
/// meshes alone.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Fault {
    /// I01: twin of twin is another half-edge, or an index is out of range.
    Twin(HalfEdgeId),
    /// I01: a half-edge and its twin do not join the same two vertices.
    TwinEnds(HalfEdgeId),
    /// I01: a face names a vertex twice.
    RepeatedVertex(FaceId),
    /// I01: a dead slot does not hold the fixed value, or a live one is on the free list.
    DeadSlot(FaceId),
    /// I01: the half-edge that a vertex keeps starts elsewhere.
    Outgoing(VertexId),
    /// I01: the two sides of an edge carry different marks.
    Mark(HalfEdgeId),
    /// I02: the faces around a vertex are not one cycle.
    Star(VertexId),
    /// I03: vertices, edges and faces do not add up.
    Euler {
        /// V − E + F found.
        found: i64,
        /// What it must be.
        expected: i64,
    },
    /// I04: a face is clockwise or flat.
    NotCounterClockwise(FaceId),
    /// I06: the hull is not convex at the end of this hull edge.
    HullNotConvex(HalfEdgeId),
    /// I06: consecutive chain vertices are not in order along one line.
    ChainOrder(VertexId),
    /// I07: a duplicate is used, or lies elsewhere than its representative.
    Duplicate(VertexId),
    /// I08: a used vertex is not finite.
    NotFinite(VertexId),
    /// The dimension does not fit the faces.
    Dimension(i8),
    /// I09, I10, I12: an unconstrained edge fails the circle test (with the tie rule).
    NotDelaunay(HalfEdgeId),
    /// A boundary edge of a domain carries no mark.
    BoundaryNotConstrained(HalfEdgeId),
    /// A ghost face lies in a region.
    GhostInRegion(FaceId),
    /// I13: the edges of an input segment are not one chain from its start to its end.
    SegmentBroken(SegmentId),
    /// I13: a chain does not run along its input segment at this vertex.
    OffSegment {
        /// The input segment.
        segment: SegmentId,
        /// The vertex.
        vertex: VertexId,
    },
    /// I13: an input vertex lies exactly on an input segment and is none of its chain.
    PassesBy {
        /// The input segment.
        segment: SegmentId,
        /// The vertex.
        vertex: VertexId,
    },
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Twin(h) => write!(f, "twin of twin of half-edge {h} is another"),
            Self::TwinEnds(h) => write!(f, "half-edge {h} and its twin join different vertices"),
            Self::RepeatedVertex(t) => write!(f, "triangle {t} names a vertex twice"),
            Self::DeadSlot(t) => write!(f, "face slot {t} is neither alive nor properly dead"),
            Self::Outgoing(v) => write!(f, "vertex {v} keeps a half-edge that starts elsewhere"),
            Self::Mark(h) => write!(f, "the two sides of half-edge {h} carry different marks"),
            Self::Star(v) => write!(f, "the faces around vertex {v} are not one cycle"),
            Self::Euler { found, expected } => write!(f, "euler characteristic is {found}, not {expected}"),
            Self::NotCounterClockwise(t) => write!(f, "triangle {t} is not counter-clockwise"),
            Self::HullNotConvex(h) => write!(f, "the hull is not convex after half-edge {h}"),
            Self::ChainOrder(v) => write!(f, "vertex {v} is out of order on its line"),
            Self::Duplicate(v) => write!(f, "vertex {v} is not a proper duplicate"),
            Self::NotFinite(v) => write!(f, "vertex {v} is not finite"),
            Self::Dimension(d) => write!(f, "dimension {d} does not fit the faces"),
            Self::NotDelaunay(h) => write!(f, "edge {h} fails the circle test"),
            Self::SegmentBroken(s) => write!(f, "the edges of segment {s} are not one chain"),
            Self::OffSegment { segment, vertex } => write!(f, "vertex {vertex} is out of place on segment {segment}"),
            Self::PassesBy { segment, vertex } => {
                write!(f, "segment {segment} passes by vertex {vertex}, which is on it")
            }
            Self::GhostInRegion(t) => write!(f, "ghost face {t} lies in a region"),
            Self::BoundaryNotConstrained(h) => write!(f, "boundary edge {h} is not constrained"),
        }
    }
}

impl Triangulation {
    /// Every broken invariant except the circle test; empty for a sound triangulation.
    ///
    /// # Complexity
    /// Linear.
    #[must_use]
    pub fn check(&self) -> Vec<Fault> {
        let mut faults = Vec::new();
        self.check_half_edges(&mut faults);
        if !faults.is_empty() {
            return faults; // The checks that follow walk along twins.
        }
        self.check_stars(&mut faults);
        self.check_vertices(&mut faults);
        self.check_dimension(&mut faults);
        if self.dimension == 2 {
            self.check_faces(&mut faults);
        }
        self.check_boundary(&mut faults);
        faults
    }

    /// [`check`](Self::check), and the circle test with the tie rule on every unconstrained edge.
    #[must_use]
    pub fn check_delaunay(&self) -> Vec<Fault> {
        let mut faults = self.check();
        if faults.is_empty() {
            faults.extend(self.edges().filter(|&h| !self.is_locally_delaunay(h)).map(Fault::NotDelaunay));
        }
        faults
    }

    /// Whether a finite edge is constrained, on the boundary, or passes the circle test (ties by the rule).
    ///
    /// # Source
    /// The constrained circle test of `[Valenzuela09]`, definition 5.
    #[must_use]
    pub fn is_locally_delaunay(&self, h: HalfEdgeId) -> bool {
        if self.is_marked(h) {
            return true;
        }
        let t = self.twin(h);
        let corners = [self.origin(h), self.dest(h), self.apex(h), self.apex(t)];
        if corners.iter().any(|v| !v.is_finite()) {
            return true;
        }
        let [a, b, c, d] = corners.map(|v| self.point(v));
        in_circle_perturbed(a, b, c, d) != CircleSide::Inside
    }

    fn check_half_edges(&self, faults: &mut Vec<Fault>) {
        let slots = self.mesh.face_slots();
        let mut freed = vec![false; slots];
        for f in self.mesh.free_faces() {
            freed[f.index()] = true;
        }
        for f in (0..slots).map(FaceId::from_index) {
            if self.mesh.is_alive(f) == freed[f.index()] {
                faults.push(Fault::DeadSlot(f));
            }
            if !self.mesh.is_alive(f) {
                continue;
            }
            let [a, b, c] = self.face_vertices(f);
            if a == b || b == c || c == a {
                faults.push(Fault::RepeatedVertex(f));
            }
            faults.extend(f.half_edges().into_iter().filter_map(|h| self.half_edge_fault(h)));
        }
    }

    fn half_edge_fault(&self, h: HalfEdgeId) -> Option<Fault> {
        let t = self.twin(h);
        if t.index() >= 3 * self.mesh.face_slots() || !self.mesh.is_alive(t.face()) || self.twin(t) != h {
            return Some(Fault::Twin(h));
        }
        if self.origin(t) != self.dest(h) || self.dest(t) != self.origin(h) {
            return Some(Fault::TwinEnds(h));
        }
        if self.mark(h) != self.mark(t) {
            return Some(Fault::Mark(h));
        }
        let v = self.origin(h);
        (v.is_finite() && self.outgoing(v).is_none()).then_some(Fault::Outgoing(v))
    }

    /// Every half-edge of every vertex is met on one round about it.
    fn check_stars(&self, faults: &mut Vec<Fault>) {
        let mut expected = vec![0usize; self.points.len()];
        for f in (0..self.mesh.face_slots()).map(FaceId::from_index).filter(|&f| self.mesh.is_alive(f)) {
            for v in self.face_vertices(f).into_iter().filter(|v| v.is_finite()) {
                expected[v.index()] += 1;
            }
        }
        for v in (0..self.points.len()).map(VertexId::from_index) {
            if self.outgoing(v).is_some_and(|h| self.origin(h) != v) {
                faults.push(Fault::Outgoing(v));
            } else if self.star(v).count() != expected[v.index()] {
                faults.push(Fault::Star(v));
            }
        }
    }

    fn check_vertices(&self, faults: &mut Vec<Fault>) {
        faults.extend(self.used_vertices().filter(|&v| !self.point(v).is_finite()).map(Fault::NotFinite));
        for &(d, r) in &self.duplicates {
            if self.is_used(d) || self.point(d) != self.point(r) {
                faults.push(Fault::Duplicate(d));
            }
        }
    }

    fn check_dimension(&self, faults: &mut Vec<Fault>) {
        let real = self.real_faces().next().is_some();
        let fits = match self.dimension {
            -1 => self.mesh.live_faces() == 0 && self.lone.is_none(),
            0 => self.mesh.live_faces() == 0 && self.lone.is_some(),
            1 => self.mesh.live_faces() > 0 && !real && self.lone.is_none(),
            _ => real && self.lone.is_none(),
        };
        if !fits {
            faults.push(Fault::Dimension(self.dimension));
        }
    }

    fn check_faces(&self, faults: &mut Vec<Fault>) {
        for f in self.real_faces() {
            let [a, b, c] = self.face_points(f);
            if orient2d(a, b, c) != Orientation::CounterClockwise {
                faults.push(Fault::NotCounterClockwise(f));
            }
        }
        if self.closure == Closure::Hull {
            // A disc: V − E + F = 1.
            let vertices = self.used_vertices().count();
            let edges = self.edges().count();
            let faces = self.face_count();
            #[allow(clippy::cast_possible_wrap, reason = "counts are below 2^33")]
            let found = vertices as i64 - edges as i64 + faces as i64;
            if found != 1 {
                faults.push(Fault::Euler { found, expected: 1 });
            }
        }
    }

    fn check_boundary(&self, faults: &mut Vec<Fault>) {
        for f in self.ghost_faces() {
            let Some(g) = self.ghost_edge(f) else { continue };
            let h = self.twin(g);
            if self.region(f) != 0 {
                faults.push(Fault::GhostInRegion(f));
            }
            if self.dimension == 1 {
                self.check_chain_edge(g, faults);
            } else if self.closure == Closure::Domain {
                if !self.is_marked(h) {
                    faults.push(Fault::BoundaryNotConstrained(h));
                }
            } else {
                let next = self.next_on_boundary(h);
                let turn = self.side_of(h, self.point(self.dest(next)));
                if turn == Orientation::Clockwise {
                    faults.push(Fault::HullNotConvex(h));
                }
            }
        }
    }

    /// In a chain, the edge after `g` goes on straight in the same direction.
    fn check_chain_edge(&self, g: HalfEdgeId, faults: &mut Vec<Fault>) {
        let next = self.twin(g.next()).next();
        if next == self.twin(g) {
            return; // The chain ends here.
        }
        let [a, b] = self.edge_points(g);
        let c = self.point(self.dest(next));
        if !crate::geometry::strictly_between(a, c, b) {
            faults.push(Fault::ChainOrder(self.dest(g)));
        }
    }
}
