//! Many small sets of points, one after the other.
//!
//! ```text
//!       hull of the points so far        p sees the edges u–q and q–v from outside: a triangle for each, and the hull
//!          v                             goes u, p, v. Then edges opposite p that fail the circle test are flipped.
//!          │ ╲
//!          │   q      p
//!          │ ╱
//!          u
//! ```
//!
//! 1. Sort the points by x, then by y; of equal ones keep the first.
//! 2. The first ones may lie on one line. The next point off it makes a triangle with each pair of neighbours on it.
//! 3. Add one point after the other. It lies outside the hull, and sees an edge at the point before. Go along the hull in
//!    both directions as long as edges are seen.
//! 4. Flip the edges opposite the new point that fail the circle test, and then those that come to lie opposite it.
//!
//! Flat arrays that are kept between calls, no vertex at infinity: for a hundred points that is faster than what is
//! fastest for a million. Larger sets go to the builder in curve order.
//!
//! # Degenerate cases
//! *All points on one line*: no triangle. *Points on the line of a hull edge* are seen by no such edge, and become
//! vertices of the hull. *Cocircular points*: the tie rule of [`in_circle_perturbed`].
//!
//! # Complexity
//! O(n log n) for the sorting, O(n²) flips at worst; O(n log n) expected for large sets.
//!
//! # Source
//! The sweep is that of `[Triangulaciones]`, part I, for a first triangulation; `[Lawson77]` for the flips.

use super::{BuildError, algorithm, incremental};
use crate::geometry::{CircleSide, Orientation, Point, in_circle_perturbed, lexicographic, orient2d};

/// No half-edge.
const NONE: u32 = u32::MAX;

/// Sets with more points are triangulated along a curve.
const MOST: usize = 256;

/// Triangulates sets of points, and keeps its memory from one to the next: the fastest way for many small sets.
///
/// # Guarantees
/// Exact. The triangles are those of [`Delaunay::new`](super::Delaunay::new).
///
/// # Examples
/// ```
/// use trimalla::Point;
/// use trimalla::delaunay::Triangulator;
///
/// let mut triangulator = Triangulator::new();
/// for size in [1.0, 2.0, 3.0] {
///     let kite = [[0.0, 0.0], [2.0, -1.0], [6.0, 0.0], [2.0, 1.0]].map(|[x, y]| Point::new(size * x, size * y));
///     assert_eq!(triangulator.triangulate(&kite)?.len(), 2);
/// }
/// # Ok::<(), trimalla::delaunay::BuildError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Triangulator {
    sorted: Vec<(Point, u32)>,
    /// The corners of each triangle, as places in `sorted`.
    corners: Vec<[u32; 3]>,
    /// The other half-edge of an edge; half-edge `3 t + k` runs from corner `k` of triangle `t` to the next.
    twins: Vec<u32>,
    hull: Hull,
    stack: Vec<u32>,
    triangles: Vec<[u32; 3]>,
}

/// The hull, counter-clockwise, by places in the order.
#[derive(Clone, Debug, Default)]
struct Hull {
    next: Vec<u32>,
    previous: Vec<u32>,
    /// The half-edge from a vertex to the next one, which has the inside on its left.
    edge: Vec<u32>,
}

impl Triangulator {
    /// A triangulator that has no memory yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Triangulates points.
    ///
    /// # Shape
    /// Counter-clockwise triangles of indices into the points, until the next call. Of equal points the one of lowest
    /// index is used; points on one line have no triangles.
    ///
    /// # Errors
    /// A coordinate that is not finite, too many points.
    pub fn triangulate(&mut self, points: &[Point]) -> Result<&[[u32; 3]], BuildError> {
        algorithm::validate(points, None)?;
        self.triangles.clear();
        if points.len() > MOST {
            let (t, _) = incremental::build(points, None);
            self.triangles.extend(t.real_faces().map(|f| t.face_vertices(f).map(|v| v.0)));
            return Ok(&self.triangles);
        }
        self.sort(points);
        if let Some(next) = self.begin() {
            for p in next..self.sorted.len() as u32 {
                self.add(p);
            }
            let name = |v: u32| self.sorted[v as usize].1;
            self.triangles.extend(self.corners.iter().map(|t| t.map(name)));
        }
        Ok(&self.triangles)
    }

    /// Step 1.
    fn sort(&mut self, points: &[Point]) {
        self.sorted.clear();
        self.sorted.extend(points.iter().copied().zip(0..));
        let order = |&(p, v): &(Point, u32), &(q, w): &(Point, u32)| lexicographic(p, q).then(v.cmp(&w));
        self.sorted.sort_unstable_by(order);
        self.sorted.dedup_by(|later, first| later.0 == first.0);
    }

