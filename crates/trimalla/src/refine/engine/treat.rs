//! The treatment of one bad triangle: steps 3 and 4 of the loop.
//!
//! 1. A triangle that no point can improve is given up, with the reason.
//! 2. Step 3 proposes places, the best first.
//! 3. The places are tried in turn until one is accepted. If a subsegment is in the way of the point, or the point
//!    would encroach upon one, the subsegment is queued for a split instead. Step 4 plans how the point is inserted,
//!    and `insertion.rs` executes the plan.

use super::Refinement;
use super::insertion::{Changed, Inserted, Refused, Site};
use crate::constrained::Provenance;
use crate::geometry::Point;
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};
use crate::locate::Locus;
use crate::refine::criteria::badness::Badness;
use crate::refine::criteria::reason::Reason;
use crate::refine::measure::lepp::lepp;
use crate::refine::steps::{Plan, Proposal};
use crate::refine::watch::event::InsertedKind;
use crate::refine::watch::stopwatch::Part;

impl Refinement {
    /// Treats a bad triangle; the error is the reason for which it is given up.
    pub(super) fn treat(&mut self, face: FaceId) -> Result<(), Reason> {
        if let Some(reason) = self.hopeless_reason(face) {
            return Err(reason);
        }
        self.count_path(face);
        self.scratch.places.clear();
        self.ledger.newest = None;
        let view = self.problem.view(&self.cdt, &self.strategy);
        self.strategy.steps.point.propose(view, face, &mut self.scratch.places);
        self.ledger.stopwatch.enter(Part::Insert);
        // Without flips a point outside the triangle does not destroy it: neither does a point that exists already, nor
        // one far away.
        let is_kept = self.strategy.traits.insert.keeps_delaunay;
        let mut refused = if is_kept { Reason::PrecisionFloor } else { Reason::StrategyCannotImprove };
        // Nothing changes until a place is accepted, so that the loci stay valid.
        for number in 0..self.scratch.places.proposals().len() {
            let place = self.scratch.places.proposals()[number];
            let tried = self.try_place(place);
            self.note_candidate(place, tried);
            match tried {
                Err(reason) => refused = reason,
                Ok(()) => {
                    self.insert_others(number);
                    return Ok(());
                }
            }
        }
        Err(self.reason_of_refused_places(self.scratch.places.proposals(), refused))
    }

    /// Inserts the points that belong to an accepted place, if a vertex was inserted there.
    #[inline(always)] // Nearly always there are none.
    fn insert_others(&mut self, number: usize) {
        if self.scratch.places.together_with(number).next().is_some() {
            self.insert_points_after(self.ledger.newest, number);
        }
    }

    /// Inserts these points in turn, each where a walk from the previous vertex ends.
    #[cold]
    #[inline(never)]
    fn insert_points_after(&mut self, first: Option<VertexId>, number: usize) {
        let Some(mut from) = first else { return };
        let points: Vec<Point> = self.scratch.places.together_with(number).collect();
        for point in points {
            let Some(h) = self.cdt.outgoing(from).filter(|_| !self.is_exhausted()) else { return };
            let face = if self.cdt.is_real(h.face()) { h.face() } else { self.cdt.twin(h).face() };
            let Some(place) = Proposal::towards(self.view(), face, point) else { continue };
            let tried = self.try_place(place);
            self.note_candidate(place, tried);
            from = self.ledger.newest.filter(|_| tried.is_ok()).unwrap_or(from);
        }
    }

    /// Why no point can improve a triangle of bad shape, if none can. A triangle that is too large is split whatever
    /// its shape.
    fn hopeless_reason(&self, face: FaceId) -> Option<Reason> {
        if !self.problem.test.bounds_shape() {
            return None;
        }
        let reason = if let Some(reason) = self.reason_between_segments(face) {
            reason
        } else if let Some((reason, _)) = self.across_gap(face).filter(|&(_, is_hopeless)| is_hopeless) {
            reason
        } else if self.is_bisection_useless(face) {
            Reason::StrategyCannotImprove
        } else {
            return None;
        };
        self.badness(face).is_some_and(Badness::is_of_shape).then_some(reason)
    }

