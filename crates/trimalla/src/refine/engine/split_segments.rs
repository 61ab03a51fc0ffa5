//! Splits of encroached subsegments: which are queued, where they are split, which vertices are deleted first.

use super::Refinement;
use super::encroached::{Encroached, SplitPlace, SplitPlan};
use super::insertion::Site;
use crate::constrained::{Provenance, SplitError};
use crate::geometry::{CircleSide, Point, in_diametral_disk};
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};
use crate::refine::criteria::reason::Reason;
use crate::refine::recipe::options::Protect;
use crate::refine::steps::Proposal;
use crate::refine::watch::event::{InsertedKind, StepOutcome};

impl Refinement {
    /// Queues the split of a subsegment; the error says why it cannot be split.
    pub(super) fn queue_subsegment(&mut self, h: HalfEdgeId, forced: bool) -> Result<(), Reason> {
        let edge = self.cdt.edge_key(h);
        if self.agenda.unsplittable.contains(&edge) {
            return Err(self.reason_of_refusal(h, self.problem.floors.floor_reason));
        }
        let plan = self.plan_split(self.in_order(h)).map_err(|reason| self.reason_of_refusal(h, reason))?;
        self.agenda.encroached.push_back(Encroached { edge, forced, plan });
        Ok(())
    }

    /// The half-edge of an edge that starts at the lower vertex: rounded decisions start from that vertex.
    fn in_order(&self, h: HalfEdgeId) -> HalfEdgeId {
        if self.cdt.origin(h) < self.cdt.dest(h) { h } else { self.cdt.twin(h) }
    }

    /// Whether step 1 wants a subsegment split, and a split would help. It would not if all vertices in its disk lie
    /// within rounding of it, since no split separates them from it.
    #[inline] // For each subsegment beside what is new; most need no split.
    pub(super) fn needs_split(&self, h: HalfEdgeId) -> bool {
        self.strategy.steps.prepare.needs_split(self.view(), h) && !self.is_encroached_within_rounding(h)
    }

    /// Whether an apex of `h` lies within rounding of it, and every apex in its disk does.
    #[inline(never)]
    fn is_encroached_within_rounding(&self, h: HalfEdgeId) -> bool {
        let sides = [h, self.cdt.twin(h)];
        let [a, b] = self.cdt.edge_points(h);
        let is_near = |apex: VertexId| apex.is_finite() && self.may_be_within_rounding([a, b, self.cdt.point(apex)]);
        sides.into_iter().any(|side| is_near(self.cdt.apex(side))) && self.is_encroached_by_flat(sides, [a, b])
    }

    /// [`is_encroached_within_rounding`](Self::is_encroached_within_rounding) where the triangle on one of the sides is
    /// flat.
    #[cold]
    #[inline(never)]
    fn is_encroached_by_flat(&self, sides: [HalfEdgeId; 2], [a, b]: [Point; 2]) -> bool {
        let is_inside =
            |apex: VertexId| apex.is_finite() && in_diametral_disk(a, b, self.cdt.point(apex)) == CircleSide::Inside;
        sides.into_iter().any(|h| self.is_apex_within_rounding(h))
            && sides.into_iter().all(|h| self.is_apex_within_rounding(h) || !is_inside(self.cdt.apex(h)))
    }

    /// Queues every subsegment that needs a split now, in the order of their vertices.
    pub(super) fn queue_all_encroached(&mut self) {
        let mut found = Vec::new();
        // A loop instead of `collect`: the nested iterators would compile to a state machine.
        self.cdt.for_each_marked_edge(|h| {
            if self.needs_split(h) {
                found.push((self.cdt.edge_key(h), h));
            }
        });
        found.sort_unstable();
        for (_, h) in found {
            // A subsegment that cannot be split stays encroached; triangles beside it get that as their reason.
            let _ = self.queue_subsegment(h, false);
        }
    }

    /// Takes the oldest queued subsegment, if there is one, and splits it if it still needs that.
    pub(super) fn split_next_subsegment(&mut self) -> Option<StepOutcome> {
        let encroached = self.agenda.encroached.pop_front()?;
        let Encroached { edge, forced, plan } = encroached;
        if let Some(record) = self.record() {
            record.note_split(encroached);
        }
        let [a, b] = edge.ends();
        self.note(|event| event.subsegment = Some([a, b]));
        // Edges of the hull of a triangulation that was not carved carry no marks.
        let is_subsegment = |&h: &HalfEdgeId| self.cdt.is_marked(h) || self.cdt.is_boundary_edge(h);
        let there = self.cdt.half_edge_between_known(a, b, plan.half_edge).filter(is_subsegment);
        let Some(h) = there else { return Some(StepOutcome::SubsegmentKept) };
        if self.agenda.unsplittable.contains(&edge) {
            return Some(StepOutcome::SubsegmentRefused);
        }
        let plan = Some(plan).filter(|plan| plan.apexes == self.apexes(h));
        if !forced && plan.is_none() && !self.needs_split(h) {
            return Some(StepOutcome::SubsegmentKept);
        }
        if self.split(h, plan) {
            return Some(StepOutcome::SubsegmentSplit);
        }
        // It could be split when it was queued: marking it avoids endless attempts.
        self.agenda.unsplittable.insert(edge);
        if let Some(record) = self.record() {
            record.note_unsplittable(edge);
        }
        Some(StepOutcome::SubsegmentRefused)
    }

