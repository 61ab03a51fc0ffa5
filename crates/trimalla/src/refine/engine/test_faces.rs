//! Tests of new faces: bad triangles join the queue, and so do subsegments that need a split.

use super::Refinement;
use crate::delaunay::Cavity;
use crate::geometry::Point;
use crate::half_edge::{FaceId, HalfEdgeId, VertexId, push_if};
use crate::refine::agenda::queue::Queue;
use crate::refine::agenda::rank_buckets::RankBuckets;
use crate::refine::criteria::bad_triangles::{Criterion, Side, UniformBounds};
use crate::refine::criteria::badness::Badness;
use crate::refine::steps::{SelectStep, View};
use crate::refine::watch::stopwatch::Part;
use crate::triangulation::corners_of_two;

/// Tests triangles, and queues the bad ones.
struct Tester<'a> {
    view: View<'a>,
    test: &'a Criterion,
    select: &'a (dyn SelectStep + Send + Sync),
    /// Whether the caller picks the triangles: then none is queued.
    is_manual: bool,
    /// The cavity that was filled last.
    cavity: &'a Cavity,
    /// Scratch: the numbers of the bad triangles in the fan of that cavity.
    bad: &'a mut Vec<usize>,
    /// The subsegments at the faces that were tested.
    beside: &'a mut Vec<HalfEdgeId>,
    queue: &'a mut Queue,
    sequence: &'a mut u64,
}