    /// Step 2; the place of the first point that is not yet in.
    fn begin(&mut self) -> Option<u32> {
        let &[(a, _), (b, _), ..] = &self.sorted[..] else { return None };
        let off = (2..self.sorted.len()).find(|&i| orient2d(a, b, self.sorted[i].0) != Orientation::Collinear)?;
        let is_left = orient2d(a, b, self.sorted[off].0) == Orientation::CounterClockwise;
        self.corners.clear();
        self.twins.clear();
        let count = self.sorted.len();
        for list in [&mut self.hull.next, &mut self.hull.previous, &mut self.hull.edge] {
            list.clear();
            list.resize(count, NONE);
        }
        let off = off as u32;
        for i in 1..off {
            let [from, to] = if is_left { [i - 1, i] } else { [i, i - 1] };
            let t = self.push([from, to, off]);
            self.hull.join(from, to, t);
            if i > 1 {
                // The side that this triangle shares with the one before.
                let (here, before) = if is_left { (t + 2, t - 2) } else { (t + 1, t - 1) };
                self.link(here, before);
            }
        }
        let last = 3 * (off - 2);
        let (lead_in, lead_out) = if is_left { (last + 1, 2) } else { (1, last + 2) };
        let [before, after] = if is_left { [off - 1, 0] } else { [0, off - 1] };
        self.hull.join(before, off, lead_in);
        self.hull.join(off, after, lead_out);
        // The triangles of the fan may fail the circle test.
        self.stack.extend((0..off - 2).map(|i| if is_left { 3 * i + 1 } else { 3 * i + 2 }));
        self.legalise_all();
        Some(off + 1)
    }

    /// Steps 3 and 4.
    fn add(&mut self, p: u32) {
        let (at, before) = (self.sorted[p as usize].0, p - 1);
        let place = |triangulator: &Self, v: u32| triangulator.sorted[v as usize].0;
        let mut first_new = NONE;
        let mut last_new = NONE;
        // Forward from the point before, then backward.
        let mut to = before;
        loop {
            let (from, next) = (to, self.hull.next[to as usize]);
            if orient2d(place(self, from), place(self, next), at) != Orientation::Clockwise {
                break;
            }
            let t = self.push([next, from, p]);
            self.link(t, self.hull.edge[from as usize]);
            if last_new != NONE {
                self.link(t + 1, last_new + 2);
            } else {
                first_new = t;
            }
            last_new = t;
            to = next;
        }
        let mut from = before;
        loop {
            let (next, previous) = (from, self.hull.previous[from as usize]);
            if orient2d(place(self, previous), place(self, next), at) != Orientation::Clockwise {
                break;
            }
            let t = self.push([next, previous, p]);
            self.link(t, self.hull.edge[previous as usize]);
            if first_new != NONE {
                self.link(t + 2, first_new + 1);
            } else {
                last_new = t;
            }
            first_new = t;
            from = previous;
        }
        if first_new == NONE {
            return; // Not for finite points in order.
        }
        self.hull.join(from, p, first_new + 1);
        self.hull.join(p, to, last_new + 2);
        self.legalise_around(p);
    }

    /// A new triangle; its first half-edge.
    fn push(&mut self, corners: [u32; 3]) -> u32 {
        let t = 3 * self.corners.len() as u32;
        self.corners.push(corners);
        self.twins.extend([NONE; 3]);
        t
    }

    fn link(&mut self, h: u32, g: u32) {
        self.twins[h as usize] = g;
        self.twins[g as usize] = h;
    }

    /// Legalises the edges opposite a new vertex, which is the last corner of the newest triangles.
    fn legalise_around(&mut self, p: u32) {
        for t in (0..self.corners.len()).rev() {
            if self.corners[t][2] != p {
                break;
            }
            self.stack.push(3 * t as u32);
        }
        self.legalise_all();
    }

    /// Flips what waits on the stack and fails the circle test, and what comes of it.
    fn legalise_all(&mut self) {
        while let Some(h) = self.stack.pop() {
            let g = self.twins[h as usize];
            if g == NONE {
                continue;
            }
            let corners = [self.origin(h), self.origin(next(h)), self.origin(previous(h)), self.origin(previous(g))];
            let [a, b, c, d] = corners.map(|v| self.sorted[v as usize].0);
            if in_circle_perturbed(a, b, c, d) == CircleSide::Inside {
                self.flip(h, g, corners);
            }
        }
    }

    /// Triangle `a b c` of `h` becomes `a d c`, that of its twin `d b c`.
    fn flip(&mut self, h: u32, g: u32, [a, b, c, d]: [u32; 4]) {
        let outside = [next(g), previous(h), previous(g), next(h)].map(|side| self.twins[side as usize]);
        let (t, u) = (h / 3, g / 3);
        self.corners[t as usize] = [a, d, c];
        self.corners[u as usize] = [d, b, c];
        self.link(3 * t + 1, 3 * u + 2);
        for (side, beyond) in [3 * t, 3 * t + 2, 3 * u, 3 * u + 1].into_iter().zip(outside) {
            self.twins[side as usize] = beyond;
            if beyond == NONE {
                let from = self.origin(side);
                self.hull.edge[from as usize] = side;
            } else {
                self.twins[beyond as usize] = side;
                self.stack.push(side);
            }
        }
    }

    fn origin(&self, h: u32) -> u32 {
        self.corners[(h / 3) as usize][(h % 3) as usize]
    }
}

impl Hull {
    /// One vertex comes after another, along a half-edge.
    fn join(&mut self, from: u32, to: u32, edge: u32) {
        self.next[from as usize] = to;
        self.previous[to as usize] = from;
        self.edge[from as usize] = edge;
    }
}

fn next(h: u32) -> u32 {
    if h % 3 == 2 { h - 2 } else { h + 1 }
}

fn previous(h: u32) -> u32 {
    if h % 3 == 0 { h + 2 } else { h - 1 }
}
