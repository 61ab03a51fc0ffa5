//! Area bounds that a mesh gave triangle by triangle, kept for the triangles that come out of them.
//!
//! Splits leave a triangle inside the one it came from, but flips do not. So the given triangles are kept as they were,
//! and a triangle has the bound of the one in which its middle lies. Each face remembers some given triangle near by
//! (its region: handed down by splits, kept by flips), from which the way there is short.

use crate::geometry::{Point, Triangle};
use crate::locate::{Locus, Walk};
use crate::mesh::FaceId;
use crate::triangulation::Triangulation;

/// The given triangles, unmarked, each with its bound.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct AreaMap {
    given: Triangulation,
    /// One a face slot of `given`; ghosts are not among them.
    bounds: Vec<Option<f64>>,
}

impl AreaMap {
    /// The map of a triangulation without marks.
    pub(crate) fn new(given: Triangulation, bounds: Vec<Option<f64>>) -> Self {
        Self { given, bounds }
    }

    /// The bound for a triangle with these corners, which came out of a given one near `hint`.
    ///
    /// # Guarantees
    /// Independent of the hint, but where rounding puts the middle outside the domain.
    ///
    /// # Complexity
    /// The given triangles between the hint and the place.
    pub(crate) fn bound_in(&self, [a, b, c]: [Point; 3], hint: FaceId) -> Option<f64> {
        let middle = Triangle::new(a, b, c).centroid();
        let bound = |f: FaceId| self.bounds.get(f.index()).copied().flatten();
        let least = |faces: &mut dyn Iterator<Item = FaceId>| {
            faces.filter(|&f| self.given.is_real(f)).filter_map(bound).min_by(f64::total_cmp)
        };
        match self.given.walk_within(hint, middle) {
            Walk::Blocked(h) => bound(h.face()),
            Walk::Arrived(Locus::Face(f)) => bound(f),
            Walk::Arrived(Locus::Edge(h)) => least(&mut [h.face(), self.given.twin(h).face()].into_iter()),
            Walk::Arrived(Locus::Vertex(v)) => least(&mut self.given.faces_around(v)),
            Walk::Arrived(_) => bound(hint),
        }
    }
}