impl Tester<'_> {
    /// Queues a face if it is bad.
    #[inline(never)]
    fn test(&mut self, f: FaceId) {
        self.queue.invalidate(f);
        let corners = self.view.cdt.corners_from_newest(f);
        if self.is_bad(f, corners) {
            self.queue_bad(f, corners, self.queue.patch_at(corners[0]));
        }
    }

    /// Tests all triangles; queues the bad ones by the ranks of their vertices in that order.
    fn test_all(&mut self, order: Vec<VertexId>) {
        let cdt = self.view.cdt;
        let bounds = self.uniform_bounds();
        let mut bad = Vec::new();
        cdt.for_each_two_triangles(|two, n| {
            for (t, is_bad) in two[..n].iter().zip(bounds.are_bad(corners_of_two(two))) {
                let is_bad = is_bad.unwrap_or_else(|| self.is_bad(t.face, cdt.corners_from_newest(t.face)));
                push_if(&mut bad, t.face, is_bad);
                self.queue.invalidate(t.face);
            }
        });
        self.queue.reserve(bad.len(), cdt.face_slots());
        let mut in_order = Vec::with_capacity(bad.len());
        RankBuckets::of(cdt, bad, order).for_each(cdt, |f| in_order.push(f));
        cdt.for_each_with_corners(&in_order, |f, corners| self.queue_bad(f, corners, self.queue.patch_at(corners[0])));
    }

    /// Whether a face with these corners is to be queued.
    #[inline(never)]
    fn is_bad(&self, f: FaceId, corners: [Point; 3]) -> bool {
        !self.is_manual && self.test.badness(self.view.cdt, f, corners).is_some()
    }

    /// Bounds that decide for most faces whether they are queued.
    fn uniform_bounds(&self) -> UniformBounds {
        let bounds = self.test.uniform_bounds();
        if self.is_manual { bounds.undecided() } else { bounds }
    }

    /// Queues a bad face.
    #[inline(always)] // Once for each bad triangle.
    fn queue_bad(&mut self, f: FaceId, corners: [Point; 3], patch: usize) {
        let priority = self.select.priority_of_corners(self.view, f, corners, *self.sequence);
        *self.sequence += 1;
        self.queue.push(self.view.cdt, f, patch, priority);
    }

    /// Tests the fan that fills the cavity, from vertex `v` at `p`. Queues the bad triangles counter-clockwise from the
    /// lowest vertex of the rim on, an order that does not depend on slots. Adds the rim edges and spokes that are
    /// subsegments to the list of subsegments.
    ///
    /// ```text
    ///        d ─ c           One pass around the rim: each triangle's second spoke is the first spoke of the next. Bad
    ///       / \ / \          triangles are listed by number, since the lowest vertex is known only at the end.
    ///      e ─ v ─ b
    ///       \ / \ /
    ///        f ─ a
    /// ```
    #[inline(never)]
    fn test_fan(&mut self, v: VertexId, p: Point) {
        let cavity = self.cavity;
        let (faces, rim, starts) = (cavity.faces(), cavity.rim(), cavity.rim_starts());
        self.queue.make_room_for(self.view.cdt.face_slots());
        self.queue.note_stamps(faces);
        self.bad.clear();
        let (mut first, mut turn, mut lowest, mut newest, mut marks) = (0, 0, VertexId::INFINITE, v, 0);
        let (bounds, mut spoke) = (self.uniform_bounds(), Side::new(p, starts[0]));
        for (k, ((&face, edge), ends)) in faces.iter().zip(rim).zip(starts.windows(2)).enumerate() {
            (first, turn, lowest) =
                if edge.from < lowest { (k, self.bad.len(), edge.from) } else { (first, turn, lowest) };
            newest = newest.max(edge.from);
            marks |= edge.mark | edge.spoke;
            let next = Side::new(p, ends[1]);
            let corners = [p, ends[0], ends[1]];
            let is_bad = bounds.is_bad(corners, [spoke, next]);
            let is_bad = is_bad.unwrap_or_else(|| self.view.cdt.is_real(face) && self.is_bad(face, corners));
            push_if(self.bad, k, is_bad);
            self.queue.invalidate_unnoted(face);
            spoke = next;
        }
        // The new vertex has the highest id, unless it reuses the slot of a deleted vertex or the fan has a ghost face.
        if v == newest {
            let patch = self.queue.patch_at(p);
            let count = self.bad.len();
            for i in turn..turn + count {
                let k = self.bad[if i < count { i } else { i - count }];
                self.queue_bad(faces[k], [p, starts[k], starts[k + 1]], patch);
            }
        } else {
            let real = |f: &FaceId| self.view.cdt.is_real(*f);
            faces[first..].iter().chain(&faces[..first]).copied().filter(real).for_each(|f| self.test(f));
        }
        if marks != 0 {
            self.add_subsegments_of_fan();
        }
    }

    /// Adds the rim edges and spokes of the fan that are subsegments to the list of subsegments.
    #[inline(never)]
    fn add_subsegments_of_fan(&mut self) {
        let cavity = self.cavity;
        for (face, edge) in cavity.faces().iter().zip(cavity.rim()) {
            if edge.mark | edge.spoke != 0 {
                push_if(self.beside, face.half_edge(0), edge.mark != 0);
                push_if(self.beside, face.half_edge(2), edge.spoke != 0);
            }
        }
    }
}

