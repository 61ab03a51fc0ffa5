//! Seidel's algorithm: trapezoids by random insertion, then monotone pieces, then triangles.
//!
//! Draw a horizontal line from every vertex to the left and to the right as far as the next sides. The lines divide the
//! polygon into trapezoids. Each has one vertex on its upper line, its *top*, one on its lower line, its *bottom*, a
//! side on its left and a side on its right:
//!
//! ```text
//!            top                            b
//!     ------o---------                    /   \
//!    /                \                 c......\     The horizontal visibility map of
//!   / left       right \                 \      \    a polygon with four vertices: three
//!  /                    \                 \......d   trapezoids, two of them triangles.
//!  -----------o----------                  \   /
//!           bottom                           a
//! ```
//!
//! The trapezoids of *any* segments that do not cross can be built by inserting one segment after the other. In random
//! order a new segment passes through four trapezoids on average, however long it is, and the decisions made so far are
//! a search tree for points: that is all the algorithm needs.
//!
//! # Steps
//! 1. The plane is one trapezoid. Put the sides into rounds at random, half of them into the last round, half of the
//!    others into the one before, and so on. Within a round they keep the order of the rings.
//! 2. Insert the ends of the next side ([`insert`](self)): look the point up in the *query structure*, a graph of the
//!    questions "above or below this vertex?" and "left or right of this side?" whose leaves are the trapezoids, and
//!    divide its trapezoid by a horizontal line.
//! 3. Lead the side from its upper end down, through one trapezoid after the other: each is divided in two. Of two
//!    parts below each other that no vertex parts any more, one trapezoid is made.
//! 4. After `n / log n`, `n / log log n`, … sides, follow all rings through the trapezoids, so that each vertex knows
//!    where it is. A search continues there and not at the root.
//! 5. A trapezoid between a side that has the inside on its right and one that has it on its left is inside. Join its
//!    top to its bottom, unless a side does that. What lies along one side is now a *mountain*: the side, and a chain
//!    of vertices that goes down beside it.
//! 6. Go down each chain, and cut off every corner that is convex: it is a triangle.
//!
//! # Degenerate cases
//! * *Vertices of one height.* Of two vertices the one with the larger x is higher, as if the plane were tilted a
//!   little. The tilt changes no orientation, so a horizontal side is a side like any other. Trapezoids may have no
//!   height.
//! * *Points at one place* are one vertex: the look-up ends at it. *Rings that touch at a vertex* need nothing else.
//! * *A vertex on a side.* The side was there first: the trapezoids on both sides of it are divided. The vertex was
//!   there first: the side ends at it, and the rest is inserted as a side of its own. Either way the mountain ends
//!   there.
//! * *Collinear runs.* A flat corner of a mountain is not cut off, and waits for the next vertex.
//! * *Sides that cross or overlap* are found when the later one is led through the trapezoids: every trapezoid that it
//!   passes asks whether it crosses its left and right side. *Holes outside of the outline*, or inside each other, show
//!   as a trapezoid that is inside by one of its sides only.
//!
//! # Complexity
//! Expected O(n log* n); a constant times n in practice. The expectation is over the rounds, which the seed determines,
//! and not over the polygon.
//!
//! # Why not in linear time
//! `[Chazelle91]` finds the horizontal visibility map of a simple polygon in O(n) without randomness, and triangles
//! follow from it as here. The algorithm is not built here, and as far as we know nowhere: it merges maps of pieces of
//! the boundary in phases, needs planar separators and ray shooting in them, and its constant outweighs `log n` for
//! every polygon that fits into a memory. It would also take simple polygons only, without holes. Compared with O(n
//! log* n), where `log* n` is at most 5, nothing is to be gained.
//!
//! # Source
//! `[Seidel91]`; in the practical form of `[NarkhedeManocha95]`, which keeps trapezoids with neighbours above and
//! below. Mountains are those of `[FournierMontuno84]`. Departures: any number of sides may meet at a vertex, polygons
//! may have holes and touch themselves, faulty ones are refused, and the mountains are read off along each side. Sides
//! are not shuffled one by one but in the rounds of `[AmentaChoiRote03]`: neighbours are inserted one after the other,
//! and what a step reads was read shortly before.

mod follow;
mod insert;
mod map;
mod mountains;
mod structure;

use super::{Polygon, PolygonError};
use crate::trace::Trace;
pub use map::{Chord, Trapezoid, TrapezoidMap};

/// The seed of [`seidel`].
const SEED: u64 = 1991;

/// Triangulates a polygon with holes by Seidel's algorithm.
///
/// # Shape
/// Indices into the points of the polygon, each triangle counter-clockwise by the exact test; `n - 2 + 2h` triangles
/// for `n` corners and `h` holes, if no rings touch.
///
/// # Errors
/// A ring without area, sides that cross or overlap, a hole that is not in the outline, cancelled.
///
/// # Complexity
/// Expected O(n log* n).
///
/// # Source
/// `[Seidel91]`
///
/// # Examples
/// ```
/// use trimalla::Point;
/// use trimalla::polygon::{Polygon, seidel};
/// use trimalla::trace::NoTrace;
///
/// let points = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (1.0, 1.0), (3.0, 1.0), (2.0, 3.0)]
///     .map(|(x, y)| Point::new(x, y));
/// let polygon = Polygon::new(&points, &[4, 7])?;
/// assert_eq!(seidel(polygon, &mut NoTrace)?.len(), 7 - 2 + 2);
/// # Ok::<(), trimalla::polygon::PolygonError>(())
/// ```
pub fn seidel(polygon: Polygon<'_>, trace: &mut (impl Trace + ?Sized)) -> Result<Vec<[u32; 3]>, PolygonError> {
    TrapezoidMap::new(polygon, SEED, trace)?.triangles(trace)
}
