//! The refinement loop.

use std::collections::{BTreeSet, VecDeque};
use std::fmt;
use std::sync::Arc;

use super::bad_triangles::{Asked, Test, UserTest, sorted};
use super::encroachment::Region;
use super::event::Event;
use super::fill::FillStage;
use super::history::{History, Picked};
use super::improvement::Improvement;
use super::joints::Joints;
use super::mirror::has_small_wedge;
use super::opening::Opening;
use super::options::{OptionError, RefineOptions};
use super::queue::{Claim, Patches, Queue};
use super::report::{Observer, Progress, Reason, Report, StopReason};
use super::ruler::Ruler;
use super::s5_recover::UnderWay;
use super::split_segments::Encroached;
use super::start::Start;
use super::steps::{InsertStep, PointStep, PrepareStep, Proposal, RecoverStep, SelectStep, StepFacts, Steps, View};
use super::stopwatch::{Clock, Part, Stopwatch};
use crate::constrained::{ConstrainedTriangulation, Edit, Released, Workspace};
use crate::delaunay::{Cavity, Lawson, max_points};
use crate::geometry::BoundingBox;
use crate::half_edge::{FaceId, HalfEdgeId, NoJournal, UndoLog, VertexId};

/// Bisection may shorten the shortest edge of the input by this factor for the sake of angles.
const BISECTIONS: f64 = 4.0;
/// No more rounds than this for triangles that had no room.
const MOST_RETRIES: u32 = 64;
/// Steps and insertions between two calls of the observer.
const PROGRESS_EVERY: u64 = 128;

/// A refinement under way.
///
/// # Guarantees
/// Input vertices are neither moved nor removed, input segments stay chains of edges, and the triangulation is
/// constrained Delaunay after every step. The same input and options give the same mesh, whatever algorithm built
/// the triangulation.
#[derive(Clone)]
pub struct Refinement {
    pub(super) cdt: ConstrainedTriangulation,
    /// What changing it takes.
    pub(super) work: Workspace,
    /// The faces that the vertex at work replaces.
    pub(super) cavity: Cavity,
    pub(super) options: RefineOptions,
    pub(super) prepare: Arc<dyn PrepareStep + Send + Sync>,
    pub(super) select: Arc<dyn SelectStep + Send + Sync>,
    /// Whether the caller picks.
    pub(super) is_manual: bool,
    pub(super) point: Arc<dyn PointStep + Send + Sync>,
    /// Whether step 3 is of the library: what it proposes inside a face was found there by a walk.
    pub(super) walks_prove_places: bool,
    pub(super) facts: StepFacts,
    pub(super) insert: Arc<dyn InsertStep + Send + Sync>,
    pub(super) recover: Arc<dyn RecoverStep + Send + Sync>,
    pub(super) region: Region,
    pub(super) ruler: Ruler,
    pub(super) test: Test,
    /// Where segments are parted into pieces.
    pub(super) joints: Joints,
    /// Whether pieces meet at so small an angle somewhere that splits mirror the vertices of other pieces.
    pub(super) has_small_wedge: bool,
    /// How many triangles a walk may cross.
    pub(super) longest_walk: usize,
    /// The square of the shortest distance allowed between vertices, in the ruler's units.
    pub(super) floor_sq: f64,
    /// The square of the shortest distance at which rounding leaves room, in the ruler's units: the floor or less.
    pub(super) precision_sq: f64,
    /// That distance in coordinate units.
    pub(super) precision: f64,
    /// What a distance below the floor is called.
    pub(super) floor_reason: Reason,
    /// Bisection stops at triangles with an edge shorter than this, squared.
    pub(super) bisection_floor_sq: f64,
    pub(super) filling: FillStage,
    pub(super) queue: Queue,
    pub(super) encroached: VecDeque<Encroached>,
    /// Subsegments whose split failed although it had seemed possible.
    pub(super) unsplittable: BTreeSet<[VertexId; 2]>,
    /// Triangles that were given up, and why.
    pub(super) given_up: Vec<([VertexId; 3], Reason)>,
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
    /// Places proposed for the triangle at work.
    pub(super) places: Vec<Proposal>,
    pub(super) log: UndoLog,
    /// The star of the vertex at work.
    pub(super) spokes: Vec<HalfEdgeId>,
    /// Room for the numbers of the bad triangles of a fan.
    pub(super) bad_in_fan: Vec<usize>,
    /// Room for the subsegments beside what is looked at.
    pub(super) beside: Vec<HalfEdgeId>,
    /// Whether it still improves, where that is watched.
    pub(super) improvement: Improvement,
    /// How many triangles joined the queue.
    pub(super) joined: u64,
    /// The triangle to be treated until it is gone.
    current: Option<Claim>,
    /// Triangles that the caller picked.
    picked: VecDeque<Picked>,
    /// Vertices that the mesh would have now.
    pub(super) vertices: usize,
    /// Vertices inserted in all, those deleted or taken back included.
    pub(super) insertions: u64,
    /// How many vertices had come and gone at the last retry, and how many retries there were.
    changes_at_retry: u64,
    retries: u32,
    pub(super) report: Report,
    /// What the step at work did, where somebody wants to know.
    pub(super) event: Option<Box<Event>>,
    /// Steps of runs told to an observer.
    pub(super) steps_told: u64,
    /// Time per step.
    pub(super) stopwatch: Stopwatch,
    /// How to go back, where somebody may want to.
    pub(super) history: Option<History>,
}

