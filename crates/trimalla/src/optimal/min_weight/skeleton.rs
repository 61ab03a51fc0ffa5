//! Step 2: which edges are impossible, and which are certain.
//!
//! In a triangulation of least weight each inner edge is *locally minimal*: if the two triangles on it form a strictly
//! convex quadrilateral, the other diagonal is not shorter, or the exchange would make the triangulation lighter. So an
//! edge for which no pair of empty triangles, one on each side, is locally minimal is impossible; then triangles that
//! have it are impossible, too, and pairs of other edges may be lost:
//!
//! ```text
//!           l                 the pair (l, r) of the edge p q is locally minimal
//!         ╱ │ ╲               if |p q| < |l r|, or if p q and l r do not cross.
//!       p ──┼── q
//!         ╲ │ ╱               Ties: of equal edges the one whose vertices come first counts as the shorter.
//!           r
//! ```
//!
//! 1. Each edge has two cursors into the triangles on its left and its right, which stand on a locally minimal pair.
//! 2. An edge whose cursors find none is removed, and the triangles on it.
//! 3. The edges whose cursors stood on these triangles are put on a stack, and go on from where they are.
//! 4. What is left of the edges is *possible*. An edge is *certain* if it crosses no other possible edge: every
//!    triangulation is maximal, and nothing could be in its place. The certain edges are the LMT-skeleton.
//!
//! Ties are decided as if each edge were longer by a symbolic amount, of another order of magnitude for each. One of
//! the lightest triangulations is the lightest of these, and all that is said here is true of that one.

use std::cmp::Ordering;

use super::empty_triangles::EmptyTriangles;
use super::fans::Fans;
use super::lengths::Lengths;
use crate::geometry::{BoundingBox, BoxTree, Orientation, Point, Segment, orient2d, segments_cross_properly};
use crate::optimal::OptimalError;
use crate::trace::{Shape, Trace};

/// The search for locally minimal pairs.
struct Search<'a> {
    points: &'a [Point],
    lengths: &'a Lengths<'a>,
    fans: &'a Fans,
    triangles: &'a EmptyTriangles,
    is_possible: Vec<bool>,
    is_dead: Vec<bool>,
    /// The cursors of each edge, on its left and its right.
    cursors: Vec<[u32; 2]>,
    open: Vec<u32>,
    /// The pairs that may still be looked at.
    steps: u64,
}

/// Tells for each edge whether it is possible; boundary edges are. After so many steps the other edges count as
/// possible.
pub(super) fn possible(
    points: &[Point],
    lengths: &Lengths<'_>,
    fans: &Fans,
    triangles: &EmptyTriangles,
    is_boundary: &[bool],
    steps: u64,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Vec<bool>, OptimalError> {
    let count = fans.edges.len();
    let mut search = Search {
        points,
        lengths,
        fans,
        triangles,
        is_possible: vec![true; count],
        is_dead: vec![false; triangles.sides.len()],
        cursors: vec![[0; 2]; count],
        open: (0..count as u32).rev().filter(|&e| !is_boundary[e as usize]).collect(),
        steps,
    };
    while let Some(e) = search.open.pop().filter(|_| search.steps > 0) {
        if trace.is_cancelled() {
            return Err(OptimalError::Cancelled);
        }
        if search.is_possible[e as usize] && !search.has_pair(e) {
            trace.refuse(Shape::Edge(fans.edges[e as usize]), "no locally minimal pair of triangles");
            search.remove(e, is_boundary);
        }
    }
    Ok(search.is_possible)
}

impl Search<'_> {
    /// The triangles on both sides of an edge.
    fn sides(&self, e: u32) -> [&[u32]; 2] {
        let half = self.fans.half[e as usize];
        [half, self.fans.twin[half as usize]].map(|h| self.triangles.left_of(h))
    }

    /// Moves the cursors to the next locally minimal pair, if they stand on none.
    fn has_pair(&mut self, e: u32) -> bool {
        let [mut i, mut j] = self.cursors[e as usize].map(|cursor| cursor as usize);
        let [left, right] = self.sides(e);
        let (mut found, mut steps) = (false, 0);
        while i < left.len() && !found {
            if !self.is_dead[left[i] as usize] {
                while j < right.len() && (self.is_dead[right[j] as usize] || !self.is_minimal(e, left[i], right[j])) {
                    (j, steps) = (j + 1, steps + 1);
                }
                found = j < right.len();
            }
            if !found {
                (i, j) = (i + 1, 0);
            }
        }
        self.cursors[e as usize] = [i as u32, j as u32];
        self.steps = self.steps.saturating_sub(steps);
        found
    }

    fn is_minimal(&self, e: u32, left: u32, right: u32) -> bool {
        let edge = self.fans.edges[e as usize];
        let half = self.fans.half[e as usize];
        let l = self.triangles.apex(self.fans, left, half);
        let r = self.triangles.apex(self.fans, right, self.fans.twin[half as usize]);
        if self.lengths.order(edge, [l, r]) == Ordering::Less {
            return true;
        }
        let [p, q, l, r] = [edge[0], edge[1], l, r].map(|v| self.points[v as usize]);
        // l and r are on both sides of the edge: it crosses l r if p and q are on both sides of that.
        orient2d(r, l, p) != Orientation::CounterClockwise || orient2d(r, l, q) != Orientation::Clockwise
    }

    /// Removes an edge and its triangles; the edges that had them in their pairs are looked at again.
    fn remove(&mut self, e: u32, is_boundary: &[bool]) {
        self.is_possible[e as usize] = false;
        let half = self.fans.half[e as usize];
        for side in [half, self.fans.twin[half as usize]] {
            for i in 0..self.triangles.left_of(side).len() {
                let t = self.triangles.left_of(side)[i];
                if std::mem::replace(&mut self.is_dead[t as usize], true) {
                    continue;
                }
                for h in self.triangles.sides[t as usize] {
                    let other = self.fans.edge[h as usize];
                    if self.is_possible[other as usize] && !is_boundary[other as usize] && self.stands_on(other, h, t) {
                        self.open.push(other);
                    }
                }
            }
        }
    }

    /// Whether the cursor of an edge on the side of a half-edge stands on a triangle.
    fn stands_on(&self, e: u32, h: u32, t: u32) -> bool {
        let is_right = self.fans.half[e as usize] != h;
        let cursor = self.cursors[e as usize][usize::from(is_right)];
        self.triangles.left_of(h).get(cursor as usize) == Some(&t)
    }
}

