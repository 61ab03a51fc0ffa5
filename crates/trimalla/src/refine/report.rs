//! What came of a refinement.

use std::fmt;

use super::engine::Refinement;
use super::event::{Event, InsertedKind};
use super::outlook::Outlook;
use super::recipe::Recipe;
use super::stopwatch::{Clock, StepTimes};
use crate::constrained::ConstrainedTriangulation;
use crate::drawing::SegmentId;

/// Why a triangle stayed bad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Reason {
    /// Its small angle lies between two input segments that meet; or it lies between two that meet and are within
    /// rounding of each other there. Segments meet at common ends, where one has a vertex inside it, and where they
    /// cross.
    InputAngle,
    /// Its shortest edge joins two segments that meet, at an angle below the bound, as far from their common end on one
    /// as on the other. Where the edge joins vertices of the input, those are within rounding of each other.
    AcrossSmallInputAngle,
    /// Two vertices of the input, a vertex and a segment, or two segments are within rounding of each other. It lies
    /// across that gap, where no vertex fits; or the split or the vertex that it needs has no room beside the gap.
    InputGap,
    /// A segment that may not be split is in the way.
    ProtectedSegment,
    /// Rounding leaves no room for another vertex.
    PrecisionFloor,
    /// A new vertex would be closer to another than the length floor asked for.
    SizeFloor,
    /// The vertex budget was used up.
    Budget,
    /// The caller cancelled.
    Cancelled,
    /// The strategy has no point that would improve it.
    StrategyCannotImprove,
    /// The order is `manual`, and it was not picked.
    NotPicked,
}

impl Reason {
    /// Every reason.
    pub const ALL: [Self; 10] = [
        Self::InputAngle,
        Self::AcrossSmallInputAngle,
        Self::InputGap,
        Self::ProtectedSegment,
        Self::PrecisionFloor,
        Self::SizeFloor,
        Self::Budget,
        Self::Cancelled,
        Self::StrategyCannotImprove,
        Self::NotPicked,
    ];

    /// The reason in words, as reports and JSON spell it.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::InputAngle => "input angle",
            Self::AcrossSmallInputAngle => "across a small input angle",
            Self::InputGap => "input gap",
            Self::ProtectedSegment => "protected segment",
            Self::PrecisionFloor => "precision floor",
            Self::SizeFloor => "size floor",
            Self::Budget => "budget",
            Self::Cancelled => "cancelled",
            Self::StrategyCannotImprove => "strategy cannot improve",
            Self::NotPicked => "not picked",
        }
    }

    /// Whether the input itself forces it, so that no refinement could do better.
    #[must_use]
    pub const fn is_forced(self) -> bool {
        matches!(self, Self::InputAngle | Self::AcrossSmallInputAngle | Self::InputGap)
    }
}

serialized_by_key!(Reason, StopReason);

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.key())
    }
}

/// Why a refinement ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum StopReason {
    /// No triangle was left that could be treated.
    #[default]
    Finished,
    /// The vertex budget was used up.
    Budget,
    /// The caller cancelled.
    Cancelled,
    /// At an angle bound above 33 degrees, with at least twenty times the vertices of the forecast, the last doubling
    /// of the vertices left no fewer bad triangles: more vertices would only make more of them.
    NoLongerImproves,
}

impl StopReason {
    /// Every reason.
    pub const ALL: [Self; 4] = [Self::Finished, Self::Budget, Self::Cancelled, Self::NoLongerImproves];

    /// The reason in words, as JSON spells it.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Finished => "finished",
            Self::Budget => "budget",
            Self::Cancelled => "cancelled",
            Self::NoLongerImproves => "no longer improves",
        }
    }
}

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

/// What came of a refinement.
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
    /// Input segments that are no chains of edges in the mesh: only where the recipe lets them go and does not recover
    /// them.
    pub lost_segments: Vec<SegmentId>,
    /// Why it ended.
    pub stop: StopReason,
    /// Edges flipped before the first insertion, to make a given mesh Delaunay.
    pub edges_flipped: u64,
    /// Points inserted inside triangles.
    pub points_inserted: u64,
    /// Points taken back because they encroached upon a segment.
    pub points_rejected: u64,
    /// Subsegments split.
    pub segments_split: u64,
    /// Both together by kind, in the order of [`InsertedKind::ALL`]; with their names:
    /// [`insertions`](Self::insertions).
    pub inserted: [u64; 4],
    /// Lengths of longest-edge propagation paths that the strategy followed: how many had 0, 1, 2, … triangles.
    pub lepp_lengths: Vec<u64>,
    /// Edges flipped instead of inserting a point, by strategies that do.
    pub flips_instead: u64,
    /// Free vertices deleted before a split.
    pub vertices_deleted: u64,
    /// How long each step took, where the caller gave a clock.
    pub step_times: Option<StepTimes>,
}

impl Report {
    /// Whether every leftover is forced by the input, and no segment was lost.
    #[must_use]
    pub fn complete(&self) -> bool {
        self.leftovers.iter().all(|l| l.reason.is_forced()) && self.lost_segments.is_empty()
    }

    /// How many vertices went in of each kind; those that were deleted later are counted, those taken back at once are
    /// not.
    #[must_use]
    pub fn insertions(&self) -> [(InsertedKind, u64); 4] {
        std::array::from_fn(|i| (InsertedKind::ALL[i], self.inserted[i]))
    }

    /// How many triangles stayed bad for each reason that occurs.
    #[must_use]
    pub fn reasons(&self) -> Vec<(Reason, usize)> {
        Reason::ALL
            .into_iter()
            .map(|r| (r, self.leftovers.iter().filter(|l| l.reason == r).count()))
            .filter(|&(_, n)| n > 0)
            .collect()
    }
}

/// How far a refinement has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Vertices so far.
    pub vertices: usize,
    /// Bad triangles known to be waiting; some of them may be gone already.
    pub waiting: usize,
    /// The vertex budget.
    pub max_vertices: usize,
}

/// Watches a refinement.
pub trait Observer {
    /// Called before the first step and then at least once in every 256 steps and insertions; `false` cancels.
    fn progress(&mut self, progress: Progress) -> bool;

    /// A clock to measure the steps by; none, and nothing is measured.
    fn clock(&self) -> Option<Clock> {
        None
    }

    /// Whether it wants the outlook, which costs about a tenth of the work.
    fn wants_outlook(&self) -> bool {
        false
    }

    /// Called by [`mesh_with`](crate::mesh_with) before the refinement begins.
    fn outlook(&mut self, _outlook: &Outlook) {}

    /// Called by [`mesh_with`](crate::mesh_with) and [`refine_mesh_with`](crate::refine_mesh_with) before the first
    /// step: here triangles can be [picked](Refinement::pick).
    fn begins(&mut self, _refinement: &mut Refinement) {}

    /// Whether it wants to know of every step.
    fn wants_events(&self) -> bool {
        false
    }

    /// Called after every step, if it is wanted, with the triangulation as it is then.
    fn event(&mut self, _event: &Event, _cdt: &ConstrainedTriangulation) {}
}

/// Watches nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoObserver;

impl Observer for NoObserver {
    fn progress(&mut self, _: Progress) -> bool {
        true
    }
}

impl<F: FnMut(Progress) -> bool> Observer for F {
    fn progress(&mut self, progress: Progress) -> bool {
        self(progress)
    }
}
