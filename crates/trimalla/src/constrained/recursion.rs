//! The recursion beside a planned segment, call by call, for pictures and explanations.

use std::ops::{Range, RangeInclusive};

use super::plan::SegmentPlan;
use super::pseudo_polygon::{Watch, watch_recursion};
use crate::geometry::{Circle, Point, Triangle};
use crate::half_edge::VertexId;
use crate::triangulation::Triangulation;

/// Vigo's recursion on one side of a planned segment.
///
/// ```text
///              2 ─── 3 ─ 4                 the boundary: from one end of the segment to the other, the region on
///            /          /                  the left of the base 0 → 5; the first call chooses a corner for it, say 2,
///          1           /                   and leaves the stretches 2..=5 and 0..=2
///        /            /
///      0 ═══════════ 5
/// ```
///
/// # Source
/// `TriangulatePseudopolygonDelaunay` of `[Vigo97]`, section 4, figures 5, 6 and 8; figures 5.1 to 5.3 of
/// `[Valenzuela09]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Recursion {
    /// The vertices of the boundary; one stands twice where the boundary passes it twice.
    pub boundary: Vec<VertexId>,
    /// The calls, in order.
    pub calls: Vec<RecursionCall>,
    /// Whether the calls fill the region. They do, unless the plan is out of date.
    pub is_complete: bool,
}

/// One call of the recursion. Vertices are given by their positions in the boundary.
#[derive(Clone, Debug, PartialEq)]
pub struct RecursionCall {
    /// Where the stretch begins; the base leads from there to its end.
    pub first: usize,
    /// Where the stretch ends.
    pub last: usize,
    /// The vertices that were the best corner until another one lay in the circle through them and the base; the chosen
    /// one is the last.
    pub improved: Vec<usize>,
    /// The vertex whose circle with the base holds no other of the stretch.
    pub chosen: usize,
    /// The circle through the base and the chosen vertex, rounded; `None` where its numbers overflow.
    pub circle: Option<Circle>,
}

impl RecursionCall {
    /// The vertices of the stretch, the ends of the base included.
    #[must_use]
    pub fn stretch(&self) -> RangeInclusive<usize> {
        self.first..=self.last
    }

    /// The vertices that are tried, in order.
    #[must_use]
    pub fn tried(&self) -> Range<usize> {
        self.first + 1..self.last
    }

    /// The two stretches that are left, each with a side of the new triangle for its base. One of two vertices is an
    /// edge that is there, and not called for; the calls for the first come before those for the second.
    #[must_use]
    pub fn left(&self) -> [RangeInclusive<usize>; 2] {
        [self.first..=self.chosen, self.chosen..=self.last]
    }
}

impl Triangulation {
    /// The recursion on the left and on the right of a planned segment: what inserting it by
    /// [`Filling::Recursive`](super::Filling::Recursive) does, call by call. The right side is seen from the other end,
    /// so that its region is on the left of its base, too.
    ///
    /// `None` where the edge is there already, and for a plan of another triangulation.
    ///
    /// # Complexity
    /// Quadratic in the vertices on a side at worst.
    #[must_use]
    pub fn plan_recursion(&self, plan: &SegmentPlan) -> Option<[Recursion; 2]> {
        let is_vertex = |v: &VertexId| v.index() < self.points().len();
        let ends = [plan.from, plan.to];
        let are_vertices = ends.iter().chain(&plan.left).chain(&plan.right).all(is_vertex);
        if plan.existing.is_some() || !are_vertices {
            return None;
        }
        let around = |from, between: &mut dyn Iterator<Item = VertexId>, to| {
            std::iter::once(from).chain(between).chain(std::iter::once(to)).collect()
        };
        let left = around(plan.from, &mut plan.left.iter().copied(), plan.to);
        let right = around(plan.to, &mut plan.right.iter().rev().copied(), plan.from);
        Some([left, right].map(|boundary| self.recursion_of(boundary)))
    }

    fn recursion_of(&self, boundary: Vec<VertexId>) -> Recursion {
        let points: Vec<Point> = boundary.iter().map(|&v| self.point(v)).collect();
        let mut notes = Notes { points: &points, calls: Vec::new(), improved: Vec::new() };
        let is_complete = watch_recursion(&points, &mut notes);
        Recursion { calls: notes.calls, boundary, is_complete }
    }
}

/// Notes the calls.
struct Notes<'a> {
    points: &'a [Point],
    calls: Vec<RecursionCall>,
    /// The vertices that were the best corner of the present call, in order.
    improved: Vec<usize>,
}

impl Watch for Notes<'_> {
    fn improved(&mut self, vertex: u32) {
        self.improved.push(vertex as usize);
    }

    fn chosen(&mut self, first: u32, last: u32, corner: u32) {
        let [first, last, chosen] = [first, last, corner].map(|v| v as usize);
        let [a, b, c] = [first, last, chosen].map(|i| self.points[i]);
        let circle = Triangle::new(a, b, c).circumcircle();
        self.calls.push(RecursionCall { first, last, improved: std::mem::take(&mut self.improved), chosen, circle });
    }
}
