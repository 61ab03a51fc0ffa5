//! A bound for each triangle of a given mesh.
//!
//! Splits leave a triangle inside the one it came from, but flips do not. So the given triangles are kept as they were,
//! and a triangle has the bound of the one in which its middle lies. The region of a face names some given triangle
//! near by (splits hand it down, flips keep it), from which the way there is short.

use super::{AreaBound, SizeField, TriangleInRegion};
use crate::half_edge::FaceId;
use crate::locate::{Locus, Walk};
use crate::triangulation::Triangulation;

/// The bound of the given triangle in which the middle of a triangle lies.
#[derive(Clone, Debug)]
pub struct ByTriangle {
    given: Triangulation,
    bounds: Vec<AreaBound>,
    least: AreaBound,
}

impl ByTriangle {
    /// Bounds for what lies in each of some triangles, by face, as [`from_mesh`](crate::domain::from_mesh()) gives
    /// them; there is none for a face without an entry.
    ///
    /// A triangle is bounded if the number of its region is that of a face here, counted from 1, and the way from that
    /// face to the middle of the triangle leads through these triangles.
    #[must_use]
    pub fn new(given: Triangulation, max_areas: &[Option<f64>]) -> Self {
        let bounds: Vec<AreaBound> = max_areas.iter().map(|&area| AreaBound::of_max_area(area)).collect();
        let least = bounds.iter().copied().fold(AreaBound::NONE, AreaBound::least);
        Self { given, bounds, least }
    }

    fn bound_in(&self, f: FaceId) -> AreaBound {
        self.bounds.get(f.index()).copied().unwrap_or(AreaBound::NONE)
    }

    /// The least bound of those faces that are triangles.
    fn least_in(&self, faces: impl Iterator<Item = FaceId>) -> AreaBound {
        faces.filter(|&f| self.given.is_real(f)).map(|f| self.bound_in(f)).fold(AreaBound::NONE, AreaBound::least)
    }

    /// The given triangle that the region of a triangle names.
    fn nearby(&self, at: &TriangleInRegion) -> Option<FaceId> {
        let f = FaceId(at.region_index()?);
        (f.index() < self.given.face_slots() && self.given.is_real(f)).then_some(f)
    }
}

impl SizeField for ByTriangle {
    /// The bound on a triangle. It does not depend on the given triangle that its region names, but where rounding puts
    /// the middle outside the given mesh.
    ///
    /// # Complexity
    /// The given triangles between that one and the middle.
    fn bound(&self, at: &TriangleInRegion) -> AreaBound {
        let Some(nearby) = self.nearby(at) else { return AreaBound::NONE };
        match self.given.walk_within(nearby, at.triangle.centroid()) {
            Walk::Blocked(h) => self.bound_in(h.face()),
            Walk::Arrived(Locus::Face(f)) => self.bound_in(f),
            Walk::Arrived(Locus::Edge(h)) => self.least_in([h.face(), self.given.twin(h).face()].into_iter()),
            Walk::Arrived(Locus::Vertex(v)) => self.least_in(self.given.faces_around(v)),
            Walk::Arrived(_) => self.bound_in(nearby),
        }
    }

    fn sure_bound(&self) -> AreaBound {
        self.least
    }

    /// The bound on this triangle: what lies inside a given triangle, or inside one that came out of it, is bounded as
    /// the given one is.
    fn expected_within(&self, at: &TriangleInRegion) -> AreaBound {
        self.bound(at)
    }
}