impl fmt::Debug for Refinement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Refinement")
            .field("options", &self.options)
            .field("vertices", &self.vertices)
            .finish_non_exhaustive()
    }
}

/// What one step did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StepOutcome {
    /// A subsegment was looked at and split if it still needed it.
    Subsegment,
    /// A node of the lattice was looked at, and went in if there was room.
    Filled,
    /// A bad triangle was looked at: a point went in, subsegments were queued, or it was given up.
    Triangle,
    /// A part of what comes before the loop was done.
    Prepared,
    /// Segments that had been let go were brought back, or some of them.
    Recovered,
    /// Triangles for which there was no room wait once more, since there may be now.
    Retried,
    /// Nothing is left to do.
    #[default]
    Finished,
    /// The vertex budget is used up.
    Exhausted,
    /// More vertices leave no fewer bad triangles: see [`StopReason::NoLongerImproves`].
    Stalled,
}

impl Refinement {
    /// Prepares the refinement of a triangulation carved by [`domain::build`](crate::domain::build), or taken over by
    /// [`domain::from_mesh`](crate::domain::from_mesh()).
    ///
    /// One that is still closed by its convex hull, as [`from_delaunay`](crate::constrained::ConstrainedDelaunay::from_delaunay) and
    /// [`new`](crate::constrained::ConstrainedDelaunay::new) make it, is closed by a domain first: [`carve_hull`](crate::constrained::ConstrainedDelaunay::carve_hull) says what that
    /// changes. Its convex hull is refined then, whatever its segments enclose.
    ///
    /// Where step 4 keeps the circle test and the start does not pass it, the start is flipped until it does.
    ///
    /// # Errors
    /// [`OptionError`].
    pub fn new(start: impl Into<Start>, options: RefineOptions) -> Result<Self, OptionError> {
        Self::timed(start, options, None)
    }

    /// [`new`](Self::new) with a clock, if there is one, to measure the steps by: [`Report::step_times`].
    ///
    /// # Errors
    /// [`OptionError`].
    pub fn timed(start: impl Into<Start>, options: RefineOptions, clock: Option<Clock>) -> Result<Self, OptionError> {
        let refinement = Self::of_steps(start, options, Steps::of(&options), clock)?;
        Ok(Self { walks_prove_places: true, ..refinement })
    }

