//! Records of steps: what a step overwrote.

use std::collections::{BTreeSet, VecDeque};

use super::encroached::Encroached;
use super::filling::{FillStage, TakenNode};
use super::parts::{Ledger, Picked, SegmentWork};
use crate::constrained::Released;
use crate::half_edge::{EdgeKey, Entry, TriangleKey, UndoLog};
use crate::refine::agenda::queue::{Changes, Queue, Ticket};
use crate::refine::criteria::reason::Reason;

/// Default memory budget of the records, in bytes: one gibibyte.
const BYTES: usize = 1 << 30;

/// The records of the steps that can be taken back.
#[derive(Clone)]
pub(super) struct History<R> {
    /// The number of steps since the history began.
    pub(super) steps: u64,
    /// The number of steps among the records.
    pub(super) recorded: u64,
    /// The records, the oldest first.
    pub(super) records: VecDeque<Record<R>>,
    /// The record of the current step.
    pub(super) current_step: Option<Box<StepRecord>>,
    /// The approximate size of the records, and the budget.
    pub(super) bytes: usize,
    pub(super) most_bytes: usize,
    /// Whether steps of runs are recorded, too.
    pub(super) with_runs: bool,
}

/// What is needed to take a step or a change back.
#[derive(Clone)]
pub(super) enum Record<R> {
    Step(Box<StepRecord>),
    /// The refinement as it was before the caller changed options, a step or a test.
    Change {
        before: Box<R>,
        bytes: usize,
    },
}

/// What is needed to take a step back.
///
/// One field for each thing that a step may overwrite, whichever part of the refinement holds it.
#[derive(Clone)]
pub(super) struct StepRecord {
    pub(super) triangulation: UndoLog,
    pub(super) ledger: Ledger,
    pub(super) sequence: u64,
    pub(super) current: Option<Ticket>,
    pub(super) changes_at_retry: u64,
    pub(super) retries: u32,
    /// The lengths of the lists before the step.
    pub(super) encroached: usize,
    pub(super) picked: usize,
    pub(super) given_up: usize,
    /// What the step took from the front of these lists.
    pub(super) split: Option<Encroached>,
    pub(super) taken: Vec<Picked>,
    /// Subsegments that turned out to be unsplittable.
    pub(super) unsplittable: Vec<EdgeKey>,
    /// The triangles given up and the unsplittable subsegments before a retry.
    pub(super) before_retry: Option<Box<Refusals>>,
    /// The queue if the step replaced it; else the journal of the queue.
    pub(super) queue: Option<Box<Queue>>,
    pub(super) queue_changes: Changes,
    /// Work on segments before it was changed.
    pub(super) segments: Option<Box<SegmentWork>>,
    pub(super) filling: Option<FillStage>,
    pub(super) node: Option<TakenNode>,
}

/// Triangles that were given up, and subsegments that cannot be split.
pub(super) type Refusals = (Vec<(TriangleKey, Reason)>, BTreeSet<EdgeKey>);

impl<R> Default for History<R> {
    fn default() -> Self {
        Self {
            steps: 0,
            recorded: 0,
            records: VecDeque::new(),
            current_step: None,
            bytes: 0,
            most_bytes: BYTES,
            with_runs: false,
        }
    }
}

impl<R> Record<R> {
    /// Approximate size of the record in bytes.
    fn bytes(&self) -> usize {
        match self {
            Self::Step(step) => step.bytes(),
            Self::Change { bytes, .. } => *bytes,
        }
    }
}

impl<R> History<R> {
    pub(super) fn push(&mut self, record: Record<R>) {
        self.bytes += record.bytes();
        self.recorded += u64::from(matches!(record, Record::Step(_)));
        self.records.push_back(record);
        while self.bytes > self.most_bytes && self.records.len() > 1 {
            if let Some(oldest) = self.records.pop_front() {
                self.forget(&oldest);
            }
        }
    }

    /// Drops the records up to so many steps from the oldest on.
    pub(super) fn forget_oldest(&mut self, steps: u64) {
        let left = self.recorded.saturating_sub(steps);
        while self.recorded > left {
            let Some(oldest) = self.records.pop_front() else { break };
            self.forget(&oldest);
        }
    }

    pub(super) fn pop(&mut self) -> Option<Record<R>> {
        let record = self.records.pop_back()?;
        self.forget(&record);
        Some(record)
    }

    fn forget(&mut self, record: &Record<R>) {
        self.bytes -= record.bytes();
        self.recorded -= u64::from(matches!(record, Record::Step(_)));
    }
}

impl StepRecord {
    /// Approximate size of the record in bytes, with its lists.
    fn bytes(&self) -> usize {
        let refusals = self.before_retry.as_ref().map_or(0, |refusals| {
            refusals.0.len() * size_of::<(TriangleKey, Reason)>() + refusals.1.len() * size_of::<EdgeKey>()
        });
        let segments = self.segments.as_ref().map_or(0, |segments| {
            size_of::<SegmentWork>() + (segments.released.len() + segments.lost.len()) * size_of::<Released>()
        });
        size_of::<Self>()
            + self.triangulation.len() * size_of::<Entry>()
            + self.queue_changes.bytes()
            + self.queue.as_ref().map_or(0, |queue| queue.bytes())
            + self.taken.len() * size_of::<Picked>()
            + refusals
            + segments
    }

    /// Records the subsegment that the step takes from the queue.
    pub(super) fn note_split(&mut self, encroached: Encroached) {
        self.split = Some(encroached);
    }

    /// Records a subsegment that the step found to be unsplittable.
    pub(super) fn note_unsplittable(&mut self, edge: EdgeKey) {
        self.unsplittable.push(edge);
    }

    /// Records a picked triangle that the step took.
    pub(super) fn note_taken(&mut self, picked: Picked) {
        self.taken.push(picked);
    }

    /// Records what a retry clears.
    pub(super) fn note_retry(&mut self, refusals: Refusals) {
        self.before_retry.get_or_insert(Box::new(refusals));
    }

    /// Records the queue before it is replaced.
    pub(super) fn note_queue(&mut self, before: Queue) {
        self.queue.get_or_insert(Box::new(before));
    }

    /// Records the stage of the filling.
    pub(super) fn note_filling(&mut self, before: FillStage) {
        self.filling.get_or_insert(before);
    }

    /// Records the node that the step takes.
    pub(super) fn note_node(&mut self, node: TakenNode) {
        self.node = Some(node);
    }
}
