//! Which of the edges that were taken a pair of vertices crosses.
//!
//! Beneath lies a triangulation of the same vertices. An edge that was taken is an edge of it, or it is noted with
//! every triangle that it passes through. So what crosses a pair is found on the way from one of its vertices to the
//! other, triangle by triangle.
//!
//! ```text
//!          b──────c          the way from p to q passes through pab, bac, caq: whatever crosses it
//!        ╱ │ ╲    │ ╲        is ab or ac, or is noted with one of the three
//!      p ╌╌│╌╌╌╲╌╌│╌╌ q
//!        ╲ │     ╲│ ╱
//!          a──────·
//! ```

use crate::geometry::{Orientation, Point, SegmentContact, orient2d, segment_contact};
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};
use crate::triangulation::Triangulation;

/// The end of a list.
const END: u32 = u32::MAX;

/// Edges that were taken.
pub(super) struct Crossings<'a> {
    t: &'a Triangulation,
    edges: Vec<[u32; 2]>,
    /// Which half-edges of the triangulation were taken.
    is_taken: Vec<bool>,
    /// For each face the first of its notes.
    first: Vec<u32>,
    /// Edges noted with faces, and the next note of the same face.
    notes: Vec<(u32, u32)>,
    /// The faces on the way of the pair that is looked at.
    way: Vec<FaceId>,
}

impl<'a> Crossings<'a> {
    /// Nothing is taken yet.
    pub(super) fn new(t: &'a Triangulation) -> Self {
        let (is_taken, first) = (vec![false; 3 * t.face_slots()], vec![END; t.face_slots()]);
        Self { t, edges: Vec::new(), is_taken, first, notes: Vec::new(), way: Vec::new() }
    }

    /// The edges that were taken, in order.
    pub(super) fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }

    /// The edges that were taken, in order.
    pub(super) fn into_edges(self) -> Vec<[u32; 2]> {
        self.edges
    }

    /// Takes an edge of the triangulation, whatever it crosses.
    pub(super) fn take_edge(&mut self, edge: [u32; 2]) {
        if let Some(h) = self.t.half_edge_between(VertexId(edge[0]), VertexId(edge[1])) {
            self.is_taken[h.index()] = true;
            self.is_taken[self.t.twin(h).index()] = true;
            self.edges.push(edge);
        }
    }

    /// Takes a pair of vertices, or says why not.
    ///
    /// # Complexity
    /// Linear in the triangles between the two, and in what is noted with them.
    pub(super) fn take(&mut self, pair: [u32; 2]) -> Result<(), &'static str> {
        let [p, q] = pair.map(VertexId);
        let edge = self.t.half_edge_between(p, q);
        if edge.is_some_and(|h| self.is_taken[h.index()]) {
            return Err("is an edge already");
        }
        self.way.clear();
        match edge {
            Some(h) => self.way.extend([h.face(), self.t.twin(h).face()]),
            None => self.go(p, q)?,
        }
        if self.way.iter().any(|&f| self.is_crossed_in(f, pair)) {
            return Err("crosses an edge");
        }
        match edge {
            Some(_) => self.take_edge(pair),
            None => self.note(pair),
        }
        Ok(())
    }

    /// Whether a pair crosses an edge that is noted with a face.
    fn is_crossed_in(&self, f: FaceId, pair: [u32; 2]) -> bool {
        let [p, q] = pair.map(|v| self.t.point(VertexId(v)));
        let mut at = self.first[f.index()];
        while let Some(&(edge, next)) = self.notes.get(at as usize) {
            let [a, b] = self.edges[edge as usize].map(|v| self.t.point(VertexId(v)));
            if segment_contact(p, q, a, b) == SegmentContact::Crossing {
                return true;
            }
            at = next;
        }
        false
    }

    fn note(&mut self, pair: [u32; 2]) {
        let edge = self.edges.len() as u32;
        self.edges.push(pair);
        for f in &self.way {
            let first = &mut self.first[f.index()];
            let next = std::mem::replace(first, self.notes.len() as u32);
            self.notes.push((edge, next));
        }
    }

    /// Collects the faces between two vertices that are not joined by an edge.
    fn go(&mut self, p: VertexId, q: VertexId) -> Result<(), &'static str> {
        let to = self.t.point(q);
        let mut edge = first_crossed(self.t, p, to)?;
        self.way.push(edge.face());
        loop {
            if self.is_taken[edge.index()] {
                return Err("crosses an edge");
            }
            let beyond = self.t.twin(edge);
            if !self.t.is_real(beyond.face()) {
                return Err("lies outside the domain");
            }
            self.way.push(beyond.face());
            let apex = self.t.apex(beyond);
            if apex == q {
                return Ok(());
            }
            edge = match orient2d(self.t.point(p), to, self.t.point(apex)) {
                Orientation::CounterClockwise => beyond.next(),
                Orientation::Clockwise => beyond.prev(),
                Orientation::Collinear => return Err("passes through a vertex"),
            };
        }
    }
}

/// The edge opposite `p`, in one of the faces around it, that the way to a point crosses: from its right to its left.
fn first_crossed(t: &Triangulation, p: VertexId, to: Point) -> Result<HalfEdgeId, &'static str> {
    let from = t.point(p);
    for h in t.star(p).filter(|h| t.is_real(h.face())) {
        let [right, left] = [t.dest(h), t.apex(h)].map(|v| t.point(v));
        match (orient2d(from, right, to), orient2d(from, left, to)) {
            (Orientation::CounterClockwise, Orientation::Clockwise) => return Ok(h.next()),
            (Orientation::Collinear, Orientation::Clockwise)
            | (Orientation::CounterClockwise, Orientation::Collinear) => {
                return Err("passes through a vertex");
            }
            _ => {}
        }
    }
    Err("lies outside the domain")
}