impl Refinement {
    fn tester(&mut self) -> Tester<'_> {
        Tester {
            view: self.problem.view(&self.cdt, &self.strategy),
            test: &self.problem.test,
            select: self.strategy.steps.select.as_ref(),
            is_manual: self.strategy.traits.select.is_manual,
            cavity: &self.scratch.cavity,
            bad: &mut self.scratch.bad_in_fan,
            beside: &mut self.scratch.beside,
            queue: &mut self.agenda.queue,
            sequence: &mut self.agenda.sequence,
        }
    }

    /// Queues every subsegment that needs a split, and every bad triangle.
    pub(super) fn test_everything(&mut self) {
        let before = self.ledger.stopwatch.enter(Part::Prepare);
        self.queue_all_encroached();
        self.ledger.stopwatch.enter(Part::Select);
        let order = self.cdt.take_order_along_curve();
        self.tester().test_all(order);
        self.ledger.stopwatch.enter(before);
    }

    /// Tests the faces and subsegments around a vertex that has been inserted.
    pub(super) fn test_star(&mut self, v: VertexId) {
        let before = self.ledger.stopwatch.enter(Part::Select);
        let mut spokes = std::mem::take(&mut self.scratch.spokes);
        spokes.clear();
        spokes.extend(self.cdt.star(v));
        // Starts at the lowest neighbour, so that the order does not depend on slots; infinity is the highest.
        let first = (0..spokes.len()).min_by_key(|&i| self.cdt.dest(spokes[i])).unwrap_or(0);
        spokes.rotate_left(first);
        for &spoke in &spokes {
            let is_real = self.cdt.is_real(spoke.face());
            if is_real {
                self.test_face(spoke.face());
            }
            let beside = &mut self.scratch.beside;
            beside.extend(self.cdt.is_marked(spoke).then_some(spoke));
            beside.extend((is_real && self.cdt.is_marked(spoke.next())).then_some(spoke.next()));
        }
        self.scratch.spokes = spokes;
        self.queue_encroached_beside();
        self.ledger.stopwatch.enter(before);
    }

    /// Tests the fan of a vertex at `p` that has just filled its cavity, which lists the faces: faster than
    /// [`test_star`](Self::test_star).
    pub(super) fn test_fan(&mut self, v: VertexId, p: Point) {
        let before = self.ledger.stopwatch.enter(Part::Select);
        self.tester().test_fan(v, p);
        self.queue_encroached_beside();
        self.ledger.stopwatch.enter(before);
    }

    /// Sorts faces by their vertices, since triangles of equal priority are treated in the order in which they were
    /// queued.
    pub(super) fn sort_by_vertices(&self, faces: &mut [FaceId]) {
        faces.sort_unstable_by_key(|&f| self.cdt.face_key(f));
    }

    /// Tests faces that are new or have changed: queues the bad ones, and the encroached subsegments beside them.
    pub(super) fn test_faces(&mut self, faces: &[FaceId]) {
        let before = self.ledger.stopwatch.enter(Part::Select);
        for &f in faces {
            self.test_face(f);
            self.scratch.beside.extend(f.half_edges().into_iter().filter(|&h| self.cdt.is_marked(h)));
        }
        self.queue_encroached_beside();
        self.ledger.stopwatch.enter(before);
    }

    /// Queues those subsegments beside the tested faces that need a split, sorted by their vertices, so that the order
    /// of the faces does not matter; empties the list.
    #[inline(always)] // After each insertion, and most are near no subsegment.
    fn queue_encroached_beside(&mut self) {
        if !self.scratch.beside.is_empty() {
            self.queue_encroached_among();
        }
    }

    #[inline(never)]
    fn queue_encroached_among(&mut self) {
        if !self.strategy.steps.prepare.is_lasting() {
            return self.scratch.beside.clear();
        }
        let mut subsegments = std::mem::take(&mut self.scratch.beside);
        let before = self.ledger.stopwatch.enter(Part::Prepare);
        subsegments.retain(|&h| self.needs_split(h));
        subsegments.sort_unstable_by_key(|&h| self.cdt.edge_key(h));
        subsegments.dedup_by_key(|h| self.cdt.edge_key(*h));
        for h in subsegments.drain(..) {
            // A subsegment that cannot be split stays encroached; triangles beside it get that as their reason.
            let _ = self.queue_subsegment(h, false);
        }
        self.scratch.beside = subsegments;
        self.ledger.stopwatch.enter(before);
    }

    /// What is wrong with a face, if anything.
    pub(super) fn badness(&self, f: FaceId) -> Option<Badness> {
        self.problem.test.badness(&self.cdt, f, self.cdt.corners_from_newest(f))
    }

    /// Queues a face if it is bad.
    pub(super) fn test_face(&mut self, f: FaceId) {
        self.tester().test(f);
    }
}
