//! `min-max-angle` and `max-min-height`: edge insertion by one walk from the anchor of the worst triangle.
//!
//! # Idea
//! The anchor q of the worst triangle T = q p r is its corner with the largest angle: as long as no edge from q enters
//! T, the angle at q stays as large, and the height from q as small. So every better triangulation has an edge from q
//! that crosses p r. The walk finds where it ends.
//!
//! ```text
//!          s                  The walk stands before the edge l m: every better triangulation has an edge from q that
//!        ╱   ╲                crosses it. Behind it is the corner s. If the polygon left of q s, along the chain
//!      ╱       ╲              q r … l s, cannot be triangulated well, no better triangulation has an edge from q that
//!    l ───────── m            ends at s or crosses l s: it would triangulate the polygon. So one crosses s m, and the
//!     ╲         ╱             walk goes on there; the chain on the left gets the corner s. The same holds on the right.
//!      r ───── p              If both polygons can be triangulated, q s is inserted.
//!        ╲ T ╱
//!          q
//! ```
//!
//! # Steps
//! 1. Begin with the triangles of the domain, or with the Delaunay triangulation.
//! 2. Take the worst triangle T and its anchor q. The walk begins before the side opposite q.
//! 3. If the edge before which it stands must stay, or nothing is behind: no triangulation is better. The value is
//!    known when this happens first. T stays, its edges are constrained from now on, and the rest is improved: go to 2.
//! 4. Try the corner s behind the edge: cut ears off the left and the right chain, one by one in turns. An ear must be
//!    convex and better than T. If a corner of one chain hides s from q, ears are cut off this chain only, until it is
//!    stuck.
//! 5. Where one of the chains is stuck first: s becomes a corner of it, the other chain takes its ears back, and the
//!    walk goes on on the other side of s.
//! 6. Where none is stuck: the ears replace the triangles that q s crosses. Go to 2, until all triangles stay.
//!
//! # Degenerate cases
//! Equal angles: only triangles that are strictly better replace T, so equally bad ones go one after the other. Corners
//! in line are no ears. Equal points: the first one is used. All points on one line: no triangle, and the value is 0.
//!
//! # Guarantees
//! Angles and heights are compared exactly, so the result is optimal for the points as they are given. If no two
//! possible triangles are equally bad, the second worst triangle is as good as it can be, too, and so on to the best
//! one: the descending list of costs is the smallest in lexicographic order. (At the hull of many points there is
//! nearly always a thin triangle that must be; that the others are good matters more.) Otherwise the result is one of
//! several optimal triangulations, depending on the order of the points.
//!
//! # Complexity
//! O(n² log n) time, O(n) memory. Every edge that a walk crosses is crossed by an edge of every better triangulation,
//! too, so it never comes back: the walks cross O(n²) edges in all. Taking turns, a walk cuts and takes back as many
//! ears as it crosses edges; log n is for finding the worst triangle. (Triangles that tie for the worst may let edges
//! come back until all of them are gone.)
//!
//! # Source
//! `[EdelsbrunnerTanWaupotitsch92]`; heights: `[BernEtAl93]`. The walk with two chains in turns is ours.

use super::cavity::Cavity;
use super::chain::{Chain, Hand, Progress};
use super::criteria::{Criterion, LargestAngle, SmallestHeight};
use super::improve;
use crate::geometry::largest_corner;
use crate::optimal::mesh::Mesh;
use crate::optimal::{Optimal, OptimalError, OptimalInput};
use crate::trace::{Shape, Trace};

/// A triangulation whose largest angle is as small as possible.
pub(in crate::optimal) fn min_max_angle(
    input: &OptimalInput<'_>,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Optimal, OptimalError> {
    improve(&LargestAngle(input.points), input, trace, walk)
}

/// A triangulation whose smallest height is as large as possible.
pub(in crate::optimal) fn max_min_height(
    input: &OptimalInput<'_>,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Optimal, OptimalError> {
    improve(&SmallestHeight(input.points), input, trace, walk)
}

/// Steps 3 to 6 for one triangle: the change that removes it, unless no triangulation is better.
fn walk<C: Criterion>(
    criterion: &C,
    mesh: &Mesh,
    (slot, bound): (u32, &C::Cost),
    trace: &mut (impl Trace + ?Sized),
) -> Option<Cavity> {
    let anchor = largest_corner(criterion.corners(mesh.triangles[slot as usize])) as u32;
    let mut before = Mesh::next(3 * slot + anchor);
    let (q, [p, r]) = (mesh.apex(before), mesh.ends(before));
    let [mut left, mut right] = [Chain::new(Hand::Left, q, r), Chain::new(Hand::Right, q, p)];
    let mut slots = vec![slot];
    loop {
        let behind = mesh.twin(before)?;
        let s = mesh.apex(behind);
        slots.push(behind / 3);
        trace.look(Shape::Edge([q, s]), "an edge from the anchor");
        let Some(stuck) = cut_in_turns(criterion, [&mut left, &mut right], s, bound) else {
            let triangles = [left.into_ears(), right.into_ears()].concat();
            return Some(Cavity { slots, triangles, edge: [q, s] });
        };
        trace.refuse(Shape::Edge([q, s]), "no good triangles beside it");
        // The triangle behind runs from l to m to s.
        before = match stuck {
            Hand::Left => {
                right.undo();
                left.push(criterion, s);
                Mesh::next(behind)
            }
            Hand::Right => {
                left.undo();
                right.push(criterion, s);
                Mesh::prev(behind)
            }
        };
    }
}

/// Step 4: cuts the chains before the end `s`; tells which of them is stuck first.
fn cut_in_turns<C: Criterion>(criterion: &C, [left, right]: [&mut Chain; 2], s: u32, bound: &C::Cost) -> Option<Hand> {
    for chain in [&mut *left, &mut *right] {
        if chain.hides(criterion, s) {
            while chain.cut(criterion, s, bound) == Progress::Cut {}
            return Some(chain.hand());
        }
    }
    loop {
        let on_left = left.cut(criterion, s, bound);
        if on_left == Progress::Stuck {
            return Some(Hand::Left);
        }
        let on_right = right.cut(criterion, s, bound);
        if on_right == Progress::Stuck {
            return Some(Hand::Right);
        }
        if [on_left, on_right] == [Progress::Done; 2] {
            return None;
        }
    }
}
