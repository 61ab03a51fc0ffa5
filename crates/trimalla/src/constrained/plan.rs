//! Phase one of inserting a segment: collects what it crosses. Read-only.

use crate::geometry::{Orientation, lexicographic, orient2d};
use crate::half_edge::{HalfEdgeId, VertexId};
use crate::triangulation::Triangulation;

/// How many spokes around the start of a segment are tested before the search goes on at both ends.
const FIRST_SPOKES: usize = 32;

/// What lies along a segment from a vertex towards another, up to the first vertex on it.
///
/// ```text
///          l1 ───── l2
///         / \      /  \          crossed: the edges from the right to the left of from–to, in order
///     from ═════════════ to      left:  l1 l2        (a vertex stands twice where the boundary of the
///         \    \  /    /         right: r1            faces crossed passes it twice)
///          ──── r1 ────
/// ```
///
/// # Source
/// `[Vigo97]` section 4; `prepareConstrainedEdgeInsertion` of `[Valenzuela09]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SegmentPlan {
    /// Where the segment starts.
    pub from: VertexId,
    /// The first vertex on the way: the end asked for, or one exactly on the segment.
    pub to: VertexId,
    /// The edge, where there is one already; nothing is crossed then.
    pub existing: Option<HalfEdgeId>,
    /// Crossed edges, each from its right to its left end.
    pub crossed: Vec<HalfEdgeId>,
    /// The crossed edges that are constrained.
    pub constrained: Vec<HalfEdgeId>,
    /// Vertices left of the segment, from start to end.
    pub left: Vec<VertexId>,
    /// Vertices right of the segment, from start to end.
    pub right: Vec<VertexId>,
    /// Inner half-edges of the rim on the left, from the end at `from` to that at `to`.
    pub(super) left_rim: Vec<HalfEdgeId>,
    /// Inner half-edges of the rim on the right, from the end at `from` to that at `to`.
    pub(super) right_rim: Vec<HalfEdgeId>,
}

impl SegmentPlan {
    /// An empty plan.
    pub(super) fn new(from: VertexId, to: VertexId) -> Self {
        Self {
            from,
            to,
            existing: None,
            crossed: Vec::new(),
            constrained: Vec::new(),
            left: Vec::new(),
            right: Vec::new(),
            left_rim: Vec::new(),
            right_rim: Vec::new(),
        }
    }

    /// Clears the plan and keeps its allocations.
    fn start(&mut self, from: VertexId, to: VertexId) {
        (self.from, self.to, self.existing) = (from, to, None);
        self.left.clear();
        self.right.clear();
        for list in [&mut self.crossed, &mut self.constrained, &mut self.left_rim, &mut self.right_rim] {
            list.clear();
        }
    }
}

impl Default for SegmentPlan {
    fn default() -> Self {
        Self::new(VertexId(0), VertexId(0))
    }
}

/// Why no plan can be made: the way leaves the triangulated domain across this boundary edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct LeavesDomain;

impl Triangulation {
    /// What inserting the segment from `from` to `to` would cross, up to the first vertex on its way.
    ///
    /// `None` where an end is unused, both are the same, or the way leaves the domain.
    ///
    /// # Complexity
    /// Linear in the edges crossed, and in the degree of `from` or in those of the vertices from `to` on, whichever is
    /// less.
    #[must_use]
    pub fn plan_segment(&self, from: VertexId, to: VertexId) -> Option<SegmentPlan> {
        (from != to && self.is_used(from) && self.is_used(to)).then(|| self.plan_towards(from, to).ok())?
    }

    pub(super) fn plan_towards(&self, from: VertexId, to: VertexId) -> Result<SegmentPlan, LeavesDomain> {
        let mut plan = SegmentPlan::new(from, to);
        self.plan_into(&mut plan, from, to)?;
        Ok(plan)
    }

    /// [`plan_towards`](Self::plan_towards), written into an earlier plan to reuse its allocations.
    pub(super) fn plan_into(&self, plan: &mut SegmentPlan, from: VertexId, to: VertexId) -> Result<(), LeavesDomain> {
        plan.start(from, to);
        match self.first_step(from, to)? {
            FirstStep::Along(h) => {
                plan.to = self.dest(h);
                plan.existing = Some(h);
                Ok(())
            }
            FirstStep::Across(spoke) => self.march(plan, spoke),
        }
    }

    /// How the segment leaves `from`: along an edge, or across a face.
    ///
    /// Both ends are searched in turn, with twice the room each time, until one of the searches succeeds:
    ///
    /// 1. Around `from`, spoke by spoke: costs the degree of `from`.
    /// 2. From `to` on, face by face back to `from`: costs the degrees of `to` and of the vertices on the way, and the
    ///    faces crossed, all but the last of which the plan crosses too.
    ///
    /// Both find the same step, so that the cheaper one sets the cost and neither the result. A planar graph has few
    /// edges between vertices of high degree: the lower degree of the two ends, summed over all edges, is linear in
    /// their number.
    ///
    /// # Source
    /// The sum of lower degrees: `[ChibaNishizeki85]`, lemma 2.
    pub(super) fn first_step(&self, from: VertexId, to: VertexId) -> Result<FirstStep, LeavesDomain> {
        let around = self.turn(from, to, FIRST_SPOKES)?;
        around.map_or_else(|| self.first_step_at_hub(from, to), Ok)
    }

    /// [`first_step`](Self::first_step) from a vertex of high degree.
    #[cold]
    #[inline(never)]
    fn first_step_at_hub(&self, from: VertexId, to: VertexId) -> Result<FirstStep, LeavesDomain> {
        let mut room = FIRST_SPOKES;
        // At the latest with room for every face the turn around `from` ends.
        while room < self.face_slots() {
            room = room.saturating_mul(2);
            let found = self.arrive(from, to, room).map_or_else(|| self.turn(from, to, room), |step| Ok(Some(step)))?;
            if let Some(step) = found {
                return Ok(step);
            }
        }
        self.turn(from, to, usize::MAX)?.ok_or(LeavesDomain)
    }

