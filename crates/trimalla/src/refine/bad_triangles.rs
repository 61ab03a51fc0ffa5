//! Bad triangles: the test, and the queue they wait in.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::options::Criteria;
use crate::constrained::{ConstrainedDelaunay, RegionRule};
use crate::geometry::{Point, triangle_angles_at_least};
use crate::mesh::{FaceId, VertexId};

/// What is wrong with a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Badness {
    /// An angle is below the bound.
    Angle,
    /// The area is above the bound.
    Area,
}

/// The criteria, ready to be tested.
#[derive(Clone, Copy, Debug)]
pub(super) struct Test {
    /// Squared cosine of the angle bound; `None` where no bound is asked for.
    cos_sq: Option<f64>,
    /// Twice the area bound.
    doubled_area: f64,
}

impl Test {
    pub(super) fn new(criteria: &Criteria) -> Self {
        let bounded = criteria.min_angle.radians() > 0.0;
        Self {
            cos_sq: bounded.then(|| criteria.min_angle.cos_sq()),
            doubled_area: criteria.max_area.map_or(f64::INFINITY, |a| 2.0 * a),
        }
    }

    /// What is wrong with a triangle of a region; the area first. Angles are certified exactly.
    #[inline]
    pub(super) fn badness(&self, [a, b, c]: [Point; 3], region: Option<RegionRule>) -> Option<Badness> {
        let in_region = region.and_then(|r| r.max_area).map_or(f64::INFINITY, |area| 2.0 * area);
        let doubled_area = self.doubled_area.min(in_region);
        if doubled_area < f64::INFINITY && (b - a).cross(c - a) > doubled_area {
            return Some(Badness::Area);
        }
        match self.cos_sq {
            Some(cos_sq) if !triangle_angles_at_least(a, b, c, cos_sq) => Some(Badness::Angle),
            _ => None,
        }
    }
}

/// A triangle in the queue, as it was when it joined.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Waiting {
    patience: f64,
    /// Sorted: the order of equally patient triangles, and what tells whether the slot still holds this one.
    vertices: [VertexId; 3],
    face: FaceId,
}

impl Eq for Waiting {}

impl Ord for Waiting {
    /// A heap gives its greatest first: the least patient, then the lowest vertices.
    fn cmp(&self, other: &Self) -> Ordering {
        other.patience.total_cmp(&self.patience).then_with(|| other.vertices.cmp(&self.vertices))
    }
}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// Bad triangles by patience. Triangles that are gone stay until they come up.
#[derive(Clone, Debug, Default)]
pub(super) struct Queue {
    heap: BinaryHeap<Waiting>,
}

impl Queue {
    /// Adds a triangle.
    pub(super) fn push(&mut self, cdt: &ConstrainedDelaunay, face: FaceId, patience: f64) {
        self.heap.push(Waiting { patience, vertices: sorted(cdt.face_vertices(face)), face });
    }

    /// The least patient triangle that is still there.
    ///
    /// # Complexity
    /// Logarithmic, amortised over the triangles that are gone.
    pub(super) fn pop(&mut self, cdt: &ConstrainedDelaunay) -> Option<FaceId> {
        while let Some(waiting) = self.heap.pop() {
            if cdt.is_real(waiting.face) && sorted(cdt.face_vertices(waiting.face)) == waiting.vertices {
                return Some(waiting.face);
            }
        }
        None
    }

    /// How many wait, those that are gone included.
    pub(super) fn len(&self) -> usize {
        self.heap.len()
    }
}

/// Three ids in order: the name of a triangle.
pub(super) fn sorted(mut v: [VertexId; 3]) -> [VertexId; 3] {
    v.sort_unstable();
    v
}
