//! Rings of few corners: ears that prove the ring simple while they are cut off.
//!
//! # Idea
//! Cut off an ear only if no other side of the ring meets its triangle. The triangle that is left in the end is simple.
//! Put the ears back one by one, the last first: each adds two sides that no side meets to a simple ring. So the whole
//! ring is simple, and no side need be compared with all others before.
//!
//! ```text
//!          b
//!        .' '.            Most ears are proved by one line: all other corners lie beyond the side that the ear
//!      .'     '.          leaves, from a to c. Then no side can meet the triangle.
//!     a ─ ─ ─ ─ c
//!      \  .──.  |         Otherwise each other side must have both ends beyond one of the three lines of the
//!       \/    \_|         triangle, or the triangle on one side of its own line.
//! ```
//!
//! # Degenerate cases
//! Rounded numbers must prove every sign. Where they do not (a corner on a side, repeated points), or where sides
//! cross, a corner is no ear, and in the end none is left: the sweep follows.
//!
//! # Complexity
//! O(n²) if ears are found soon, O(n³) at worst.

use super::few::counter_clockwise;
use crate::geometry::{Orientation, Point, Turn, orient2d};

/// The lists for a ring, which can be used again.
#[derive(Clone, Debug, Default)]
pub(super) struct ProvingEars {
    /// The corners, counter-clockwise, and which vertices they are.
    corners: Vec<(Point, u32)>,
    /// The corners before and after each corner.
    links: Vec<[u32; 2]>,
}

/// The lines of the triangle of an ear.
const CA: u8 = 1;
const AB: u8 = 2;
const BC: u8 = 4;

impl ProvingEars {
    /// From so many corners on it pays to ask first whether the ring is convex.
    pub(super) const FEWEST_IF_CONVEX: usize = 8;
    /// Up to so many corners this is faster than to look for an easier way.
    pub(super) const MOST_AT_ONCE: usize = 24;
    /// The most corners for which this is faster than the sweep.
    pub(super) const MOST: usize = 40;

    /// Triangulates a ring whose first point is vertex `first`, if it is proved simple; false otherwise.
    pub(super) fn triangulate(&mut self, ring: &[Point], first: u32, triangles: &mut Vec<[u32; 3]>) -> bool {
        if ring.len() < 3 || !counter_clockwise(ring, first, &mut self.corners) {
            return false;
        }
        let n = self.corners.len() as u32;
        self.links.clear();
        self.links.extend((0..n).map(|i| [i.wrapping_sub(1), i + 1]));
        self.links[0][0] = n - 1;
        self.links[n as usize - 1][1] = 0;
        let begun = triangles.len();
        let done = self.cut(triangles);
        if !done {
            triangles.truncate(begun);
        }
        done
    }

    /// Cuts off ears until a triangle is left. After an ear the corner before it is next, which may be one now.
    fn cut(&mut self, triangles: &mut Vec<[u32; 3]>) -> bool {
        let (mut at, mut left, mut refused) = (0, self.corners.len(), 0);
        while left > 3 {
            let [before, after] = self.links[at as usize];
            if self.is_ear([before, at, after]) {
                triangles.push(self.triangle([before, at, after]));
                self.links[before as usize][1] = after;
                self.links[after as usize][0] = before;
                left -= 1;
                refused = 0;
                at = before;
            } else {
                refused += 1;
                if refused > left {
                    return false;
                }
                at = after;
            }
        }
        let [before, after] = self.links[at as usize];
        triangles.push(self.triangle([before, at, after]));
        orient2d(self.at(before), self.at(at), self.at(after)) == Orientation::CounterClockwise
    }

    #[inline(always)]
    fn at(&self, corner: u32) -> Point {
        self.corners[corner as usize].0
    }

    #[inline]
    fn triangle(&self, corners: [u32; 3]) -> [u32; 3] {
        corners.map(|corner| self.corners[corner as usize].1)
    }

    /// Whether a corner is convex and no side but its own meets its triangle.
    #[inline]
    fn is_ear(&self, corners: [u32; 3]) -> bool {
        let [a, b, c] = corners.map(|corner| self.at(corner));
        if !Turn::of(a, b, c).is_surely_counter_clockwise() {
            return false;
        }
        let (mut from, mut at) = (corners[2], self.links[corners[2] as usize][1]);
        while at != corners[0] && surely_left(a, c, self.at(at)) {
            (from, at) = (at, self.links[at as usize][1]);
        }
        // A corner in the triangle is what most often forbids an ear.
        let is_inside = |p| !surely_left(b, a, p) && !surely_left(c, b, p);
        at == corners[0] || (!is_inside(self.at(at)) && self.meets_no_side_from(from, corners, [a, b, c]))
    }

    /// Whether no side from a corner on to `a` meets the triangle.
    fn meets_no_side_from(&self, mut from: u32, [at_a, _, at_c]: [u32; 3], [a, b, c]: [Point; 3]) -> bool {
        let (west, east) = (a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x));
        let (south, north) = (a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y));
        let around = |p: Point| {
            u8::from(p.x < west) | u8::from(p.x > east) << 1 | u8::from(p.y < south) << 2 | u8::from(p.y > north) << 3
        };
        // a and c lie on two lines each.
        let lines_of = |corner: u32| match corner {
            _ if corner == at_a => CA | AB,
            _ if corner == at_c => BC | CA,
            _ => lines_beyond([a, b, c], self.at(corner)),
        };
        let mut sides = around(self.at(from));
        while from != at_a {
            let to = self.links[from as usize][1];
            let next = around(self.at(to));
            if sides & next == 0
                && lines_of(from) & lines_of(to) == 0
                && !is_beside([a, b, c], self.at(from), self.at(to))
            {
                return false;
            }
            (from, sides) = (to, next);
        }
        true
    }
}

/// The lines of a triangle beyond which a point surely lies.
#[inline]
fn lines_beyond([a, b, c]: [Point; 3], p: Point) -> u8 {
    let bit = |is_beyond: bool, bit: u8| if is_beyond { bit } else { 0 };
    bit(surely_left(a, c, p), CA) | bit(surely_left(b, a, p), AB) | bit(surely_left(c, b, p), BC)
}

#[inline(always)]
fn surely_left(a: Point, b: Point, p: Point) -> bool {
    Turn::of(b, p, a).is_surely_counter_clockwise()
}

/// Whether a triangle surely lies on one side of a line.
#[inline]
fn is_beside(triangle: [Point; 3], from: Point, to: Point) -> bool {
    let turns = triangle.map(|p| Turn::of(from, to, p));
    turns.iter().all(|turn| turn.is_surely_counter_clockwise())
        || turns.iter().all(|turn| turn.reversed().is_surely_counter_clockwise())
}
