//! Taking steps back: what each step overwrote is restored in reverse order.
//!
//! ```text
//!     records   step 1 │ step 2 │ own test │ step 3          taken back newest first: step 3, the test, step 2, …
//!               ───────┴────────┴──────────┴───────>
//! ```
//!
//! A record of a step holds the journal of the triangulation, the journal of the queue, and the few other values that a
//! step changes, so that a step and taking it back cost the same. Lists to which a step appends, and from whose front
//! it takes, are restored by their lengths. A change that the caller makes between two steps is recorded as a copy of
//! the refinement; picks are an exception, since the recorded lengths restore them.
//!
//! The oldest records are dropped when the records exceed the memory budget.

use super::Refinement;
use super::parts::{Ledger, Scratch};
use super::records::{History, Record, StepRecord};
use crate::half_edge::{Checkpoint, UndoLog};
use crate::refine::agenda::queue::Changes;
use crate::refine::watch::event::StepOutcome;

/// Approximate bytes for each vertex that a copy of a refinement takes.
const BYTES_A_VERTEX: usize = 128;

impl Refinement {
    /// Records every step from now on, those of [`run`](Self::run) included, so that [`back`](Self::back) can take them
    /// back. Drops the oldest records when the records exceed `most_bytes`.
    ///
    /// [`step`](Self::step) and [`run_until`](Self::run_until) always record their steps, within one gibibyte unless
    /// this is called.
    pub fn keep_history(&mut self, most_bytes: usize) {
        let history = self.history.take().unwrap_or_default();
        self.history = Some(History { most_bytes, with_runs: true, ..history });
    }

    /// Approximate size of the records in bytes.
    #[must_use]
    pub fn history_bytes(&self) -> usize {
        self.history.as_ref().map_or(0, |history| history.bytes)
    }

    /// The number of steps that can be taken back.
    #[must_use]
    pub fn steps_made(&self) -> u64 {
        self.history.as_ref().map_or(0, |history| history.recorded)
    }

    /// The number of the last step, as its [`Event`](crate::refine::Event) has it: 0 before the first.
    #[must_use]
    pub fn step_number(&self) -> u64 {
        self.history.as_ref().map_or(0, |history| history.steps)
    }

    /// What the last step has overwritten in the triangulation, if it can be taken back.
    #[must_use]
    pub fn last_changes(&self) -> Option<&UndoLog> {
        match self.history.as_ref()?.records.back()? {
            Record::Step(step) => Some(&step.triangulation),
            Record::Change { .. } => None,
        }
    }

    /// Drops the records of so many of the oldest steps, which can no longer be taken back then.
    pub fn forget_oldest(&mut self, steps: u64) {
        if let Some(history) = &mut self.history {
            history.forget_oldest(steps);
        }
    }

    /// A copy of the refinement that begins a history of its own.
    #[must_use]
    pub fn without_history(&self) -> Self {
        Self {
            cdt: self.cdt.clone(),
            problem: self.problem.clone(),
            strategy: self.strategy.clone(),
            agenda: self.agenda.clone(),
            segments: self.segments.clone(),
            filling: self.filling.clone(),
            ledger: self.ledger.clone(),
            scratch: Scratch::default(),
            history: None,
        }
    }

    /// Drops the records, unless steps of runs are recorded, too.
    pub(super) fn clear_history_before_run(&mut self) {
        self.history = self.history.take().filter(|history| history.with_runs);
    }

    /// Begins to record steps made one by one; returns the number of the next step.
    pub(super) fn begin_step_history(&mut self) -> u64 {
        self.history.get_or_insert_default().steps + 1
    }

    /// Executes one step, and records it if steps are recorded.
    #[inline(always)] // Before each step of a run, and there is hardly ever a history.
    pub(super) fn recorded<T>(&mut self, step: impl FnOnce(&mut Self) -> T) -> T {
        if self.history.is_none() {
            return step(self);
        }
        self.begin_record();
        let result = step(self);
        self.end_record();
        result
    }

    #[cold]
    #[inline(never)]
    fn begin_record(&mut self) {
        let agenda = &mut self.agenda;
        agenda.queue.begin_record();
        let record = StepRecord {
            triangulation: UndoLog::new(),
            ledger: self.ledger.clone(),
            sequence: agenda.sequence,
            current: agenda.current,
            changes_at_retry: agenda.changes_at_retry,
            retries: agenda.retries,
            encroached: agenda.encroached.len(),
            picked: agenda.picked.len(),
            given_up: agenda.given_up.len(),
            split: None,
            taken: Vec::new(),
            unsplittable: Vec::new(),
            before_retry: None,
            queue: None,
            queue_changes: Changes::default(),
            segments: None,
            filling: None,
            node: None,
        };
        self.scratch.log.clear();
        self.scratch.is_recorded = true;
        if let Some(history) = &mut self.history {
            history.current_step = Some(Box::new(record));
        }
    }

