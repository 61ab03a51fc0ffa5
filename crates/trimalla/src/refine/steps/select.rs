//! Step 2 as a trait.

use super::view::View;
use crate::geometry::Point;
use crate::half_edge::FaceId;

/// What a step 2 says of itself, once for a whole refinement.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SelectTraits {
    /// Of triangles with equal priority the one that joined the queue first is treated first; else the one that joined
    /// it last.
    pub takes_oldest: bool,
    /// A large drawing may be treated in patches of some thousand triangles, one after the other, with the order kept
    /// inside each of them.
    pub works_by_patches: bool,
    /// Only triangles that the caller picks are treated.
    pub is_manual: bool,
}

/// Step 2: the order of bad triangles.
pub trait SelectStep {
    /// The priority of a bad triangle, not negative: the triangle with the lowest value is treated first, to within a
    /// 128th; [`takes_oldest`](SelectTraits::takes_oldest) decides ties.
    ///
    /// `joined` counts the triangles that joined the queue before this one.
    fn priority(&self, view: View<'_>, face: FaceId, sequence: u64) -> f64;

    /// The number that [`priority`](Self::priority) gives, where the corners of the triangle are known, in some order.
    fn priority_of_corners(&self, view: View<'_>, face: FaceId, corners: [Point; 3], sequence: u64) -> f64 {
        let _ = corners;
        self.priority(view, face, sequence)
    }

    /// What the step says of itself.
    fn traits(&self) -> SelectTraits {
        SelectTraits::default()
    }
}
