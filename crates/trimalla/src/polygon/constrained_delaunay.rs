//! `constrained-delaunay`: any triangulation of the polygon, and then flips of edges that fail the circle test.
//!
//! ```text
//!          c                     c
//!        /   \                 / | \
//!       /  h  \               /  |  \       h is illegal if d lies inside the circle of a, b, c. Then it is replaced
//!      a ----- b      ->     a   |   b      by the other diagonal, and the four edges around are looked at again.
//!       \  g  /               \  |  /
//!        \   /                 \ | /
//!          d                     d
//! ```
//!
//! 1. Triangulate the polygon in any way.
//! 2. Find the edges between two triangles; the others are sides of the polygon, and stay.
//! 3. Put all of them on a stack. Take one after the other; if it is illegal, flip it, and put the four edges around on
//!    the stack.
//!
//! The constrained Delaunay triangulation is the only one without illegal edges, ties being broken as everywhere here,
//! so the result does not depend on step 1.
//!
//! # Degenerate cases
//! Where rings touch in a place that has two indices, the edges that end there under different indices do not adjoin
//! each other, and are not flipped.
//!
//! # Complexity
//! O(n log n) for step 1, O(n²) flips at worst; few where step 1 cuts off what is near. O(n) memory.
//!
//! # Source
//! `[LeeLin86]`; `[Lawson77]` for the flips.

use super::adjacency::{NONE, Twins, next, origin, previous};
use super::{Polygon, PolygonError, monotone};
use crate::geometry::{CircleSide, Point, in_circle_perturbed};
use crate::trace::{Shape, Trace};

/// Triangulates a polygon with holes, constrained Delaunay.
///
/// # Shape
/// See [`PolygonMethod::triangulate`](super::PolygonMethod::triangulate).
///
/// # Errors
/// Those of [`monotone`](super::monotone()).
pub fn constrained_delaunay(
    polygon: Polygon<'_>,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Vec<[u32; 3]>, PolygonError> {
    let mut triangles = monotone(polygon, trace)?;
    Flips::default().legalise(polygon.points(), &mut triangles, trace)?;
    Ok(triangles)
}

/// What flips need to know of triangles, kept from one polygon to the next.
#[derive(Clone, Debug, Default)]
pub(super) struct Flips {
    /// [`NONE`] on a side of the polygon.
    adjacency: Twins,
    stack: Vec<u32>,
}

impl Flips {
    /// Steps 2 and 3.
    pub(super) fn legalise(
        &mut self,
        points: &[Point],
        triangles: &mut [[u32; 3]],
        trace: &mut (impl Trace + ?Sized),
    ) -> Result<(), PolygonError> {
        self.adjacency.find(triangles);
        self.stack.clear();
        self.stack.extend((0..).zip(&self.adjacency.twins).filter(|&(h, &g)| g != NONE && h < g).map(|(h, _)| h));
        while let Some(h) = self.stack.pop() {
            if trace.is_cancelled() {
                return Err(PolygonError::Cancelled);
            }
            let g = self.adjacency.twins[h as usize];
            if g == NONE {
                continue; // A flip gave the number to a side of the polygon.
            }
            let corners = [origin(triangles, h), origin(triangles, next(h)), apex(triangles, h), apex(triangles, g)];
            let [a, b, c, d] = corners.map(|v| points[v as usize]);
            if in_circle_perturbed(a, b, c, d) == CircleSide::Inside {
                self.flip(h, g, corners, triangles);
                tell(corners, trace);
            }
        }
        Ok(())
    }

    fn link(&mut self, h: u32, g: u32) {
        self.adjacency.twins[h as usize] = g;
        if g != NONE {
            self.adjacency.twins[g as usize] = h;
        }
    }

    /// The triangle of `h` becomes a, d, c, that of its twin d, b, c.
    fn flip(&mut self, h: u32, g: u32, [a, b, c, d]: [u32; 4], triangles: &mut [[u32; 3]]) {
        let outside = [next(g), previous(h), previous(g), next(h)].map(|side| self.adjacency.twins[side as usize]);
        let (t, u) = (h / 3, g / 3);
        triangles[t as usize] = [a, d, c];
        triangles[u as usize] = [d, b, c];
        self.link(3 * t + 1, 3 * u + 2);
        for (side, beyond) in [3 * t, 3 * t + 2, 3 * u, 3 * u + 1].into_iter().zip(outside) {
            self.link(side, beyond);
            if beyond != NONE {
                self.stack.push(side);
            }
        }
    }
}

/// Tells of a flip.
fn tell([a, b, c, d]: [u32; 4], trace: &mut (impl Trace + ?Sized)) {
    trace.remove(Shape::Edge([a, b]), "fails the circle test");
    trace.remove(Shape::Triangle([a, b, c]), "on one side of the edge");
    trace.remove(Shape::Triangle([b, a, d]), "on the other side");
    trace.add(Shape::Edge([c, d]), "the other diagonal");
    trace.add(Shape::Triangle([a, d, c]), "on one side of the diagonal");
    trace.add(Shape::Triangle([d, b, c]), "on the other side");
}

/// The corner of a half-edge's triangle that is not at its ends.
fn apex(triangles: &[[u32; 3]], h: u32) -> u32 {
    origin(triangles, previous(h))
}
