//! Step 1: the edges that pass the diamond test.
//!
//! Every vertex `p` looks around through the triangles of any triangulation of the points. What it sees through a chain
//! of triangles is a *cone* between two vertices that it saw before; the next triangle shows one more vertex or none:
//!
//! ```text
//!             left                      w is between the two: p sees w, and the cone is split in two;
//!            / |\ .                     w is right of the cone: it is led on through the side from w to left;
//!           /  |  \  .                  w is left of it: through the side from right to w.
//!         p ───┼── w ── . sees w        Signs are exact, and what is hidden behind a vertex is not seen.
//!           \  |  /  .
//!            \ |/ .
//!             right
//! ```
//!
//! The edge `p q` fails the diamond test if both of its isosceles triangles, of base angle π/4.6, have vertices inside.
//! Then no triangulation of least weight has it `[DrysdaleMcElfreshSnoeyink01]`. The vertices that `p` has seen are
//! held against the triangles on all edges from `p` into a cone at once: if `r` is in the left triangle on the shortest
//! edge that can come, along the right side of the cone and along the left, it is in those of all edges between. So
//! cones end soon, and the nearest cone goes first. The test is in doubles with room for their errors: a doubtful edge
//! is kept.
//!
//! In a domain a point in the diamond may be hidden by a hole, and the test says nothing: all edges are kept.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::base::{Base, NONE};
use super::lengths::Lengths;
use crate::geometry::{Orientation, Vector, orient2d};
use crate::optimal::OptimalError;
use crate::trace::Trace;

/// tan(π/4.6) = 0.81356034376…, rounded down so far that rounding does not matter.
const SLOPE: f64 = 0.813_560_343;
/// The relative error for which the tests in doubles have room.
const ROOM: f64 = 1e-13;
/// A vertex that has seen so many still looks for others beside its cones.
const MANY: usize = 48;
/// At most so many vertices are held against an edge or a cone.
const MOST: usize = 256;

/// What is seen through a side of a triangle.
#[derive(Clone, Copy, Debug)]
struct Cone {
    /// Everything to come is at least so far away.
    distance: f64,
    /// The triangle behind the side.
    behind: u32,
    /// The side.
    right: u32,
    left: u32,
    /// The vertices that bound the cone.
    low: u32,
    high: u32,
    /// Whether the left and the right triangles on all edges into the cone are known not to be empty.
    is_full: [bool; 2],
}

/// The nearest cone is the greatest.
impl Ord for Cone {
    fn cmp(&self, other: &Self) -> Ordering {
        other.distance.total_cmp(&self.distance).then_with(|| (other.low, other.high).cmp(&(self.low, self.high)))
    }
}

