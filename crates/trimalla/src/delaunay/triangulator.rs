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
//! 1. Sort the points by the distance from their middle; of equal ones keep the first.
//! 2. The first three make a triangle.
//! 3. Add one point after the other. It is farther from the middle than the others, so it lies outside their hull. Find
//!    an edge that it sees, beginning in its direction from the middle; go along the hull in both directions as long as
//!    edges are seen.
//! 4. Flip the edges opposite the new point that fail the circle test, and then those that come to lie opposite it.
//!
//! Distances are rounded. Where a point sees no edge for that reason, where the first three lie on one line, and in
//! sets of a few points, step 1 sorts by x, then by y: a point then sees an edge at the one before it, by exact
//! signs. In this order the first ones may lie on one line; the next one off it makes a triangle with each pair of
//! neighbours there.
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
//! The order by distance is that of `[Sinclair16]`; `[Lawson77]` for the flips.

use super::{BuildError, algorithm, incremental};
use crate::geometry::{BoundingBox, CircleSide, Orientation, Point, in_circle_perturbed, lexicographic, orient2d};

/// No half-edge.
const NONE: u32 = u32::MAX;

/// Sets with more points are triangulated along a curve.
const MOST: usize = 256;

/// Sets with no more points are sorted by their coordinates.
const FEW: usize = 12;

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
    /// Points with their distances.
    by_distance: Vec<(f64, Point, u32)>,
    /// Vertices of the hull by their direction from the middle.
    by_direction: Vec<u32>,
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
        if points.len() <= FEW || !self.outward(points) {
            self.rightward(points);
        }
        let name = |v: u32| self.sorted[v as usize].1;
        self.triangles.extend(self.corners.iter().map(|t| t.map(name)));
        Ok(&self.triangles)
    }

    /// All steps by x and y.
    fn rightward(&mut self, points: &[Point]) {
        self.sorted.clear();
        self.sorted.extend(points.iter().copied().zip(0..));
        self.sorted.sort_unstable_by(|&(p, v), &(q, w)| lexicographic(p, q).then(v.cmp(&w)));
        self.sorted.dedup_by(|later, first| later.0 == first.0);
        self.corners.clear();
        if let Some(next) = self.begin() {
            for p in next..self.sorted.len() as u32 {
                self.add(p, p - 1);
            }
        }
    }

    /// All steps by distance; whether that was possible.
    fn outward(&mut self, points: &[Point]) -> bool {
        let Some(bounds) = BoundingBox::of(points.iter().copied()) else { return false };
        let middle = Point::midpoint(bounds.min, bounds.max);
        self.by_distance.clear();
        self.by_distance.extend(points.iter().zip(0..).map(|(&p, v)| (Point::distance_sq(p, middle), p, v)));
        self.by_distance
            .sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then_with(|| lexicographic(a.1, b.1)).then(a.2.cmp(&b.2)));
        self.sorted.clear();
        self.sorted.extend(self.by_distance.iter().map(|&(_, p, v)| (p, v)));
        self.sorted.dedup_by(|later, first| later.0 == first.0);
        self.by_direction.clear();
        self.by_direction.resize((self.sorted.len() as f64).sqrt() as usize + 1, NONE);
        if self.begin() != Some(3) {
            return false;
        }
        for v in 0..3 {
            self.note_direction(v, middle);
        }
        for p in 3..self.sorted.len() as u32 {
            let Some(seen) = self.seen_from(p, middle) else { return false };
            let before = self.add(p, seen);
            self.note_direction(before, middle);
            self.note_direction(p, middle);
        }
        true
    }

    /// The sector of a direction.
    fn sector(&self, v: u32, middle: Point) -> usize {
        let from = self.sorted[v as usize].0 - middle;
        let size = from.x.abs() + from.y.abs();
        let turn = if from.y > 0.0 { 3.0 - from.x / size } else { 1.0 + from.x / size };
        // A number from 0 to 4; what is no number becomes 0.
        ((0.25 * turn * self.by_direction.len() as f64) as usize).min(self.by_direction.len() - 1)
    }

    fn note_direction(&mut self, v: u32, middle: Point) {
        let sector = self.sector(v, middle);
        self.by_direction[sector] = v;
    }

    /// A vertex of the hull from which an edge begins that a point sees.
    fn seen_from(&self, p: u32, middle: Point) -> Option<u32> {
        let sector = self.sector(p, middle);
        let (after, before) = self.by_direction.split_at(sector);
        let is_there = |&&v: &&u32| v != NONE && self.hull.next[v as usize] != NONE;
        let near = *before.iter().chain(after).find(is_there)?;
        let begin = self.hull.previous[near as usize];
        let at = |v: u32| self.sorted[v as usize].0;
        let mut from = begin;
        loop {
            let to = self.hull.next[from as usize];
            if orient2d(at(from), at(to), at(p)) == Orientation::Clockwise {
                return Some(from);
            }
            from = to;
            if from == begin {
                return None;
            }
        }
    }

    /// Step 2; the place of the first point that is not yet in. None if all are on one line.
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
        // A line meets the circle of a triangle in two of its points at most: the fan passes the circle test.
        Some(off + 1)
    }

    /// Steps 3 and 4, given a vertex of the hull at which an edge is seen; the vertex before the new one on the hull.
    fn add(&mut self, p: u32, seen: u32) -> u32 {
        let at = self.sorted[p as usize].0;
        let place = |triangulator: &Self, v: u32| triangulator.sorted[v as usize].0;
        let mut first_new = NONE;
        let mut last_new = NONE;
        // Forward from there, then backward.
        let mut to = seen;
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
        let mut from = seen;
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
            return from; // Not for finite points in order.
        }
        self.hull.leave_out(from, to);
        self.hull.join(from, p, first_new + 1);
        self.hull.join(p, to, last_new + 2);
        self.legalise_around(p);
        from
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

    /// Flips the edges opposite a new vertex that fail the circle test, and what then lies opposite it. The vertex
    /// is the last corner of the newest triangles.
    fn legalise_around(&mut self, p: u32) {
        let newest = self.corners.iter().rev().take_while(|corners| corners[2] == p).count();
        let all = self.corners.len();
        self.stack.extend((all - newest..all).map(|t| 3 * t as u32));
        while let Some(h) = self.stack.pop() {
            let g = self.twins[h as usize];
            if g == NONE {
                continue;
            }
            let corners = [self.origin(h), self.origin(next(h)), p, self.origin(previous(g))];
            let [a, b, c, d] = corners.map(|v| self.sorted[v as usize].0);
            if in_circle_perturbed(a, b, c, d) == CircleSide::Inside {
                self.flip(h, g, corners);
            }
        }
    }

    /// Triangle `a b p` of `h` becomes `a d p`, that of its twin `d b p`; the edges `a d` and `d b` wait.
    fn flip(&mut self, h: u32, g: u32, [a, b, p, d]: [u32; 4]) {
        let outside = [next(g), previous(h), previous(g), next(h)].map(|side| self.twins[side as usize]);
        let (t, u) = (h / 3 * 3, g / 3 * 3);
        self.corners[(h / 3) as usize] = [a, d, p];
        self.corners[(g / 3) as usize] = [d, b, p];
        self.link(t + 1, u + 2);
        for (side, beyond) in [t, t + 2, u, u + 1].into_iter().zip(outside) {
            self.twins[side as usize] = beyond;
            if beyond == NONE {
                let from = self.origin(side);
                self.hull.edge[from as usize] = side;
            } else {
                self.twins[beyond as usize] = side;
            }
        }
        self.stack.extend([t, u]);
    }

    fn origin(&self, h: u32) -> u32 {
        self.corners[(h / 3) as usize][(h % 3) as usize]
    }
}

impl Hull {
    /// Takes out what lies between two vertices.
    fn leave_out(&mut self, from: u32, to: u32) {
        let mut between = self.next[from as usize];
        while between != to {
            between = std::mem::replace(&mut self.next[between as usize], NONE);
        }
    }

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
