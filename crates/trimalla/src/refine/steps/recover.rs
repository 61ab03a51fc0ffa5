//! Step 5 as a trait.

use super::step_edit::StepEdit;

/// The traits of a step 5, which are constant during a refinement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RecoverTraits {
    /// Segments inside the domain are locked while points are inserted: no flip and no cavity crosses them.
    pub locks_segments: bool,
    /// No segment is missing at the end of a refinement.
    pub restores_segments: bool,
}

/// Step 5: what becomes of segments inside the domain.
///
/// The boundary of the domain, and segments that separate two regions, are always locked.
pub trait RecoverStep {
    /// The traits of the step.
    fn traits(&self) -> RecoverTraits;

    /// Changes the triangulation when no bad triangle is left, or when the refinement ends.
    ///
    /// If it has changed something, the loop continues until no bad triangle is left, and calls it again. This ends,
    /// since every change uses something limited: insertions are bounded, and so are vertices and segments. The report
    /// names the segments that are missing at the end.
    fn recover(&self, edit: &mut dyn StepEdit) {
        let _ = edit;
    }
}
