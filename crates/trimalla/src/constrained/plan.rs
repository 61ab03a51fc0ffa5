//! Phase one of inserting a segment: what it crosses, looked up and changed by nobody.

use crate::geometry::{Orientation, lexicographic, orient2d};
use crate::mesh::{HalfEdgeId, VertexId};
use crate::triangulation::Triangulation;

/// What lies along a segment from a vertex towards another, up to the first vertex on it.
///
/// ```text
///          l1 ───── l2
///         / \      /  \          crossed: the edges from the right to the left of from–to, in order
///     from ═════════════ to      left:  l1 l2        (a vertex stands twice where the border of the
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
    /// Those of them that are constrained.
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

/// Why no plan can be made: the way leaves the triangulated domain across this boundary edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct LeavesDomain;

impl Triangulation {
    /// What inserting the segment from `from` to `to` would cross, up to the first vertex on its way.
    ///
    /// `None` where an end is unused, both are the same, or the way leaves the domain.
    ///
    /// # Complexity
    /// Linear in the degree of `from` and in the edges crossed.
    #[must_use]
    pub fn plan_segment(&self, from: VertexId, to: VertexId) -> Option<SegmentPlan> {
        (from != to && self.is_used(from) && self.is_used(to)).then(|| self.plan_towards(from, to).ok())?
    }

    pub(super) fn plan_towards(&self, from: VertexId, to: VertexId) -> Result<SegmentPlan, LeavesDomain> {
        let mut plan = SegmentPlan {
            from,
            to,
            existing: None,
            crossed: Vec::new(),
            constrained: Vec::new(),
            left: Vec::new(),
            right: Vec::new(),
            left_rim: Vec::new(),
            right_rim: Vec::new(),
        };
        match self.first_step(from, to)? {
            FirstStep::Along(h) => {
                plan.to = self.dest(h);
                plan.existing = Some(h);
            }
            FirstStep::Across(spoke) => self.march(&mut plan, spoke)?,
        }
        Ok(plan)
    }

    /// Turns around `from` until an edge runs along the segment, or a face has it strictly inside.
    fn first_step(&self, from: VertexId, to: VertexId) -> Result<FirstStep, LeavesDomain> {
        let (a, b) = (self.point(from), self.point(to));
        for h in self.star(from) {
            let x = self.dest(h);
            if !x.is_finite() {
                continue;
            }
            match orient2d(a, b, self.point(x)) {
                Orientation::Collinear if lexicographic(a, self.point(x)) == lexicographic(a, b) => {
                    return Ok(FirstStep::Along(h));
                }
                Orientation::Clockwise => {
                    let y = self.apex(h);
                    if y.is_finite() && orient2d(a, b, self.point(y)) == Orientation::CounterClockwise {
                        return Ok(FirstStep::Across(h));
                    }
                }
                _ => {}
            }
        }
        Err(LeavesDomain)
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
            match orient2d(a, b, self.point(z)) {
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

enum FirstStep {
    /// This edge runs along the segment.
    Along(HalfEdgeId),
    /// The segment leaves between this spoke and the next one counter-clockwise.
    Across(HalfEdgeId),
}
