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
//! 1. Sort the points by the distance from their middle, as whole numbers: the bits of the distance, the index in place
//!    of the lowest ones.
//! 2. The first three make a triangle.
//! 3. Add one point after the other. It is farther from the middle than the others, so it lies outside their hull. Find
//!    an edge that it sees, beginning in its direction from the middle; go along the hull in both directions as long as
//!    edges are seen. Leave out a point that equals a vertex of the hull.
//! 4. Flip the edges opposite the new point that fail the circle test, and then those that come to lie opposite it.
//!
//! Distances are rounded. Where a point sees no edge for that reason, where the first three lie on one line, and in
//! sets of a few points, step 1 sorts by x, then by y, and keeps the first of equal points: a point then sees an edge
//! at the one before it, by exact signs. In this order the first ones may lie on one line; the next one off it makes a
//! triangle with each pair of neighbours there.
//!
//! Flat arrays that are kept between calls, with four places for each triangle, so that no number of a half-edge is
//! divided by three; no vertex at infinity. For a hundred points that is faster than what is fastest for a million.
//! Larger sets go to the builder in curve order.
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

/// The bits of a distance that an index replaces.
const INDEX: u64 = 0xff;

/// Sets with more points are triangulated along a curve.
const MOST: usize = INDEX as usize + 1;

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
    /// The distances from the middle, with indices as their lowest bits.
    keys: Vec<u64>,
    /// Points and their indices in order. A vertex is a place in this list.
    sorted: Vec<(Point, u32)>,
    /// The sector of each vertex by its direction from the middle.
    sectors: Vec<u32>,
    /// The last vertex that came to the hull in each sector.
    by_direction: Vec<u32>,
    mesh: Mesh,
    hull: Hull,
    stack: Vec<u32>,
    triangles: Vec<[u32; 3]>,
}

/// Half-edge `4 t + k` runs from corner `k` of triangle `t` to the next one; every fourth is not used.
#[derive(Clone, Debug, Default)]
struct Mesh {
    origins: Vec<u32>,
    /// The other half-edge of an edge, [`NONE`] on the hull.
    twins: Vec<u32>,
}

/// The hull, counter-clockwise, by vertices. [`NONE`] follows a vertex that is not on it.
#[derive(Clone, Debug, Default)]
struct Hull {
    next: Vec<u32>,
    previous: Vec<u32>,
    /// The half-edge from a vertex to the next one, which has the inside on its left.
    edge: Vec<u32>,
}

