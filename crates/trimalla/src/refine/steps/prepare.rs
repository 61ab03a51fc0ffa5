//! Step 1 as a trait.

use super::step_edit::StepEdit;
use super::view::View;
use crate::half_edge::HalfEdgeId;

/// Step 1: which subsegments need a split, and what else is done before the first point goes in.
pub trait PrepareStep {
    /// Changes the triangulation before the loop begins; says whether it is to be called again.
    ///
    /// It is called as long as it says so and has changed something. Work that takes long is done in slices: between
    /// two calls the caller sees the progress, and may cancel.
    fn begin(&self, edit: &mut dyn StepEdit) -> bool {
        let _ = edit;
        false
    }

    /// Whether subsegments are tested before every insertion, not once before the first.
    fn is_lasting(&self) -> bool {
        true
    }

    /// Whether subsegment `h` is to be split before (and while) points go in.
    ///
    /// A subsegment that is queued is tested again only if one of the two triangles beside it has changed by its turn.
    fn needs_split(&self, view: View<'_>, h: HalfEdgeId) -> bool;
}
