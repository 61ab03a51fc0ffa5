//! What a refinement consists of: the question, the way to answer it, what is to be done, and what was done.

use std::collections::{BTreeSet, VecDeque};
use std::fmt;
use std::sync::Arc;

use super::encroached::Encroached;
use crate::constrained::{ConstrainedTriangulation, Recovery, Released, Workspace};
use crate::delaunay::{Cavity, Lawson};
use crate::geometry::BoundingBox;
use crate::half_edge::{FaceId, HalfEdgeId, UndoLog, VertexId};
use crate::refine::agenda::queue::{Queue, Ticket};
use crate::refine::criteria::bad_triangles::Criterion;
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

/// A triangle, by its slot and its sorted vertices.
pub(super) type Picked = (FaceId, [VertexId; 3]);

/// What is asked, and what of the input answers depend on. It stays as it is while points go in.
#[derive(Clone)]
pub(super) struct Problem {
    pub(super) options: RefineOptions,
    /// What makes a triangle bad.
    pub(super) test: Criterion,
    /// What encroaches upon a subsegment.
    pub(super) region: Region,
    /// The box around the vertices, which no point leaves that goes in.
    pub(super) bounds: Option<BoundingBox>,
    pub(super) ruler: Ruler,
    pub(super) floors: Floors,
    /// Where segments are split into pieces.
    pub(super) joints: Joints,
    /// Whether pieces meet at so small an angle somewhere that splits mirror the vertices of other pieces.
    pub(super) has_small_wedge: bool,
    /// Whether a mesh is refined as it was given, although edges may fail the circle test.
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
}

impl Problem {
    /// What the steps are shown of a triangulation.
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

/// How it is answered: the five steps, and what they say of themselves.
#[derive(Clone)]
pub(super) struct Strategy {
    pub(super) steps: Steps,
    pub(super) traits: StepTraits,
    /// Whether step 3 is of the library: what it proposes inside a face was found there by a walk.
    pub(super) walks_prove_places: bool,
    /// How many triangles a walk may cross.
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

    /// The same strategy after one of its steps has been exchanged.
    pub(super) fn renewed(self) -> Self {
        let walks_prove_places = self.walks_prove_places;
        Self { walks_prove_places, ..Self::of(self.steps) }
    }
}

impl fmt::Debug for Strategy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Strategy").finish_non_exhaustive()
    }
}

/// What is to be done, and what cannot be.
#[derive(Clone, Default)]
pub(super) struct Agenda {
    /// Bad triangles.
    pub(super) queue: Queue,
    /// How many triangles joined the queue.
    pub(super) sequence: u64,
    /// The triangle to be treated until it is gone.
    pub(super) current: Option<Ticket>,
    /// Triangles that the caller picked.
    pub(super) picked: VecDeque<Picked>,
    /// Subsegments that wait for their split.
    pub(super) encroached: VecDeque<Encroached>,
    /// Subsegments whose split failed although it had seemed possible.
    pub(super) unsplittable: BTreeSet<[VertexId; 2]>,
    /// Triangles that were given up, and why.
    pub(super) given_up: Vec<([VertexId; 3], Reason)>,
    /// How many vertices had come and gone at the last retry of those.
    pub(super) changes_at_retry: u64,
    pub(super) retries: u32,
}

/// The work on segments before the loop, between and after: what was let go, and what is on its way back.
#[derive(Clone, Default)]
pub(super) struct SegmentWork {
    /// What comes before the loop, as far as it is not done.
    pub(super) opening: Opening,
    /// Edges that fail the circle test before the loop begins, or may.
    pub(super) illegal: Lawson,
    /// Pieces of segments that are not locked.
    pub(super) released: Vec<Released>,
    /// Such pieces on their way back.
    pub(super) recovery: Option<Box<RunningRecovery>>,
    /// Pieces that could not come back.
    pub(super) lost: Vec<Released>,
}

/// What was done, counted and measured.
#[derive(Clone)]
pub(super) struct Ledger {
    pub(super) report: Report,
    /// Vertices that the mesh would have now.
    pub(super) vertices: usize,
    /// Vertices inserted in all, those deleted or taken back included.
    pub(super) insertions: u64,
    /// The vertex inserted last for the triangle at work, if any was.
    pub(super) newest: Option<VertexId>,
    /// Whether it still improves, where that is watched.
    pub(super) improvement: Improvement,
    /// What the step at work did, where somebody wants to know.
    pub(super) event: Option<Box<Event>>,
    /// Steps of runs that an observer was shown.
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

/// Lists that a step works with, kept from one to the next.
#[derive(Clone, Default)]
pub(super) struct Scratch {
    /// What changing the triangulation takes.
    pub(super) work: Workspace,
    /// What the step at work has overwritten.
    pub(super) log: UndoLog,
    /// Whether the step at work is recorded, so that it can be taken back.
    pub(super) is_recorded: bool,
    /// The faces that the vertex at work replaces.
    pub(super) cavity: Cavity,
    /// Places proposed for the triangle at work.
    pub(super) places: Places,
    /// Faces that step 4 plans to replace.
    pub(super) planned: Vec<FaceId>,
    /// The star of the vertex at work.
    pub(super) spokes: Vec<HalfEdgeId>,
    /// The numbers of the bad triangles of a fan.
    pub(super) bad_in_fan: Vec<usize>,
    /// The subsegments beside what is looked at.
    pub(super) beside: Vec<HalfEdgeId>,
}

/// What is to be done next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Opening {
    /// A mesh that was given is to be flipped until it passes the circle test.
    #[default]
    Given,
    /// Its edges are being flipped.
    Legalising,
    /// Segments inside are to be let go.
    Release,
    /// They are gone, and edges across them are being flipped.
    Releasing,
    /// They are to be split until they are edges.
    Conform,
    /// They were split, and are to be let go again.
    ReleaseAgain,
    /// They are gone again, and edges across them are being flipped.
    ReleasingAgain,
    /// Everything is to be looked at.
    Test,
    /// Step 1 changes the triangulation.
    Prepare,
    /// The loop is on.
    Done,
}

/// Segments on their way back, and the pieces of all segments, which stay what they are meanwhile.
#[derive(Clone, Debug)]
pub(super) struct RunningRecovery {
    pub(super) recovery: Recovery,
    /// [All pieces](Joints::pieces).
    pub(super) pieces: Vec<Piece>,
}

/// When bad triangles are counted next, and how many there were the last time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Improvement {
    /// The count is due when the mesh has so many vertices.
    pub(super) due: usize,
    pub(super) bad: usize,
}

impl Improvement {
    /// Nothing is watched.
    pub(super) const UNWATCHED: Self = Self { due: usize::MAX, bad: usize::MAX };

    /// Whether a count is due.
    #[inline]
    pub(super) fn is_due(self, vertices: usize) -> bool {
        vertices >= self.due
    }
}
