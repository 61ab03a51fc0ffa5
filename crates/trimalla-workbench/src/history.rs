//! Commands that were done, and what takes them back.

use std::collections::VecDeque;

use trimalla::refine::Event;

use crate::changes::{Change, Traces};
use crate::runs::RunInformation;
use crate::state::State;

/// A command that was done.
#[derive(Debug)]
pub(crate) struct Done {
    pub(crate) line: String,
    traces: Traces,
}

/// A command that was taken back.
#[derive(Debug)]
pub(crate) struct Undone {
    pub(crate) line: String,
    /// The state it led to, where it replaced everything; else it is run again, on the state it was run on before.
    pub(crate) after: Option<Box<State>>,
    /// The event of its last step and its run, where it is not run again.
    pub(crate) event: Option<Box<Event>>,
    pub(crate) run: Option<Box<RunInformation>>,
}

impl Done {
    pub(crate) fn new(line: String, traces: Traces) -> Self {
        Self { line, traces }
    }

    /// What its run did, if it ended one.
    pub(crate) fn run(&self) -> Option<&RunInformation> {
        self.traces.run.as_deref()
    }

    /// The event of its last step, if it made steps.
    pub(crate) fn event(&self) -> Option<&Event> {
        self.traces.event.as_deref()
    }

    /// How many steps of a refinement it made.
    fn steps(&self) -> u64 {
        let is_step = |change: &&Change| matches!(change, Change::Step { .. });
        self.traces.changes.iter().filter(is_step).count() as u64
    }

    fn has_replaced_everything(&self) -> bool {
        self.traces.changes.iter().any(|change| matches!(change, Change::Whole(_)))
    }

    /// The state before it, if it replaced everything.
    fn before(&mut self) -> Option<&mut State> {
        self.traces.changes.iter_mut().find_map(|change| match change {
            Change::Whole(before) => Some(&mut **before),
            _ => None,
        })
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + self.line.len() + self.traces.bytes()
    }

    /// Takes the command back.
    pub(crate) fn undo(self, state: &mut State) -> Undone {
        let mut changes = self.traces.changes.into_iter();
        // What a command does after it has replaced everything is undone by going back to what was there before.
        let after = match changes.next() {
            Some(Change::Whole(before)) => Some(Box::new(std::mem::replace(state, *before))),
            first => {
                let rest: Vec<Change> = first.into_iter().chain(changes).collect();
                rest.into_iter().rev().for_each(|change| change.undo(state));
                None
            }
        };
        let (event, run) = if after.is_some() { (self.traces.event, self.traces.run) } else { (None, None) };
        Undone { line: self.line, after, event, run }
    }
}

/// The commands that can be taken back and done again, within a budget of memory.
#[derive(Debug)]
pub(crate) struct History {
    done: VecDeque<Done>,
    undone: Vec<Undone>,
    bytes: usize,
    most_bytes: usize,
    /// How many commands were done before the oldest that can be taken back.
    forgotten: usize,
    /// How many of those that can be taken back have replaced everything.
    wholes: usize,
}

impl History {
    /// What the records may take where nothing is said: 256 MiB.
    pub(crate) const MOST_BYTES: usize = 256 << 20;

    pub(crate) fn new(most_bytes: usize) -> Self {
        Self { done: VecDeque::new(), undone: Vec::new(), bytes: 0, most_bytes, forgotten: 0, wholes: 0 }
    }

    /// Notes a command that was done and led to a state; commands that were taken back cannot be done again after it.
    /// Returns how many of the oldest had to go.
    pub(crate) fn push(&mut self, done: Done, state: &mut State) -> usize {
        self.undone.clear();
        self.push_again(done, state)
    }

    /// Notes a command that was done again and led to a state.
    pub(crate) fn push_again(&mut self, done: Done, state: &mut State) -> usize {
        self.count(&done, true);
        self.done.push_back(done);
        let mut dropped = 0;
        // The newest stays, whatever it takes.
        while self.bytes > self.most_bytes && self.done.len() > 1 {
            let Some(oldest) = self.done.pop_front() else { break };
            self.count(&oldest, false);
            self.forget_steps(oldest.steps(), state);
            dropped += 1;
        }
        self.forgotten += dropped;
        dropped
    }

    /// Frees the records of steps before the oldest command: they are those of the refinement that the next command
    /// which replaced everything has put away, or of the one at work.
    fn forget_steps(&mut self, steps: u64, state: &mut State) {
        if steps > 0 {
            let all = if self.wholes > 0 { self.done.len() } else { 0 };
            let put_away = self.done.iter_mut().take(all).find_map(Done::before);
            put_away.unwrap_or(state).forget_oldest_steps(steps);
        }
    }

    /// The newest command, to be taken back.
    pub(crate) fn pop(&mut self) -> Option<Done> {
        let done = self.done.pop_back()?;
        self.count(&done, false);
        Some(done)
    }

    /// Counts a command that joins the records, or leaves them.
    fn count(&mut self, done: &Done, joins: bool) {
        let (bytes, whole) = (done.bytes(), usize::from(done.has_replaced_everything()));
        if joins {
            self.bytes += bytes;
            self.wholes += whole;
        } else {
            self.bytes -= bytes;
            self.wholes -= whole;
        }
    }

    /// The newest command.
    pub(crate) fn newest(&self) -> Option<&Done> {
        self.done.back()
    }

    /// The commands that were taken back, in the order in which they are done again.
    pub(crate) fn lines_undone(&self) -> impl Iterator<Item = &str> {
        self.undone.iter().rev().map(|undone| undone.line.as_str())
    }

    /// Notes a command that was taken back.
    pub(crate) fn push_undone(&mut self, undone: Undone) {
        self.undone.push(undone);
    }

    /// The command that was taken back last, to be done again.
    pub(crate) fn pop_undone(&mut self) -> Option<Undone> {
        self.undone.pop()
    }

    /// About how many bytes the records take.
    pub(crate) const fn bytes(&self) -> usize {
        self.bytes
    }

    /// What the records may take, in bytes.
    pub(crate) const fn most_bytes(&self) -> usize {
        self.most_bytes
    }

    /// How many commands can be taken back.
    pub(crate) fn len(&self) -> usize {
        self.done.len()
    }

    /// How many commands can be done again.
    pub(crate) fn undone(&self) -> usize {
        self.undone.len()
    }

    /// How many commands were dropped for the memory they took.
    pub(crate) const fn forgotten(&self) -> usize {
        self.forgotten
    }
}
