//! The refinement loop.

use super::options::{OptionError, RefineOptions};
use super::report::{Observer, Report};
use crate::constrained::ConstrainedDelaunay;

/// A refinement under way.
#[derive(Clone, Debug)]
pub struct Refinement {
    cdt: ConstrainedDelaunay,
    options: RefineOptions,
}

impl Refinement {
    /// Prepares the refinement of a carved triangulation.
    ///
    /// # Errors
    /// [`OptionError`].
    pub fn new(cdt: ConstrainedDelaunay, options: RefineOptions) -> Result<Self, OptionError> {
        options.validate()?;
        Ok(Self { cdt, options })
    }

    /// Runs to the end.
    pub fn run(&mut self, _observer: &mut dyn Observer) {}

    /// The triangulation and what came of it.
    #[must_use]
    pub fn finish(self) -> (ConstrainedDelaunay, Report) {
        let report = Report { recipe: self.options.recipe, ..Report::default() };
        (self.cdt, report)
    }
}