    /// Follows the segment from `to` back to `from`, across that many faces and spokes at most: its last step, turned
    /// around, is the first one from `from`.
    fn arrive(&self, from: VertexId, to: VertexId, room: usize) -> Option<FirstStep> {
        let (mut at, mut left) = (to, room);
        let (a, b) = (self.point(to), self.point(from));
        while left > 0 {
            let mut edge = match self.turn(at, from, left).ok()?? {
                FirstStep::Along(h) if self.dest(h) == from => return Some(FirstStep::Along(self.twin(h))),
                FirstStep::Along(h) => {
                    (at, left) = (self.dest(h), left - 1);
                    continue;
                }
                FirstStep::Across(spoke) => spoke.next(),
            };
            at = loop {
                left = left.checked_sub(1)?;
                let t = self.twin(edge);
                let z = self.apex(t);
                if z == from {
                    return Some(FirstStep::Across(t.prev()));
                }
                if !z.is_finite() {
                    return None;
                }
                edge = match orient2d(a, b, self.point(z)) {
                    Orientation::Collinear => break z,
                    Orientation::CounterClockwise => t.next(),
                    Orientation::Clockwise => t.prev(),
                };
            };
        }
        None
    }

    /// Turns around `from` until an edge runs along the segment, or a face has it strictly inside; `None` if that takes
    /// more than `spokes` spokes.
    ///
    /// ```text
    ///        l  l            a turn that starts on the right goes counter-clockwise, one that starts
    ///         \ |            on the left clockwise: the shorter way to where the side changes
    ///      r ─ from ═══▶ to
    ///         / |
    ///        r  r
    /// ```
    fn turn(&self, from: VertexId, to: VertexId, spokes: usize) -> Result<Option<FirstStep>, LeavesDomain> {
        let first = self.outgoing(from).ok_or(LeavesDomain)?;
        let (mut spoke, mut bearing) = (first, self.bearing(first, from, to));
        let clockwise = bearing == Bearing::Left;
        // A star has no more spokes than there are faces.
        for _ in 0..spokes.min(self.face_slots()) {
            if bearing == Bearing::Ahead {
                return Ok(Some(FirstStep::Along(spoke)));
            }
            let next = if clockwise { self.cw(spoke) } else { self.ccw(spoke) };
            if next == first {
                return Err(LeavesDomain);
            }
            let next_bearing = self.bearing(next, from, to);
            match (bearing, next_bearing) {
                (Bearing::Right, Bearing::Left) if !clockwise => return Ok(Some(FirstStep::Across(spoke))),
                (Bearing::Left, Bearing::Right) if clockwise => return Ok(Some(FirstStep::Across(next))),
                _ => (spoke, bearing) = (next, next_bearing),
            }
        }
        Ok(None)
    }

    /// Where a spoke of `from` points.
    #[inline(always)]
    fn bearing(&self, spoke: HalfEdgeId, from: VertexId, to: VertexId) -> Bearing {
        let x = self.dest(spoke);
        if x == to {
            return Bearing::Ahead;
        }
        if !x.is_finite() {
            return Bearing::Elsewhere;
        }
        let [a, b, x] = [from, to, x].map(|v| self.point(v));
        match orient2d(a, b, x) {
            Orientation::CounterClockwise => Bearing::Left,
            Orientation::Clockwise => Bearing::Right,
            Orientation::Collinear if lexicographic(a, x) == lexicographic(a, b) => Bearing::Ahead,
            Orientation::Collinear => Bearing::Elsewhere,
        }
    }

    /// Goes from face to face along the segment; `spoke` is the first face's edge at its start.
    fn march(&self, plan: &mut SegmentPlan, spoke: HalfEdgeId) -> Result<(), LeavesDomain> {
        let (a, b) = (self.point(plan.from), self.point(plan.to));
        let mut edge = spoke.next();
        plan.right.push(self.origin(edge));
        plan.left.push(self.dest(edge));
        plan.right_rim.push(spoke);
        plan.left_rim.push(spoke.prev());
        for _ in 0..self.face_slots() {
            plan.crossed.push(edge);
            if self.is_marked(edge) {
                plan.constrained.push(edge);
            }
            let t = self.twin(edge);
            let z = self.apex(t);
            if !z.is_finite() {
                return Err(LeavesDomain);
            }
            // In face (y, x, z): t = y→x, then x→z on the right, z→y on the left.
            let side = if z == plan.to { Orientation::Collinear } else { orient2d(a, b, self.point(z)) };
            match side {
                Orientation::Collinear => {
                    plan.to = z;
                    plan.right_rim.push(t.next());
                    plan.left_rim.push(t.prev());
                    return Ok(());
                }
                Orientation::CounterClockwise => {
                    plan.left.push(z);
                    plan.left_rim.push(t.prev());
                    edge = t.next();
                }
                Orientation::Clockwise => {
                    plan.right.push(z);
                    plan.right_rim.push(t.next());
                    edge = t.prev();
                }
            }
        }
        Err(LeavesDomain)
    }
}

/// Where a spoke points, seen along the segment.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Bearing {
    /// Along the segment.
    Ahead,
    Left,
    Right,
    /// To infinity, or backwards.
    Elsewhere,
}

/// How a segment leaves a vertex.
pub(super) enum FirstStep {
    /// This edge runs along the segment.
    Along(HalfEdgeId),
    /// The segment leaves between this spoke and the next one counter-clockwise.
    Across(HalfEdgeId),
}
