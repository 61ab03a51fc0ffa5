//! Going back: states remembered now and then, and what was done after them done again.
//!
//! A refinement is a function of its input, its options and what the caller does between steps. So a state some steps
//! before is the newest one remembered before it, and the steps and picks between once more, as they were recorded:
//!
//! ```text
//!     state ── step 1 ── pick ── step 2 ── step 3 ── (own test) ── state ── step 4
//!       0                                                           3, kept: no state before it knows the test
//! ```
//!
//! Of states long past fewer and fewer are kept: about as many as the logarithm of the number of steps, so that memory
//! stays within a few times the triangulation's own.

use super::Refinement;
use crate::half_edge::{FaceId, VertexId};
use crate::refine::event::StepOutcome;

/// Steps between two states remembered, at least.
const STRIDE: u64 = 32;
/// In large triangulations, one state is remembered in as many steps as it has faces over this.
const FACES_A_STEP: u64 = 256;

/// What was done step by step.
#[derive(Clone, Default)]
pub(super) struct History {
    steps: u64,
    /// The oldest first.
    states: Vec<State>,
    /// Triangles that were picked, in order, each with the number of steps made by then.
    picks: Vec<(u64, Picked)>,
    /// Whether the caller has changed more than picks since the last step.
    is_changed: bool,
}

/// A triangle, by its slot and its sorted vertices.
pub(super) type Picked = (FaceId, [VertexId; 3]);

/// A state right before a step.
#[derive(Clone)]
struct State {
    /// The number of steps made by then.
    at: u64,
    refinement: Box<Refinement>,
    /// How many picks it knows of.
    picks: usize,
    /// Whether something was changed before it that is not recorded: no other state leads to it.
    is_kept: bool,
}

impl History {
    /// Forgets states so that those left lie about twice as far apart each time one goes further back.
    fn thin(&mut self) {
        let now = self.steps;
        let mut last = None;
        self.states.retain(|state| {
            let at = state.at;
            let keep = at == 0 || state.is_kept || last.is_none_or(|l| at - l >= ((now - at) / 4).max(STRIDE));
            if keep {
                last = Some(at);
            }
            keep
        });
    }

    /// The triangles picked when so many steps had been made, those left out that were picked before so many others.
    fn picked_at(&self, steps: u64, known: usize) -> Vec<Picked> {
        self.picks[known..].iter().filter(|(at, _)| *at == steps).map(|&(_, picked)| picked).collect()
    }
}

impl Refinement {
    /// Remembers the present, where it is time to.
    pub(super) fn remember(&mut self) {
        let mut history = self.history.take().unwrap_or_default();
        let stride = STRIDE.max(self.cdt.face_slots() as u64 / FACES_A_STEP);
        let is_kept = std::mem::take(&mut history.is_changed);
        let is_due = history.states.last().is_none_or(|state| history.steps >= state.at + stride);
        if is_due || is_kept {
            history.thin();
            let (at, picks) = (history.steps, history.picks.len());
            history.states.push(State { at, refinement: Box::new(self.clone()), picks, is_kept });
        }
        self.history = Some(history);
    }

    /// The number of the step that is about to be made.
    pub(super) fn count_step(&mut self) -> u64 {
        self.history.as_mut().map_or(0, |history| {
            history.steps += 1;
            history.steps
        })
    }

    /// How many steps can be taken back: those made one by one.
    #[must_use]
    pub fn steps_made(&self) -> u64 {
        self.history.as_ref().map_or(0, |history| history.steps)
    }

    /// Notes that the caller picked a triangle.
    pub(super) fn record_pick(&mut self, picked: Picked) {
        if let Some(history) = &mut self.history {
            history.picks.push((history.steps, picked));
        }
    }

    /// Notes that the caller has changed something between steps that is not recorded.
    pub(super) fn record_change(&mut self) {
        if let Some(history) = &mut self.history {
            history.is_changed = true;
        }
    }

    /// Takes the last step back: everything is what it was right before it, with what was picked and chosen by then.
    /// Says whether there was one.
    ///
    /// A [`run`](Self::run) between steps cannot be taken back, and ends what can be.
    ///
    /// # Complexity
    /// A copy of the triangulation, and some of the steps before once more.
    pub fn back(&mut self) -> bool {
        let Some(mut history) = self.history.take() else { return false };
        let Some(target) = history.steps.checked_sub(1) else {
            self.history = Some(history);
            return false;
        };
        while history.states.last().is_some_and(|state| state.at > target) {
            history.states.pop();
        }
        history.picks.retain(|(at, _)| *at <= target);
        history.is_changed = false;
        let Some(state) = history.states.last() else { return false };
        *self = (*state.refinement).clone();
        let (from, known) = (state.at, state.picks);
        for steps in from..=target {
            if steps > from {
                self.advance();
            }
            history.picked_at(steps, known).into_iter().for_each(|picked| self.put_picked(picked));
        }
        history.steps = target;
        self.history = Some(history);
        true
    }

    /// Runs step by step until a condition holds, asked after each step, or nothing is left to do; says how the last
    /// step ended. The steps can be taken back.
    pub fn run_until(&mut self, mut holds: impl FnMut(&Self) -> bool) -> StepOutcome {
        loop {
            self.remember();
            self.count_step();
            let outcome = self.advance();
            if matches!(outcome, StepOutcome::Finished | StepOutcome::Exhausted | StepOutcome::Stalled) || holds(self) {
                return outcome;
            }
        }
    }
}
