//! Filling in expected linear time.
//!
//! 1. Take the vertices out of the boundary in random order, never one that is closer to the base than both its
//!    neighbours, until one is left: with the base it is the first triangle.
//! 2. Put them back in reverse order. Each lies outside what is filled, across the edge that joined its
//!    neighbours; triangles across that edge whose circle holds it (or that it does not see) are dug out,
//!    and the hole is filled with a fan around it.
//!
//! ```text
//!      u                        u
//!     /                       / | \ \
//!    p ───── n      ──>      p  |  \  n        dug out: triangles across p–n whose circle holds u
//!     \  x  /                 \ | / x
//! ```
//!
//! Every triangle is counter-clockwise: proved, or one of the two that a vertex inside the circle beyond an edge that
//! it sees makes with the far corner. Where one is not, the region is too twisted for this method and the caller falls
//! back. A triangle dug out for want of sight alone may leave edges that fail the circle test: Lawson's loop looks at
//! them then.
//!
//! # Source
//! `[ShewchukBrown15]`, after Chew's algorithm for convex polygons; written from the paper's idea. The paper marks
//! vertices around doubtful holes and fills again; here Lawson's loop does that.

use super::{Boundary, Edges};
use crate::geometry::Point;
use crate::half_edge::{Patch, Side, Triangle};

/// Draws before the farthest vertex is taken instead.
const DRAWS: u32 = 16;

/// Scratch.
#[derive(Clone, Debug, Default)]
pub(super) struct Room {
    shrinking: Shrinking,
    free: Vec<u32>,
    pending: Vec<Pending>,
}

/// See [`super::Filler::fill`].
pub(super) fn fill(boundary: Boundary<'_>, patch: &mut Patch, room: &mut Room) -> Option<Edges> {
    let n = boundary.len()?;
    let Room { shrinking, free, pending } = room;
    shrinking.take_out(boundary.0);
    free.clear();
    pending.clear();
    let mut growing = Growing { boundary, patch, free, pending, edges: Edges::Legal };
    let (&apex, others) = shrinking.order.split_first()?;
    growing.start(n, apex)?;
    for &u in others {
        growing.put_back(u, shrinking.prev[u as usize], shrinking.next[u as usize])?;
    }
    debug_assert!(growing.free.is_empty(), "whoever digs a triangle out puts two in");
    Some(growing.edges)
}

/// The boundary as a linked list that grows shorter.
#[derive(Clone, Debug, Default)]
struct Shrinking {
    prev: Vec<u32>,
    next: Vec<u32>,
    /// Distances from the base, up to a factor; rounded, as only the order of work depends on them.
    height: Vec<f64>,
    /// Inner vertices in the order in which they go back.
    order: Vec<u32>,
}

impl Shrinking {
    fn start(&mut self, points: &[Point]) {
        let n = points.len() as u32;
        let (a, b) = (points[0], points[points.len() - 1]);
        let (dx, dy) = (b.x - a.x, b.y - a.y);
        self.prev.clear();
        self.prev.extend((0..n).map(|i| i.wrapping_sub(1)));
        self.next.clear();
        self.next.extend(1..=n);
        self.order.clear();
        self.order.extend(1..n - 1);
        self.height.clear();
        self.height.extend(points.iter().map(|p| dx * (p.y - a.y) - dy * (p.x - a.x)));
        self.height[0] = 0.0;
        self.height[points.len() - 1] = 0.0;
    }

    /// Takes all inner vertices out.
    fn take_out(&mut self, points: &[Point]) {
        self.start(points);
        let mut random = 0x2545_f491_4f6c_dd1du64;
        for i in (1..self.order.len()).rev() {
            let mut pick = i;
            for _ in 0..DRAWS {
                random ^= random << 13;
                random ^= random >> 7;
                random ^= random << 17;
                pick = below(i as u64 + 1, random);
                if !self.is_valley(self.order[pick]) {
                    break;
                }
            }
            if self.is_valley(self.order[pick]) {
                // The farthest vertex is never a valley.
                let height = |&k: &usize| self.height[self.order[k] as usize];
                pick = (0..=i).max_by(|a, b| height(a).total_cmp(&height(b))).unwrap_or(i);
            }
            self.order.swap(i, pick);
            let v = self.order[i] as usize;
            let (p, n) = (self.prev[v], self.next[v]);
            self.next[p as usize] = n;
            self.prev[n as usize] = p;
        }
    }