/// Where a point lies beside the hull.
enum Beside {
    /// It sees the edge from this vertex to the next one.
    Edge(u32),
    /// It equals a vertex.
    Vertex,
    /// It sees nothing.
    Nothing,
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
        let triangles = self.mesh.origins.chunks_exact(4);
        self.triangles.extend(triangles.map(|t| [name(t[0]), name(t[1]), name(t[2])]));
        Ok(&self.triangles)
    }

    /// All steps by x and y.
    fn rightward(&mut self, points: &[Point]) {
        self.sorted.clear();
        self.sorted.extend(points.iter().copied().zip(0..));
        self.sorted.sort_unstable_by(|&(p, v), &(q, w)| lexicographic(p, q).then(v.cmp(&w)));
        self.sorted.dedup_by(|later, first| later.0 == first.0);
        if let Some(next) = self.begin() {
            for p in next..self.sorted.len() as u32 {
                let before = p - 1;
                let seen = if self.sees(p, before) { before } else { self.hull.previous[before as usize] };
                self.add(p, seen);
            }
        }
    }

    /// All steps by distance; whether that was possible.
    fn outward(&mut self, points: &[Point]) -> bool {
        let Some(bounds) = BoundingBox::of(points.iter().copied()) else { return false };
        let middle = Point::midpoint(bounds.min, bounds.max);
        self.keys.clear();
        self.keys.extend(points.iter().zip(0..).map(|(&p, v)| Point::distance_sq(p, middle).to_bits() & !INDEX | v));
        self.keys.sort_unstable();
        self.sorted.clear();
        self.sorted.extend(self.keys.iter().map(|key| (points[(key & INDEX) as usize], (key & INDEX) as u32)));
        if self.begin() != Some(3) {
            return false;
        }
        let count = (points.len() as f64).sqrt() as usize + 1;
        self.sectors.clear();
        self.sectors.extend(self.sorted.iter().map(|&(p, _)| sector(p, middle, count)));
        self.by_direction.clear();
        self.by_direction.resize(count, NONE);
        for v in 0..3 {
            self.note_direction(v);
        }
        for p in 3..self.sorted.len() as u32 {
            match self.seen_from(p) {
                Beside::Edge(seen) => {
                    let before = self.add(p, seen);
                    self.note_direction(before);
                    self.note_direction(p);
                }
                Beside::Vertex => {}
                Beside::Nothing => return false,
            }
        }
        true
    }

    fn note_direction(&mut self, v: u32) {
        self.by_direction[self.sectors[v as usize] as usize] = v;
    }

    /// Looks for an edge that a point sees, in both directions along the hull.
    fn seen_from(&self, p: u32) -> Beside {
        let (after, before) = self.by_direction.split_at(self.sectors[p as usize] as usize);
        let is_there = |&&v: &&u32| v != NONE && self.hull.next[v as usize] != NONE;
        let Some(&near) = before.iter().chain(after).find(is_there) else { return Beside::Nothing };
        let (mut forward, mut backward) = (near, near);
        loop {
            backward = self.hull.previous[backward as usize];
            if self.sees(p, backward) {
                return Beside::Edge(backward);
            }
            if backward == forward {
                break;
            }
            if self.sees(p, forward) {
                return Beside::Edge(forward);
            }
            forward = self.hull.next[forward as usize];
            if backward == forward {
                break;
            }
        }
        let mut v = near;
        loop {
            if self.at(v) == self.at(p) {
                return Beside::Vertex;
            }
            v = self.hull.next[v as usize];
            if v == near {
                return Beside::Nothing;
            }
        }
    }

    fn at(&self, v: u32) -> Point {
        self.sorted[v as usize].0
    }

    /// Whether a point lies outside the edge of the hull that begins at a vertex.
    fn sees(&self, p: u32, from: u32) -> bool {
        let to = self.hull.next[from as usize];
        orient2d(self.at(from), self.at(to), self.at(p)) == Orientation::Clockwise
    }

    /// Step 2; the first vertex that is not yet in. None if all are on one line.
    fn begin(&mut self) -> Option<u32> {
        self.mesh.origins.clear();
        self.mesh.twins.clear();
        let &[(a, _), (b, _), ..] = &self.sorted[..] else { return None };
        let off = (2..self.sorted.len()).find(|&i| orient2d(a, b, self.sorted[i].0) != Orientation::Collinear)?;
        let is_left = orient2d(a, b, self.sorted[off].0) == Orientation::CounterClockwise;
        let count = self.sorted.len();
        for list in [&mut self.hull.next, &mut self.hull.previous, &mut self.hull.edge] {
            list.clear();
            list.resize(count, NONE);
        }
        let off = off as u32;
        for i in 1..off {
            let [from, to] = if is_left { [i - 1, i] } else { [i, i - 1] };
            let t = self.mesh.push([from, to, off]);
            self.hull.join(from, to, t);
            if i > 1 {
                // The side that this triangle shares with the one before.
                let (here, before) = if is_left { (t + 2, t - 3) } else { (t + 1, t - 2) };
                self.mesh.link(here, before);
            }
        }
        let last = 4 * (off - 2);
        let (lead_in, lead_out) = if is_left { (last + 1, 2) } else { (1, last + 2) };
        let [before, after] = if is_left { [off - 1, 0] } else { [0, off - 1] };
        self.hull.join(before, off, lead_in);
        self.hull.join(off, after, lead_out);
        // A line meets the circle of a triangle in two of its points at most: the fan passes the circle test.
        Some(off + 1)
    }

    /// Steps 3 and 4, given a vertex at which an edge is seen; the vertex before the new one on the hull.
    fn add(&mut self, p: u32, seen: u32) -> u32 {
        let first = self.mesh.push([self.hull.next[seen as usize], seen, p]);
        self.mesh.link(first, self.hull.edge[seen as usize]);
        self.stack.push(first);
        let (mut from, mut to) = (seen, self.hull.next[seen as usize]);
        let mut last_new = first;
        while self.sees(p, to) {
            let next = self.hull.next[to as usize];
            let t = self.mesh.push([next, to, p]);
            self.mesh.link(t, self.hull.edge[to as usize]);
            self.mesh.link(t + 1, last_new + 2);
            self.stack.push(t);
            self.hull.next[to as usize] = NONE;
            last_new = t;
            to = next;
        }
        let mut first_new = first;
        loop {
            let previous = self.hull.previous[from as usize];
            if !self.sees(p, previous) {
                break;
            }
            let t = self.mesh.push([from, previous, p]);
            self.mesh.link(t, self.hull.edge[previous as usize]);
            self.mesh.link(t + 2, first_new + 1);
            self.stack.push(t);
            self.hull.next[from as usize] = NONE;
            first_new = t;
            from = previous;
        }
        self.hull.join(from, p, first_new + 1);
        self.hull.join(p, to, last_new + 2);
        self.legalise_around(p);
        from
    }

    /// Flips the edges opposite a new vertex that fail the circle test, and what then lies opposite it. The vertex is
    /// the last corner of the triangles that wait, each by its first half-edge.
    fn legalise_around(&mut self, p: u32) {
        let c = self.at(p);
        while let Some(t) = self.stack.pop() {
            let g = self.mesh.twins[t as usize];
            if g == NONE {
                continue;
            }
            let [a, b] = [t, t + 1].map(|h| self.mesh.origins[h as usize]);
            let d = self.mesh.origins[previous(g) as usize];
            if in_circle_perturbed(self.at(a), self.at(b), c, self.at(d)) == CircleSide::Inside {
                self.flip(t, g, [a, b, p, d]);
            }
        }
    }

    /// Triangle `a b p` of `t` becomes `a d p`, that of its twin `d b p`; the edges `a d` and `d b` wait.
    fn flip(&mut self, t: u32, g: u32, [_, b, p, d]: [u32; 4]) {
        let u = g & !3;
        let [beyond_ad, beyond_db, beyond_bp] = [next(g), previous(g), t + 1].map(|h| self.mesh.twins[h as usize]);
        self.mesh.origins[t as usize + 1] = d;
        self.mesh.origins[u as usize..][..3].copy_from_slice(&[d, b, p]);
        self.mesh.link(t + 1, u + 2);
        for (side, beyond) in [(t, beyond_ad), (u, beyond_db), (u + 1, beyond_bp)] {
            self.mesh.twins[side as usize] = beyond;
            if beyond == NONE {
                let from = self.mesh.origins[side as usize];
                self.hull.edge[from as usize] = side;
            } else {
                self.mesh.twins[beyond as usize] = side;
            }
        }
        self.stack.extend([u, t]);
    }
}

/// The sector of a direction.
fn sector(p: Point, middle: Point, count: usize) -> u32 {
    let from = p - middle;
    let size = from.x.abs() + from.y.abs();
    let turn = if from.y > 0.0 { 3.0 - from.x / size } else { 1.0 + from.x / size };
    // A number from 0 to 4; what is no number becomes 0.
    ((0.25 * turn * count as f64) as u32).min(count as u32 - 1)
}

impl Mesh {
    /// A new triangle; its first half-edge.
    fn push(&mut self, [a, b, c]: [u32; 3]) -> u32 {
        let t = self.origins.len() as u32;
        self.origins.extend([a, b, c, NONE]);
        self.twins.extend([NONE; 4]);
        t
    }

    fn link(&mut self, h: u32, g: u32) {
        self.twins[h as usize] = g;
        self.twins[g as usize] = h;
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
    if h & 3 == 2 { h - 2 } else { h + 1 }
}

fn previous(h: u32) -> u32 {
    if h & 3 == 0 { h + 2 } else { h - 1 }
}
