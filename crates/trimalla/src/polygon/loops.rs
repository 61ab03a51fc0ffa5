//! The boundary of the inside, as loops with the inside on their left; holes joined to the rest by bridges.
//!
//! Where rings touch, or a vertex lies inside a side, the loop turns so that it keeps to one part of the inside. So a
//! loop that passes a point twice has a corner for each of the two, and parts of the inside that only touch have loops
//! of their own. What is still several loops around one part of the inside (an outline and its holes) is joined by
//! *bridges*:
//!
//! ```text
//!    .-------------.        .-------------.
//!    |   .--.      |        |   .--.      |     A bridge is passed in both directions. It is the diagonal that a
//!    |   '--'      |   ->   | __'--'      |     sweep draws at the leftmost corner of a hole, to its helper.
//!    '-------------'        ''------------'
//! ```

use super::corners::{Corners, Mark};
use super::sweep::{Cause, Chain, Pieces, Sweep};
use super::{Polygon, PolygonError};
use crate::geometry::{Orientation, Point, orient2d};
use crate::trace::{Shape, Trace};

/// No corner.
const NONE: u32 = u32::MAX;

/// The loops of a polygon. A corner may be missing in all of them only if its loop is no more.
#[derive(Clone, Debug, Default)]
pub(super) struct Loops {
    pub(super) points: Vec<Point>,
    pub(super) vertices: Vec<u32>,
    /// The corners after and before each corner.
    pub(super) next: Vec<u32>,
    pub(super) previous: Vec<u32>,
    /// A corner of each loop.
    pub(super) begins: Vec<u32>,
}

impl Loops {
    /// Proves a polygon valid and finds its loops.
    pub(super) fn of(polygon: Polygon<'_>, trace: &mut (impl Trace + ?Sized)) -> Result<Self, PolygonError> {
        let mut corners = Corners::default();
        corners.fill(polygon)?;
        let mut finder = Finder { ends: vec![[NONE; 2]; corners.count], bridges: Vec::new(), last: Vec::new(), trace };
        Sweep::default().run(&mut corners, &mut finder)?;
        let Finder { ends, bridges, .. } = finder;
        let count = corners.points.len();
        let mut loops = Self {
            points: corners.points,
            vertices: corners.vertices,
            next: vec![NONE; count],
            previous: vec![NONE; count],
            begins: Vec::new(),
        };
        for [from, to] in ends {
            loops.link(from, to);
        }
        loops.build(&bridges, trace);
        Ok(loops)
    }

    /// Links two corners.
    pub(super) fn link(&mut self, from: u32, to: u32) {
        self.next[from as usize] = to;
        self.previous[to as usize] = from;
    }

    /// The point of a corner.
    #[inline]
    pub(super) fn at(&self, corner: u32) -> Point {
        self.points[corner as usize]
    }

    /// Draws the bridges that join different loops, and finds where each loop begins.
    fn build(&mut self, bridges: &[[u32; 2]], trace: &mut (impl Trace + ?Sized)) {
        let mut loop_of = self.number();
        let mut parents: Vec<u32> = (0..self.points.len() as u32).collect();
        let mut copies = vec![NONE; self.points.len()];
        for &[a, b] in bridges {
            let [wa, wb] = [a, b].map(|c| root(&mut parents, loop_of[c as usize]));
            if wa == wb {
                continue;
            }
            parents[wa as usize] = wb;
            trace.add(Shape::Edge([a, b].map(|c| self.vertices[c as usize])), "a bridge to a hole");
            self.join(a, b, &mut copies);
            loop_of.resize(self.points.len(), wb);
        }
        for c in 0..loop_of.len() as u32 {
            if root(&mut parents, loop_of[c as usize]) == c {
                self.begins.push(c);
            }
        }
    }

