//! The parts of a refinement: the problem, the strategy, the agenda, the work on segments, the ledger and the scratch.

use std::collections::{BTreeSet, VecDeque};
use std::fmt;
use std::sync::Arc;

use super::encroached::Encroached;
use crate::constrained::{ConstrainedTriangulation, Recovery, Released, Workspace};
use crate::delaunay::{Cavity, Lawson};
use crate::geometry::BoundingBox;
use crate::half_edge::{EdgeKey, FaceId, HalfEdgeId, TriangleKey, UndoLog, VertexId};
use crate::refine::agenda::queue::{Queue, Ticket};
use crate::refine::criteria::bad_triangles::{Criterion, UserTest};
use crate::refine::criteria::encroachment::Region;
use crate::refine::criteria::floors::Floors;
use crate::refine::criteria::reason::Reason;
use crate::refine::measure::joints::{Joints, Piece, marked_edges};
use crate::refine::measure::mirror::has_small_wedge;
use crate::refine::measure::ruler::Ruler;
use crate::refine::recipe::Initial;
use crate::refine::recipe::options::RefineOptions;
use crate::refine::steps::{InsertTraits, Places, StepTraits, Steps, View};
use crate::refine::watch::event::Event;
use crate::refine::watch::report::Report;
use crate::refine::watch::stopwatch::Stopwatch;
use crate::size::{SizeBounds, SizeField};

/// A triangle, by its slot and its vertices.
pub(super) type Picked = (FaceId, TriangleKey);

/// The options, and what is derived from them and from the input. It does not change while points are inserted.
#[derive(Clone)]
pub(super) struct Problem {
    pub(super) options: RefineOptions,
    /// What makes a triangle bad.
    pub(super) test: Criterion,
    /// What encroaches upon a subsegment.
    pub(super) region: Region,
    /// The bounding box of the vertices; inserted points lie in it.
    pub(super) bounds: Option<BoundingBox>,
    pub(super) ruler: Ruler,
    pub(super) floors: Floors,
    /// Where segments are split into pieces.
    pub(super) joints: Joints,
    /// Whether two pieces meet at an angle so small that splits mirror the vertices of other pieces.
    pub(super) has_small_wedge: bool,
    /// Whether a given mesh is refined as it is, although edges may fail the circle test.
    pub(super) is_as_given: bool,
}

impl Problem {
    pub(super) fn new(
        (cdt, is_delaunay): (&ConstrainedTriangulation, bool),
        fields: Vec<Arc<dyn SizeField>>,
        options: RefineOptions,
        insert: InsertTraits,
    ) -> Self {
        let bounds = cdt.bounding_box();
        let ruler = Ruler::for_box(bounds);
        let marked = marked_edges(cdt);
        let size = SizeBounds::new(options.criteria.max_area, cdt, fields);
        Self {
            test: Criterion::new(&options.criteria, size),
            region: Region::new(options.recipe.encroachment, &options.criteria),
            floors: Floors::of((cdt, bounds), &options, ruler, insert),
            joints: Joints::along(cdt, &marked),
            has_small_wedge: has_small_wedge(cdt, &marked, ruler),
            is_as_given: !is_delaunay && options.recipe.initial == Initial::Given,
            bounds,
            ruler,
            options,
        }
    }

    /// The problem with this test of the caller's own in place of the one before, if there is one.
    pub(super) fn with_user_test(self, test: Option<Arc<UserTest>>) -> Self {
        Self { test: self.test.with_user_test(test), ..self }
    }

    /// The view of a triangulation that the steps get.
    #[inline(always)] // Several times for each triangle treated.
    pub(super) fn view<'a>(&'a self, cdt: &'a ConstrainedTriangulation, strategy: &Strategy) -> View<'a> {
        View {
            cdt,
            criteria: &self.options.criteria,
            size: self.test.size(),
            ruler: self.ruler,
            longest_walk: strategy.longest_walk,
        }
    }
}

/// The five steps with their traits.
#[derive(Clone)]
pub(super) struct Strategy {
    pub(super) steps: Steps,
    pub(super) traits: StepTraits,
    /// Whether step 3 is the library's own: a walk has then proved that its proposals inside a face lie there.
    pub(super) walks_prove_places: bool,
    /// The number of triangles that a walk may cross.
    pub(super) longest_walk: usize,
}

impl Strategy {
    pub(super) fn of(steps: Steps) -> Self {
        let traits = StepTraits::of(&steps);
        Self {
            traits,
            walks_prove_places: false,
            longest_walk: View::longest_walk(traits.insert.keeps_delaunay),
            steps,
        }
    }
}

impl fmt::Debug for Strategy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Strategy").finish_non_exhaustive()
    }
}

