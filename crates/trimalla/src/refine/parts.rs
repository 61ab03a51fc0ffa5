//! What a refinement consists of: the question, the way to answer it, what is to be done, and what was done.

use std::collections::{BTreeSet, VecDeque};
use std::fmt;

use super::bad_triangles::Test;
use super::encroachment::Region;
use super::event::Event;
use super::history::Picked;
use super::improvement::Improvement;
use super::joints::Joints;
use super::mirror::has_small_wedge;
use super::opening::Opening;
use super::options::RefineOptions;
use super::queue::{Claim, Queue};
use super::report::{Reason, Report};
use super::ruler::Ruler;
use super::s5_recover::UnderWay;
use super::split_segments::Encroached;
use super::steps::{InsertStep, Proposal, StepFacts, Steps, View};
use super::stopwatch::Stopwatch;
use crate::constrained::{ConstrainedTriangulation, Released, Workspace};
use crate::delaunay::{Cavity, Lawson};
use crate::geometry::BoundingBox;
use crate::half_edge::{HalfEdgeId, UndoLog, VertexId};

/// Bisection may shorten the shortest edge of the input by this factor for the sake of angles.
const BISECTIONS: f64 = 4.0;

/// What is asked, and what of the input answers depend on. It stays as it is while points go in.
#[derive(Clone)]
pub(super) struct Problem {
    pub(super) options: RefineOptions,
    /// What makes a triangle bad.
    pub(super) test: Test,
    /// What encroaches upon a subsegment.
    pub(super) region: Region,
    pub(super) ruler: Ruler,
    pub(super) floors: Floors,
    /// Where segments are split into pieces.
    pub(super) joints: Joints,
    /// Whether pieces meet at so small an angle somewhere that splits mirror the vertices of other pieces.
    pub(super) has_small_wedge: bool,
}

impl Problem {
    pub(super) fn new(cdt: &ConstrainedTriangulation, options: RefineOptions, insert: &dyn InsertStep) -> Self {
        let ruler = Ruler::for_box(cdt.bounding_box());
        Self {
            test: Test::new(&options.criteria, cdt),
            region: Region::new(options.recipe.encroachment, &options.criteria),
            floors: Floors::of(cdt, &options, ruler, insert),
            joints: Joints::of(cdt),
            has_small_wedge: has_small_wedge(cdt, ruler),
            ruler,
            options,
        }
    }
}

/// The shortest lengths.
#[derive(Clone, Copy, Debug)]
pub(super) struct Floors {
    /// The square of the shortest distance allowed between vertices, in the ruler's units.
    pub(super) floor_sq: f64,
    /// What a distance below it is called.
    pub(super) floor_reason: Reason,
    /// The square of the shortest distance at which rounding leaves room, in the ruler's units: the floor or less.
    pub(super) precision_sq: f64,
    /// That distance in coordinate units.
    pub(super) precision: f64,
    /// Bisection stops at triangles with an edge shorter than this, squared; 0 for a step 4 that does not keep small angles.
    pub(super) bisection_floor_sq: f64,
}

impl Floors {
    fn of(cdt: &ConstrainedTriangulation, options: &RefineOptions, ruler: Ruler, insert: &dyn InsertStep) -> Self {
        let bounds = cdt.bounding_box();
        let (floor, floor_reason) = length_floor(bounds, options, ruler);
        let precision = precision_floor(bounds, ruler);
        let floors = Self {
            floor_sq: floor * floor,
            floor_reason,
            precision_sq: precision * precision,
            precision: precision / ruler.scale(),
            bisection_floor_sq: 0.0,
        };
        floors.for_insert(cdt, ruler, insert)
    }

    /// The same for that step 4.
    ///
    /// Edges that are shorter than rounding leaves room for do not count.
    pub(super) fn for_insert(self, cdt: &ConstrainedTriangulation, ruler: Ruler, insert: &dyn InsertStep) -> Self {
        if !insert.keeps_small_angles() {
            return Self { bisection_floor_sq: 0.0, ..self };
        }
        let length_sq = |h: HalfEdgeId| {
            let [a, b] = cdt.edge_points(h);
            ruler.length_sq(a, b)
        };
        let lengths = cdt.edges().map(length_sq).filter(|&length_sq| length_sq >= self.precision_sq);
        let shortest_sq = lengths.fold(f64::INFINITY, f64::min);
        Self { bisection_floor_sq: shortest_sq / (BISECTIONS * BISECTIONS), ..self }
    }
}

/// The length floor in the ruler's units, and the reason it is given as.
pub(super) fn length_floor(bounds: Option<BoundingBox>, options: &RefineOptions, ruler: Ruler) -> (f64, Reason) {
    let precision = precision_floor(bounds, ruler);
    match options.limits.length_floor {
        Some(asked) if asked * ruler.scale() > precision => (asked * ruler.scale(), Reason::SizeFloor),
        _ => (precision, Reason::PrecisionFloor),
    }
}

/// The shortest distance at which rounding leaves room for vertices, in the ruler's units.
pub(super) fn precision_floor(bounds: Option<BoundingBox>, ruler: Ruler) -> f64 {
    let largest = bounds.map_or(0.0, BoundingBox::largest_coordinate);
    largest * ruler.scale() * 256.0 * f64::EPSILON
}

/// How it is answered: the five steps, and what they say of themselves.
#[derive(Clone)]
pub(super) struct Strategy {
    pub(super) steps: Steps,
    pub(super) facts: StepFacts,
    /// Whether the caller picks.
    pub(super) is_manual: bool,
    /// Whether step 3 is of the library: what it proposes inside a face was found there by a walk.
    pub(super) walks_prove_places: bool,
    /// How many triangles a walk may cross.
    pub(super) longest_walk: usize,
}

impl Strategy {
    pub(super) fn of(steps: Steps) -> Self {
        Self {
            facts: StepFacts::of(steps.select.as_ref(), steps.point.as_ref(), steps.insert.as_ref()),
            is_manual: steps.select.is_manual(),
            walks_prove_places: false,
            longest_walk: View::longest_walk(steps.insert.as_ref()),
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
    pub(super) joined: u64,
    /// The triangle to be treated until it is gone.
    pub(super) current: Option<Claim>,
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
    pub(super) recovery: Option<Box<UnderWay>>,
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
    /// Whether it still improves, where that is watched.
    pub(super) improvement: Improvement,
    /// What the step at work did, where somebody wants to know.
    pub(super) event: Option<Box<Event>>,
    /// Steps of runs that an observer was shown.
    pub(super) steps_told: u64,
    /// Time per step.
    pub(super) stopwatch: Stopwatch,
}

impl Ledger {
    pub(super) fn new(options: &RefineOptions, vertices: usize, stopwatch: Stopwatch) -> Self {
        Self {
            report: Report { recipe: options.recipe, ..Report::default() },
            vertices,
            insertions: 0,
            improvement: Improvement::UNWATCHED,
            event: None,
            steps_told: 0,
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
    /// The faces that the vertex at work replaces.
    pub(super) cavity: Cavity,
    /// Places proposed for the triangle at work.
    pub(super) places: Vec<Proposal>,
    /// The star of the vertex at work.
    pub(super) spokes: Vec<HalfEdgeId>,
    /// The numbers of the bad triangles of a fan.
    pub(super) bad_in_fan: Vec<usize>,
    /// The subsegments beside what is looked at.
    pub(super) beside: Vec<HalfEdgeId>,
}
