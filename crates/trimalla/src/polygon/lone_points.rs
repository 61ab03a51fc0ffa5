//! Holes of one point: points inside a polygon that become corners of triangles. Formats without a place for such
//! points write them as holes.
//!
//! ```text
//!   ·───────·       ·───────·      ·───────·      ·───────·
//!   │     ╱ │       │╲    ╱ │      │     ╱ │      │     ╱ │     Inside a triangle a point makes three of it, on an
//!   │   ╱   │  ──>  │ ·─╱   │      │   x   │ ──>  │  ╲x   │     edge two of each triangle there.
//!   │ ╱  x  │       │╱╱     │      │ ╱     │      │ ╱  ╲  │
//!   ·───────·       ·───────·      ·───────·      ·───────·
//! ```
//!
//! # Steps
//! 1. Leave out the holes whose points are all equal.
//! 2. Triangulate by any method.
//! 3. Find the triangles that have the point inside or on an edge, and divide each of them.
//!
//! # Degenerate cases
//! *A point at a vertex*, or at another point, is that vertex: no triangle has it. *A point on a side* divides the
//! triangle at the side. *A point outside* is refused.
//!
//! # Complexity
//! O(t) a point, for t triangles.

use super::{Polygon, PolygonError};
use crate::geometry::{Orientation, Point, orient2d};
use crate::trace::{Renumbered, Shape, Trace};

/// A polygon whose holes of one point are apart.
#[derive(Debug)]
pub(super) struct LonePoints {
    points: Vec<Point>,
    ring_ends: Vec<u32>,
    /// The index of each point among those of the polygon, and the number of each ring among its rings.
    of: Vec<u32>,
    rings: Vec<usize>,
    /// The holes of one point: the number of the ring, and the index of its first point.
    lone: Vec<(usize, u32)>,
}

impl LonePoints {
    /// Step 1; `None` if there are no holes of one point.
    pub(super) fn of(polygon: Polygon<'_>) -> Option<Self> {
        let is_lone = |ring: &[Point]| ring.first().is_some_and(|first| ring.iter().all(|p| p == first));
        let mut rings = polygon.rings().skip(1);
        if !rings.any(|ring| is_lone(&polygon.points()[ring])) {
            return None;
        }
        let mut apart =
            Self { points: Vec::new(), ring_ends: Vec::new(), of: Vec::new(), rings: Vec::new(), lone: Vec::new() };
        for (number, ring) in polygon.rings().enumerate() {
            let first = ring.start as u32;
            if number > 0 && is_lone(&polygon.points()[ring.clone()]) {
                apart.lone.push((number, first));
            } else {
                apart.points.extend_from_slice(&polygon.points()[ring.clone()]);
                apart.of.extend(first..ring.end as u32);
                apart.ring_ends.push(apart.points.len() as u32);
                apart.rings.push(number);
            }
        }
        Some(apart)
    }

    /// Steps 2 and 3: triangles of the polygon, by a method for the other rings.
    ///
    /// # Errors
    /// Those of the method, with the polygon's own indices; a point outside; cancelled.
    pub(super) fn triangulate<T: Trace + ?Sized>(
        &self,
        polygon: Polygon<'_>,
        trace: &mut T,
        by: impl FnOnce(Polygon<'_>, &mut Renumbered<'_, T>) -> Result<Vec<[u32; 3]>, PolygonError>,
    ) -> Result<Vec<[u32; 3]>, PolygonError> {
        let number = |v: u32| self.of.get(v as usize).copied().unwrap_or(v);
        let made = by(Polygon::new(&self.points, &self.ring_ends)?, &mut Renumbered::new(trace, &self.of));
        let made =
            made.map_err(|error| error.renumbered(number, |ring| self.rings.get(ring).copied().unwrap_or(ring)))?;
        let mut triangles: Vec<[u32; 3]> = made.into_iter().map(|t| t.map(number)).collect();
        for &(ring, vertex) in &self.lone {
            if trace.is_cancelled() {
                return Err(PolygonError::Cancelled);
            }
            if !insert(polygon.points(), vertex, &mut triangles, trace) {
                return Err(PolygonError::Nesting { ring, vertex, at: polygon.points()[vertex as usize] });
            }
        }
        Ok(triangles)
    }
}

/// Step 3: false if no triangle has the point inside or on its boundary.
fn insert(points: &[Point], vertex: u32, triangles: &mut Vec<[u32; 3]>, trace: &mut (impl Trace + ?Sized)) -> bool {
    let at = |v: u32| points[v as usize];
    let p = at(vertex);
    let mut is_found = false;
    for t in 0..triangles.len() {
        let [a, b, c] = triangles[t];
        let edges = [[a, b], [b, c], [c, a]];
        let turns = edges.map(|[from, to]| orient2d(at(from), at(to), p));
        if turns.contains(&Orientation::Clockwise) {
            continue;
        }
        is_found = true;
        if [a, b, c].map(at).contains(&p) {
            continue;
        }
        // Of a point on an edge, the part at that edge would be flat.
        let parts = edges.into_iter().zip(turns).filter(|(_, turn)| *turn == Orientation::CounterClockwise);
        let parts: Vec<[u32; 3]> = parts.map(|([from, to], _)| [from, to, vertex]).collect();
        trace.remove(Shape::Triangle([a, b, c]), "has the point inside or on an edge");
        for (number, &part) in parts.iter().enumerate() {
            trace.add(Shape::Triangle(part), "a part of it, with the point as corner");
            if number == 0 {
                triangles[t] = part;
            } else {
                triangles.push(part);
            }
        }
    }
    is_found
}
