//! Drives random edits with rollback against anything that can be edited and checked.
//!
//! The driver keeps a stack of remembered states. After every edit the subject is checked (always
//! while small, now and then when large). A rollback goes back to a state drawn from the stack and
//! must restore it exactly; now and then the edits taken back are made once more, from the same
//! random numbers, and must lead to the same result.
#![allow(dead_code, reason = "every test uses a part of it")]

use trimalla::half_edge::{Checkpoint, UndoLog};
use trimalla_testkit::generators::SplitMix64;

/// Something that random edits are made to.
pub(crate) trait Subject: Clone + PartialEq {
    /// Draws one edit, carries it out and returns it as a line of Rust.
    fn edit(&mut self, random: &mut SplitMix64, log: &mut UndoLog) -> String;

    /// Takes edits back.
    fn rollback(&mut self, log: &mut UndoLog, to: Checkpoint);

    /// Everything wrong with the subject, the full check.
    fn faults(&self) -> Vec<String>;

    /// How large the subject is, in vertices.
    fn size(&self) -> usize;

    /// Whether two subjects are the same but for the slots of their arrays.
    fn is_alike(&self, other: &Self) -> bool;
}

/// How long and how thoroughly to drive.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plan {
    /// Seed of all that is drawn.
    pub(crate) seed: u64,
    /// Number of edits.
    pub(crate) edits: usize,
    /// Up to this size the subject is checked and remembered after every edit.
    pub(crate) small: usize,
    /// Larger subjects are checked and remembered after so many edits.
    pub(crate) every: usize,
    /// One rollback in so many edits, on average.
    pub(crate) rollback_in: usize,
}

/// What was driven.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tally {
    /// Edits made, those made once more included.
    pub(crate) edits: usize,
    /// Rollbacks, each compared array by array.
    pub(crate) rollbacks: usize,
    /// Full checks.
    pub(crate) checks: usize,
}

impl Tally {
    /// The sums of both.
    pub(crate) fn plus(self, other: Self) -> Self {
        Self {
            edits: self.edits + other.edits,
            rollbacks: self.rollbacks + other.rollbacks,
            checks: self.checks + other.checks,
        }
    }
}

/// A state to come back to.
struct Remembered<S> {
    at: Checkpoint,
    state: S,
    /// The generator as it was.
    random: SplitMix64,
    /// How many edits led here.
    edits: usize,
}

/// Carries the plan out; panics with the edits that led to the first failure.
pub(crate) fn drive<S: Subject>(subject: S, plan: Plan) -> (S, Tally) {
    let mut driver = Driver::new(subject, plan);
    let mut dice = SplitMix64::new(plan.seed ^ 0x0d1c_e5ee);
    while driver.tally.edits < plan.edits {
        driver.edit();
        if dice.below(plan.rollback_in) == 0 {
            driver.take_back(&mut dice);
        }
    }
    (driver.subject, driver.tally)
}

/// The subject, its past, and what was done.
struct Driver<S> {
    plan: Plan,
    subject: S,
    log: UndoLog,
    random: SplitMix64,
    past: Vec<Remembered<S>>,
    /// The edits in force, oldest first.
    lines: Vec<String>,
    tally: Tally,
}

impl<S: Subject> Driver<S> {
    fn new(subject: S, plan: Plan) -> Self {
        let random = SplitMix64::new(plan.seed);
        let lines = Vec::new();
        let (log, past, tally) = (UndoLog::new(), Vec::new(), Tally::default());
        let mut driver = Self { plan, subject, log, random, past, lines, tally };
        driver.check();
        driver.remember();
        driver
    }

    /// One edit, checked and remembered as the plan says.
    fn edit(&mut self) {
        self.edit_unchecked();
        let small = self.subject.size() <= self.plan.small;
        if small || self.tally.edits % self.plan.every == 0 {
            self.check();
            self.remember();
        }
    }

    fn edit_unchecked(&mut self) {
        let line = self.subject.edit(&mut self.random, &mut self.log);
        self.lines.push(line);
        self.tally.edits += 1;
    }

    fn remember(&mut self) {
        self.past.push(Remembered {
            at: self.log.checkpoint(),
            state: self.subject.clone(),
            random: self.random.clone(),
            edits: self.lines.len(),
        });
    }

    /// Goes back to a remembered state, near or far; one time in four, edits lead forward again.
    fn take_back(&mut self, dice: &mut SplitMix64) {
        let near = self.past.len().saturating_sub(8);
        let from = if dice.below(8) == 0 { 0 } else { near };
        let gone = self.past.split_off(from + 1 + dice.below(self.past.len() - from));
        self.roll_back();
        if dice.below(4) == 0 {
            self.replay(gone);
        } else {
            self.take_another_future(dice.next_u64());
        }
    }

    /// Goes back to the last state that is still remembered.
    fn roll_back(&mut self) {
        let Some(goal) = self.past.last() else { return };
        self.subject.rollback(&mut self.log, goal.at);
        if self.subject != goal.state {
            let after = &self.lines[goal.edits..];
            panic!("rollback past {after:#?} did not restore {}", self.story(goal.edits));
        }
        self.random = goal.random.clone();
        self.lines.truncate(goal.edits);
        self.tally.rollbacks += 1;
    }

    /// The same edits once more lead to the same states.
    fn replay(&mut self, gone: Vec<Remembered<S>>) {
        for Remembered { state, random, edits, .. } in gone {
            while self.lines.len() < edits {
                self.edit_unchecked();
            }
            if !self.subject.is_alike(&state) {
                panic!("the same edits after a rollback led elsewhere: {}", self.story(edits));
            }
            self.random = random;
            self.remember();
        }
    }

    /// What follows is drawn from another seed, also when it is drawn again from here.
    fn take_another_future(&mut self, seed: u64) {
        self.random = SplitMix64::new(seed);
        if let Some(now) = self.past.last_mut() {
            now.random = self.random.clone();
        }
    }

    fn check(&mut self) {
        self.tally.checks += 1;
        let faults = self.subject.faults();
        assert!(faults.is_empty(), "{faults:#?} after {}", self.story(self.lines.len()));
    }

    /// The first edits in force, as Rust.
    fn story(&self, edits: usize) -> String {
        format!("{:?}:\n{}", self.plan, self.lines[..edits].join("\n"))
    }
}