    /// Splits a subsegment; returns whether it was possible.
    ///
    /// Deletes the free vertices in its disk first. If there is no room for the split without them, as beside a joint
    /// that becomes sharp and needs a split on a circle, the deletions are rolled back.
    fn split(&mut self, h: HalfEdgeId, plan: Option<SplitPlan>) -> bool {
        let acute = plan.map_or_else(|| self.acute_ends(h), |plan| plan.acute);
        let place = plan.map(|plan| plan.place);
        if !self.problem.region.is_lens() || !self.minds_encroachment() || acute != [false, false] {
            return self.split_near(h, place);
        }
        let ends = [self.cdt.origin(h), self.cdt.dest(h)];
        let (here, deleted) = (self.scratch.log.checkpoint(), self.ledger.report.vertices_deleted);
        let tested = self.delete_free_vertices(h);
        let deleted = self.ledger.report.vertices_deleted - deleted;
        if deleted == 0 {
            return self.split_near(h, place);
        }
        if self.split_between(ends, None) {
            return true;
        }
        self.cdt.rollback(&mut self.scratch.log, here);
        self.ledger.report.vertices_deleted -= deleted;
        self.ledger.vertices += deleted as usize;
        self.note(|event| event.deleted.clear());
        self.test_again(tested);
        self.split_between(ends, place)
    }

    /// Tests the faces in slots that were tested before a rollback, since the tickets of those slots are void.
    fn test_again(&mut self, mut slots: Vec<FaceId>) {
        slots.retain(|f| f.index() < self.cdt.face_slots() && self.cdt.is_real(*f));
        self.sort_by_vertices(&mut slots);
        slots.dedup();
        self.test_faces(&slots);
    }

    /// Splits the subsegment between two vertices, if it exists and there is room; returns whether it did.
    fn split_between(&mut self, [a, b]: [VertexId; 2], place: Option<SplitPlace>) -> bool {
        let Some(h) = self.cdt.half_edge_between(a, b) else { return false };
        self.split_near(h, place)
    }

    /// Splits a subsegment at the given or planned place, or else a few last places beside it; returns whether there
    /// was room.
    fn split_near(&mut self, h: HalfEdgeId, place: Option<SplitPlace>) -> bool {
        let Some(place) = place.or_else(|| self.plan_split(h).ok().map(|plan| plan.place)) else { return false };
        if self.split_at_place(h, place) {
            return true;
        }
        let mut beside = self.places_beside_on_boundary(h, place.point).into_iter();
        beside.any(|point| self.split_at_place(h, SplitPlace { point, shell: None }))
    }

    fn split_at_place(&mut self, h: HalfEdgeId, place: SplitPlace) -> bool {
        let provenance = self.provenance_of(h, place);
        let is_on_shell = matches!(provenance, Provenance::Shell { .. }) || self.is_around_joint(h, place);
        let plan = self.plan(Proposal::Split(h));
        let Ok(inserted) = self.insert(plan, Site::Edge(h, place.point, provenance)) else { return false };
        self.ledger.vertices += 1;
        self.ledger.report.segments_split += 1;
        self.note_inserted(
            inserted.vertex,
            if is_on_shell { InsertedKind::Shell } else { InsertedKind::SegmentMiddle },
        );
        self.test_around_inserted(inserted, place.point);
        true
    }

    /// How `h` can be split, or why it cannot.
    fn plan_split(&self, h: HalfEdgeId) -> Result<SplitPlan, Reason> {
        let acute = self.acute_ends(h);
        let mut place = self.split_place(h, acute)?;
        if let Err(SplitError::TooShort | SplitError::Crowded) = self.cdt.can_split(h, place.point) {
            let point = self.place_beside_gap(h, place.point).ok_or(Reason::PrecisionFloor)?;
            place = SplitPlace { point, shell: None };
        }
        Ok(SplitPlan { half_edge: h, apexes: self.apexes(h), acute, place })
    }

    /// The vertices opposite an edge, on its left and on its right.
    fn apexes(&self, h: HalfEdgeId) -> [VertexId; 2] {
        [self.cdt.apex(h), self.cdt.apex(self.cdt.twin(h))]
    }

