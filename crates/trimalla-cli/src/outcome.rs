//! The outcome of `mesh` and `refine`, before it is written and reported.

use trimalla::Meshed;

/// The outcome of a refinement, its warnings in the numbers of the input.
pub(crate) struct Outcome {
    pub(crate) meshed: Meshed,
    /// Warnings about the input.
    pub(crate) warnings: Vec<String>,
    /// Warnings before the work.
    pub(crate) foreseen: Vec<String>,
    /// The angle floor in words, if there are small input angles.
    pub(crate) floor: Option<String>,
}
