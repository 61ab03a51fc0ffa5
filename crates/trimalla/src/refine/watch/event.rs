//! Events: what a step did, with everything that a picture of the step needs.
//!
//! Events are recorded for steps made one by one, and for observers that want them; other runs record none.

use crate::geometry::Point;
use crate::half_edge::VertexId;
use crate::refine::criteria::badness::Badness;
use crate::refine::criteria::reason::Reason;

/// What one step did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StepOutcome {
    /// A queued subsegment was split.
    SubsegmentSplit,
    /// A queued subsegment is left whole: it no longer needs the split, or is no longer there.
    SubsegmentKept,
    /// A queued subsegment needs the split, and there is no room for it.
    SubsegmentRefused,
    /// A node of the lattice was tested, and inserted if there was room.
    Filled,
    /// A bad triangle was treated: a point was inserted, subsegments were queued, or it was given up.
    Triangle,
    /// A slice of the stages before the loop was done.
    Prepared,
    /// Released segments, or some of them, were recovered.
    Recovered,
    /// Triangles for which there was no room were queued again, since there may be room now.
    Retried,
    /// Nothing is left to do.
    #[default]
    Finished,
    /// The vertex budget is used up.
    Exhausted,
    /// More vertices leave no fewer bad triangles: see
    /// [`StopReason::NoLongerImproves`](crate::refine::StopReason::NoLongerImproves).
    Stalled,
}

impl StepOutcome {
    /// Whether no step follows: nothing is left to do, or a limit is met.
    #[must_use]
    pub const fn is_last(self) -> bool {
        matches!(self, Self::Finished | Self::Exhausted | Self::Stalled)
    }

    /// The outcome in a word or two, as the program prints it.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Prepared => "prepared",
            Self::SubsegmentSplit => "subsegment split",
            Self::SubsegmentKept => "subsegment kept",
            Self::SubsegmentRefused => "subsegment refused",
            Self::Filled => "filled",
            Self::Triangle => "triangle",
            Self::Recovered => "recovered",
            Self::Retried => "retried",
            Self::Finished => "finished",
            Self::Exhausted => "exhausted",
            Self::Stalled => "stalled",
        }
    }
}

/// Where a new vertex lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InsertedKind {
    /// Free, inside a face or exactly on an unconstrained edge.
    Free,
    /// On an unconstrained edge, but for its rounding.
    OnEdge,
    /// In the middle of a subsegment.
    SegmentMiddle,
    /// On a subsegment, on a circle around an end where segments meet.
    Shell,
}

impl InsertedKind {
    /// Every kind.
    pub const ALL: [Self; 4] = [Self::Free, Self::OnEdge, Self::SegmentMiddle, Self::Shell];

    /// In words.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Free => "free",
            Self::OnEdge => "on edge",
            Self::SegmentMiddle => "segment middle",
            Self::Shell => "shell",
        }
    }
}

/// A place that step 3 proposed and the loop tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// The point; `None` for the split of a subsegment that was in the way.
    pub point: Option<Point>,
    /// The subsegment that was in the way, or the edge on which the point lies.
    pub edge: Option<[VertexId; 2]>,
    /// Why it was refused; `None` if it was accepted, or a subsegment is split instead.
    pub refused: Option<Reason>,
}

/// A vertex that was inserted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InsertedVertex {
    /// The vertex.
    pub vertex: VertexId,
    /// Its position.
    pub point: Point,
    /// What kind of place that is.
    pub kind: InsertedKind,
}

/// Three vertices of a triangle, in ascending order.
pub type Name = [VertexId; 3];

/// What a step did.
///
/// One field for each kind of change that a step may make; most are empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Event {
    /// The number of the step, from 1.
    pub number: u64,
    /// How it ended.
    pub outcome: StepOutcome,
    /// The subsegment that was tested, lower vertex first.
    pub subsegment: Option<[VertexId; 2]>,
    /// The triangle that was selected, and what is wrong with it: `None` if a good one was picked.
    pub selected: Option<(Name, Option<Badness>)>,
    /// Its longest-edge propagation path, itself first.
    pub lepp: Vec<Name>,
    /// The terminal edge of that path.
    pub terminal_edge: Option<[VertexId; 2]>,
    /// The places tried, in order.
    pub candidates: Vec<Candidate>,
    /// Subsegments that the point would have encroached upon.
    pub encroached: Vec<[VertexId; 2]>,
    /// The inserted vertex.
    pub inserted: Option<InsertedVertex>,
    /// Free vertices that were deleted before the insertion, with their positions.
    pub deleted: Vec<(VertexId, Point)>,
    /// Why the triangle was given up.
    pub given_up: Option<Reason>,
    /// Triangles that the step destroyed, ascending.
    pub destroyed: Vec<Name>,
    /// Triangles that the step made, ascending.
    pub made: Vec<Name>,
}

impl Event {
    /// Why the selected triangle was selected, in words: what is wrong with it, or that a good one was picked.
    #[must_use]
    pub fn why(&self) -> Option<&'static str> {
        self.selected.map(|(_, badness)| badness.map_or("picked", Badness::key))
    }
}
