//! `min-max-slope`: edge insertion by trying the edges from the corners of the worst triangle.
//!
//! # Idea
//! Each point has a height, and a triangulation makes a surface of flat triangles. It is best if its steepest triangle
//! is as flat as possible: roads and runoff are judged by slopes. Every better triangulation has an edge from one of
//! the corners of the worst triangle into that triangle, but nothing tells where the edge ends. So all ends are tried.
//!
//! ```text
//!      s1     s2                 T = q p r is the worst triangle. The edges q s1, q s2, … cross p r. Each one is tried:
//!       ╲     │    s3            along the way to its end, the corners of the crossed triangles are collected left and
//!        l ───┼─── ╱ m           right, and ears are cut off as soon as they may be. If both sides are triangulated at
//!         ╲   │   ╱ ╱            the end, the edge is inserted. If not, it is in no triangulation that is better than
//!          ╲  │  ╱ ╱             this one, and so in none that is better than a later one: it is never tried again.
//!        r ───────── p
//!          ╲  T    ╱
//!              q
//! ```
//!
//! # Steps
//! 1. Begin with the triangles of the domain, or with the Delaunay triangulation.
//! 2. Take the worst triangle T. For each of its corners q, search the triangles behind the side p r opposite, near
//!    ones first, for ends s such that q s crosses p r.
//! 3. For each end that never failed with q: follow q s from triangle to triangle, and cut ears on both sides. An ear
//!    must be convex and better than T. If an edge that must stay or a corner is in the way, or a side is stuck, the
//!    edge q s has failed for ever.
//! 4. The first edge that does not fail is inserted; go to 2. If all fail, no triangulation is better: T stays, its
//!    edges are constrained from now on; go to 2, until all triangles stay.
//!
//! # Degenerate cases
//! Triangles of equal slope are frequent (level ground), and the theorems hold for different slopes only. So equal
//! slopes are told apart as if the height of each vertex were raised by an amount that is infinitely small, and
//! infinitely smaller than that of the vertex before. Points in line, equal points, all points on one line: as for
//! angles.
//!
//! # Guarantees
//! Slopes are compared exactly, as quotients of integers, so the result is optimal for the numbers as they are given.
//! If no two possible triangles are equally steep, the descending list of slopes is the smallest in lexicographic
//! order.
//!
//! # Complexity
//! O(n³) time, O(n²) memory: each of the O(n²) edges fails once, in O(n); an insertion removes an edge p r for ever.
//! Usually a worst triangle has few ends near it and few insertions are needed: see the figures of the tests.
//!
//! # Source
//! `[BernEtAl93]`, sections 5 and 8.

use std::collections::HashSet;

use super::cavity::Cavity;
use super::chain::{Chain, Hand, Progress};
use super::criteria::{Criterion, Slope};
use super::improve;
use crate::geometry::{Orientation, orient2d};
use crate::half_edge::EdgeKey;
use crate::optimal::mesh::Mesh;
use crate::optimal::{Optimal, OptimalError, OptimalInput};
use crate::trace::{Shape, Trace};

/// A triangulation whose steepest triangle is as flat as possible.
pub(in crate::optimal) fn min_max_slope(
    input: &OptimalInput<'_>,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Optimal, OptimalError> {
    input.check()?;
    let heights = input.heights.ok_or(OptimalError::NoHeights { method: "min-max-slope" })?;
    let criterion = Slope { points: input.points, heights };
    let mut trial = Trial::default();
    improve(&criterion, input, trace, |criterion, mesh, worst, trace| trial.search(criterion, mesh, worst, trace))
}

/// What is kept between searches.
#[derive(Default)]
struct Trial {
    /// The edges that failed.
    failed: HashSet<EdgeKey<u32>>,
    /// The search that last visited a triangle.
    visited: Vec<u32>,
    searches: u32,
    queue: Vec<u32>,
}

impl Trial {
    /// Steps 2 to 4: the change that removes the worst triangle, unless no triangulation is better.
    fn search<C: Criterion>(
        &mut self,
        criterion: &C,
        mesh: &Mesh,
        (slot, bound): (u32, &C::Cost),
        trace: &mut (impl Trace + ?Sized),
    ) -> Option<Cavity> {
        (0..3).find_map(|k| self.search_from(criterion, mesh, (3 * slot + k, bound), trace))
    }

