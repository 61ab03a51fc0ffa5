//! The refinement loop.

mod change;
mod encroached;
mod events;
mod fill;
mod filling;
mod gaps;
mod history;
mod improvement;
pub(super) mod insertion;
mod leftovers;
mod mirrored_place;
mod opening;
mod overview;
mod parts;
mod records;
pub(super) mod recovery;
mod split_segments;
pub(super) mod start;
mod step_edit;
mod test_faces;
mod treat;

use std::fmt;

use crate::constrained::{ConstrainedTriangulation, Edit};
use crate::delaunay::max_points;
use crate::geometry::BoundingBox;
use crate::half_edge::{FaceId, NoJournal, UndoLog};
use crate::refine::agenda::queue::{Patches, Queue};
use crate::refine::criteria::reason::{Reason, StopReason};
use crate::refine::recipe::options::{OptionError, RefineOptions};
use crate::refine::steps::{Steps, View};
use crate::refine::watch::event::StepOutcome;
use crate::refine::watch::observer::{Beginning, Observer, Overview, Progress};
use crate::refine::watch::stopwatch::{Part, Stopwatch};
use filling::FillStage;
use parts::{Agenda, Ledger, Opening, Picked, Problem, Scratch, SegmentWork, Strategy};
use records::History;
use start::Start;

/// The largest number of retries of triangles for which there was no room.
const MOST_RETRIES: u32 = 64;
/// Number of steps and insertions between two calls of the observer.
const PROGRESS_EVERY: u64 = 128;

/// A refinement under way.
///
/// # Guarantees
/// Input vertices are neither moved nor removed, input segments stay chains of edges, and the triangulation is
/// constrained Delaunay after every step. The same input and options give the same mesh, whatever algorithm built
/// the triangulation.
#[derive(Clone)]
pub struct Refinement {
    cdt: ConstrainedTriangulation,
    problem: Problem,
    strategy: Strategy,
    agenda: Agenda,
    segments: SegmentWork,
    filling: FillStage,
    ledger: Ledger,
    scratch: Scratch,
    /// The records by which steps are taken back, if they are kept.
    history: Option<History<Self>>,
}

impl fmt::Debug for Refinement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Refinement")
            .field("options", &self.problem.options)
            .field("vertices", &self.ledger.vertices)
            .finish_non_exhaustive()
    }
}

impl Refinement {
    /// Prepares the refinement of a triangulation carved by [`domain::build`](crate::domain::build), or taken over by
    /// [`domain::from_mesh`](crate::domain::from_mesh()).
    ///
    /// One that is still closed by its convex hull, as
    /// [`from_delaunay`](crate::constrained::ConstrainedDelaunay::from_delaunay) and
    /// [`new`](crate::constrained::ConstrainedDelaunay::new) make it, is closed by a domain first:
    /// [`carve_hull`](crate::constrained::ConstrainedDelaunay::carve_hull) says what that changes. Its convex hull is
    /// refined then, whatever its segments enclose.
    ///
    /// If step 4 keeps the circle test and the start fails it somewhere, edges are flipped until it holds.
    ///
    /// [`Start`] has what else a refinement may begin with: size fields, steps and a test of the caller's own, a clock.
    ///
    /// # Errors
    /// [`OptionError`].
    pub fn new(start: impl Into<Start>, options: RefineOptions) -> Result<Self, OptionError> {
        let mut refinement = Self::unprepared(start, options)?;
        refinement.begin_opening();
        Ok(refinement)
    }

    /// [`new`](Self::new) for callers that must answer soon: all triangles are tested when the refinement is
    /// [prepared](Self::prepare), run or stepped, in a slice of their own. The mesh is the same.
    ///
    /// # Errors
    /// [`OptionError`].
    pub fn unprepared(start: impl Into<Start>, mut options: RefineOptions) -> Result<Self, OptionError> {
        let Start { mut cdt, mut work, is_delaunay, fields, setup } = start.into();
        options.validate()?;
        if !cdt.edit(&mut work, &mut NoJournal).carve_hull() {
            return Err(OptionError::NoTriangles);
        }
        // The indices of half-edges bound the number of vertices.
        options.limits.max_vertices = options.limits.max_vertices.min(max_points());
        let strategy = match setup.steps {
            Some(steps) => Strategy::of(steps),
            None => Strategy { walks_prove_places: true, ..Strategy::of(Steps::of(&options)) },
        };
        let opening = if is_delaunay { Opening::Release } else { Opening::Given };
        let vertices = cdt.input_points() + cdt.steiner_vertices();
        let problem = Problem::new((&cdt, is_delaunay), fields, options, strategy.traits.insert);
        let mut refinement = Self {
            problem: problem.with_user_test(setup.test),
            strategy,
            agenda: Agenda::default(),
            segments: SegmentWork { opening, ..SegmentWork::default() },
            filling: FillStage::Done,
            ledger: Ledger::new(&options, vertices, Stopwatch::new(setup.clock)),
            scratch: Scratch { work, ..Scratch::default() },
            history: None,
            cdt,
        };
        refinement.skip_stages();
        Ok(refinement)
    }

