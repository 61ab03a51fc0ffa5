//! The treatment of one bad triangle: steps 3 and 4 of the loop.
//!
//! 1. Those that no point can help are given up, with the reason.
//! 2. The point strategy proposes places, the best first.
//! 3. Each place is tried until one is taken: a subsegment in the way waits for its split; so does, instead of the
//!    point, one that a point would encroach upon. Step 4 by cavity sees that before it cuts; otherwise the point goes
//!    in through the journal and comes out again, as it does if it is too near to another vertex.

use super::{Refinement, ends_of};
use crate::constrained::Provenance;
use crate::geometry::Point;
use crate::half_edge::{Checkpoint, FaceId, HalfEdgeId, NoJournal, VertexId};
use crate::locate::Locus;
use crate::refine::event::{Badness, InsertedKind};
use crate::refine::lepp::lepp;
use crate::refine::report::Reason;
use crate::refine::steps::Proposal;
use crate::refine::stopwatch::Part;

impl Refinement {
    /// Treats a bad triangle; the error says why it is given up.
    pub(super) fn treat(&mut self, face: FaceId) -> Result<(), Reason> {
        if let Some(reason) = self.is_hopeless(face) {
            return Err(reason);
        }
        self.count_path(face);
        let mut places = std::mem::take(&mut self.scratch.places);
        places.clear();
        self.strategy.steps.point.propose(self.view(), face, &mut places);
        self.ledger.stopwatch.enter(Part::Insert);
        // Without flips a point off the triangle does not destroy it: one that is there already, or far off, never
        // will.
        let is_kept = self.strategy.facts.keeps_delaunay;
        let mut refused = if is_kept { Reason::PrecisionFloor } else { Reason::StrategyCannotImprove };
        // Nothing changes until one is taken, so that the loci stay right.
        let taken = places.iter().any(|&place| {
            let tried = self.try_place(place);
            self.note_candidate(place, tried);
            tried.map_err(|reason| refused = reason).is_ok()
        });
        let outcome = if taken { Ok(()) } else { Err(self.reason_of_refused_places(&places, refused)) };
        self.scratch.places = places;
        outcome
    }

    /// Why no point can help a triangle of bad shape, where none can; one that is too large is split whatever its shape
    /// is.
    fn is_hopeless(&self, face: FaceId) -> Option<Reason> {
        if !self.problem.test.bounds_shape() {
            return None;
        }
        let reason = if let Some(reason) = self.hopeless_between_segments(face) {
            reason
        } else if let Some((reason, _)) = self.across_gap(face).filter(|&(_, is_hopeless)| is_hopeless) {
            reason
        } else if self.is_beyond_help(face) {
            Reason::StrategyCannotImprove
        } else {
            return None;
        };
        self.badness(face).is_some_and(Badness::is_of_shape).then_some(reason)
    }

    /// Counts the length of the path, where the strategy follows it.
    fn count_path(&mut self, face: FaceId) {
        if self.strategy.facts.follows_path {
            let length = lepp(&self.cdt, self.problem.ruler, face, self.problem.options.recipe.lepp_rule).len();
            let lengths = &mut self.ledger.report.lepp_lengths;
            lengths.resize(lengths.len().max(length + 1), 0);
            lengths[length] += 1;
        }
    }

    /// Inserts at a place, or queues the split that must come before; the error says why neither can be.
    fn try_place(&mut self, place: Proposal) -> Result<(), Reason> {
        let is_true = if self.strategy.walks_prove_places {
            place.is_true_after_walk(&self.cdt)
        } else {
            place.is_true(&self.cdt)
        };
        if !is_true {
            return Err(Reason::StrategyCannotImprove);
        }
        if let Some(h) = self.strategy.steps.insert.flip_instead(self.view(), place) {
            self.flip(h);
            return Ok(());
        }
        match place {
            Proposal::Split(h) => self.split_instead(&[h]),
            Proposal::OnEdge { edge, point } => self.try_on_edge(edge, point),
            Proposal::Free { point, locus } => self.try_point(point, locus),
        }
    }

    /// Flips an edge that fails the circle test; counted, so that the bound on insertions holds.
    fn flip(&mut self, h: HalfEdgeId) {
        let h = self.edit().flip_edge(h);
        self.ledger.insertions += 1;
        self.ledger.report.flips_instead += 1;
        let mut faces = [h.face(), self.cdt.twin(h).face()];
        self.put_in_order(&mut faces);
        self.look_at_faces(&faces);
    }

