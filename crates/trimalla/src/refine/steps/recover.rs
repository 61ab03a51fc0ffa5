//! Step 5 as a trait.

use super::step_edit::StepEdit;

/// What a step 5 says of itself, once for a whole refinement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RecoverTraits {
    /// Segments inside are locked while points go in: no flip and no cavity crosses them.
    pub locks_segments: bool,
    /// No segment is missing when a refinement has finished.
    pub restores_segments: bool,
}

/// Step 5: what becomes of segments inside the domain.
///
/// The boundary of the domain, and segments that part two regions, are always locked.
pub trait RecoverStep {
    /// What the step says of itself.
    fn traits(&self) -> RecoverTraits;

    /// Changes the triangulation when no triangle is bad any more, or the refinement ends.
    ///
    /// Where it has changed something, the loop goes on until no triangle is bad, and calls it again. It ends because
    /// every change takes from what is limited: insertions are counted, and there are only so many vertices and
    /// segments. Segments that are missing in the end are named in the report.
    fn recover(&self, edit: &mut dyn StepEdit) {
        let _ = edit;
    }
}
