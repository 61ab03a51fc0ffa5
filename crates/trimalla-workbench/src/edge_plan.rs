//! What inserting an edge would do, step by step, as values.

use trimalla::constrained::{ConstrainedTriangulation, Recursion, RecursionCall, SegmentPlan};
use trimalla::geometry::Point;
use trimalla::half_edge::VertexId;

use crate::document::Document;
use crate::error::CommandError;

/// Longer sides are not filled in a plan, as the recursion is quadratic at worst. `Edge` fills them in linear time.
const MOST_ON_A_SIDE: usize = 2000;

/// A vertex: its name, and where it lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NamedPoint {
    /// The name.
    pub name: u32,
    /// The place.
    pub at: Point,
}

/// What inserting a constrained edge would do, up to the first vertex on its way.
///
/// # Source
/// The data between the two phases of section 5.1.1 of `[Valenzuela09]`, figures 5.1 to 5.3; the recursion of
/// `[Vigo97]`, figures 5, 6 and 8.
#[derive(Clone, Debug, PartialEq)]
pub struct EdgePlan {
    /// Where the edge begins.
    pub from: NamedPoint,
    /// The first vertex on its way: the end that was asked for, or one exactly on the edge.
    pub to: NamedPoint,
    /// Whether the edge is there already; all lists are empty then.
    pub is_there: bool,
    /// The edges that it crosses, in order, each from its right to its left end.
    pub crossed: Vec<[NamedPoint; 2]>,
    /// Those that are constrained: `Edge` splits them.
    pub constrained: Vec<[NamedPoint; 2]>,
    /// The pseudo-polygon on the left.
    pub left: PlanSide,
    /// The pseudo-polygon on the right, seen from the other end.
    pub right: PlanSide,
}

/// The pseudo-polygon on one side of an edge that is planned.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlanSide {
    /// Its vertices from one end of the edge to the other; the region lies on the left of the way back.
    pub boundary: Vec<NamedPoint>,
    /// The calls of the recursion that fills it, in order, with positions in the boundary. None where the boundary has
    /// more than 2000 vertices.
    pub calls: Vec<RecursionCall>,
}

impl Document {
    /// What inserting a constrained edge between two vertices, given by their names, would do.
    ///
    /// # Errors
    /// [`CommandError`] where there is no such vertex, nothing is triangulated, or the way leaves the domain.
    pub fn edge_plan(&self, i: u32, j: u32) -> Result<EdgePlan, CommandError> {
        let Some(t) = self.triangulation() else { return Err(CommandError::nothing_triangulated()) };
        let ends = [self.state().vertex(i)?, self.state().vertex(j)?];
        let none = || CommandError::new(format!("no edge can lead from vertex {i} to vertex {j}"));
        let plan = t.plan_segment(ends[0], ends[1]).ok_or_else(none)?;
        let named = |v: VertexId| NamedPoint { name: self.name(v), at: t.point(v) };
        let edges = |all: &[_]| all.iter().map(|&h| [t.origin(h), t.dest(h)].map(named)).collect();
        let [left, right] = recursion(t, &plan)
            .map(|side| PlanSide { boundary: side.boundary.into_iter().map(named).collect(), calls: side.calls });
        Ok(EdgePlan {
            from: named(plan.from),
            to: named(plan.to),
            is_there: plan.existing.is_some(),
            crossed: edges(&plan.crossed),
            constrained: edges(&plan.constrained),
            left,
            right,
        })
    }
}

/// The recursion on both sides of a plan; without calls where a side is too long.
fn recursion(t: &ConstrainedTriangulation, plan: &SegmentPlan) -> [Recursion; 2] {
    if plan.left.len().max(plan.right.len()) + 2 <= MOST_ON_A_SIDE {
        if let Some(sides) = t.plan_recursion(plan) {
            return sides;
        }
    }
    let side = |vertices: Vec<VertexId>, ends: [VertexId; 2]| {
        let is_there = vertices.is_empty();
        let boundary = std::iter::once(ends[0]).chain(vertices).chain(std::iter::once(ends[1]));
        Recursion { boundary: boundary.filter(|_| !is_there).collect(), calls: Vec::new(), is_complete: false }
    };
    let right = plan.right.iter().rev().copied().collect();
    [side(plan.left.clone(), [plan.from, plan.to]), side(right, [plan.to, plan.from])]
}