    /// Whether a vertex is closer to the base than both its neighbours on the boundary.
    fn is_valley(&self, v: u32) -> bool {
        let [v, p, n] = [v, self.prev[v as usize], self.next[v as usize]].map(|v| self.height[v as usize]);
        v < p && v < n
    }
}

/// A number below `n`, which fits 32 bits, from the high half of random bits.
fn below(n: u64, random: u64) -> usize {
    (((random >> 32) * n) >> 32) as usize
}

/// Triangles in the making. `patch.rim[i]` is the side along the edge of the growing boundary that begins at vertex
/// `i`.
struct Growing<'a> {
    boundary: Boundary<'a>,
    patch: &'a mut Patch,
    free: &'a mut Vec<u32>,
    /// Edges to dig through or to build on, the next one last.
    pending: &'a mut Vec<Pending>,
    edges: Edges,
}

/// An edge from `v` to `w` seen from the vertex put back; `beyond` runs from `v` to `w` in the triangle beyond, if any.
#[derive(Clone, Copy, Debug)]
struct Pending {
    v: u32,
    w: u32,
    beyond: Side,
    /// Whether the vertex is known to see it.
    seen: bool,
}

impl Growing<'_> {
    /// The first triangle: the base and one vertex.
    fn start(&mut self, n: u32, apex: u32) -> Option<()> {
        let corners = [0, n - 1, apex];
        self.patch.start(self.boundary.0.len());
        let first = self.add(corners);
        self.patch.base = first;
        self.patch.rim[apex as usize] = first.next(); // last → apex
        self.patch.rim[0] = first.prev(); // apex → 0
        self.boundary.is_ccw(corners).then_some(())
    }

    /// Puts `u` back between `p` and `n`.
    fn put_back(&mut self, u: u32, p: u32, n: u32) -> Option<()> {
        self.pending.push(Pending { v: n, w: p, beyond: self.patch.rim[p as usize], seen: false });
        let mut spoke = Side::BOUNDARY; // u → w of the triangle before in the fan
        while let Some(edge) = self.pending.pop() {
            let triangle = [edge.v, u, edge.w];
            if !edge.seen && !self.boundary.is_ccw(triangle) {
                self.edges = Edges::Unproved;
                self.dig(edge, false)?;
                continue;
            }
            if edge.beyond != Side::BOUNDARY && self.boundary.is_inside(triangle, self.patch.origin(edge.beyond.prev()))
            {
                self.dig(edge, true)?;
                continue;
            }
            let t = self.add(triangle);
            self.join_beyond(t.prev(), edge);
            if spoke == Side::BOUNDARY {
                self.patch.rim[u as usize] = t; // n → u
            } else {
                self.patch.set_across(spoke, t);
                self.patch.set_across(t, spoke);
            }
            spoke = t.next();
        }
        self.patch.rim[p as usize] = spoke; // u → p
        Some(())
    }

    /// Takes away the triangle beyond an edge; its two other edges are pending instead, and seen or not.
    fn dig(&mut self, e: Pending, seen: bool) -> Option<()> {
        if e.beyond == Side::BOUNDARY {
            return None;
        }
        let (wx, xv) = (e.beyond.next(), e.beyond.prev());
        let x = self.patch.origin(xv);
        self.free.push(e.beyond.triangle());
        for (v, w, side) in [(x, e.w, wx), (e.v, x, xv)] {
            self.pending.push(Pending { v, w, beyond: self.patch.across(side), seen });
        }
        // A filled region has no more than twice as many pending edges as the boundary has vertices.
        (self.pending.len() <= 2 * self.boundary.0.len()).then_some(())
    }

    /// Adds a triangle; returns its first side.
    fn add(&mut self, corners: [u32; 3]) -> Side {
        let triangle = Triangle { corners, across: [Side::BOUNDARY; 3] };
        let triangles = &mut self.patch.triangles;
        if let Some(slot) = self.free.pop() {
            triangles[slot as usize] = triangle;
            return Side::new(slot, 0);
        }
        triangles.push(triangle);
        Side::new(triangles.len() as u32 - 1, 0)
    }

    /// Joins new side w → v to what lies beyond it, or makes it the side along the boundary.
    fn join_beyond(&mut self, side: Side, e: Pending) {
        if e.beyond != Side::BOUNDARY {
            self.patch.set_across(side, e.beyond);
            self.patch.set_across(e.beyond, side);
        } else if e.w == 0 && e.v as usize == self.boundary.0.len() - 1 {
            self.patch.base = side;
        } else {
            self.patch.rim[e.v as usize] = side;
        }
    }
}
