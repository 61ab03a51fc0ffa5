//! Changing the options of a refinement under way.

use super::Refinement;
use super::start::Start;
use crate::constrained::ConstrainedTriangulation;
use crate::refine::recipe::options::{OptionError, RefineOptions};
use crate::refine::watch::report::Report;
use crate::triangulation::Triangulation;

impl Refinement {
    /// Continues under other options, with the steps of their recipe: all triangles are tested by the new criteria.
    /// Size fields and a test of the caller's own stay; picked triangles are dropped. [`back`](Self::back) restores the
    /// old options, too.
    ///
    /// # Errors
    /// [`OptionError`]; nothing has changed then.
    ///
    /// # Complexity
    /// Linear.
    pub fn change_options(&mut self, options: RefineOptions) -> Result<(), OptionError> {
        options.validate()?;
        self.record_change();
        self.finish_recovery();
        let nothing = ConstrainedTriangulation::new(Triangulation::default());
        let start = Start {
            cdt: std::mem::replace(&mut self.cdt, nothing),
            work: std::mem::take(&mut self.scratch.work),
            is_delaunay: self.strategy.traits.insert.keeps_delaunay,
            fields: self.problem.test.size().fields().to_vec(),
        };
        let mut changed = Self::timed(start, options, None)?;
        changed.ledger.stopwatch = self.ledger.stopwatch;
        changed.ledger.report = Report { recipe: options.recipe, ..std::mem::take(&mut self.ledger.report) };
        changed.ledger.insertions = self.ledger.insertions;
        changed.ledger.steps_observed = self.ledger.steps_observed;
        changed.history = self.history.take();
        *self = match self.problem.test.user_test() {
            Some(test) => changed.with_user_test(test),
            None => changed,
        };
        Ok(())
    }
}
