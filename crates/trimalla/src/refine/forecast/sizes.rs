//! The size of features at each vertex, graded.
//!
//! The size at a vertex is its distance to the nearest feature that does not touch it; away from there it grows no
//! faster than the distance times a grading. Grading is Dijkstra's algorithm along the edges of the triangulation.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::feet::Footed;
use crate::half_edge::VertexId;

/// Sizes by vertex, in the ruler's units.
#[derive(Debug)]
pub(super) struct Sizes {
    /// No size is below this.
    pub(super) floor: f64,
    /// Features nearer than this are within rounding of each other, and refinement does not separate them.
    pub(super) precision: f64,
    size: Vec<f64>,
    /// The vertex whose feature sets the size: after grading perhaps one far away.
    source: Vec<VertexId>,
    /// The vertex at the other end of a vertex' nearest feature.
    partner: Vec<Option<VertexId>>,
}

/// A positive length, ordered as its bits.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Length(u64);

impl Sizes {
    /// Measures and grades the sizes. No size is below the floor of refinement, in the ruler's units.
    ///
    /// # Complexity
    /// O(n log n).
    pub(super) fn of(footed: &Footed, grading: f64, floor: f64, precision: f64) -> Self {
        Self::under(footed, grading, floor, precision, |_| f64::INFINITY)
    }

    /// Like [`of`](Self::of), where no size at a vertex is above `most`.
    pub(super) fn under(
        footed: &Footed,
        grading: f64,
        floor: f64,
        precision: f64,
        most: impl Fn(VertexId) -> f64,
    ) -> Self {
        let n = footed.cdt.points().len();
        let source = (0..n).map(VertexId::from_index).collect();
        let mut sizes = Self { floor, precision, size: vec![f64::INFINITY; n], source, partner: vec![None; n] };
        sizes.measure(footed);
        for (v, size) in sizes.size.iter_mut().enumerate() {
            *size = size.min(most(VertexId::from_index(v))).max(floor);
        }
        sizes.grade(footed, grading);
        sizes
    }

    pub(super) fn at(&self, v: VertexId) -> f64 {
        self.size[v.index()]
    }

    /// The vertex whose feature sets the size at `v`.
    pub(super) fn source(&self, v: VertexId) -> VertexId {
        self.source[v.index()]
    }

    /// The vertex at the other end of that feature.
    pub(super) fn partner(&self, v: VertexId) -> Option<VertexId> {
        self.partner[v.index()]
    }

    fn measure(&mut self, footed: &Footed) {
        let cdt = &footed.cdt;
        for h in cdt.edges() {
            let (u, v) = (cdt.origin(h), cdt.dest(h));
            if !footed.is_feature(u, v) {
                continue;
            }
            let length = footed.ruler.length_sq(cdt.point(u), cdt.point(v)).sqrt();
            if length < self.precision {
                continue;
            }
            for (one, other) in [(u, v), (v, u)] {
                let i = one.index();
                // Of equal lengths the one to the lowest vertex, whatever the order of edges.
                let (known, partner) = (self.size[i], self.partner[i]);
                if length < known || length == known && partner.is_some_and(|p| other < p) {
                    self.size[i] = length;
                    self.partner[i] = Some(other);
                }
            }
        }
    }

    /// Vertices leave the heap with their final sizes, the smallest first; vertices that lower no neighbour are never
    /// pushed.
    fn grade(&mut self, footed: &Footed, grading: f64) {
        let cdt = &footed.cdt;
        let mut heap: BinaryHeap<Reverse<(Length, VertexId)>> = BinaryHeap::new();
        for h in cdt.edges() {
            let (u, v) = (cdt.origin(h), cdt.dest(h));
            let low = if self.at(u) < self.at(v) { u } else { v };
            let reach = grading * footed.ruler.length_sq(cdt.point(u), cdt.point(v)).sqrt();
            if self.at(low) + reach < self.at(u).max(self.at(v)) {
                heap.push(Reverse((Length(self.at(low).to_bits()), low)));
            }
        }
        while let Some(Reverse((length, v))) = heap.pop() {
            let size = self.at(v);
            if length.0 != size.to_bits() {
                continue;
            }
            for u in cdt.neighbours(v) {
                let reached = size + grading * footed.ruler.length_sq(cdt.point(v), cdt.point(u)).sqrt();
                if reached < self.at(u) {
                    self.size[u.index()] = reached;
                    self.source[u.index()] = self.source(v);
                    heap.push(Reverse((Length(reached.to_bits()), u)));
                }
            }
        }
    }
}