/// What is queued, and what has been given up.
#[derive(Clone, Default)]
pub(super) struct Agenda {
    /// Bad triangles.
    pub(super) queue: Queue,
    /// The number of triangles that have been queued so far.
    pub(super) sequence: u64,
    /// The triangle that is treated until it is destroyed.
    pub(super) current: Option<Ticket>,
    /// Triangles that the caller picked.
    pub(super) picked: VecDeque<Picked>,
    /// Subsegments queued for their split.
    pub(super) encroached: VecDeque<Encroached>,
    /// Subsegments whose split failed although it was possible when they were queued.
    pub(super) unsplittable: BTreeSet<EdgeKey>,
    /// Triangles that were given up, and why.
    pub(super) given_up: Vec<(TriangleKey, Reason)>,
    /// The number of insertions and deletions at the last retry.
    pub(super) changes_at_retry: u64,
    pub(super) retries: u32,
}

/// The work on segments before the loop, between its steps and after it: which are released, and which are being
/// recovered.
#[derive(Clone, Default)]
pub(super) struct SegmentWork {
    /// The current stage before the loop.
    pub(super) opening: Opening,
    /// Edges that fail the circle test before the loop begins, or may fail it.
    pub(super) illegal: Lawson,
    /// The released pieces: segments that are not locked.
    pub(super) released: Vec<Released>,
    /// The recovery of released pieces under way.
    pub(super) recovery: Option<Box<RunningRecovery>>,
    /// Released pieces that could not be recovered.
    pub(super) lost: Vec<Released>,
}

/// What was done, counted and measured.
#[derive(Clone)]
pub(super) struct Ledger {
    pub(super) report: Report,
    /// The present number of vertices.
    pub(super) vertices: usize,
    /// The number of insertions so far, those of vertices that were deleted or taken back included.
    pub(super) insertions: u64,
    /// The vertex inserted last for the current triangle, if any.
    pub(super) newest: Option<VertexId>,
    /// When the bad triangles are counted next, if they are counted.
    pub(super) improvement: Improvement,
    /// The event of the current step, if events are recorded.
    pub(super) event: Option<Box<Event>>,
    /// The number of steps of runs whose events an observer got.
    pub(super) steps_observed: u64,
    /// Time per step.
    pub(super) stopwatch: Stopwatch,
}

impl Ledger {
    pub(super) fn new(options: &RefineOptions, vertices: usize, stopwatch: Stopwatch) -> Self {
        Self {
            report: Report { recipe: options.recipe, ..Report::default() },
            vertices,
            insertions: 0,
            newest: None,
            improvement: Improvement::UNWATCHED,
            event: None,
            steps_observed: 0,
            stopwatch,
        }
    }
}

/// Scratch lists, reused from step to step.
#[derive(Clone, Default)]
pub(super) struct Scratch {
    /// The workspace of operations on the triangulation.
    pub(super) work: Workspace,
    /// What the current step has overwritten.
    pub(super) log: UndoLog,
    /// Whether the current step is recorded, so that it can be taken back.
    pub(super) is_recorded: bool,
    /// The faces that the current vertex replaces.
    pub(super) cavity: Cavity,
    /// The places proposed for the current triangle.
    pub(super) places: Places,
    /// Faces that step 4 plans to replace.
    pub(super) planned: Vec<FaceId>,
    /// The star of the current vertex.
    pub(super) spokes: Vec<HalfEdgeId>,
    /// The numbers of the bad triangles of a fan.
    pub(super) bad_in_fan: Vec<usize>,
    /// The subsegments at the faces that are tested.
    pub(super) beside: Vec<HalfEdgeId>,
}

/// The stages before the loop.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Opening {
    /// Edges of a given mesh are to be flipped until it passes the circle test.
    #[default]
    Given,
    /// Edges of the given mesh are being flipped.
    Legalising,
    /// Segments inside the domain are to be released.
    Release,
    /// Segments are released; edges are being flipped.
    Releasing,
    /// Released segments are to be split until they are chains of edges.
    Conform,
    /// The split segments are to be released again.
    ReleaseAgain,
    /// Segments are released again; edges are being flipped.
    ReleasingAgain,
    /// All triangles and subsegments are to be tested.
    Test,
    /// Step 1 changes the triangulation.
    Prepare,
    /// The loop has begun.
    Done,
}

/// A recovery of segments under way, with the pieces of all segments, which do not change meanwhile.
#[derive(Clone, Debug)]
pub(super) struct RunningRecovery {
    pub(super) recovery: Recovery,
    /// [All pieces](Joints::pieces).
    pub(super) pieces: Vec<Piece>,
}

/// When the bad triangles are counted next, and the last count.
#[derive(Clone, Copy, Debug)]
pub(super) struct Improvement {
    /// The number of vertices at which the count is due.
    pub(super) due: usize,
    pub(super) bad: usize,
}

impl Improvement {
    /// Bad triangles are not counted.
    pub(super) const UNWATCHED: Self = Self { due: usize::MAX, bad: usize::MAX };

    /// Whether a count is due.
    #[inline]
    pub(super) fn is_due(self, vertices: usize) -> bool {
        vertices >= self.due
    }
}
