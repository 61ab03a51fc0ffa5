//! Step 3 as a trait.

use super::proposal::Places;
use super::view::View;
use crate::half_edge::FaceId;

/// The traits of a step 3, which are constant during a refinement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PointTraits {
    /// The step follows longest-edge propagation paths: the report counts their lengths.
    pub follows_path: bool,
    /// A free point that encroaches upon a subsegment is not inserted, and the subsegment is split instead.
    pub minds_encroachment: bool,
    /// Subsegments are split on circles around every end where another segment meets them, not only if the angle there
    /// is below 60 degrees.
    pub shells_at_every_joint: bool,
}

impl Default for PointTraits {
    fn default() -> Self {
        Self { follows_path: false, minds_encroachment: true, shells_at_every_joint: true }
    }
}

impl PointTraits {
    /// The traits of a step that places points on longest-edge propagation paths, whatever segments are near.
    pub(crate) const ON_PATH: Self =
        Self { follows_path: true, minds_encroachment: false, shells_at_every_joint: false };
}

/// Step 3: where new vertices are placed.
pub trait PointStep {
    /// Adds places for a new vertex that improves `face`, the best first. The loop tries the next place if one is
    /// refused because of rounding or the length floor, or is not [true](super::Proposal::is_true).
    ///
    /// [`Places::push_together`] adds several points that are inserted together.
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places);

    /// The traits of the step.
    fn traits(&self) -> PointTraits {
        PointTraits::default()
    }
}
