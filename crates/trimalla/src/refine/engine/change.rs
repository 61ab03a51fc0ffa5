//! Changing the options or the test of a refinement under way.

use std::sync::Arc;

use super::Refinement;
use super::parts::Improvement;
use super::start::{Setup, Start};
use crate::constrained::ConstrainedTriangulation;
use crate::refine::recipe::options::{OptionError, RefineOptions};
use crate::refine::watch::report::Report;
use crate::size::TriangleInRegion;
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
            setup: Setup { test: self.problem.test.user_test(), ..Setup::default() },
        };
        let mut changed = Self::new(start, options)?;
        changed.ledger.stopwatch = self.ledger.stopwatch;
        changed.ledger.report = Report { recipe: options.recipe, ..std::mem::take(&mut self.ledger.report) };
        changed.ledger.insertions = self.ledger.insertions;
        changed.ledger.steps_observed = self.ledger.steps_observed;
        changed.history = self.history.take();
        *self = changed;
        Ok(())
    }

    /// Continues with a test of the caller's own, in place of the one before, if there was one: all triangles are
    /// tested by it. [`Start::with_test`] says what a test must keep; [`back`](Self::back) restores the old one.
    ///
    /// # Complexity
    /// Linear.
    pub fn change_test(&mut self, test: impl Fn(TriangleInRegion) -> bool + Send + Sync + 'static) {
        self.record_change();
        self.problem.test = self.problem.test.clone().with_user_test(Some(Arc::new(test)));
        self.ledger.improvement = Improvement::UNWATCHED;
        if self.is_open() && !self.is_filling() {
            self.test_everything();
        }
    }
}