    /// Tries the edges that cross a side `p r` of the worst triangle, from the corner opposite, near ends first.
    fn search_from<C: Criterion>(
        &mut self,
        criterion: &C,
        mesh: &Mesh,
        (side, bound): (u32, &C::Cost),
        trace: &mut (impl Trace + ?Sized),
    ) -> Option<Cavity> {
        let wedge = Wedge { q: mesh.apex(side), sides: mesh.ends(side) };
        self.begin(mesh, side);
        let mut next = 0;
        while let Some(&before) = self.queue.get(next) {
            next += 1;
            let Some(behind) = mesh.twin(before) else { continue };
            if std::mem::replace(&mut self.visited[(behind / 3) as usize], self.searches) == self.searches {
                continue;
            }
            let s = mesh.apex(behind);
            if wedge.holds(criterion, s) {
                if let Some(cavity) = self.attempt(criterion, mesh, (side, s, bound), trace) {
                    return Some(cavity);
                }
            }
            let beyond = [Mesh::next(behind), Mesh::prev(behind)];
            self.queue.extend(beyond.into_iter().filter(|&h| wedge.meets(criterion, mesh.ends(h))));
        }
        None
    }

    /// Starts a search before a side; no triangle is visited yet but its own.
    fn begin(&mut self, mesh: &Mesh, side: u32) {
        self.searches = self.searches.wrapping_add(1);
        self.visited.resize(mesh.triangles.len(), 0);
        if self.searches == 0 {
            self.visited.fill(0);
            self.searches = 1;
        }
        self.visited[(side / 3) as usize] = self.searches;
        self.queue.clear();
        self.queue.push(side);
    }

    /// Step 3 for one end, unless it failed before.
    fn attempt<C: Criterion>(
        &mut self,
        criterion: &C,
        mesh: &Mesh,
        (side, s, bound): (u32, u32, &C::Cost),
        trace: &mut (impl Trace + ?Sized),
    ) -> Option<Cavity> {
        let q = mesh.apex(side);
        let edge = EdgeKey::of([q, s]);
        if self.failed.contains(&edge) {
            return None;
        }
        trace.look(Shape::Edge([q, s]), "an edge into the worst triangle");
        let found = insert(criterion, mesh, (side, s, bound));
        if found.is_none() {
            trace.refuse(Shape::Edge([q, s]), "no good triangles beside it");
            self.failed.insert(edge);
        }
        found
    }
}

/// Follows an edge from the corner opposite `side` to `s`, and cuts ears on both sides.
fn insert<C: Criterion>(criterion: &C, mesh: &Mesh, (side, s, bound): (u32, u32, &C::Cost)) -> Option<Cavity> {
    let (q, [p, r]) = (mesh.apex(side), mesh.ends(side));
    let [mut left, mut right] = [Chain::new(Hand::Left, q, r), Chain::new(Hand::Right, q, p)];
    let mut slots = vec![side / 3];
    let mut before = side;
    loop {
        let behind = mesh.twin(before)?;
        slots.push(behind / 3);
        let corner = mesh.apex(behind);
        if corner == s {
            let is_done = [&mut left, &mut right].into_iter().all(|chain| cut_all(chain, criterion, s, bound));
            let cavity = || Cavity { slots, triangles: [left.into_ears(), right.into_ears()].concat(), edge: [q, s] };
            return is_done.then(cavity);
        }
        let [from, to, at] = [q, s, corner].map(|v| criterion.point(v));
        let chain = match orient2d(from, to, at) {
            Orientation::CounterClockwise => {
                before = Mesh::next(behind);
                &mut left
            }
            Orientation::Clockwise => {
                before = Mesh::prev(behind);
                &mut right
            }
            Orientation::Collinear => return None,
        };
        cut_all(chain, criterion, corner, bound);
        chain.push(criterion, corner);
    }
}

/// Cuts off what can be cut off before the end `s`; tells whether that is all.
fn cut_all<C: Criterion>(chain: &mut Chain, criterion: &C, s: u32, bound: &C::Cost) -> bool {
    loop {
        match chain.cut(criterion, s, bound) {
            Progress::Cut => {}
            stopped => return stopped == Progress::Done,
        }
    }
}

/// The rays from `q` through a side of its triangle, the ends of the side counter-clockwise.
struct Wedge {
    q: u32,
    sides: [u32; 2],
}

impl Wedge {
    /// Whether a vertex lies inside.
    fn holds<C: Criterion>(&self, criterion: &C, v: u32) -> bool {
        !self.is_right(criterion, v) && !self.is_left(criterion, v)
    }

    /// Whether an edge may have points inside.
    fn meets<C: Criterion>(&self, criterion: &C, ends: [u32; 2]) -> bool {
        !ends.iter().all(|&v| self.is_right(criterion, v)) && !ends.iter().all(|&v| self.is_left(criterion, v))
    }

    fn is_right<C: Criterion>(&self, criterion: &C, v: u32) -> bool {
        let [q, p, v] = [self.q, self.sides[0], v].map(|v| criterion.point(v));
        orient2d(q, p, v) != Orientation::CounterClockwise
    }

    fn is_left<C: Criterion>(&self, criterion: &C, v: u32) -> bool {
        let [q, r, v] = [self.q, self.sides[1], v].map(|v| criterion.point(v));
        orient2d(q, r, v) != Orientation::Clockwise
    }
}