    /// Counts the length of the path, if step 3 follows it.
    fn count_path(&mut self, face: FaceId) {
        if self.strategy.traits.point.follows_path {
            let length = lepp(&self.cdt, self.problem.ruler, face, self.problem.options.recipe.lepp_rule).len();
            let lengths = &mut self.ledger.report.lepp_lengths;
            lengths.resize(lengths.len().max(length + 1), 0);
            lengths[length] += 1;
        }
    }

    /// Inserts a vertex at a place, or queues the split that must come first; the error says why neither is possible.
    pub(super) fn try_place(&mut self, place: Proposal) -> Result<(), Reason> {
        let is_true = if self.strategy.walks_prove_places {
            place.is_true_after_walk(&self.cdt)
        } else {
            place.is_true(&self.cdt)
        };
        if !is_true {
            return Err(Reason::StrategyCannotImprove);
        }
        if let Proposal::Split(h) = place {
            return self.split_instead(&[h]);
        }
        match (self.plan(place), place) {
            (Plan::Flip(h), _) => self.try_flip(h),
            (plan, Proposal::OnEdge { edge, point }) => self.try_on_edge(plan, edge, point),
            (plan, Proposal::Free { point, locus }) => self.try_point(plan, point, locus),
            (_, Proposal::Split(h)) => self.split_instead(&[h]),
        }
    }

    /// Flips an edge instead of an insertion, if its two faces form a convex quadrilateral. If step 4 keeps the circle
    /// test, only an edge that fails it is flipped. Flips are counted, so that the bound on insertions holds.
    fn try_flip(&mut self, h: HalfEdgeId) -> Result<(), Reason> {
        let is_there = self.cdt.is_alive(h.face());
        let is_fine = is_there && (!self.strategy.traits.insert.keeps_delaunay || self.cdt.fails_circle_test(h));
        let Some(h) = (if is_fine { self.edit().try_flip(h) } else { None }) else {
            return Err(Reason::StrategyCannotImprove);
        };
        self.ledger.insertions += 1;
        self.ledger.report.flips_instead += 1;
        let mut faces = [h.face(), self.cdt.twin(h).face()];
        self.sort_by_vertices(&mut faces);
        self.test_faces(&faces);
        Ok(())
    }

    /// Queues the split of one of the subsegments that are in the way; the triangle stays in the queue.
    ///
    /// One split often makes the others unnecessary, so they are left until they are found again. With lenses the
    /// longest is split, with disks the shortest: measured on drawings, that needs the fewest vertices.
    fn split_instead(&mut self, subsegments: &[HalfEdgeId]) -> Result<(), Reason> {
        if let [only] = subsegments {
            return self.queue_subsegment(*only, true);
        }
        let length = |h: HalfEdgeId| {
            let [a, b] = self.cdt.edge_points(h);
            self.problem.ruler.length_sq(a, b)
        };
        let mut order = subsegments.to_vec();
        order.sort_by(|&h, &g| {
            let shorter = length(h).total_cmp(&length(g));
            let by_length = if self.problem.region.is_lens() { shorter.reverse() } else { shorter };
            by_length.then_with(|| self.cdt.edge_key(h).cmp(&self.cdt.edge_key(g)))
        });
        let mut refused = Reason::PrecisionFloor;
        for h in order {
            match self.queue_subsegment(h, true) {
                Ok(()) => return Ok(()),
                Err(reason) => refused = reason,
            }
        }
        Err(refused)
    }