impl PartialOrd for Cone {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Cone {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Cone {}

/// A vertex looks around.
struct View<'a> {
    base: &'a Base<'a>,
    lengths: &'a Lengths<'a>,
    /// Whether the diamond test may be used.
    may_test: bool,
    from: u32,
    /// The ways to the vertices seen so far.
    seen: Vec<Vector>,
    open: BinaryHeap<Cone>,
    /// The vertices to which there may be an edge.
    found: Vec<u32>,
}

/// The edges that pass the test, boundary edges among them, each with its lower vertex first, sorted; nothing if they
/// are more than `limit`.
pub(super) fn candidates(
    base: &Base<'_>,
    lengths: &Lengths<'_>,
    limit: usize,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Option<Vec<[u32; 2]>>, OptimalError> {
    let may_test = base.is_hull && lengths.is_ordinary();
    let (seen, open, found) = (Vec::new(), BinaryHeap::new(), Vec::new());
    let mut view = View { base, lengths, may_test, from: 0, seen, open, found };
    let mut edges: Vec<[u32; 2]> = base.boundary().flat_map(|[a, b]| [[a, b], [b, a]]).collect();
    for from in 0..base.points.len() as u32 {
        if trace.is_cancelled() {
            return Err(OptimalError::Cancelled);
        }
        view.look_from(from);
        edges.extend(view.found.iter().map(|&to| [from, to]));
        if edges.len() / 2 > limit {
            return Ok(None);
        }
    }
    Ok(Some(found_from_both(edges)))
}

/// The edges that both of their ends have found.
fn found_from_both(mut edges: Vec<[u32; 2]>) -> Vec<[u32; 2]> {
    for [a, b] in &mut edges {
        // The direction is kept in the lowest bit, so that the two directions of an edge are neighbours in the order.
        let is_turned = u32::from(a > b);
        (*a, *b) = (*a.min(b), 2 * *a.max(b) + is_turned);
    }
    edges.sort_unstable();
    edges.dedup();
    let is_pair = |two: &&[[u32; 2]]| two[0][0] == two[1][0] && two[0][1] / 2 == two[1][1] / 2;
    edges.windows(2).filter(is_pair).map(|two| [two[0][0], two[0][1] / 2]).collect()
}

impl View<'_> {
    /// Finds the vertices to which there may be an edge.
    fn look_from(&mut self, from: u32) {
        self.from = from;
        self.seen.clear();
        self.open.clear();
        self.found.clear();
        self.see_neighbours();
        while let Some(mut cone) = self.open.pop() {
            self.fill(&mut cone);
            if cone.is_full != [true; 2] {
                self.look_behind(&cone);
            }
        }
    }

    /// The neighbours, the nearest first, and the cones between them.
    fn see_neighbours(&mut self) {
        let base = self.base;
        let from = self.from;
        let mut ends: Vec<u32> = Vec::new();
        for (t, corner) in base.around(from) {
            let [right, left] = [1, 2].map(|i| base.triangles[t as usize][(corner + i) % 3]);
            ends.extend([right, left]);
            let behind = base.across[t as usize][corner];
            self.push(Cone { distance: 0.0, behind, right, left, low: right, high: left, is_full: [false; 2] });
        }
        ends.sort_unstable();
        ends.dedup();
        ends.sort_by(|&a, &b| self.way(a).length_sq().total_cmp(&self.way(b).length_sq()));
        self.seen.extend(ends.iter().map(|&v| self.lengths.way(from, v)));
        for to in ends {
            self.test(to, [false; 2]);
        }
    }

    fn way(&self, to: u32) -> Vector {
        self.lengths.way(self.from, to)
    }

    fn side(&self, of: u32, v: u32) -> Orientation {
        let at = |v: u32| self.base.points[v as usize];
        orient2d(at(self.from), at(of), at(v))
    }

    /// A cone to be looked into later, if there is anything behind its side.
    fn push(&mut self, mut cone: Cone) {
        if cone.behind != NONE {
            if self.may_test {
                cone.distance = self.distance_of_side(&cone).max(cone.distance);
            }
            self.open.push(cone);
        }
    }

    /// The vertex of the next triangle.
    fn look_behind(&mut self, cone: &Cone) {
        let &Cone { behind, right, left, .. } = cone;
        let corners = self.base.triangles[behind as usize];
        let at = corners.iter().position(|&v| v != right && v != left).unwrap_or(0);
        let next = corners[at];
        // The triangle is (next, left, right), counter-clockwise.
        let [beyond_right, beyond_left] = [1, 2].map(|i| self.base.across[behind as usize][(at + i) % 3]);
        let is_left_of_low = self.side(cone.low, next) == Orientation::CounterClockwise;
        let is_right_of_high = self.side(cone.high, next) == Orientation::Clockwise;
        let through_right = Cone { behind: beyond_right, left: next, ..*cone };
        let through_left = Cone { behind: beyond_left, right: next, ..*cone };
        match (is_left_of_low, is_right_of_high) {
            (true, true) => {
                self.seen.push(self.way(next));
                self.test(next, cone.is_full);
                self.push(Cone { high: next, ..through_right });
                self.push(Cone { low: next, ..through_left });
            }
            (_, false) => {
                self.note_beside(next, cone.is_full[0]);
                self.push(through_right);
            }
            (false, true) => {
                self.note_beside(next, cone.is_full[1]);
                self.push(through_left);
            }
        }
    }

    /// A vertex beside a cone, hidden perhaps, may be in triangles that were empty so far. Without it a narrow cone
    /// between others that ended would go on through all triangles; most vertices do not need it.
    fn note_beside(&mut self, v: u32, is_full: bool) {
        if self.may_test && !is_full && self.seen.len() >= MANY {
            self.seen.push(self.way(v));
        }
    }

    /// Keeps an edge that passes the diamond test, as far as is seen.
    fn test(&mut self, to: u32, mut is_full: [bool; 2]) {
        if self.may_test {
            let way = self.way(to);
            self.fill_both([way, way], &mut is_full);
        }
        if is_full != [true; 2] {
            self.found.push(to);
        }
    }

    /// Finds out on which sides no edge into the cone has an empty triangle.
    fn fill(&self, cone: &mut Cone) {
        if self.may_test && cone.distance > 0.0 {
            let shortest = |way: Vector| way.scaled(cone.distance / way.length_sq().sqrt());
            let ways = [shortest(self.way(cone.low)), shortest(self.way(cone.high))];
            self.fill_both(ways, &mut cone.is_full);
        }
    }

    /// Looks for a vertex that is in the left triangles on two edges, given as ways, and for one in the right
    /// triangles.
    fn fill_both(&self, [one, two]: [Vector; 2], is_full: &mut [bool; 2]) {
        let [mut is_left_full, mut is_right_full] = *is_full;
        let squares = [one.length_sq(), two.length_sq()];
        for &r in self.seen.iter().take(MOST) {
            let heights = [one.cross(r), two.cross(r)];
            let is_left = heights[0] > 0.0;
            if is_left != (heights[1] > 0.0) || (if is_left { is_left_full } else { is_right_full }) {
                continue;
            }
            let size = r.length_sq();
            if is_inside(heights[0].abs(), one.dot(r), squares[0], size)
                && is_inside(heights[1].abs(), two.dot(r), squares[1], size)
            {
                *(if is_left { &mut is_left_full } else { &mut is_right_full }) = true;
                if is_left_full && is_right_full {
                    break;
                }
            }
        }
        *is_full = [is_left_full, is_right_full];
    }

    /// A lower bound of the distance at which the cone meets its side.
    fn distance_of_side(&self, cone: &Cone) -> f64 {
        let (right, left) = (self.way(cone.right), self.way(cone.left));
        let (low, high) = (self.way(cone.low), self.way(cone.high));
        let side = left - right;
        let area = right.cross(left) - ROOM * (right.length_sq() + left.length_sq());
        let length = side.length_sq().sqrt();
        let along = |way: Vector| {
            let size = way.length_sq().sqrt();
            area / (way.cross(side) + ROOM * size * length) * size
        };
        let distance = if low.dot(side) > 0.0 {
            along(low)
        } else if high.dot(side) < 0.0 {
            along(high)
        } else {
            area / length
        };
        if distance > 0.0 && distance.is_finite() { distance * (1.0 - 1e-9) } else { 0.0 }
    }
}

/// Whether a point is surely inside a triangle on an edge: given its height above the edge times the length of the
/// edge, its place along the edge times that length, and the squared lengths of the edge and of the way to the point.
#[inline(always)]
fn is_inside(height: f64, along: f64, square: f64, size: f64) -> bool {
    let error = ROOM * (square + size);
    height > error && height + error < SLOPE * along.min(square - along)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;
    use crate::optimal::OptimalInput;
    use crate::trace::NoTrace;

    #[test]
    fn every_edge_of_a_convex_ring_is_seen_unless_hidden() {
        let points =
            [(0.0, 0.0), (2.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 2.0), (0.0, 4.0)].map(|(x, y)| Point::new(x, y));
        let base = Base::new(&OptimalInput::of_points(&points)).unwrap();
        let (lengths, far) = (Lengths::new(&points), vec![Point::new(1e300, 0.0); 2]);
        assert!(!Lengths::new(&[far, vec![Point::new(1e-300, 0.0)]].concat()).is_ordinary());
        let found = candidates(&base, &lengths, 100, &mut NoTrace).unwrap().unwrap();
        // 0-2 is hidden by 1, 0-3 and 2-5 by 4.
        let hidden = [[0, 2], [0, 3], [2, 5]];
        assert!(found.iter().all(|edge| !hidden.contains(edge)));
        assert!([[0, 1], [1, 2], [2, 3], [3, 5], [0, 5]].iter().all(|edge| found.contains(edge)), "{found:?}");
        assert_eq!(candidates(&base, &lengths, 3, &mut NoTrace), Ok(None));
    }
}