    /// Starts the lattice stage if the recipe enables it and a triangle is large enough; otherwise queues all bad
    /// triangles and encroached subsegments.
    pub(super) fn begin(&mut self) {
        let bounds = self.problem.bounds;
        let expected = self.ledger.vertices.saturating_add(self.vertices_for_area());
        let queue = self.empty_queue(bounds, expected);
        self.replace_queue(queue);
        self.ledger.improvement = self.initial_improvement();
        self.filling = self.initial_fill_stage(bounds);
        if self.is_filling() {
            drop(self.cdt.take_order_along_curve());
        } else {
            self.test_everything();
        }
    }

    /// Replaces the queue.
    pub(super) fn replace_queue(&mut self, queue: Queue) {
        let before = std::mem::replace(&mut self.agenda.queue, queue);
        if let Some(record) = self.record() {
            record.note_queue(before);
        }
    }

    /// An empty queue for an expected number of vertices: by patches of the drawing's box, if step 2 allows that.
    pub(super) fn empty_queue(&self, bounds: Option<BoundingBox>, vertices: usize) -> Queue {
        if self.strategy.traits.select.works_by_patches {
            Queue::by_patches(Patches::new(bounds, vertices.min(self.problem.options.limits.max_vertices)))
        } else {
            Queue::default()
        }
    }

    /// Whether the area of triangles is bounded anywhere, or may be by a test of the caller.
    pub(super) fn has_area_bound(&self) -> bool {
        self.problem.test.sufficient_bounds().doubled_area < f64::INFINITY
    }

