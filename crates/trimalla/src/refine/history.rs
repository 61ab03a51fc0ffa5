//! Going back: states remembered now and then, and the steps after them done again.
//!
//! A refinement is a function of its input and options, so a state some steps before is the newest one remembered before it,
//! and the steps between once more. Of states long past fewer and fewer are kept: about as many as the logarithm of the
//! number of steps, so that memory stays within a few times the triangulation's own.

use super::refinement::{Refinement, StepOutcome};

/// Steps between two states remembered, at least.
const STRIDE: u64 = 32;
/// In large triangulations, one state is remembered in as many steps as it has faces over this.
const FACES_A_STEP: u64 = 256;

/// States remembered, the oldest first.
#[derive(Clone, Default)]
pub(super) struct History {
    steps: u64,
    states: Vec<(u64, Box<Refinement>)>,
}

impl History {
    /// Forgets states so that those left lie about twice as far apart each time one goes further back.
    fn thin(&mut self) {
        let now = self.steps;
        let mut last = None;
        self.states.retain(|&(at, _)| {
            let keep = at == 0 || last.is_none_or(|l| at - l >= ((now - at) / 4).max(STRIDE));
            if keep {
                last = Some(at);
            }
            keep
        });
    }
}

impl Refinement {
    /// Remembers the present, where it is time to.
    pub(super) fn remember(&mut self) {
        let mut history = self.history.take().unwrap_or_default();
        let stride = STRIDE.max(self.cdt.face_slots() as u64 / FACES_A_STEP);
        let is_due = history.states.last().is_none_or(|s| history.steps >= s.0 + stride);
        if is_due {
            history.thin();
            history.states.push((history.steps, Box::new(self.clone())));
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

    /// Takes the last step back: every array is what it was before. Says whether there was one.
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
        while history.states.last().is_some_and(|s| s.0 > target) {
            history.states.pop();
        }
        let Some((at, state)) = history.states.last() else { return false };
        *self = (**state).clone();
        history.steps = *at;
        self.history = Some(history);
        while self.steps_made() < target {
            self.remember();
            self.count_step();
            self.advance();
        }
        true
    }

    /// Runs step by step until a condition holds, asked after each step, or nothing is left to do; says how the last step
    /// ended. The steps can be taken back.
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
