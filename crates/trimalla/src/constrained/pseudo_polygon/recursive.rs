//! Vigo's recursion.
//!
//! The base needs a third corner: the vertex whose circle with the base holds no other. It parts the
//! region in two, each with one side of the triangle for its base.
//!
//! # Complexity
//! Quadratic at worst. The recursion is a stack of its own, so long chains overflow nothing.
//!
//! # Source
//! `[Vigo97]`, `TriangulatePseudopolygonDelaunay`; corners that are not left of the base are passed over
//! here, which the paper leaves to the in-circle test.

use super::{Boundary, Edges, is_inside};
use crate::geometry::ccw;
use crate::half_edge::{Patch, Side, Triangle};

/// A stretch of the boundary between two vertices, with the edge between them for its base.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    first: u32,
    last: u32,
    /// The side of an earlier triangle along the base, if any.
    parent: Side,
}

/// The stack.
#[derive(Clone, Debug, Default)]
pub(super) struct Room(Vec<Stretch>);

/// Watches the recursion. What `()` does compiles to nothing.
pub(crate) trait Watch {
    /// A vertex has become the best corner of a base so far.
    fn improved(&mut self, vertex: u32);

    /// The stretch from `first` to `last` has got its corner, the best of those that were told since the last call.
    fn chosen(&mut self, first: u32, last: u32, corner: u32);
}

impl Watch for () {
    #[inline(always)]
    fn improved(&mut self, _: u32) {}

    #[inline(always)]
    fn chosen(&mut self, _: u32, _: u32, _: u32) {}
}

/// See [`super::Filler::fill`].
pub(super) fn fill(
    boundary: Boundary<'_>,
    patch: &mut Patch,
    room: &mut Room,
    watch: &mut impl Watch,
) -> Option<Edges> {
    let n = boundary.len()?;
    patch.start(boundary.0.len());
    patch.base = Side::new(0, 0);
    room.0.clear();
    let mut next = Some(Stretch { first: 0, last: n - 1, parent: Side::BOUNDARY });
    while let Some(Stretch { first, last, parent }) = next.take().or_else(|| room.0.pop()) {
        let corner = best_corner(boundary, first, last, watch)?;
        watch.chosen(first, last, corner);
        // Counter-clockwise first → last → corner; the other two sides are rims or bases of stretches.
        let this = patch.triangles.len() as u32;
        patch
            .triangles
            .push(Triangle { corners: [first, last, corner], across: [parent, Side::BOUNDARY, Side::BOUNDARY] });
        if parent != Side::BOUNDARY {
            patch.set_across(parent, Side::new(this, 0));
        }
        for (first, last, side) in [(corner, last, Side::new(this, 1)), (first, corner, Side::new(this, 2))] {
            if first + 1 == last {
                patch.rim[first as usize] = side;
            } else if let Some(waiting) = next.replace(Stretch { first, last, parent: side }) {
                room.0.push(waiting);
            }
        }
    }
    Some(Edges::Legal)
}

/// Of the vertices strictly between and left of the base, the one whose circle holds none of the others.
fn best_corner(boundary: Boundary<'_>, first: u32, last: u32, watch: &mut impl Watch) -> Option<u32> {
    let [a, b] = boundary.at([first, last]);
    let mut best = None;
    for (v, &p) in (first + 1..).zip(&boundary.0[first as usize + 1..last as usize]) {
        let is_better = best.is_none_or(|(_, c)| is_inside([a, b, c], p));
        if is_better && ccw(a, b, p) {
            best = Some((v, p));
            watch.improved(v);
        }
    }
    best.map(|(v, _)| v)
}