    /// For each corner, the first corner of its loop.
    fn number(&self) -> Vec<u32> {
        let mut loop_of = vec![NONE; self.points.len()];
        for c in 0..self.points.len() as u32 {
            let mut at = c;
            while loop_of[at as usize] == NONE {
                loop_of[at as usize] = c;
                at = self.next[at as usize];
            }
        }
        loop_of
    }

    /// Draws a bridge between two corners, each of which becomes two.
    fn join(&mut self, a: u32, b: u32, copies: &mut Vec<u32>) {
        let (to, from) = (self.at(b), self.at(a));
        let a = self.copy_towards(a, to, copies);
        let b = self.copy_towards(b, from, copies);
        let [after_a, after_b] = [a, b].map(|c| self.next[c as usize]);
        let [a2, b2] = [a, b].map(|c| {
            self.points.push(self.points[c as usize]);
            self.vertices.push(self.vertices[c as usize]);
            self.next.push(NONE);
            self.previous.push(NONE);
            copies.push(copies[c as usize]);
            copies[c as usize] = copies.len() as u32 - 1;
            copies.len() as u32 - 1
        });
        for (from, to) in [(a, b2), (b2, after_b), (b, a2), (a2, after_a)] {
            self.link(from, to);
        }
    }

    /// Of a corner and those that bridges made of it, the one whose inside goes towards a point.
    fn copy_towards(&self, corner: u32, p: Point, copies: &[u32]) -> u32 {
        let mut at = corner;
        while !self.opens_towards(at, p) {
            at = copies[at as usize];
            if at == NONE {
                return corner;
            }
        }
        at
    }

    /// Whether the inside at a corner goes towards a point.
    fn opens_towards(&self, corner: u32, p: Point) -> bool {
        let [before, after] = [self.previous[corner as usize], self.next[corner as usize]].map(|c| self.at(c));
        let o = self.at(corner);
        let (out, back) = (orient2d(o, after, p), orient2d(o, before, p));
        if orient2d(before, o, after) == Orientation::CounterClockwise {
            out == Orientation::CounterClockwise && back == Orientation::Clockwise
        } else {
            !(back != Orientation::Clockwise && out != Orientation::CounterClockwise)
        }
    }
}

/// The root of a tree of numbers; the way to it is halved.
fn root(parents: &mut [u32], mut at: u32) -> u32 {
    while parents[at as usize] != at {
        parents[at as usize] = parents[parents[at as usize] as usize];
        at = parents[at as usize];
    }
    at
}

/// Finds the ends of all edges, and the diagonals at split vertices.
struct Finder<'a, T: Trace + ?Sized> {
    /// The corners from and to which each edge goes, the inside on its left.
    ends: Vec<[u32; 2]>,
    bridges: Vec<[u32; 2]>,
    /// The last corner of each piece.
    last: Vec<(Mark, Chain)>,
    trace: &'a mut T,
}

impl<T: Trace + ?Sized> Pieces for Finder<'_, T> {
    fn diagonal(&mut self, from: Mark, to: Mark, cause: Cause) {
        if cause != Cause::Merge {
            self.bridges.push([from.corner, to.corner]);
        }
    }

    fn begin(&mut self, at: Mark) -> u32 {
        self.last.push((at, Chain::Lower));
        self.last.len() as u32 - 1
    }

    fn extend(&mut self, piece: u32, at: Mark, chain: Chain) {
        self.last[piece as usize] = (at, chain);
    }

    fn finish(&mut self, _: u32, _: Mark) {}

    fn last(&self, piece: u32) -> (Mark, Chain) {
        self.last[piece as usize]
    }

    fn edge(&mut self, edge: u32, corner: u32, goes_out: bool) {
        if edge as usize >= self.ends.len() {
            self.ends.resize(edge as usize + 1, [NONE; 2]);
        }
        self.ends[edge as usize][usize::from(!goes_out)] = corner;
    }

    fn is_cancelled(&self) -> bool {
        self.trace.is_cancelled()
    }
}
