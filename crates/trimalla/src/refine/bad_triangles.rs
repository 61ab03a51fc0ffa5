//! Bad triangles: the test, and the queue they wait in.

use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::sync::Arc;

use super::options::Criteria;
use crate::constrained::{ConstrainedDelaunay, RegionRule};
use crate::geometry::{Point, Triangle, triangle_angles_at_least};
use crate::mesh::{FaceId, VertexId};
use crate::quality::aspect_ratio;

/// What is wrong with a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Badness {
    /// An angle is below the bound.
    Angle,
    /// The aspect ratio is above the bound.
    AspectRatio,
    /// The area is above the bound.
    Area,
    /// The caller's own test refuses it.
    Asked,
}

impl Badness {
    /// Whether splitting the triangle into smaller ones of its shape is no help.
    pub(super) fn is_of_shape(self) -> bool {
        matches!(self, Self::Angle | Self::AspectRatio)
    }
}

/// A test of the caller's own: whether a triangle, counter-clockwise, with the attribute of its region (0 without), must
/// be refined.
pub type UserTest = dyn Fn(Triangle, f64) -> bool + Send + Sync;

/// The criteria, ready to be tested.
#[derive(Clone)]
pub(super) struct Test {
    /// Squared cosine of the angle bound; `None` where no bound is asked for.
    cos_sq: Option<f64>,
    /// Twice the area bound.
    doubled_area: f64,
    max_aspect_ratio: f64,
    asked: Option<Arc<UserTest>>,
}

impl Test {
    pub(super) fn new(criteria: &Criteria) -> Self {
        let bounded = criteria.min_angle.radians() > 0.0;
        Self {
            cos_sq: bounded.then(|| criteria.min_angle.cos_sq()),
            doubled_area: criteria.max_area.map_or(f64::INFINITY, |a| 2.0 * a),
            max_aspect_ratio: criteria.max_aspect_ratio.unwrap_or(f64::INFINITY),
            asked: None,
        }
    }

    /// The same with a test of the caller's own.
    pub(super) fn with_asked(self, asked: Arc<UserTest>) -> Self {
        Self { asked: Some(asked), ..self }
    }

    /// What is wrong with a triangle of a region; the size first. Angles are certified exactly.
    #[inline]
    pub(super) fn badness(&self, [a, b, c]: [Point; 3], region: Option<RegionRule>) -> Option<Badness> {
        let in_region = region.and_then(|r| r.max_area).map_or(f64::INFINITY, |area| 2.0 * area);
        let doubled_area = self.doubled_area.min(in_region);
        if doubled_area < f64::INFINITY && (b - a).cross(c - a) > doubled_area {
            return Some(Badness::Area);
        }
        if self.asked.as_ref().is_some_and(|test| test(Triangle::new(a, b, c), region.map_or(0.0, |r| r.attribute))) {
            return Some(Badness::Asked);
        }
        match self.cos_sq {
            Some(cos_sq) if !triangle_angles_at_least(a, b, c, cos_sq) => Some(Badness::Angle),
            _ => self.aspect_badness([a, b, c]),
        }
    }

    fn aspect_badness(&self, [a, b, c]: [Point; 3]) -> Option<Badness> {
        let bounded = self.max_aspect_ratio < f64::INFINITY;
        (bounded && aspect_ratio(&Triangle::new(a, b, c)) > self.max_aspect_ratio).then_some(Badness::AspectRatio)
    }
}

/// A triangle in the queue, as it was when it joined.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Waiting {
    patience: f64,
    /// Sorted: the order of equally patient triangles.
    vertices: [VertexId; 3],
    face: FaceId,
    /// The look that put it here; only the newest look at a slot counts.
    look: u32,
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
///
/// Each bad triangle that was looked at waits exactly once: what waited in its slot before is void, so that it does not
/// matter whether a triangle that went and came again got its old slot back.
///
/// Patience is cut into steps of an eighth of an octave, each with a heap of its own: the order is that of one
/// heap, but the work goes on in a small one, near in memory.
#[derive(Clone, Debug, Default)]
pub(super) struct Queue {
    steps: Vec<BinaryHeap<Waiting>>,
    /// No step below this one holds anything.
    lowest: usize,
    len: usize,
    /// The newest look at each slot; 0 where there was nothing bad.
    looks: Vec<u32>,
    last_look: u32,
}

impl Queue {
    /// Mantissa bits that do not choose the step.
    const SHIFT: u32 = 49;

    /// Adds a triangle, whose patience is not negative.
    pub(super) fn push(&mut self, cdt: &ConstrainedDelaunay, face: FaceId, patience: f64) {
        // Positive numbers are ordered as their bits.
        let patience = patience.max(0.0);
        let step = usize::try_from(patience.to_bits() >> Self::SHIFT).unwrap_or(usize::MAX);
        if step >= self.steps.len() {
            self.steps.resize_with(step + 1, BinaryHeap::new);
        }
        if face.index() >= self.looks.len() {
            self.looks.resize(cdt.face_slots(), 0);
        }
        self.last_look = self.last_look.wrapping_add(1).max(1);
        self.looks[face.index()] = self.last_look;
        let vertices = sorted(cdt.face_vertices(face));
        self.steps[step].push(Waiting { patience, vertices, face, look: self.last_look });
        self.lowest = if self.len == 0 { step } else { self.lowest.min(step) };
        self.len += 1;
    }

    /// Notes that there is nothing bad in a slot now.
    pub(super) fn pass(&mut self, face: FaceId) {
        if let Some(look) = self.looks.get_mut(face.index()) {
            *look = 0;
        }
    }

    /// The least patient triangle that is still there.
    ///
    /// # Complexity
    /// Logarithmic, amortised over the triangles that are gone.
    pub(super) fn pop(&mut self, cdt: &ConstrainedDelaunay) -> Option<FaceId> {
        while self.len > 0 {
            let Some(waiting) = self.steps.get_mut(self.lowest)?.pop() else {
                self.lowest += 1;
                continue;
            };
            self.len -= 1;
            let newest = self.looks.get(waiting.face.index()) == Some(&waiting.look);
            if newest && cdt.is_real(waiting.face) && sorted(cdt.face_vertices(waiting.face)) == waiting.vertices {
                return Some(waiting.face);
            }
        }
        None
    }

    /// How many wait, those that are gone included.
    pub(super) fn len(&self) -> usize {
        self.len
    }
}

/// Three ids in order: the name of a triangle.
pub(super) fn sorted(mut v: [VertexId; 3]) -> [VertexId; 3] {
    v.sort_unstable();
    v
}
