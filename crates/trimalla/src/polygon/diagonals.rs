//! Triangulation by diagonals: the proof that every polygon has a triangulation, as a program.
//!
//! A *diagonal* joins two vertices through the inside. It divides the polygon in two, each with fewer vertices, and
//! triangles need no more division. That is the whole proof, but for the lemma that every polygon with more than three
//! vertices has a diagonal:
//!
//! ```text
//!        v                     v            Take a vertex v. Either it is an end of a diagonal, or
//!       / \                   /|\           it is convex and its neighbours u and w see each other:
//!      /   \                 / | \          the vertex of the triangle u v w that is farthest from
//!     u-----w               /  z  \         the line u w, if there is one, sees v.
//!     |     |              /  / \  \
//!     |     |             u--    ---w
//! ```
//!
//! # Steps
//! 1. Take a part of the polygon: at first all of it. If it has three vertices, it is a triangle.
//! 2. Try to join its first vertex to each of the others. A diagonal leaves both its ends into the angle between their
//!    two sides, crosses no side of the part, and has no vertex inside.
//! 3. If no other vertex is seen, the neighbours of the first vertex see each other: join these.
//! 4. Divide the part, and go on with both halves.
//!
//! # Degenerate cases
//! A vertex in a collinear run is a vertex: the part on its side cannot be flat, as no diagonal runs through a vertex.
//! Where a polygon touches itself from the inside, it is divided there at the beginning; where it touches itself from
//! the outside, the vertex is in the walk round the polygon twice, each time with its own angle. A vertex on a side is
//! inserted into it.
//!
//! # Complexity
//! O(n³): at most n − 3 diagonals, each found among n candidates, each held against n sides.
//!
//! # Source
//! The lemma is that of `[Meisters75]`; the tests are those of `[ORourke98]`, exact here.

use super::angles::{is_in_angle, walks};
use super::{Polygon, PolygonError, TrapezoidMap};
use crate::geometry::{Point, segments_cross_properly, strictly_between};
use crate::trace::{NoTrace, Shape, Trace};

/// Triangulates a polygon without holes by one diagonal after the other.
///
/// # Shape
/// Indices into the points of the polygon, each triangle counter-clockwise by the exact test; `n - 2` of them, if the
/// polygon does not touch itself.
///
/// # Errors
/// [`PolygonError::Holes`] for a polygon with holes; a ring without area, sides that cross or overlap, cancelled.
///
/// # Complexity
/// O(n³).
///
/// # Source
/// `[Meisters75]`, `[ORourke98]`
///
/// # Examples
/// ```
/// use trimalla::Point;
/// use trimalla::polygon::{Polygon, diagonals};
/// use trimalla::trace::NoTrace;
///
/// let points = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 1.0), (0.0, 4.0)].map(|(x, y)| Point::new(x, y));
/// let polygon = Polygon::new(&points, &[5])?;
/// assert_eq!(diagonals(polygon, &mut NoTrace)?.len(), 3);
/// # Ok::<(), trimalla::polygon::PolygonError>(())
/// ```
pub fn diagonals(polygon: Polygon<'_>, trace: &mut (impl Trace + ?Sized)) -> Result<Vec<[u32; 3]>, PolygonError> {
    let holes = polygon.ring_count().saturating_sub(1);
    if holes > 0 {
        return Err(PolygonError::Holes { method: "diagonals", holes });
    }
    // The trapezoids prove that nothing crosses, and know which vertices touch which sides.
    let map = TrapezoidMap::new(polygon, 0, &mut NoTrace)?;
    let mut parts = walks(&map, polygon.points());
    let mut triangles = Vec::with_capacity(polygon.points().len());
    while let Some(part) = parts.pop() {
        if trace.is_cancelled() {
            return Err(PolygonError::Cancelled);
        }
        if let [a, b, c] = part[..] {
            trace.add(Shape::Triangle([a, b, c]), "three vertices are left");
            triangles.push([a, b, c]);
            continue;
        }
        let Some((i, j)) = find_diagonal(&part, polygon.points(), trace) else {
            // The lemma says that this does not happen.
            let first = part.first().copied().unwrap_or(0);
            return Err(PolygonError::Misplaced { ring: 0, at: polygon.points()[first as usize] });
        };
        trace.add(Shape::Edge([part[i], part[j]]), "a diagonal");
        let one = part[i..=j].to_vec();
        let other = part[j..].iter().chain(&part[..=i]).copied().collect();
        parts.extend([other, one]);
    }
    Ok(triangles)
}

/// A diagonal of a part with more than three vertices, by the places of its ends: the lower one first.
fn find_diagonal(part: &[u32], points: &[Point], trace: &mut (impl Trace + ?Sized)) -> Option<(usize, usize)> {
    let last = part.len() - 1;
    let from_the_first = (2..last).map(|j| (0, j));
    from_the_first.chain([(1, last)]).find(|&(i, j)| {
        let edge = Shape::Edge([part[i], part[j]]);
        let found = is_diagonal(part, points, i, j);
        if found {
            trace.look(edge, "sees it");
        } else {
            trace.refuse(edge, "does not see it");
        }
        found
    })
}

/// Whether two places of a walk are joined by a diagonal.
fn is_diagonal(part: &[u32], points: &[Point], i: usize, j: usize) -> bool {
    let n = part.len();
    let point = |k: usize| points[part[k % n] as usize];
    let (p, q) = (point(i), point(j));
    let leaves_inside = |k: usize, towards: Point| is_in_angle(point(k), point(k + 1), point(k + n - 1), towards);
    let is_blocked_at = |k: usize| {
        let (a, b) = (point(k), point(k + 1));
        strictly_between(p, q, a) || segments_cross_properly(p, q, a, b)
    };
    p != q && leaves_inside(i, q) && leaves_inside(j, p) && !(0..n).any(is_blocked_at)
}
