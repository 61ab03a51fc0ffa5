//! Step 5: what becomes of interior segments.
//!
//! | key | while points go in | in the end |
//! |---|---|---|
//! | `whole-edge` | segments are edges that no flip crosses | they are there |
//! | `by-splitting` | segments inside are let go | those missing are halved until they are chains of edges |
//! | `none` | segments inside are let go | what is missing is reported |

mod by_splitting;
mod none;
mod whole_edge;

use std::sync::Arc;

use super::event::InsertedKind;
use super::joints::Joints;
use super::mirror::Mirrors;
use super::recipe::{Recipe, Recover};
use super::refinement::{Refinement, precision_floor};
use super::ruler::Ruler;
use super::steps::RecoverStep;
use super::stopwatch::Part;
use crate::constrained::{ConstrainedDelaunay, SegmentPlan, SplitLimits};
use crate::geometry::Point;
use crate::mesh::NoJournal;
use by_splitting::BySplitting;
use none::Nothing;
use whole_edge::WholeEdge;

/// The step of a recipe.
pub(super) fn step(recipe: &Recipe) -> Arc<dyn RecoverStep + Send + Sync> {
    match recipe.recover {
        Recover::WholeEdge => Arc::new(WholeEdge),
        Recover::BySplitting => Arc::new(BySplitting),
        Recover::None => Arc::new(Nothing),
    }
}

impl Refinement {
    /// Brings segments back that were let go, if the recipe does so; says whether the loop has to go on.
    pub(super) fn recover_segments(&mut self) -> bool {
        if self.released.is_empty() || !self.recover.splits_back() {
            return false;
        }
        self.split_released();
        self.look_at_everything();
        true
    }

    /// Splits what was let go until it is edges, and locks it.
    pub(super) fn split_released(&mut self) {
        let before = self.stopwatch.enter(Part::Recover);
        let released = std::mem::take(&mut self.released);
        let (ruler, floor_sq) = (self.ruler, self.floor_sq);
        let may_part = |a: Point, b: Point| a != b && ruler.length_sq(a, b) >= floor_sq;
        let vertices = self.options.limits.max_vertices.saturating_sub(self.vertices);
        let mirrors = Mirrors::new(&self.cdt, &self.joints, ruler);
        let place = |cdt: &ConstrainedDelaunay, stretch, plan: &SegmentPlan| mirrors.place(cdt, stretch, plan);
        let limits = SplitLimits { vertices, may_part: &may_part, place: &place };
        let inserted = self.cdt.recover_by_splitting(released, &limits, &mut self.log);
        self.vertices += inserted;
        self.insertions += inserted as u64;
        self.report.segments_split += inserted as u64;
        self.report.inserted[InsertedKind::SegmentMiddle as usize] += inserted as u64;
        self.stopwatch.enter(before);
    }

    /// In the end: what is there of segments let go is marked as theirs, and those with a piece missing are reported.
    pub(super) fn claim_segments(&mut self) {
        self.recover_segments();
        let missing = self.cdt.claim(&self.released, &mut NoJournal);
        let mut lost: Vec<u32> =
            missing.iter().flat_map(|piece| self.cdt.segments_of_class(piece.mark).into_owned()).collect();
        lost.sort_unstable();
        lost.dedup();
        self.report.lost_segments = lost;
    }
}

/// Splits the segments of a triangulation from which nothing was removed, until each is a chain of edges of the Delaunay
/// triangulation of all vertices.
///
/// Returns how many pieces are edges only because they are constrained: those that `max_vertices`, or the distance of 256 units
/// in the last place of the largest coordinate between vertices, left no room to split.
pub(crate) fn make_conforming(cdt: &mut ConstrainedDelaunay, max_vertices: usize) -> usize {
    let bounds = cdt.bounding_box();
    let ruler = Ruler::for_box(bounds);
    let floor = precision_floor(bounds, ruler);
    let may_part = |a: Point, b: Point| a != b && ruler.length_sq(a, b) >= floor * floor;
    let joints = Joints::of(cdt);
    let mirrors = Mirrors::new(cdt, &joints, ruler);
    let place = |cdt: &ConstrainedDelaunay, stretch, plan: &SegmentPlan| mirrors.place(cdt, stretch, plan);
    let vertices = max_vertices.saturating_sub(cdt.points().len());
    // Edges of the hull are edges of the Delaunay triangulation, and there are no regions yet.
    let released = cdt.release_inner_segments();
    let limits = SplitLimits { vertices, may_part: &may_part, place: &place };
    cdt.recover_by_splitting(released, &limits, &mut NoJournal);
    cdt.pieces_held_by_marks()
}

#[cfg(test)]
super::conformance::conforms!(recover, recover: Recover {
    none => None,
    by_splitting => BySplitting,
    whole_edge => WholeEdge,
});
