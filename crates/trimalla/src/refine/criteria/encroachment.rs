//! The regions that protect subsegments.
//!
//! ```text
//!          _.-----._                      _____
//!        /    disk   \                 .-' lens '-.
//!       a ═══════════ b               a ═══════════ b        p encroaches where it sees a–b at
//!        \           /                 '-._____.-'           90° or more      180° − 2α or more
//! ```

use crate::geometry::{CircleSide, Point, in_diametral_disk};
use crate::refine::measure::ruler::Ruler;
use crate::refine::recipe::Encroachment;
use crate::refine::recipe::options::Criteria;

/// The points that see a subsegment at a given angle or more, at least 90 degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::refine) struct Region {
    /// Squared cosine of that angle; 0 for the disk.
    cos_sq: f64,
}

impl Region {
    /// The region of a recipe at an angle bound.
    ///
    /// # Source
    /// The lens: `[Chew93]`, `[Shewchuk02]`; the disk: `[Ruppert95]`. From 45 degrees on the lens is the disk.
    pub(in crate::refine) fn new(kind: Encroachment, criteria: &Criteria) -> Self {
        let doubled = 2.0 * criteria.effective_min_angle().radians();
        let cos = crate::geometry::math::cos(doubled);
        let cos_sq = match kind {
            Encroachment::Lens if cos > 0.0 => cos * cos,
            _ => 0.0,
        };
        Self { cos_sq }
    }

    /// Whether free vertices in the diametral disk are deleted before a split: if the region is smaller than the disk.
    pub(in crate::refine) fn is_lens(self) -> bool {
        self.cos_sq > 0.0
    }

    /// Whether `p` encroaches upon the subsegment from `a` to `b`.
    pub(in crate::refine) fn holds(self, a: Point, b: Point, p: Point, ruler: Ruler) -> bool {
        if self.cos_sq == 0.0 {
            return in_diametral_disk(a, b, p) == CircleSide::Inside;
        }
        let (u, v) = (ruler.vector(p, a), ruler.vector(p, b));
        let dot = u.dot(v);
        // Branch-free `&`: which of the two fails is unpredictable.
        (dot < 0.0) & (dot * dot >= self.cos_sq * u.length_sq() * v.length_sq())
    }
}
