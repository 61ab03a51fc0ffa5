//! What a refinement starts from, and going on under other options.

use super::Refinement;
use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, Workspace};
use crate::refine::options::{OptionError, RefineOptions};
use crate::refine::report::Report;
use crate::triangulation::Triangulation;

/// What a refinement starts from: a constrained Delaunay triangulation of a domain
/// ([`domain::build`](crate::domain::build)), or a mesh that was taken up
/// ([`domain::from_mesh`](crate::domain::from_mesh())), some of whose edges may fail the circle test.
#[derive(Clone, Debug)]
pub struct Start {
    pub(super) cdt: ConstrainedTriangulation,
    pub(super) work: Workspace,
    /// Whether it is known that every edge passes the circle test.
    pub(super) is_delaunay: bool,
}

impl Start {
    /// The triangulation.
    #[must_use]
    pub fn triangulation(&self) -> &ConstrainedTriangulation {
        &self.cdt
    }
}

impl From<ConstrainedDelaunay> for Start {
    fn from(cdt: ConstrainedDelaunay) -> Self {
        let (cdt, work) = cdt.into_parts();
        Self { cdt, work, is_delaunay: true }
    }
}

impl From<ConstrainedTriangulation> for Start {
    fn from(cdt: ConstrainedTriangulation) -> Self {
        Self { cdt, work: Workspace::default(), is_delaunay: false }
    }
}

impl Refinement {
    /// Goes on under other options, with the steps of their recipe: all triangles are held against the new criteria. A
    /// test of the caller's own stays; what was picked does not. [`back`](Self::back) leads to the old options, too.
    ///
    /// # Errors
    /// [`OptionError`]; nothing has changed then.
    ///
    /// # Complexity
    /// Linear.
    pub fn change_options(&mut self, options: RefineOptions) -> Result<(), OptionError> {
        options.validate()?;
        self.record_change();
        self.claim_segments();
        let nothing = ConstrainedTriangulation::new(Triangulation::default());
        let start = Start {
            cdt: std::mem::replace(&mut self.cdt, nothing),
            work: std::mem::take(&mut self.scratch.work),
            is_delaunay: self.strategy.traits.insert.keeps_delaunay,
        };
        let mut changed = Self::timed(start, options, None)?;
        changed.ledger.stopwatch = self.ledger.stopwatch;
        changed.ledger.report = Report { recipe: options.recipe, ..std::mem::take(&mut self.ledger.report) };
        changed.ledger.insertions = self.ledger.insertions;
        changed.ledger.steps_told = self.ledger.steps_told;
        changed.history = self.history.take();
        *self = match self.problem.test.asked() {
            Some(asked) => changed.with_user_test(asked),
            None => changed,
        };
        Ok(())
    }
}