    /// Where `h` is to be split, or why it must not be split.
    fn split_place(&self, h: HalfEdgeId, acute: [bool; 2]) -> Result<SplitPlace, Reason> {
        let on_boundary = self.cdt.is_boundary_edge(h);
        let protected = match self.problem.options.protect {
            Protect::None => false,
            Protect::Boundary => on_boundary,
            Protect::All => true,
        };
        if protected {
            return Err(Reason::ProtectedSegment);
        }
        let (t, mut shell) = self.split_parameter(h, acute);
        let mut point = self.point_at(h, t);
        if self.is_crowded_beside(h, point) {
            if let Some(staggered) = self.staggered_place(h) {
                (point, shell) = (staggered, None);
            }
        }
        let [a, b] = self.cdt.edge_points(h);
        if self.problem.ruler.length_sq(a, point).min(self.problem.ruler.length_sq(point, b))
            < self.problem.floors.floor_sq
        {
            return Err(self.problem.floors.floor_reason);
        }
        Ok(SplitPlace { point, shell })
    }

    /// The point at a parameter of `h`, computed from the ends of its piece.
    pub(super) fn point_at(&self, h: HalfEdgeId, t: f64) -> Point {
        match self.problem.joints.piece_along(&self.cdt, h) {
            Some(piece) => self.cdt.place_on_piece(h, piece, t),
            None => self.cdt.place_on_subsegment(h, t),
        }
    }

    /// The provenance of a vertex that splits `h`: its segment, and its circle if that is around an end of the segment.
    fn provenance_of(&self, h: HalfEdgeId, place: SplitPlace) -> Provenance {
        let provenance = self.cdt.provenance_on(h, place.point);
        if let (Some((exponent, around_b)), Provenance::OnSegment { segment, t }) = (place.shell, provenance) {
            let apex = if around_b { self.cdt.dest(h) } else { self.cdt.origin(h) };
            let ends = self.cdt.segments()[segment.index()];
            if ends.contains(&apex) {
                return Provenance::Shell { segment, t, around_end: apex == ends[1], shell: exponent };
            }
        }
        provenance
    }

    /// Whether a split of `h` lies on a circle around a joint inside the segment.
    fn is_around_joint(&self, h: HalfEdgeId, place: SplitPlace) -> bool {
        let Some((_, around_dest)) = place.shell else { return false };
        let apex = if around_dest { self.cdt.dest(h) } else { self.cdt.origin(h) };
        self.problem.joints.piece_along(&self.cdt, h).is_some_and(|piece| piece.contains(&apex))
    }

    /// The parameter of the split: on a circle around an end, if another segment meets only that end; else the mirror
    /// image of a vertex of another segment at less than a degree; else the middle.
    ///
    /// Splits at distances that are powers of two from a shared end lie on common circles, so that the subsegments of
    /// two segments that meet at a small angle stop encroaching upon each other.
    ///
    /// # Source
    /// Concentric shells: `[Ruppert95]` section 5; the power is chosen so that the split lies in the middle third.
    fn split_parameter(&self, h: HalfEdgeId, acute: [bool; 2]) -> (f64, Option<(i16, bool)>) {
        let around_b = match acute {
            [true, false] => false,
            [false, true] => true,
            _ => return (self.mirrored_place(h).unwrap_or(0.5), None),
        };
        let [a, b] = self.cdt.edge_points(h);
        let length = self.problem.ruler.length_sq(a, b).sqrt();
        if length.is_nan() || length < f64::MIN_POSITIVE {
            return (0.5, None); // Too short to measure: the length floor refuses it.
        }
        let (power, exponent) = power_of_two_below(length / 1.5);
        let t = power / length;
        (if around_b { 1.0 - t } else { t }, Some((exponent, around_b)))
    }

    /// Whether another constrained edge bounds one of the two triangles of `h`, at its origin and at its dest.
    ///
    /// For strategies that split on circles only at sharp joints, the angle there must be below 60 degrees.
    fn acute_ends(&self, h: HalfEdgeId) -> [bool; 2] {
        let t = self.cdt.twin(h);
        let meets = |g: HalfEdgeId, apex: VertexId, end: VertexId| {
            let finite = self.cdt.dest(g).is_finite() && self.cdt.origin(g).is_finite();
            finite
                && self.cdt.is_marked(g)
                && (self.strategy.traits.point.shells_at_every_joint || self.is_sharp(h, apex, end))
        };
        let (origin, dest) = (self.cdt.origin(h), self.cdt.dest(h));
        let (left, right) = (self.cdt.apex(h), self.cdt.apex(t));
        [
            meets(h.prev(), left, origin) || meets(t.next(), right, origin),
            meets(h.next(), left, dest) || meets(t.prev(), right, dest),
        ]
    }