    /// Inserts a free point; if it would encroach upon subsegments, queues the split of one of them instead.
    #[inline(always)] // For most triangles.
    fn try_point(&mut self, plan: Plan, point: Point, locus: Locus) -> Result<(), Reason> {
        if plan != Plan::Fan && self.nearest_sq(point, locus) < self.problem.floors.floor_sq {
            return Err(self.problem.floors.floor_reason);
        }
        match self.insert(plan, Site::Free(point, locus)) {
            Ok(inserted) => {
                self.count_point(inserted.vertex, InsertedKind::Free);
                self.test_around_inserted(inserted, point);
                Ok(())
            }
            Err(Refused::Encroaches(encroached)) => {
                self.ledger.report.points_rejected += 1;
                if let Some(event) = &mut self.ledger.event {
                    event.encroached = encroached.iter().map(|&h| self.cdt.edge_key(h).ends()).collect();
                }
                self.split_instead(&encroached)
            }
            Err(refused) => Err(self.reason_of_refused(&refused)),
        }
    }

    /// Splits an unconstrained edge.
    fn try_on_edge(&mut self, plan: Plan, h: HalfEdgeId, point: Point) -> Result<(), Reason> {
        if self.nearest_sq(point, Locus::Edge(h)) < self.problem.floors.floor_sq {
            return Err(self.problem.floors.floor_reason);
        }
        let mut place = point;
        let mut split = self.insert(plan, Site::Edge(h, point, Provenance::Free));
        if matches!(split, Err(Refused::NoRoom)) {
            for beside in self.places_beside_on_edge(h, point) {
                (place, split) = (beside, self.insert(plan, Site::Edge(h, beside, Provenance::Free)));
                if !matches!(split, Err(Refused::NoRoom)) {
                    break;
                }
            }
        }
        let inserted = split.map_err(|refused| self.reason_of_refused(&refused))?;
        self.count_point(inserted.vertex, InsertedKind::OnEdge);
        self.test_around_inserted(inserted, place);
        Ok(())
    }

    /// Counts a vertex that is not on a subsegment, and adds it to the event.
    pub(super) fn count_point(&mut self, v: VertexId, kind: InsertedKind) {
        self.ledger.vertices += 1;
        self.ledger.report.points_inserted += 1;
        self.note_inserted(v, kind);
    }

    /// Tests the faces that the insertion of a vertex at a point has changed.
    #[inline(always)] // After each insertion.
    pub(super) fn test_around_inserted(&mut self, inserted: Inserted, point: Point) {
        match inserted.changed {
            Changed::Fan => self.test_fan(inserted.vertex, point),
            Changed::Star => self.test_star(inserted.vertex),
            Changed::Since(here) => self.test_faces(&self.faces_changed_since(here)),
        }
    }

    /// The reason under which a refusal is reported.
    pub(super) const fn reason_of_refused(&self, refused: &Refused) -> Reason {
        match refused {
            Refused::NoRoom | Refused::Encroaches(_) => Reason::PrecisionFloor,
            Refused::Crowded => self.problem.floors.floor_reason,
        }
    }

    /// Whether further bisection is useless: it keeps the smallest angle, and the edges are already far shorter than
    /// those at the start.
    fn is_bisection_useless(&self, face: FaceId) -> bool {
        let shortest_sq = || {
            let [a, b, c] = self.cdt.corners(face);
            self.problem
                .ruler
                .length_sq(a, b)
                .min(self.problem.ruler.length_sq(b, c))
                .min(self.problem.ruler.length_sq(c, a))
        };
        self.problem.floors.bisection_floor_sq > 0.0 && shortest_sq() < self.problem.floors.bisection_floor_sq
    }

    /// The square of the distance from a point to the nearest vertex of the faces it lies in.
    fn nearest_sq(&self, p: Point, locus: Locus) -> f64 {
        let corners = |f: FaceId| {
            self.cdt
                .face_vertices(f)
                .into_iter()
                .filter(|v| v.is_finite())
                .map(|v| self.problem.ruler.length_sq(p, self.cdt.point(v)))
        };
        let least = |f: FaceId| corners(f).fold(f64::INFINITY, f64::min);
        match locus {
            Locus::Face(f) => least(f),
            Locus::Edge(h) => least(h.face()).min(least(self.cdt.twin(h).face())),
            _ => 0.0,
        }
    }
}