    /// Subsegments are in the way: one that can be is split, and the triangle waits.
    ///
    /// One split often clears the way of the others too, so they are left until they are met again. With lenses the
    /// longest is split, with disks the shortest: measured on drawings, that leaves fewest vertices.
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
            by_length.then_with(|| ends_of(&self.cdt, h).cmp(&ends_of(&self.cdt, g)))
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

    /// Inserts a free point by its cavity. The rim tells the neighbours and the subsegments opposite, so that nothing
    /// is cut that would have to be taken back.
    fn try_cavity(&mut self, point: Point, locus: Locus) -> Result<(), Reason> {
        if !self.cdt.find_cavity(&mut self.scratch.cavity, point, locus) {
            return Err(Reason::PrecisionFloor);
        }
        let (crowds, marks) = self.look_at_rim(point);
        if crowds {
            return Err(self.problem.floors.floor_reason);
        }
        self.ledger.insertions += 1;
        if marks != 0 && self.minds_encroachment() {
            let encroached = self.encroached_on_rim(point);
            if !encroached.is_empty() {
                self.ledger.report.points_rejected += 1;
                if let Some(event) = &mut self.ledger.event {
                    event.encroached = encroached.iter().map(|&h| ends_of(&self.cdt, h)).collect();
                }
                return self.split_instead(&encroached);
            }
        }
        let v = self.fill_cavity(point);
        self.look_around_cavity(v, point);
        Ok(())
    }

    /// Whether a vertex on the rim of the cavity found last is closer to a point than the length floor allows, and
    /// marks: 0 where no edge of the rim is a subsegment.
    #[inline(always)] // Before each insertion.
    pub(super) fn look_at_rim(&self, point: Point) -> (bool, u32) {
        let cavity = &self.scratch.cavity;
        let (mut crowds, mut marks) = (false, 0);
        for (edge, &start) in cavity.rim().iter().zip(cavity.rim_starts()) {
            crowds |=
                edge.from.is_finite() & (self.problem.ruler.length_sq(point, start) < self.problem.floors.floor_sq);
            marks |= edge.mark;
        }
        (crowds, marks)
    }

    /// The subsegments on the rim of the cavity found last that a point encroaches upon.
    fn encroached_on_rim(&self, point: Point) -> Vec<HalfEdgeId> {
        let rim = self.scratch.cavity.rim().split_last().map_or(&[][..], |(_, once)| once);
        let marked = rim.iter().filter(|e| e.mark != 0).map(|e| self.cdt.twin(e.outer));
        marked.filter(|&h| self.is_encroached(h, point)).collect()
    }

    /// Puts a free vertex into the cavity found last. Nobody takes it back; an event is told by what the log holds.
    pub(super) fn fill_cavity(&mut self, point: Point) -> VertexId {
        let v = if self.ledger.event.is_some() {
            self.cdt.edit(&mut self.scratch.work, &mut self.scratch.log).fill_cavity(
                &mut self.scratch.cavity,
                point,
                Provenance::Free,
            )
        } else {
            self.cdt.edit(&mut self.scratch.work, &mut NoJournal).fill_cavity(
                &mut self.scratch.cavity,
                point,
                Provenance::Free,
            )
        };
        self.ledger.vertices += 1;
        self.ledger.report.points_inserted += 1;
        self.note_inserted(v, InsertedKind::Free);
        v
    }

    /// Inserts a free point; takes it back if it encroaches upon subsegments.
    fn try_point(&mut self, point: Point, locus: Locus) -> Result<(), Reason> {
        if self.strategy.facts.by_cavity {
            return self.try_cavity(point, locus);
        }
        if self.nearest_sq(point, locus) < self.problem.floors.floor_sq {
            return Err(self.problem.floors.floor_reason);
        }
        let here = self.scratch.log.checkpoint();
        let mut edit = self.cdt.edit(&mut self.scratch.work, &mut self.scratch.log);
        let v = self.strategy.steps.insert.insert(&mut edit, point, locus).ok_or(Reason::PrecisionFloor)?;
        self.ledger.insertions += 1;
        self.keep_if_apart(v, here)?;
        let encroached = if self.minds_encroachment() { self.encroached_by(v) } else { Vec::new() };
        if encroached.is_empty() {
            self.ledger.vertices += 1;
            self.ledger.report.points_inserted += 1;
            self.note_inserted(v, InsertedKind::Free);
            self.look_around(v);
            return Ok(());
        }
        let ends: Vec<[VertexId; 2]> = encroached.into_iter().map(|h| ends_of(&self.cdt, h)).collect();
        self.note(|event| event.encroached.clone_from(&ends));
        self.cdt.rollback(&mut self.scratch.log, here);
        self.ledger.report.points_rejected += 1;
        let subsegments: Vec<HalfEdgeId> =
            ends.into_iter().filter_map(|[a, b]| self.cdt.half_edge_between(a, b)).collect();
        self.split_instead(&subsegments)
    }

