//! Triangulation of the pseudo-polygon on one side of a new segment.
//!
//! The vertices on one side of the segment, from its one end to its other, bound a region without
//! triangles. It may touch itself: a vertex from which edges dangle into the region stands in the
//! list once for each time the border passes it.
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
//! * [`randomised`]: expected linear time, the default;
//! * [`recursive`]: Vigo's, quadratic; the step view's, the oracle's, and what is fallen back on where
//!   the former meets a region too twisted for it.

mod randomised;
mod recursive;
#[cfg(test)]
mod tests;

use crate::geometry::{CircleSide, Orientation, Point, in_circle_perturbed, orient2d};

/// What lies across a side of a filled triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Across {
    /// Side `.1` of triangle `.0` of the same filling.
    Triangle(u32, u32),
    /// The rim between vertices `i` and `i + 1`.
    Rim(u32),
    /// The base.
    Base,
}

/// A triangle of a filling: positions in the list of vertices, counter-clockwise, and what lies
/// across the side from `vertices[k]` to `vertices[k + 1]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Filled {
    pub(super) vertices: [u32; 3],
    pub(super) across: [Across; 3],
}

/// How a pseudo-polygon is filled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Filling {
    /// In expected linear time, `[ShewchukBrown15]`.
    #[default]
    Randomised,
    /// By recursion, `[Vigo97]` section 4; quadratic at worst.
    Recursive,
}

/// Fills the pseudo-polygon with one triangle fewer than two for each vertex, all counter-clockwise.
///
/// Returns `None` only where the vertices do not bound such a region.
pub(super) fn fill(points: &[Point], filling: Filling) -> Option<Vec<Filled>> {
    match filling {
        Filling::Randomised => randomised::fill(points).or_else(|| recursive::fill(points)),
        Filling::Recursive => recursive::fill(points),
    }
}

/// Whether the triangle of three positions is strictly counter-clockwise.
fn is_ccw(points: &[Point], [a, b, c]: [u32; 3]) -> bool {
    let [a, b, c] = [a, b, c].map(|i| points[i as usize]);
    orient2d(a, b, c) == Orientation::CounterClockwise
}

/// Whether `d` lies inside the circle of counter-clockwise `a`, `b`, `c`; a vertex that stands in the list twice
/// is not inside a circle through itself.
fn is_inside(points: &[Point], [a, b, c]: [u32; 3], d: u32) -> bool {
    let [a, b, c, d] = [a, b, c, d].map(|i| points[i as usize]);
    d != a && d != b && d != c && in_circle_perturbed(a, b, c, d) == CircleSide::Inside
}