    /// Whether the angle at an end of `h` between `apex` and the other end is less than 60 degrees.
    fn is_sharp(&self, h: HalfEdgeId, apex: VertexId, end: VertexId) -> bool {
        let other = if end == self.cdt.origin(h) { self.cdt.dest(h) } else { self.cdt.origin(h) };
        let [end, other, apex] = [end, other, apex].map(|v| self.cdt.point(v));
        let (u, v) = (self.problem.ruler.vector(end, other), self.problem.ruler.vector(end, apex));
        let dot = u.dot(v);
        dot > 0.0 && 4.0 * dot * dot > u.length_sq() * v.length_sq()
    }

    /// Deletes free vertices in the diametral disk of subsegment `h`, nearest triangle first, except those of a given
    /// mesh. Returns the faces that were tested.
    ///
    /// # Source
    /// `[Chew93]`: a split then makes no edge shorter than half the subsegment.
    fn delete_free_vertices(&mut self, h: HalfEdgeId) -> Vec<FaceId> {
        let mut tested = Vec::new();
        let (a, b) = (self.cdt.origin(h), self.cdt.dest(h));
        for (known, from, to) in [(h, a, b), (self.cdt.twin(h), b, a)] {
            // Each round deletes a vertex.
            for _ in 0..self.cdt.points().len() {
                let Some(h) = self.cdt.half_edge_between_known(from, to, known) else { return tested };
                let apex = self.cdt.apex(h);
                let inside = apex.is_finite()
                    && self.cdt.is_deletable(apex)
                    && in_diametral_disk(self.cdt.point(from), self.cdt.point(to), self.cdt.point(apex))
                        == CircleSide::Inside;
                if !inside || !self.delete_free_vertex(apex, &mut tested) {
                    break;
                }
            }
        }
        tested
    }

    /// The real faces inside a rim, given by the half-edges outside it, which no flip has moved.
    ///
    /// A hole of `n` edges has `n - 2` faces; those without an edge on the rim are found across the edges of others.
    fn hole_faces(&self, rim: &[HalfEdgeId]) -> Vec<FaceId> {
        let mut faces: Vec<FaceId> = Vec::with_capacity(rim.len());
        for &outer in rim {
            add_once(&mut faces, self.cdt.twin(outer).face());
        }
        let mut at = 0;
        while faces.len() + 2 < rim.len() {
            let Some(f) = faces.get(at) else { break };
            for inner in f.half_edges().map(|h| self.cdt.twin(h)).into_iter().filter(|h| !rim.contains(h)) {
                add_once(&mut faces, inner.face());
            }
            at += 1;
        }
        faces.retain(|&f| self.cdt.is_real(f));
        faces
    }

    /// Deletes a free vertex; tests the triangles and subsegments of the hole, and adds those triangles to a list.
    /// Returns whether the vertex could be deleted.
    pub(super) fn delete_free_vertex(&mut self, v: VertexId, tested: &mut Vec<FaceId>) -> bool {
        let at = self.cdt.point(v);
        // The half-edges outside the rim stay in their slots; the faces across them fill the hole afterwards.
        let rim: Vec<HalfEdgeId> = self.cdt.star(v).map(|h| self.cdt.twin(h.next())).collect();
        let is_delaunay = self.holds_circle_test();
        let link: Vec<VertexId> = if is_delaunay { Vec::new() } else { self.cdt.neighbours(v).collect() };
        if self.edit().remove(v).is_err() {
            return false;
        }
        self.note(|event| event.deleted.push((v, at)));
        self.ledger.vertices -= 1;
        self.ledger.report.vertices_deleted += 1;
        let mut faces: Vec<FaceId> = if is_delaunay {
            self.hole_faces(&rim)
        } else {
            // Flips may have continued beyond the rim, so the half-edges outside it may have moved.
            link.iter().flat_map(|&w| self.cdt.faces_around(w)).collect()
        };
        self.sort_by_vertices(&mut faces);
        faces.dedup();
        self.test_faces(&faces);
        tested.append(&mut faces);
        true
    }
}

fn add_once(faces: &mut Vec<FaceId>, f: FaceId) {
    if !faces.contains(&f) {
        faces.push(f);
    }
}

/// The greatest power of two not above a positive number, and its exponent.
fn power_of_two_below(x: f64) -> (f64, i16) {
    const EXPONENT: u64 = 0x7ff << 52;
    let bits = x.to_bits() & EXPONENT;
    #[allow(clippy::cast_possible_truncation, reason = "eleven bits")]
    let exponent = (bits >> 52) as i16 - 1023;
    (f64::from_bits(bits), exponent)
}