    #[cold]
    #[inline(never)]
    fn end_record(&mut self) {
        self.scratch.is_recorded = false;
        let changes = self.agenda.queue.end_record();
        // A copy takes no more room than it needs, and the log keeps its own for the next step.
        let triangulation = self.scratch.log.clone();
        let Some(history) = &mut self.history else { return };
        history.steps += 1;
        if let Some(mut record) = history.current_step.take() {
            record.triangulation = triangulation;
            record.queue_changes = match &mut record.queue {
                Some(first) => first.end_record(),
                None => changes,
            };
            history.push(Record::Step(record));
        }
    }

    /// The record of the current step, if steps are recorded.
    #[inline(always)] // Several times a step, and there is hardly ever a history.
    pub(super) fn record(&mut self) -> Option<&mut StepRecord> {
        self.history.as_mut().and_then(|history| history.current_step.as_deref_mut())
    }

    /// Records the refinement before the caller changes something other than picks.
    pub(super) fn record_change(&mut self) {
        if let Some(mut history) = self.history.take() {
            history.push(Record::Change {
                bytes: self.cdt.points().len() * BYTES_A_VERTEX,
                before: Box::new(self.clone()),
            });
            self.history = Some(history);
        }
    }

    /// Records the work on segments before the current step changes it.
    pub(super) fn record_segments(&mut self) {
        if self.history.is_some() {
            let segments = Box::new(self.segments.clone());
            if let Some(record) = self.record() {
                record.segments.get_or_insert(segments);
            }
        }
    }

    /// Takes the last step back: restores the state right before it, with the options and picks of that moment. Returns
    /// whether there was a step.
    ///
    /// A [`run`](Self::run) can be taken back step by step after a call of [`keep_history`](Self::keep_history);
    /// otherwise a run drops the records.
    ///
    /// # Complexity
    /// That of the step; a copy of the triangulation if the caller has changed options or steps since.
    pub fn back(&mut self) -> bool {
        let Some(mut history) = self.history.take() else { return false };
        let has_step = history.recorded > 0;
        let mut is_back = !has_step;
        // Each round pops a record; the last one popped is a step.
        while !is_back {
            match history.pop() {
                Some(Record::Change { before, .. }) => *self = *before,
                Some(Record::Step(step)) => {
                    history.steps -= 1;
                    self.take_back(*step);
                    is_back = true;
                }
                None => is_back = true,
            }
        }
        self.history = Some(history);
        has_step
    }

    /// Restores what a step overwrote.
    fn take_back(&mut self, mut step: StepRecord) {
        self.cdt.rollback(&mut step.triangulation, Checkpoint(0));
        let agenda = &mut self.agenda;
        if let Some(queue) = step.queue {
            agenda.queue = *queue;
        }
        agenda.queue.take_back(step.queue_changes);
        agenda.sequence = step.sequence;
        agenda.current = step.current;
        (agenda.changes_at_retry, agenda.retries) = (step.changes_at_retry, step.retries);
        // Drops what the step, or the caller after it, appended; restores what the step took from the front.
        agenda.encroached.truncate(step.encroached - usize::from(step.split.is_some()));
        agenda.encroached.extend(step.split);
        agenda.encroached.rotate_right(usize::from(step.split.is_some()));
        agenda.picked.truncate(step.picked - step.taken.len());
        step.taken.into_iter().rev().for_each(|picked| agenda.picked.push_front(picked));
        for edge in step.unsplittable {
            agenda.unsplittable.remove(&edge);
        }
        if let Some(refusals) = step.before_retry {
            (agenda.given_up, agenda.unsplittable) = *refusals;
        }
        agenda.given_up.truncate(step.given_up);
        if let Some(segments) = step.segments {
            self.segments = *segments;
        }
        if let Some(filling) = step.filling {
            self.filling = filling;
        }
        if let Some(node) = step.node {
            self.filling.put_back(node);
        }
        self.ledger = Ledger { stopwatch: self.ledger.stopwatch, ..step.ledger };
    }

    /// Runs step by step until a condition, evaluated after each step, holds or nothing is left to do; returns the
    /// outcome of the last step. The steps can be taken back.
    pub fn run_until(&mut self, mut holds: impl FnMut(&Self) -> bool) -> StepOutcome {
        loop {
            self.begin_step_history();
            let outcome = self.recorded(Self::advance);
            if outcome.is_last() || holds(self) {
                return outcome;
            }
        }
    }
}