    /// [`timed`](Self::timed) with steps of the caller's own in the place of the recipe's.
    ///
    /// # Errors
    /// [`OptionError`].
    pub fn of_steps(
        start: impl Into<Start>,
        mut options: RefineOptions,
        steps: Steps,
        clock: Option<Clock>,
    ) -> Result<Self, OptionError> {
        let Start { mut cdt, mut work, is_delaunay } = start.into();
        let Steps { prepare, select, point, insert, recover } = steps;
        options.validate()?;
        if !cdt.edit(&mut work, &mut NoJournal).carve_hull() {
            return Err(OptionError::NoTriangles);
        }
        // No budget is larger than what the indices of half-edges can name.
        options.limits.max_vertices = options.limits.max_vertices.min(max_points());
        let bounds = cdt.bounding_box();
        let ruler = Ruler::for_box(bounds);
        let (floor, floor_reason) = length_floor(bounds, &options, ruler);
        let precision = precision_floor(bounds, ruler);
        let region = Region::new(options.recipe.encroachment, &options.criteria);
        let vertices = cdt.input_points() + cdt.steiner_vertices();
        let recipe = options.recipe;
        let mut refinement = Self {
            facts: StepFacts::of(select.as_ref(), point.as_ref(), insert.as_ref()),
            prepare,
            is_manual: select.is_manual(),
            select,
            point,
            walks_prove_places: false,
            longest_walk: View::longest_walk(insert.as_ref()),
            bisection_floor_sq: bisection_floor_sq(&cdt, ruler, insert.as_ref(), precision * precision),
            insert,
            recover,
            region,
            ruler,
            test: Test::new(&options.criteria, &cdt),
            joints: Joints::of(&cdt),
            has_small_wedge: has_small_wedge(&cdt, ruler),
            floor_sq: floor * floor,
            precision_sq: precision * precision,
            precision: precision / ruler.scale(),
            floor_reason,
            filling: FillStage::Done,
            queue: Queue::default(),
            encroached: VecDeque::new(),
            unsplittable: BTreeSet::new(),
            given_up: Vec::new(),
            opening: if is_delaunay { Opening::Release } else { Opening::Given },
            illegal: Lawson::default(),
            released: Vec::new(),
            recovery: None,
            lost: Vec::new(),
            places: Vec::new(),
            log: UndoLog::new(),
            spokes: Vec::new(),
            bad_in_fan: Vec::new(),
            beside: Vec::new(),
            improvement: Improvement::UNWATCHED,
            joined: 0,
            current: None,
            picked: VecDeque::new(),
            vertices,
            insertions: 0,
            changes_at_retry: 0,
            retries: 0,
            report: Report { recipe, ..Report::default() },
            event: None,
            steps_told: 0,
            stopwatch: Stopwatch::new(clock),
            history: None,
            cdt,
            work,
            cavity: Cavity::default(),
            options,
        };
        refinement.begin_opening();
        Ok(refinement)
    }

    /// Wide parts are to be filled first, if the recipe asks for it and there are any; otherwise everything is looked at.
    pub(super) fn begin(&mut self, bounds: Option<BoundingBox>) {
        let expected = self.vertices.saturating_add(self.vertices_for_area());
        self.queue = self.empty_queue(bounds, expected);
        self.improvement = self.improvement_from_start();
        self.filling = self.fill_from_start(bounds);
        if self.is_filling() {
            drop(self.cdt.take_order_along_curve());
        } else {
            self.look_at_everything();
        }
    }

    /// An empty queue in the order of step 2 for so many vertices: by patches of the drawing's box, if it allows.
    pub(super) fn empty_queue(&self, bounds: Option<BoundingBox>, vertices: usize) -> Queue {
        if self.select.works_by_patches() {
            Queue::by_patches(Patches::new(bounds, vertices.min(self.options.limits.max_vertices)))
        } else {
            Queue::default()
        }
    }

