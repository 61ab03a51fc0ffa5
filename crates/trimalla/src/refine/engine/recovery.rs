//! Recovery of released segments.

use super::Refinement;
use super::parts::RunningRecovery;
use crate::constrained::{
    Changed, ConstrainedDelaunay, ConstrainedTriangulation, Recovery, Released, SegmentPlan, SplitLimits,
};
use crate::drawing::SegmentId;
use crate::geometry::Point;
use crate::half_edge::{NoJournal, UndoLog};
use crate::refine::criteria::floors::precision_floor;
use crate::refine::criteria::reason::StopReason;
use crate::refine::measure::joints::{Joints, Piece};
use crate::refine::measure::mirror::Mirrors;
use crate::refine::measure::ruler::Ruler;
use crate::refine::watch::event::InsertedKind;
use crate::refine::watch::stopwatch::Part;

/// Number of pieces of segments treated in one slice.
const SLICE: usize = 256;

impl Refinement {
    /// Begins a recovery of segments.
    pub(super) fn begin_recovery(&mut self, recovery: Recovery) {
        self.segments.recovery =
            Some(Box::new(RunningRecovery { recovery, pieces: self.problem.joints.pieces(&self.cdt) }));
    }

    /// Recovers some pieces as whole edges, at once; returns how many of them are edges then. The others are lost.
    pub(super) fn recover_whole(&mut self, chosen: Vec<Released>) -> usize {
        let count = chosen.len();
        let mut recovery = Recovery::as_whole_edges(chosen);
        while !recovery.is_done() {
            self.recover_some(&mut recovery, &[]);
        }
        let lost = recovery.into_lost();
        let there = count - lost.len();
        self.segments.lost.extend(lost);
        if self.is_open() {
            self.test_everything();
        }
        there
    }

    /// Runs one slice of the recovery under way, if there is one; returns whether there was.
    #[inline(always)] // Before each step.
    pub(super) fn continue_recovery(&mut self) -> bool {
        // Nearly always there is no recovery.
        self.segments.recovery.is_some() && self.recover_slice()
    }

    #[inline(never)]
    fn recover_slice(&mut self) -> bool {
        self.record_segments();
        let Some(mut running) = self.segments.recovery.take() else { return false };
        let RunningRecovery { recovery, pieces } = &mut *running;
        let before = self.ledger.stopwatch.enter(Part::Recover);
        self.recover_some(recovery, pieces);
        if recovery.is_done() {
            self.segments.lost.extend(running.recovery.into_lost());
            if self.is_open() {
                self.test_everything();
            }
        } else {
            self.segments.recovery = Some(running);
        }
        self.ledger.stopwatch.enter(before);
        true
    }

    /// Recovers one slice; `pieces` are all pieces of all segments for a recovery by splitting.
    fn recover_some(&mut self, recovery: &mut Recovery, pieces: &[Piece]) {
        let (ruler, floor_sq) = (self.problem.ruler, self.problem.floors.floor_sq);
        let may_part = |a: Point, b: Point| a != b && ruler.length_sq(a, b) >= floor_sq;
        let is_cancelled = self.ledger.report.stop == StopReason::Cancelled;
        let room = self.problem.options.limits.max_vertices.saturating_sub(self.ledger.vertices);
        let vertices = if is_cancelled { 0 } else { room };
        let mirrors = Mirrors::new(&self.problem.joints, pieces, ruler);
        let place = |cdt: &ConstrainedTriangulation, stretch, plan: &SegmentPlan| mirrors.place(cdt, stretch, plan);
        let limits = SplitLimits { vertices, pieces: SLICE, may_part: &may_part, place: &place };
        let Changed { inserted, removed } =
            self.cdt.edit(&mut self.scratch.work, &mut self.scratch.log).recover_some(recovery, &limits);
        self.ledger.vertices = self.ledger.vertices + inserted - removed;
        self.ledger.report.vertices_deleted += removed as u64;
        self.ledger.insertions += inserted as u64;
        self.ledger.report.segments_split += inserted as u64;
        self.ledger.report.inserted[InsertedKind::SegmentMiddle as usize] += inserted as u64;
    }

    /// Finishes the recovery: locks the released pieces that are edges, and reports the segments with a missing piece.
    ///
    /// If the caller has cancelled, no vertex is inserted any more.
    pub(super) fn finish_recovery(&mut self) {
        while self.recover_by_step() {
            while self.continue_recovery() {
                self.scratch.log.clear();
            }
        }
        let mut missing = self.cdt.edit(&mut self.scratch.work, &mut NoJournal).mark_present(&self.segments.released);
        missing.append(&mut self.segments.lost);
        let mut lost: Vec<SegmentId> =
            missing.iter().flat_map(|piece| self.cdt.segments_of_class(piece.mark).into_owned()).collect();
        lost.sort_unstable();
        lost.dedup();
        self.ledger.report.lost_segments = lost;
    }
}

/// Splits the segments of a triangulation from which nothing was removed, until each is a chain of edges of the
/// Delaunay triangulation of all vertices.
///
/// Returns the number of pieces that are edges only because they are constrained: `max_vertices`, or the least distance
/// between vertices of 256 units in the last place of the largest coordinate, left no room to split them.
pub(crate) fn make_conforming(cdt: &mut ConstrainedDelaunay, max_vertices: usize) -> usize {
    let bounds = cdt.bounding_box();
    let ruler = Ruler::for_box(bounds);
    let floor = precision_floor(bounds, ruler);
    let may_part = |a: Point, b: Point| a != b && ruler.length_sq(a, b) >= floor * floor;
    let joints = Joints::of(cdt);
    let pieces = joints.pieces(cdt);
    let mirrors = Mirrors::new(&joints, &pieces, ruler);
    let place = |cdt: &ConstrainedTriangulation, stretch, plan: &SegmentPlan| mirrors.place(cdt, stretch, plan);
    let mut log = UndoLog::new();
    // Edges of the hull are Delaunay edges, and there are no regions yet.
    let mut edit = cdt.edit(&mut log);
    let (released, mut waiting) = edit.release_inner_segments();
    edit.legalise_some(&mut waiting, usize::MAX);
    let mut recovery = Recovery::of(released);
    while !recovery.is_done() {
        log.clear();
        let vertices = max_vertices.saturating_sub(cdt.points().len());
        let limits = SplitLimits { vertices, pieces: SLICE, may_part: &may_part, place: &place };
        cdt.edit(&mut log).recover_some(&mut recovery, &limits);
    }
    cdt.pieces_held_by_marks()
}
