//! Step 3 as a trait.

use super::proposal::Places;
use super::view::View;
use crate::half_edge::FaceId;

/// What a step 3 says of itself, once for a whole refinement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PointTraits {
    /// The step follows longest-edge propagation paths: the report counts their lengths.
    pub follows_path: bool,
    /// A free point that encroaches upon a subsegment is not inserted, and the subsegment is split instead.
    pub minds_encroachment: bool,
    /// Subsegments are split on circles around every end where another segment joins, not only where the angle there is
    /// below 60 degrees.
    pub shells_at_every_joint: bool,
}

impl Default for PointTraits {
    fn default() -> Self {
        Self { follows_path: false, minds_encroachment: true, shells_at_every_joint: true }
    }
}

impl PointTraits {
    /// The traits of a step that puts points on longest-edge propagation paths, whatever segments are near.
    pub(crate) const ON_PATH: Self =
        Self { follows_path: true, minds_encroachment: false, shells_at_every_joint: false };
}

/// Step 3: where new vertices go.
pub trait PointStep {
    /// Adds places for a new vertex that helps `face`, the best first. The loop tries the next place where the one
    /// before cannot be had for rounding or the length floor, or is not [true](super::Proposal::is_true).
    ///
    /// [`Places::push_together`] adds several points that go in together.
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places);

    /// What the step says of itself.
    fn traits(&self) -> PointTraits {
        PointTraits::default()
    }
}
