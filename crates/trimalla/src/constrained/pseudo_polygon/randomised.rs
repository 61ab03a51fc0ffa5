//! Filling in expected linear time.
//!
//! 1. Take the vertices out of the border in random order, never one that is closer to the base than both its
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
//! Every triangle is proved counter-clockwise before it is added; where one is not, the region is too twisted for
//! this method and the caller falls back. The caller also runs Lawson's loop over the result, so a
//! hole dug for want of sight costs flips, not correctness.
//!
//! # Source
//! `[ShewchukBrown15]`, after Chew's algorithm for convex polygons; written from the paper's idea. The paper marks
//! vertices around doubtful holes and fills again; here Lawson's loop does that.

use super::{Across, Filled, is_ccw, is_inside};
use crate::geometry::Point;

const NONE: u32 = u32::MAX;
/// Draws before the farthest vertex is taken instead.
const DRAWS: u32 = 16;

/// See [`super::fill`].
pub(super) fn fill(points: &[Point]) -> Option<Vec<Filled>> {
    let n = u32::try_from(points.len()).ok().filter(|&n| n >= 3)?;
    let mut border = Border::new(n);
    let taken = border.take_out(points);
    let mut fan = Filler::start(points, taken[0])?;
    for &u in &taken[1..] {
        fan.put_back(u, border.prev[u as usize], border.next[u as usize])?;
    }
    Some(fan.finish(n))
}

/// The border as a linked list.
struct Border {
    prev: Vec<u32>,
    next: Vec<u32>,
}

impl Border {
    fn new(n: u32) -> Self {
        Self { prev: (0..n).map(|i| i.wrapping_sub(1)).collect(), next: (1..=n).collect() }
    }

    /// Takes all inner vertices out; returns them in the order in which they go back.
    fn take_out(&mut self, points: &[Point]) -> Vec<u32> {
        let height = heights(points);
        let mut order: Vec<u32> = (1..self.next.len() as u32 - 1).collect();
        let mut random = 0x2545_f491_4f6c_dd1du64;
        for i in (1..order.len()).rev() {
            let mut pick = i;
            for _ in 0..DRAWS {
                random ^= random << 13;
                random ^= random >> 7;
                random ^= random << 17;
                pick = (random % (i as u64 + 1)) as usize;
                if !self.is_valley(order[pick], &height) {
                    break;
                }
            }
            if self.is_valley(order[pick], &height) {
                // The farthest vertex is never a valley.
                pick = (0..=i)
                    .max_by(|&a, &b| height[order[a] as usize].total_cmp(&height[order[b] as usize]))
                    .unwrap_or(i);
            }
            order.swap(i, pick);
            let v = order[i] as usize;
            let (p, n) = (self.prev[v], self.next[v]);
            self.next[p as usize] = n;
            self.prev[n as usize] = p;
        }
        order
    }

    /// Whether a vertex is closer to the base than both its neighbours on the border.
    fn is_valley(&self, v: u32, height: &[f64]) -> bool {
        let h = height[v as usize];
        h < height[self.prev[v as usize] as usize] && h < height[self.next[v as usize] as usize]
    }
}

/// Distances from the base, up to a factor; rounded, as only the order of work depends on them.
fn heights(points: &[Point]) -> Vec<f64> {
    let (a, b) = (points[0], points[points.len() - 1]);
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    let mut heights: Vec<f64> = points.iter().map(|p| dx * (p.y - a.y) - dy * (p.x - a.x)).collect();
    heights[0] = 0.0;
    heights[points.len() - 1] = 0.0;
    heights
}

/// Triangles in the making: vertices and neighbours, three a triangle.
struct Filler<'a> {
    points: &'a [Point],
    vertex: Vec<u32>,
    twin: Vec<u32>,
    free: Vec<u32>,
    /// For border vertex `i`: the half-edge inside the border edge from its successor to it.
    inside: Vec<u32>,
    /// The half-edge along the base.
    base: u32,
    /// Edges to dig through or to build on, the next one last.
    pending: Vec<Pending>,
}

/// An edge from `v` to `w` seen from the vertex put back; `beyond` runs from `v` to `w` in the triangle
/// beyond, if any.
#[derive(Clone, Copy)]
struct Pending {
    v: u32,
    w: u32,
    beyond: u32,
}

fn next(h: u32) -> u32 {
    if h % 3 == 2 { h - 2 } else { h + 1 }
}

fn prev(h: u32) -> u32 {
    if h % 3 == 0 { h + 2 } else { h - 1 }
}