    /// A lower estimate of the vertices that the area bounds need: half as many as triangles.
    fn vertices_for_area(&self) -> usize {
        if !self.has_area_bound() {
            return 0;
        }
        let parts = |f: FaceId| {
            let [a, b, c] = self.cdt.corners_from_newest(f);
            (b - a).cross(c - a) / self.problem.test.expected_bound(&self.cdt, f).doubled()
        };
        // The cast saturates.
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a number of vertices, not negative"
        )]
        let vertices = (self.cdt.real_faces().map(parts).sum::<f64>() / 2.0) as usize;
        vertices
    }

    /// Whether every unconstrained edge passes the circle test between steps: not in a given mesh that is refined as it
    /// is.
    pub(super) fn holds_circle_test(&self) -> bool {
        self.strategy.traits.insert.keeps_delaunay && !self.problem.is_as_given
    }

    /// The triangulation as it is now.
    #[must_use]
    pub fn triangulation(&self) -> &ConstrainedTriangulation {
        &self.cdt
    }

    /// The operations on the triangulation, with the log of the step.
    #[inline(always)]
    pub(super) fn edit(&mut self) -> Edit<'_, UndoLog> {
        self.cdt.edit(&mut self.scratch.work, &mut self.scratch.log)
    }

    /// Runs until nothing is left to do, a limit is met, or the observer cancels.
    ///
    /// # Complexity
    /// Near linear in the vertices of the result.
    pub fn run(&mut self, observer: &mut dyn Observer) -> StopReason {
        self.clear_history_before_run();
        self.ledger.report.stop = StopReason::default();
        self.ledger.stopwatch = self.ledger.stopwatch.or_clock(observer.clock());
        let (mut steps, mut reported_at) = (0, None);
        let stop = loop {
            // Counts steps, too: many steps may insert nothing.
            let work = steps + self.ledger.insertions;
            if reported_at.is_none_or(|reported| work >= reported + PROGRESS_EVERY) {
                reported_at = Some(work);
                if !observer.progress(self.progress()) {
                    break StopReason::Cancelled;
                }
            }
            steps += 1;
            let outcome =
                if observer.wants_events() { self.step_observed(observer) } else { self.recorded(Self::advance) };
            match outcome {
                StepOutcome::Finished => break StopReason::Finished,
                StepOutcome::Exhausted => break StopReason::Budget,
                StepOutcome::Stalled => break StopReason::NoLongerImproves,
                StepOutcome::Prepared
                | StepOutcome::SubsegmentSplit
                | StepOutcome::SubsegmentKept
                | StepOutcome::SubsegmentRefused
                | StepOutcome::Filled
                | StepOutcome::Triangle
                | StepOutcome::Recovered
                | StepOutcome::Retried => {}
            }
        };
        self.ledger.report.stop = stop;
        stop
    }

    pub(super) fn progress(&self) -> Progress {
        Progress {
            vertices: self.ledger.vertices,
            waiting: self.agenda.queue.len() + self.nodes_left(),
            max_vertices: self.problem.options.limits.max_vertices,
        }
    }

    /// Makes one step: splits a queued subsegment, or else treats the bad triangle of lowest priority.
    ///
    /// Afterwards the log holds the changes of this step alone.
    pub(super) fn advance(&mut self) -> StepOutcome {
        self.ledger.stopwatch.enter(Part::Prepare);
        self.scratch.log.clear();
        if !self.scratch.is_recorded {
            self.cdt.forget_undo_outside();
        }
        let outcome = self.take_step();
        self.ledger.stopwatch.enter(Part::Outside);
        outcome
    }

    fn take_step(&mut self) -> StepOutcome {
        if self.continue_recovery() {
            return StepOutcome::Recovered;
        }
        if !self.is_open() {
            return self.opening_step();
        }
        if self.is_exhausted() {
            let waits = !self.agenda.encroached.is_empty() || self.agenda.queue.len() > 0 || self.is_filling();
            return if waits { StepOutcome::Exhausted } else { StepOutcome::Finished };
        }
        if self.ledger.improvement.is_due(self.ledger.vertices) && self.no_longer_improves() {
            return StepOutcome::Stalled;
        }
        if let Some(outcome) = self.split_next_subsegment() {
            return outcome;
        }
        if self.fill_step() {
            return StepOutcome::Filled;
        }
        self.ledger.stopwatch.enter(Part::Select);
        let Some(face) = self.next_face() else {
            if self.recover_by_step() {
                return StepOutcome::Recovered;
            }
            return if self.retry() { StepOutcome::Retried } else { StepOutcome::Finished };
        };
        let ticket = self.agenda.queue.issue(&self.cdt, face);
        self.note_selected(face);
        self.ledger.stopwatch.enter(Part::Point);
        match self.treat(face) {
            Ok(()) if self.problem.options.recipe.until_destroyed => self.agenda.current = Some(ticket),
            Ok(()) if self.agenda.queue.is_valid(&self.cdt, ticket) => self.test_face(face),
            Ok(()) => {}
            Err(reason) => self.agenda.given_up.push((self.cdt.face_key(face), reason)),
        }
        StepOutcome::Triangle
    }

    /// Queues triangles again that were given up because there was no room, and subsegments that could not be split, if
    /// anything has changed since; returns whether it did.
    ///
    /// So a second refinement of the resulting mesh has nothing to do.
    fn retry(&mut self) -> bool {
        let had_no_room = |reason: Reason| matches!(reason, Reason::PrecisionFloor | Reason::InputGap);
        let is_refused = self.agenda.given_up.iter().any(|g| had_no_room(g.1)) || !self.agenda.unsplittable.is_empty();
        let is_worth_it = is_refused && self.agenda.retries < MOST_RETRIES;
        let r = &self.ledger.report;
        let changes = r.points_inserted + r.segments_split + r.vertices_deleted;
        if !is_worth_it || changes == self.agenda.changes_at_retry {
            return false;
        }
        self.agenda.retries += 1;
        self.agenda.changes_at_retry = changes;
        let refusals = (std::mem::take(&mut self.agenda.given_up), std::mem::take(&mut self.agenda.unsplittable));
        if let Some(record) = self.record() {
            record.note_retry(refusals);
        }
        self.test_everything();
        true
    }

    /// The current triangle if it still exists, else the triangle of lowest priority.
    fn next_face(&mut self) -> Option<FaceId> {
        if let Some(ticket) = self.agenda.current.take().filter(|&ticket| self.agenda.queue.is_valid(&self.cdt, ticket))
        {
            return Some(ticket.face);
        }
        if !self.strategy.traits.select.is_manual {
            return self.agenda.queue.pop(&self.cdt, self.strategy.traits.select.takes_oldest);
        }
        let there = |cdt: &ConstrainedTriangulation, &(f, key): &Picked| cdt.is_real(f) && cdt.face_key(f) == key;
        while let Some(picked) = self.agenda.picked.pop_front() {
            if let Some(record) = self.record() {
                record.note_taken(picked);
            }
            if there(&self.cdt, &picked) {
                return Some(picked.0);
            }
        }
        None
    }

    /// Picks a triangle to be treated after those picked before, for the order `manual`. A triangle that no longer
    /// exists when its turn comes is skipped.
    ///
    /// Returns whether there is such a triangle.
    pub fn pick(&mut self, face: FaceId) -> bool {
        let is_there = face.index() < self.cdt.face_slots() && self.cdt.is_real(face);
        if is_there {
            self.agenda.picked.push_back((face, self.cdt.face_key(face)));
        }
        is_there
    }

    /// Whether the budget is spent. Deletions lower the number of vertices, so insertions are bounded, too: every run
    /// ends.
    fn is_exhausted(&self) -> bool {
        let most = self.problem.options.limits.max_vertices;
        self.ledger.vertices >= most || self.ledger.insertions >= 16 * most as u64 + 1024
    }

    /// Whether free points that encroach upon a subsegment are refused.
    pub(super) fn minds_encroachment(&self) -> bool {
        self.strategy.traits.point.minds_encroachment
    }

    pub(super) fn view(&self) -> View<'_> {
        self.problem.view(&self.cdt, &self.strategy)
    }
}

impl Beginning for Refinement {
    fn triangulation(&self) -> &ConstrainedTriangulation {
        &self.cdt
    }

    fn overview(&self) -> Overview {
        Self::overview(self)
    }

    fn pick(&mut self, face: FaceId) -> bool {
        Self::pick(self, face)
    }
}