/// Tells for each edge whether it is possible and crosses no other possible edge.
///
/// # Complexity
/// n log n for edges that cross few boxes of others.
pub(super) fn certain(points: &[Point], fans: &Fans, is_possible: &[bool]) -> Vec<bool> {
    let mut is_certain = is_possible.to_vec();
    for (e, &half) in fans.half.iter().enumerate() {
        if is_possible[e] && is_crossed_nearby(points, fans, is_possible, half) {
            is_certain[e] = false;
        }
    }
    let possible: Vec<u32> = (0..fans.edges.len() as u32).filter(|&e| is_possible[e as usize]).collect();
    let segment = |e: u32| {
        let [a, b] = fans.edges[e as usize].map(|v| points[v as usize]);
        Segment::new(a, b)
    };
    let tree = BoxTree::new(possible.iter().map(|&e| segment(e).bounding_box()).collect::<Vec<BoundingBox>>());
    for &e in &possible {
        if !is_certain[e as usize] {
            continue;
        }
        let near = tree.near(segment(e), [0.0; 2]);
        let crosses = |&&i: &&u32| {
            let ([a, b], [c, d]) = (segment(e).ends(), segment(possible[i as usize]).ends());
            segments_cross_properly(a, b, c, d)
        };
        is_certain[e as usize] = !near.iter().any(|i| crosses(&i));
    }
    is_certain
}

/// Whether an edge is crossed by one that starts at the third corner of a triangle on it: the common case.
fn is_crossed_nearby(points: &[Point], fans: &Fans, is_possible: &[bool], half: u32) -> bool {
    let at = |v: u32| points[v as usize];
    [half, fans.twin[half as usize]].into_iter().any(|h| {
        let (p, q) = (fans.from(h), fans.to[h as usize]);
        // The edges next to it at both ends, on its left.
        let [next, prev] = [
            next_possible(fans, is_possible, p, h, true),
            next_possible(fans, is_possible, q, fans.twin[h as usize], false),
        ];
        [next, prev].into_iter().any(|corner| {
            fans.of(corner).any(|h| {
                let to = fans.to[h as usize];
                is_possible[fans.edge[h as usize] as usize] && segments_cross_properly(at(p), at(q), at(corner), at(to))
            })
        })
    })
}

/// Where the next possible half-edge around a vertex leads.
fn next_possible(fans: &Fans, is_possible: &[bool], v: u32, h: u32, is_ccw: bool) -> u32 {
    let mut at = h;
    loop {
        at = if is_ccw { fans.after(v, at) } else { fans.before(v, at) };
        if at == h || is_possible[fans.edge[at as usize] as usize] {
            return fans.to[at as usize];
        }
    }
}