impl<'a> Filler<'a> {
    /// The first triangle: the base and one vertex.
    fn start(points: &'a [Point], apex: u32) -> Option<Self> {
        let last = points.len() as u32 - 1;
        let first = [0, last, apex];
        if !is_ccw(points, first) {
            return None;
        }
        let mut inside = vec![NONE; points.len()];
        inside[apex as usize] = 1; // last → apex
        inside[0] = 2; // apex → 0
        Some(Self {
            points,
            vertex: first.to_vec(),
            twin: vec![NONE; 3],
            free: Vec::new(),
            inside,
            base: 0,
            pending: Vec::new(),
        })
    }

    /// Puts `u` back between `p` and `n`.
    fn put_back(&mut self, u: u32, p: u32, n: u32) -> Option<()> {
        self.pending.push(Pending { v: n, w: p, beyond: self.inside[p as usize] });
        let mut spoke = NONE; // u → w of the triangle before in the fan
        while let Some(edge) = self.pending.pop() {
            if self.must_dig(edge, u) {
                self.dig(edge)?;
                continue;
            }
            let t = self.add([edge.v, u, edge.w])?;
            self.join_beyond(t + 2, edge);
            if spoke == NONE {
                self.inside[u as usize] = t; // n → u
            } else {
                self.twin[spoke as usize] = t;
                self.twin[t as usize] = spoke;
            }
            spoke = t + 1;
        }
        self.inside[p as usize] = spoke; // u → p
        Some(())
    }

    fn must_dig(&self, e: Pending, u: u32) -> bool {
        if e.beyond == NONE {
            return false;
        }
        let t = [e.v, u, e.w];
        !is_ccw(self.points, t) || is_inside(self.points, t, self.vertex[prev(e.beyond) as usize])
    }

    /// Takes away the triangle beyond an edge; its two other edges are pending instead.
    fn dig(&mut self, e: Pending) -> Option<()> {
        let (wx, xv) = (next(e.beyond), prev(e.beyond));
        let x = self.vertex[xv as usize];
        self.free.push(e.beyond / 3);
        let (beyond_wx, beyond_xv) = (self.beyond(wx), self.beyond(xv));
        self.pending.push(Pending { v: x, w: e.w, beyond: beyond_wx });
        self.pending.push(Pending { v: e.v, w: x, beyond: beyond_xv });
        // A filled region has no more than twice as many pending edges as the border has vertices.
        (self.pending.len() <= 2 * self.points.len()).then_some(())
    }

    fn beyond(&mut self, h: u32) -> u32 {
        let t = self.twin[h as usize];
        if t != NONE {
            self.twin[t as usize] = NONE;
        }
        t
    }

    /// Adds a triangle, proved counter-clockwise; returns its first half-edge.
    fn add(&mut self, t: [u32; 3]) -> Option<u32> {
        if !is_ccw(self.points, t) {
            return None;
        }
        if let Some(slot) = self.free.pop() {
            let h = 3 * slot;
            for k in 0..3 {
                self.vertex[(h + k) as usize] = t[k as usize];
                self.twin[(h + k) as usize] = NONE;
            }
            return Some(h);
        }
        let h = self.vertex.len() as u32;
        self.vertex.extend(t);
        self.twin.extend([NONE; 3]);
        Some(h)
    }

    /// Joins new half-edge `h` = w → v to what lies beyond it, or makes it the inside of the border.
    fn join_beyond(&mut self, h: u32, e: Pending) {
        if e.beyond != NONE {
            self.twin[h as usize] = e.beyond;
            self.twin[e.beyond as usize] = h;
        } else if e.w == 0 && e.v as usize == self.points.len() - 1 {
            self.base = h;
        } else {
            self.inside[e.v as usize] = h;
        }
    }

    /// The triangles that are left, numbered anew.
    fn finish(self, n: u32) -> Vec<Filled> {
        let mut number: Vec<u32> = vec![0; self.vertex.len() / 3];
        for &f in &self.free {
            number[f as usize] = NONE;
        }
        for (count, slot) in (0..).zip(number.iter_mut().filter(|s| **s != NONE)) {
            *slot = count;
        }
        let mut rim = vec![NONE; self.vertex.len()];
        for i in 0..n - 1 {
            rim[self.inside[i as usize] as usize] = i;
        }
        let across = |h: u32| match self.twin[h as usize] {
            NONE if h == self.base => Across::Base,
            NONE => Across::Rim(rim[h as usize]),
            t => Across::Triangle(number[t as usize / 3], t % 3),
        };
        (0..self.vertex.len() as u32 / 3)
            .filter(|&t| number[t as usize] != NONE)
            .map(|t| Filled {
                vertices: [0, 1, 2].map(|k| self.vertex[(3 * t + k) as usize]),
                across: [0, 1, 2].map(|k| across(3 * t + k)),
            })
            .collect()
    }
}
