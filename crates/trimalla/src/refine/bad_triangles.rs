//! Bad triangles: the test, and the queue they wait in.

use std::collections::VecDeque;
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
        let bound = if in_region < self.doubled_area { in_region } else { self.doubled_area };
        if bound < f64::INFINITY && (b - a).cross(c - a) > bound {
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

/// A triangle as it was at a look: gone as soon as its slot is looked at again, as it is whenever it changes. So a triangle
/// that goes and comes again is another one, whether it gets its old slot back or not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Claim {
    pub(super) face: FaceId,
    look: u32,
}

/// Bad triangles by patience. Triangles that are gone stay until they come up.
///
/// Patience is cut into steps of a 128th of an octave, each a list of its own: adding and taking cost a constant.
/// Within a step those that came last leave first, which lie near in memory and, measured, makes smaller meshes than the
/// other way round; for an order that asks for it, those that came first.
///
/// Each bad triangle that was looked at waits exactly once: what waited in its slot before is void, so that it does not
/// matter whether a triangle that went and came again got its old slot back.
#[derive(Clone, Debug, Default)]
pub(super) struct Queue {
    steps: Vec<VecDeque<Claim>>,
    /// One bit a step: whether anything waits there.
    occupied: Vec<u64>,
    /// No word of `occupied` below this one has a bit.
    lowest: usize,
    len: usize,
    /// The newest look at each slot; 0 where there was nothing bad.
    looks: Vec<u32>,
    last_look: u32,
}

impl Queue {
    /// Mantissa bits that do not choose the step.
    const SHIFT: u32 = 45;
    /// Exponents below this one, biased, share the first step: patience is measured in units that fit the drawing.
    const LEAST: u64 = (1023 - 220) << 7;

    /// Adds a triangle, whose patience is not negative.
    pub(super) fn push(&mut self, cdt: &ConstrainedDelaunay, face: FaceId, patience: f64) {
        // Positive numbers are ordered as their bits.
        let step = (patience.max(0.0).to_bits() >> Self::SHIFT).saturating_sub(Self::LEAST);
        let step = usize::try_from(step).unwrap_or(usize::MAX);
        if step >= self.steps.len() {
            self.steps.resize_with(step + 1, VecDeque::new);
            self.occupied.resize(step / 64 + 1, 0);
        }
        let claim = self.claim(cdt, face);
        self.steps[step].push_back(claim);
        self.occupied[step / 64] |= 1 << (step % 64);
        self.lowest = self.lowest.min(step / 64);
        self.len += 1;
    }

    /// Looks at a slot: earlier claims to it are void.
    pub(super) fn claim(&mut self, cdt: &ConstrainedDelaunay, face: FaceId) -> Claim {
        if face.index() >= self.looks.len() {
            self.looks.resize(cdt.face_slots(), 0);
        }
        self.last_look = self.last_look.wrapping_add(1).max(1);
        self.looks[face.index()] = self.last_look;
        Claim { face, look: self.last_look }
    }

    /// Whether a triangle is still the one that was claimed.
    pub(super) fn is_valid(&self, cdt: &ConstrainedDelaunay, claim: Claim) -> bool {
        self.looks.get(claim.face.index()) == Some(&claim.look) && cdt.is_real(claim.face)
    }

    /// Notes that there is nothing bad in a slot now.
    pub(super) fn pass(&mut self, face: FaceId) {
        if let Some(look) = self.looks.get_mut(face.index()) {
            *look = 0;
        }
    }

    /// The least patient triangle that is still there; every face that changes is looked at again.
    ///
    /// # Complexity
    /// Constant, amortised over the triangles that are gone.
    pub(super) fn pop(&mut self, cdt: &ConstrainedDelaunay, oldest_first: bool) -> Option<FaceId> {
        while let Some(word) = self.occupied.get(self.lowest) {
            if *word == 0 {
                self.lowest += 1;
                continue;
            }
            let step = self.lowest * 64 + word.trailing_zeros() as usize;
            loop {
                let list = &mut self.steps[step];
                let Some(claim) = (if oldest_first { list.pop_front() } else { list.pop_back() }) else { break };
                self.len -= 1;
                if self.is_valid(cdt, claim) {
                    return Some(claim.face);
                }
            }
            self.occupied[self.lowest] &= !(1 << (step % 64));
        }
        None
    }

    /// How many wait, those that are gone included.
    pub(super) fn len(&self) -> usize {
        self.len
    }
}

/// Three ids in order: the name of a triangle.
#[inline]
pub(super) fn sorted([a, b, c]: [VertexId; 3]) -> [VertexId; 3] {
    let (low, high) = (a.min(b), a.max(b));
    [low.min(c), low.max(high.min(c)), high.max(c)]
}
