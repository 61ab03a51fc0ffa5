//! The stages before the loop, in slices; a run can be cancelled between two slices.
//!
//! ```text
//!   legalise a given mesh ─> release segments inside ─> split them until they are edges ─> release them ─> test all faces
//!          (as given)           (conforming, or not               (conforming)                (not
//!                                    locked)                                                 locked)
//! ```
//!
//! Where a recipe needs none of these stages, as the default does not, [`Refinement::new`] tests all triangles at once,
//! and [`Refinement::unprepared`] leaves that to a slice. Every slice is a step.

use super::Refinement;
use super::parts::Opening;
use crate::constrained::Recovery;
use crate::refine::criteria::reason::StopReason;
use crate::refine::recipe::Initial;
use crate::refine::watch::event::StepOutcome;
use crate::refine::watch::observer::Observer;
use crate::refine::watch::stopwatch::Part;

/// Number of edges tested in one slice.
const SLICE: usize = 1 << 14;

impl Refinement {
    /// Whether the stages before the loop are done.
    pub(super) fn is_open(&self) -> bool {
        self.segments.opening == Opening::Done
    }

    /// Tests all triangles if that is the only stage left.
    pub(super) fn begin_opening(&mut self) {
        self.ledger.stopwatch.enter(Part::Rest);
        if self.segments.opening == Opening::Test {
            self.opening_step();
        }
        self.ledger.stopwatch.enter(Part::Outside);
    }

    /// Skips the stages that the recipe does not need.
    pub(super) fn skip_stages(&mut self) {
        let recipe = self.problem.options.recipe;
        let is_conforming = recipe.initial == Initial::Conforming;
        if self.segments.opening == Opening::Given
            && !(self.strategy.traits.insert.keeps_delaunay && recipe.initial != Initial::Given)
        {
            self.segments.opening = Opening::Release;
        }
        if self.segments.opening == Opening::Release
            && !is_conforming
            && self.strategy.steps.recover.traits().locks_segments
        {
            self.segments.opening = Opening::Test;
        }
        if self.segments.opening == Opening::Conform && !is_conforming {
            self.segments.opening = Opening::Test;
        }
        if self.segments.opening == Opening::ReleaseAgain && self.strategy.steps.recover.traits().locks_segments {
            self.segments.opening = Opening::Test;
        }
    }

    /// Runs the stages before the loop. Calls the observer before each slice, which may cancel; returns whether all
    /// stages are done.
    ///
    /// [`run`](Self::run) does so, too. Until then, triangles of a mesh that is not Delaunay may be flipped away.
    pub fn prepare(&mut self, observer: &mut dyn Observer) -> bool {
        self.ledger.report.stop = StopReason::default();
        while !self.is_open() || self.segments.recovery.is_some() {
            if !observer.progress(self.progress()) {
                self.ledger.report.stop = StopReason::Cancelled;
                return false;
            }
            self.recorded(Self::advance);
        }
        true
    }

    /// Runs all slices that are left: for a refinement that is finished before its first step.
    pub(super) fn finish_opening(&mut self) {
        while !self.is_open() || self.segments.recovery.is_some() {
            self.scratch.log.clear();
            if !self.continue_recovery() {
                self.opening_step();
            }
        }
    }

    /// Runs one slice.
    pub(super) fn opening_step(&mut self) -> StepOutcome {
        self.record_segments();
        match self.segments.opening {
            Opening::Given => {
                self.segments.illegal = self.cdt.illegal_edges();
                self.segments.opening = Opening::Legalising;
            }
            Opening::Release | Opening::ReleaseAgain => {
                (self.segments.released, self.segments.illegal) = self.edit().release_inner_segments();
                let is_first = self.segments.opening == Opening::Release;
                self.segments.opening = if is_first { Opening::Releasing } else { Opening::ReleasingAgain };
            }
            _ => {}
        }
        match self.segments.opening {
            Opening::Legalising => self.ledger.report.edges_flipped += self.flip_slice(Opening::Release),
            Opening::Releasing => {
                self.flip_slice(Opening::Conform);
            }
            Opening::ReleasingAgain => {
                self.flip_slice(Opening::Test);
            }
            Opening::Conform => {
                let released = std::mem::take(&mut self.segments.released);
                self.begin_recovery(Recovery::of(released));
                self.segments.opening = Opening::ReleaseAgain;
            }
            Opening::Prepare => self.prepare_by_step(),
            _ => {
                self.begin();
                self.prepare_by_step();
            }
        }
        self.skip_stages();
        StepOutcome::Prepared
    }

    /// Lets step 1 change the triangulation; the loop begins when it needs no further call.
    fn prepare_by_step(&mut self) {
        self.segments.opening = if self.begin_by_step() { Opening::Prepare } else { Opening::Done };
    }

    /// Flips one slice of the illegal edges, and goes on to the next stage when none is left; returns the number of
    /// flips.
    fn flip_slice(&mut self, next: Opening) -> u64 {
        let flips = self
            .cdt
            .edit(&mut self.scratch.work, &mut self.scratch.log)
            .legalise_some(&mut self.segments.illegal, SLICE);
        self.segments.opening = if self.segments.illegal.is_done() { next } else { self.segments.opening };
        flips
    }
}