    /// Whether triangles anywhere are held against a bound on their area, or perhaps against a test of the caller's own.
    pub(super) fn has_area_bound(&self) -> bool {
        self.test.sure_bounds(self.cdt.regions().rules()).doubled_area < f64::INFINITY
    }

    /// How many vertices area bounds ask for at least: half as many as triangles.
    fn vertices_for_area(&self) -> usize {
        if !self.has_area_bound() {
            return 0;
        }
        let parts = |f: FaceId| {
            let [a, b, c] = self.cdt.corners_from_newest(f);
            (b - a).cross(c - a) / self.test.doubled_area_bound(self.cdt.region_rule(f))
        };
        // The cast saturates.
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a number of vertices, not negative"
        )]
        let vertices = (self.cdt.real_faces().map(parts).sum::<f64>() / 2.0) as usize;
        vertices
    }

    /// The same with a step 2 of the caller's own.
    #[must_use]
    pub fn with_select(mut self, select: impl SelectStep + Send + Sync + 'static) -> Self {
        self.record_change();
        self.is_manual = select.is_manual();
        self.select = Arc::new(select);
        self.ask_steps();
        if self.is_open() {
            self.begin(self.cdt.bounding_box());
        }
        self
    }

    /// The same with a step 3 of the caller's own; [`Steps`] shows one.
    #[must_use]
    pub fn with_point(mut self, point: impl PointStep + Send + Sync + 'static) -> Self {
        self.record_change();
        self.point = Arc::new(point);
        self.ask_steps();
        self.walks_prove_places = false;
        self
    }

    /// The same with a step 4 of the caller's own.
    #[must_use]
    pub fn with_insert(mut self, insert: impl InsertStep + Send + Sync + 'static) -> Self {
        self.record_change();
        self.bisection_floor_sq = bisection_floor_sq(&self.cdt, self.ruler, &insert, self.precision_sq);
        self.longest_walk = View::longest_walk(&insert);
        self.insert = Arc::new(insert);
        self.ask_steps();
        if self.insert.keeps_small_angles() {
            self.improvement = Improvement::UNWATCHED;
        }
        self
    }

    /// Asks the steps what they say of themselves.
    fn ask_steps(&mut self) {
        self.facts = StepFacts::of(self.select.as_ref(), self.point.as_ref(), self.insert.as_ref());
    }

    /// Asks for more: triangles that the caller's own test refuses are bad, too.
    ///
    /// The test is asked about a triangle and the attribute of its region: [`Asked`]. It must answer the same for the same triangle, or
    /// the result depends on when it is asked; whatever it answers, the limits end the work.
    ///
    /// # Examples
    /// ```
    /// use trimalla::refine::{Asked, NoObserver, RefineOptions, Refinement};
    /// # use trimalla::{constrained::Crossings, delaunay::AlgorithmKey, domain::{DomainRule, build}, drawing::Pslg, geometry::Point};
    /// # let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(Point::from).to_vec();
    /// # let pslg = Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]], ..Pslg::default() };
    /// # let (cdt, _) = build(&pslg, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default())?;
    /// // The smaller the farther left.
    /// let fine = |asked: Asked| asked.triangle.area() > 0.05 + 0.1 * asked.triangle.centroid().x;
    /// let mut refinement = Refinement::new(cdt, RefineOptions::default())?.with_test(fine);
    /// refinement.run(&mut NoObserver);
    /// # assert!(refinement.finish().1.triangles > 20);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn with_test(mut self, test: impl Fn(Asked) -> bool + Send + Sync + 'static) -> Self {
        self.record_change();
        self.with_user_test(Arc::new(test))
    }

    pub(super) fn with_user_test(mut self, test: Arc<UserTest>) -> Self {
        self.test = self.test.clone().with_asked(test);
        self.improvement = Improvement::UNWATCHED;
        if self.is_open() && !self.is_filling() {
            self.look_at_everything();
        }
        self
    }

    /// The triangulation as it is now.
    #[must_use]
    pub fn triangulation(&self) -> &ConstrainedTriangulation {
        &self.cdt
    }

    /// What changes the triangulation, noted in the log of the step.
    #[inline(always)]
    pub(super) fn edit(&mut self) -> Edit<'_, UndoLog> {
        self.cdt.edit(&mut self.work, &mut self.log)
    }

    /// Runs until nothing is left to do, a limit is met, or the observer cancels.
    ///
    /// # Complexity
    /// Near linear in the vertices of the result.
    pub fn run(&mut self, observer: &mut dyn Observer) -> StopReason {
        self.history = None;
        self.report.stop = StopReason::default();
        self.stopwatch = self.stopwatch.or_clock(observer.clock());
        let (mut steps, mut told_at) = (0, None);
        let stop = loop {
            // Steps count, too: many may pass without an insertion.
            let work = steps + self.insertions;
            if told_at.is_none_or(|told| work >= told + PROGRESS_EVERY) {
                told_at = Some(work);
                if !observer.progress(self.progress()) {
                    break StopReason::Cancelled;
                }
            }
            steps += 1;
            let outcome = if observer.wants_events() { self.told(observer) } else { self.advance() };
            match outcome {
                StepOutcome::Finished => break StopReason::Finished,
                StepOutcome::Exhausted => break StopReason::Budget,
                StepOutcome::Stalled => break StopReason::NoLongerImproves,
                StepOutcome::Prepared
                | StepOutcome::Subsegment
                | StepOutcome::Filled
                | StepOutcome::Triangle
                | StepOutcome::Recovered
                | StepOutcome::Retried => {}
            }
        };
        self.report.stop = stop;
        stop
    }

    pub(super) fn progress(&self) -> Progress {
        Progress {
            vertices: self.vertices,
            waiting: self.queue.len() + self.nodes_left(),
            max_vertices: self.options.limits.max_vertices,
        }
    }

    /// One step: a waiting subsegment first, then the most urgent bad triangle.
    ///
    /// The log holds what it changed, and nothing else.
    pub(super) fn advance(&mut self) -> StepOutcome {
        self.stopwatch.enter(Part::Prepare);
        self.log.clear();
        self.cdt.forget_undo_outside();
        let outcome = self.take_step();
        self.stopwatch.enter(Part::Outside);
        outcome
    }

    fn take_step(&mut self) -> StepOutcome {
        if self.recover_on() {
            return StepOutcome::Recovered;
        }
        if !self.is_open() {
            return self.open_further();
        }
        if self.is_exhausted() {
            let waits = !self.encroached.is_empty() || self.queue.len() > 0 || self.is_filling();
            return if waits { StepOutcome::Exhausted } else { StepOutcome::Finished };
        }
        if self.improvement.is_due(self.vertices) && self.no_longer_improves() {
            return StepOutcome::Stalled;
        }
        if self.split_next_subsegment() {
            return StepOutcome::Subsegment;
        }
        if self.fill_on() {
            return StepOutcome::Filled;
        }
        self.stopwatch.enter(Part::Select);
        let Some(face) = self.next_face() else {
            if self.recover_segments() {
                return StepOutcome::Recovered;
            }
            return if self.retry() { StepOutcome::Retried } else { StepOutcome::Finished };
        };
        let claim = self.queue.claim(&self.cdt, face);
        self.note_selected(face);
        self.stopwatch.enter(Part::Point);
        match self.treat(face) {
            Ok(()) if self.options.recipe.until_destroyed => self.current = Some(claim),
            Ok(()) if self.queue.is_valid(&self.cdt, claim) => self.look_at_bad(face),
            Ok(()) => {}
            Err(reason) => self.given_up.push((sorted(self.cdt.face_vertices(face)), reason)),
        }
        StepOutcome::Triangle
    }

    /// Lets triangles wait again that were given up for want of room, and subsegments that could not be split, if anything has
    /// changed since; says whether it did.
    ///
    /// So a mesh that is refined again finds nothing left to do.
    fn retry(&mut self) -> bool {
        let had_no_room = |reason: Reason| matches!(reason, Reason::PrecisionFloor | Reason::InputGap);
        let is_refused = self.given_up.iter().any(|g| had_no_room(g.1)) || !self.unsplittable.is_empty();
        let is_worth_it = is_refused && self.retries < MOST_RETRIES;
        let r = &self.report;
        let changes = r.points_inserted + r.segments_split + r.vertices_deleted;
        if !is_worth_it || changes == self.changes_at_retry {
            return false;
        }
        self.retries += 1;
        self.changes_at_retry = changes;
        self.given_up.clear();
        self.unsplittable.clear();
        self.look_at_everything();
        true
    }

    /// The triangle at work if it is still there, else the most urgent one.
    fn next_face(&mut self) -> Option<FaceId> {
        if let Some(claim) = self.current.take().filter(|&claim| self.queue.is_valid(&self.cdt, claim)) {
            return Some(claim.face);
        }
        if !self.is_manual {
            return self.queue.pop(&self.cdt, self.facts.takes_oldest);
        }
        let there = |&(f, name): &Picked| self.cdt.is_real(f) && sorted(self.cdt.face_vertices(f)) == name;
        while let Some(picked) = self.picked.pop_front() {
            if there(&picked) {
                return Some(picked.0);
            }
        }
        None
    }

    /// Picks a triangle to be treated, after those picked before; for the order `manual`. One that is gone by then is
    /// passed over.
    ///
    /// Says whether there is such a triangle.
    pub fn pick(&mut self, face: FaceId) -> bool {
        let is_there = face.index() < self.cdt.face_slots() && self.cdt.is_real(face);
        if is_there {
            let picked = (face, sorted(self.cdt.face_vertices(face)));
            self.put_picked(picked);
            self.record_pick(picked);
        }
        is_there
    }

    pub(super) fn put_picked(&mut self, picked: Picked) {
        self.picked.push_back(picked);
    }

    /// Deletions make room again, so insertions are counted too: no run goes on for ever.
    fn is_exhausted(&self) -> bool {
        let most = self.options.limits.max_vertices;
        self.vertices >= most || self.insertions >= 16 * most as u64 + 1024
    }

    /// Whether the point strategy keeps clear of segments.
    pub(super) fn minds_encroachment(&self) -> bool {
        self.facts.minds_encroachment
    }

    pub(super) fn view(&self) -> View<'_> {
        View { cdt: &self.cdt, criteria: &self.options.criteria, ruler: self.ruler, longest_walk: self.longest_walk }
    }
}

/// The square of the length at which an insertion that keeps small angles stops; 0 for any other. Edges that are shorter
/// than rounding leaves room for do not count.
fn bisection_floor_sq(cdt: &ConstrainedTriangulation, ruler: Ruler, insert: &dyn InsertStep, precision_sq: f64) -> f64 {
    if !insert.keeps_small_angles() {
        return 0.0;
    }
    let length_sq = |h: HalfEdgeId| {
        let [a, b] = cdt.edge_points(h);
        ruler.length_sq(a, b)
    };
    let lengths = cdt.edges().map(length_sq).filter(|&length_sq| length_sq >= precision_sq);
    lengths.fold(f64::INFINITY, f64::min) / (BISECTIONS * BISECTIONS)
}

/// The ends of an edge, the lower one first.
pub(super) fn ends_of(cdt: &ConstrainedTriangulation, h: HalfEdgeId) -> [VertexId; 2] {
    let (a, b) = (cdt.origin(h), cdt.dest(h));
    [a.min(b), a.max(b)]
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
