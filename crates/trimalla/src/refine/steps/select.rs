//! Step 2 as a trait.

use super::view::View;
use crate::geometry::Point;
use crate::half_edge::FaceId;

/// The traits of a step 2, which are constant during a refinement.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SelectTraits {
    /// Of triangles with equal priority the oldest in the queue is treated first; else the newest.
    pub takes_oldest: bool,
    /// A large drawing may be treated in patches of some thousand triangles, one after the other; the order holds
    /// inside each patch.
    pub works_by_patches: bool,
    /// Only triangles that the caller picks are treated.
    pub is_manual: bool,
}

/// Step 2: the order of bad triangles.
pub trait SelectStep {
    /// The priority of a bad triangle, at least 0: the triangle with the lowest value is treated first, quantised to a
    /// 128th of an octave; [`takes_oldest`](SelectTraits::takes_oldest) decides ties.
    ///
    /// `sequence` is the number of triangles that were queued before this one.
    fn priority(&self, view: View<'_>, face: FaceId, sequence: u64) -> f64;

    /// The same value as [`priority`](Self::priority), for a caller that has the corners of the triangle, in some
    /// order.
    fn priority_of_corners(&self, view: View<'_>, face: FaceId, corners: [Point; 3], sequence: u64) -> f64 {
        let _ = corners;
        self.priority(view, face, sequence)
    }

    /// The traits of the step.
    fn traits(&self) -> SelectTraits {
        SelectTraits::default()
    }
}
