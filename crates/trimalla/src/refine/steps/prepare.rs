//! Step 1 as a trait.

use super::step_edit::StepEdit;
use super::view::View;
use crate::half_edge::HalfEdgeId;

/// Step 1: which subsegments need a split, and what else is done before the first point is inserted.
pub trait PrepareStep {
    /// Changes the triangulation before the loop begins; returns whether the loop is to call it again.
    ///
    /// The loop calls it again if it has also changed something. A long task is done in slices: between two calls the
    /// caller sees the progress, and may cancel.
    fn begin(&self, edit: &mut dyn StepEdit) -> bool {
        let _ = edit;
        false
    }

    /// Whether subsegments are tested before every insertion, not once before the first.
    fn is_lasting(&self) -> bool {
        true
    }

    /// Whether subsegment `h` is to be split before (and while) points are inserted.
    ///
    /// A queued subsegment is tested again only if one of its two triangles has changed when its turn comes.
    fn needs_split(&self, view: View<'_>, h: HalfEdgeId) -> bool;
}