    /// Splits an unconstrained edge.
    fn try_on_edge(&mut self, h: HalfEdgeId, point: Point) -> Result<(), Reason> {
        if self.nearest_sq(point, Locus::Edge(h)) < self.problem.floors.floor_sq {
            return Err(self.problem.floors.floor_reason);
        }
        if self.strategy.facts.by_cavity {
            return self.try_cavity_on_edge(h, point);
        }
        let here = self.scratch.log.checkpoint();
        let mut edit = self.cdt.edit(&mut self.scratch.work, &mut self.scratch.log);
        let mut split = self.strategy.steps.insert.split(&mut edit, h, point, Provenance::Free);
        if split.is_err() {
            let beside = self.places_beside_on_edge(h, point);
            let mut edit = self.cdt.edit(&mut self.scratch.work, &mut self.scratch.log);
            let beside = beside
                .into_iter()
                .find_map(|p| self.strategy.steps.insert.split(&mut edit, h, p, Provenance::Free).ok());
            split = beside.map_or(split, Ok);
        }
        let v = split.map_err(|_| Reason::PrecisionFloor)?;
        self.ledger.insertions += 1;
        self.keep_if_apart(v, here)?;
        self.ledger.vertices += 1;
        self.ledger.report.points_inserted += 1;
        self.note_inserted(v, InsertedKind::OnEdge);
        self.look_around(v);
        Ok(())
    }

    /// Splits an unconstrained edge by cavity.
    fn try_cavity_on_edge(&mut self, h: HalfEdgeId, point: Point) -> Result<(), Reason> {
        let mut place = point;
        let mut split = self.split_by_cavity(h, point, Provenance::Free);
        if split.is_err() {
            for beside in self.places_beside_on_edge(h, point) {
                (place, split) = (beside, self.split_by_cavity(h, beside, Provenance::Free));
                if split.is_ok() {
                    break;
                }
            }
        }
        let Some((v, is_fan)) = split? else { return Err(self.problem.floors.floor_reason) };
        self.ledger.vertices += 1;
        self.ledger.report.points_inserted += 1;
        self.note_inserted(v, InsertedKind::OnEdge);
        if is_fan {
            self.look_around_cavity(v, place)
        } else {
            self.look_around(v)
        }
        Ok(())
    }

    /// Takes a vertex back that the insert step did not put in, or that is too close to a neighbour.
    fn keep_if_apart(&mut self, v: VertexId, before: Checkpoint) -> Result<(), Reason> {
        let why = if !self.is_there(v) {
            Reason::StrategyCannotImprove
        } else if self.crowds_a_neighbour(v) {
            self.problem.floors.floor_reason
        } else {
            return Ok(());
        };
        self.cdt.rollback(&mut self.scratch.log, before);
        Err(why)
    }

    /// Whether the triangulation has the vertex that a step 4 says it inserted.
    fn is_there(&self, v: VertexId) -> bool {
        v.index() < self.cdt.points().len() && self.cdt.is_used(v)
    }

    /// Whether a new vertex is closer to a neighbour than the length floor allows. The nearest vertex is a neighbour.
    pub(super) fn crowds_a_neighbour(&self, v: VertexId) -> bool {
        let p = self.cdt.point(v);
        self.cdt
            .neighbours(v)
            .any(|w| self.problem.ruler.length_sq(p, self.cdt.point(w)) < self.problem.floors.floor_sq)
    }

    /// Whether bisection has gone as far as it can help: it keeps the smallest angle, so far below the first lengths
    /// there is nothing to win.
    fn is_beyond_help(&self, face: FaceId) -> bool {
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

    /// The subsegments opposite a new vertex that it encroaches upon.
    fn encroached_by(&self, v: VertexId) -> Vec<HalfEdgeId> {
        let p = self.cdt.point(v);
        let marked = self.cdt.star(v).map(HalfEdgeId::next).filter(|&h| self.cdt.is_marked(h));
        marked.filter(|&h| self.is_encroached(h, p)).collect()
    }

    fn is_encroached(&self, h: HalfEdgeId, p: Point) -> bool {
        let [a, b] = self.cdt.edge_points(h);
        self.problem.region.holds(a, b, p, self.problem.ruler)
    }
}
