//! The loop's implementation of [`StepEdit`], for steps 1 and 5.

use std::sync::Arc;

use super::Refinement;
use crate::constrained::{Recovery, Released};
use crate::half_edge::{EdgeKey, VertexId};
use crate::refine::criteria::reason::StopReason;
use crate::refine::steps::{Bring, Proposal, StepEdit, View};

/// Counters of a refinement: if one of them differs, the refinement has changed.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Counts {
    insertions: u64,
    deleted: u64,
    encroached: usize,
    released: usize,
}

impl Refinement {
    /// Calls step 1, which may change the triangulation; returns whether it asks for another call and has changed
    /// something.
    pub(super) fn begin_by_step(&mut self) -> bool {
        let (step, before) = (Arc::clone(&self.strategy.steps.prepare), self.counts());
        step.begin(self) && self.counts() != before
    }

    /// Calls step 5, which may change the triangulation; returns whether the loop has to continue.
    pub(super) fn recover_by_step(&mut self) -> bool {
        self.record_segments();
        let (step, before) = (Arc::clone(&self.strategy.steps.recover), self.counts());
        step.recover(self);
        self.segments.recovery.is_some() || self.counts() != before
    }

    fn counts(&self) -> Counts {
        Counts {
            insertions: self.ledger.insertions,
            deleted: self.ledger.report.vertices_deleted,
            encroached: self.agenda.encroached.len(),
            released: self.segments.released.len(),
        }
    }

    /// Whether steps may still change anything.
    fn may_change(&self) -> bool {
        self.ledger.report.stop != StopReason::Cancelled && !self.is_exhausted()
    }
}

impl StepEdit for Refinement {
    fn view(&self) -> View<'_> {
        Self::view(self)
    }

    fn put(&mut self, place: Proposal) -> bool {
        // Every place from a step is verified.
        self.may_change() && place.is_true(&self.cdt) && self.try_place(place).is_ok()
    }

    fn delete(&mut self, v: VertexId) -> bool {
        let is_there = v.index() < self.cdt.points().len() && self.cdt.is_used(v) && self.cdt.is_deletable(v);
        self.may_change() && is_there && self.delete_free_vertex(v, &mut Vec::new())
    }

    fn missing(&self) -> Vec<[VertexId; 2]> {
        let is_missing = |piece: &&Released| self.cdt.half_edge_between(piece.from, piece.to).is_none();
        self.segments.released.iter().filter(is_missing).map(|piece| [piece.from, piece.to]).collect()
    }

    fn bring_back(&mut self, pieces: &[[VertexId; 2]]) -> usize {
        if !self.may_change() {
            return 0;
        }
        let mut wanted: Vec<EdgeKey> = pieces.iter().copied().map(EdgeKey::of).collect();
        wanted.sort_unstable();
        let is_wanted = |piece: &Released| wanted.binary_search(&EdgeKey::of([piece.from, piece.to])).is_ok();
        let (chosen, others) = std::mem::take(&mut self.segments.released).into_iter().partition(is_wanted);
        self.segments.released = others;
        self.recover_whole(chosen)
    }

    fn bring_all_back(&mut self, how: Bring) {
        if !self.segments.released.is_empty() {
            let released = std::mem::take(&mut self.segments.released);
            self.begin_recovery(match how {
                Bring::BySplitting => Recovery::of(released),
                Bring::AsWholeEdges => Recovery::as_whole_edges(released),
            });
        }
    }
}
