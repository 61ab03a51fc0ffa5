//! Triangulation of the pseudo-polygon on one side of a new segment.
//!
//! The vertices on one side of the segment, from its one end to its other, bound a region without
//! triangles. It may touch itself: a vertex from which edges dangle into the region stands in the
//! list once for each time the boundary passes it.
//!
//! ```text
//!              2 ─── 3 ─ 4                 base: from 0 to 5; the region lies on its left
//!            /          /                  rim i: between i and i + 1
//!          1           /
//!        /            /
//!      0 ═══════════ 5
//! ```
//!
//! Two ways to fill it, with one result:
//! * [`randomised`]: expected linear time, the default for all but short boundaries;
//! * [`recursive`]: Vigo's, quadratic; fast where the boundary is short. The step view and the oracle use it, and it
//!   takes over where the former meets a region too twisted for it.
//!
//! # Guarantees
//! Every vertex of the boundary sees the base: edges lead from it across the base, which no other part of the boundary
//! crosses. So the constrained Delaunay triangulation of the region is found by circles alone, as `[Vigo97]` shows.
//! Only signs of the exact predicates decide.

mod randomised;
mod recursive;
#[cfg(test)]
mod tests;

use crate::geometry::{CircleSide, Orientation, Point, in_circle_perturbed, orient2d};
use crate::half_edge::Patch;
pub(super) use recursive::Watch;

/// Up to this many boundary vertices recursion is quicker.
const SHORT: usize = 24;

/// How a pseudo-polygon is filled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Filling {
    /// In expected linear time, `[ShewchukBrown15]`.
    #[default]
    Randomised,
    /// By recursion, `[Vigo97]` section 4; quadratic at worst.
    Recursive,
}

/// Whether the inner edges of a filling pass the circle test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Edges {
    /// All pass the circle test.
    Legal,
    /// Some may not.
    Unproved,
}

/// Fills pseudo-polygons, one after the other, and keeps its scratch.
#[derive(Clone, Debug, Default)]
pub(super) struct Filler {
    /// The boundary of the next one.
    pub(super) points: Vec<Point>,
    randomised: randomised::Room,
    recursive: recursive::Room,
}

impl Filler {
    /// Fills the pseudo-polygon with one triangle fewer than two for each vertex, all counter-clockwise.
    ///
    /// Returns `None` only where the points do not bound such a region.
    pub(super) fn fill(&mut self, patch: &mut Patch, filling: Filling) -> Option<Edges> {
        let boundary = Boundary(&self.points);
        if filling == Filling::Randomised && self.points.len() > SHORT {
            if let Some(edges) = randomised::fill(boundary, patch, &mut self.randomised) {
                return Some(edges);
            }
        }
        recursive::fill(boundary, patch, &mut self.recursive, &mut ())
    }
}

/// Fills the pseudo-polygon of some points by recursion and watches it; returns whether the points bound such a region.
///
/// # Complexity
/// Quadratic at worst.
pub(super) fn watch_recursion(points: &[Point], watch: &mut impl Watch) -> bool {
    recursive::fill(Boundary(points), &mut Patch::default(), &mut recursive::Room::default(), watch).is_some()
}

/// The boundary of a pseudo-polygon; its vertices are named by their positions.
#[derive(Clone, Copy, Debug)]
struct Boundary<'a>(&'a [Point]);

impl Boundary<'_> {
    /// Number of vertices; `None` where there are too few for a triangle.
    fn len(self) -> Option<u32> {
        u32::try_from(self.0.len()).ok().filter(|&n| n >= 3)
    }

    #[inline]
    fn at<const N: usize>(self, vertices: [u32; N]) -> [Point; N] {
        vertices.map(|i| self.0[i as usize])
    }

    /// Whether the triangle of three vertices is strictly counter-clockwise.
    #[inline]
    fn is_ccw(self, triangle: [u32; 3]) -> bool {
        let [a, b, c] = self.at(triangle);
        orient2d(a, b, c) == Orientation::CounterClockwise
    }

    /// Whether a vertex lies inside the circle of a counter-clockwise triangle.
    #[inline]
    fn is_inside(self, triangle: [u32; 3], d: u32) -> bool {
        is_inside(self.at(triangle), self.0[d as usize])
    }
}

/// Whether a point lies inside the circle of a counter-clockwise triangle; a vertex that stands on the boundary twice
/// is not inside a circle through itself.
#[inline]
fn is_inside([a, b, c]: [Point; 3], d: Point) -> bool {
    in_circle_perturbed(a, b, c, d) == CircleSide::Inside && d != a && d != b && d != c
}
