//! The report: the result of a refinement in numbers.

use super::event::InsertedKind;
use super::stopwatch::StepTimes;
use crate::drawing::SegmentId;
use crate::refine::criteria::reason::{Reason, StopReason};
use crate::refine::recipe::Recipe;

/// A triangle that stayed bad.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Leftover {
    /// Index among the triangles of the mesh.
    pub triangle: usize,
    /// Its smallest angle in degrees.
    pub min_angle_deg: f64,
    /// Why.
    pub reason: Reason,
}

/// The report: the result of a refinement in numbers.
///
/// One field for each figure of the printed report.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default))]
pub struct Report {
    /// The recipe.
    pub recipe: Recipe,
    /// Vertices of the mesh, the input's included.
    pub vertices: usize,
    /// Triangles of the mesh.
    pub triangles: usize,
    /// Vertices that are not the input's.
    pub steiner_points: usize,
    /// Smallest angle of the mesh, in degrees.
    pub min_angle_deg: f64,
    /// Largest angle of the mesh, in degrees.
    pub max_angle_deg: f64,
    /// Triangles that stayed bad, by index.
    pub leftovers: Vec<Leftover>,
    /// Input segments that are no chains of edges in the mesh: only if the recipe releases segments and does not
    /// recover them.
    pub lost_segments: Vec<SegmentId>,
    /// Why it ended.
    pub stop: StopReason,
    /// Edges flipped before the first insertion, to make a given mesh Delaunay.
    pub edges_flipped: u64,
    /// Points inserted inside triangles.
    pub points_inserted: u64,
    /// Points refused because they would encroach upon a segment.
    pub points_rejected: u64,
    /// Subsegments split.
    pub segments_split: u64,
    /// Points inserted and subsegments split, by kind, in the order of [`InsertedKind::ALL`]; with their names:
    /// [`insertions`](Self::insertions).
    pub inserted: [u64; 4],
    /// Lengths of the longest-edge propagation paths that step 3 followed: the number of paths with 0, 1, 2, …
    /// triangles.
    pub lepp_lengths: Vec<u64>,
    /// Edges flipped instead of inserting a point, as some strategies do.
    pub flips_instead: u64,
    /// Free vertices deleted before a split.
    pub vertices_deleted: u64,
    /// The time of each step, if the caller gave a clock.
    pub step_times: Option<StepTimes>,
}

impl Report {
    /// Whether every leftover is forced by the input, and no segment was lost.
    #[must_use]
    pub fn complete(&self) -> bool {
        self.leftovers.iter().all(|l| l.reason.is_forced()) && self.lost_segments.is_empty()
    }

    /// The number of vertices inserted of each kind; vertices that were deleted later count, those rolled back at once
    /// do not.
    #[must_use]
    pub fn insertions(&self) -> [(InsertedKind, u64); 4] {
        std::array::from_fn(|i| (InsertedKind::ALL[i], self.inserted[i]))
    }

    /// The number of triangles that stayed bad for each reason that occurs.
    #[must_use]
    pub fn reasons(&self) -> Vec<(Reason, usize)> {
        Reason::ALL
            .into_iter()
            .map(|r| (r, self.leftovers.iter().filter(|l| l.reason == r).count()))
            .filter(|&(_, n)| n > 0)
            .collect()
    }
}
