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

use super::{Border, Edges};
use crate::mesh::Patch;

/// A stretch of the border between two vertices, with the edge between them for its base.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    first: u32,
    last: u32,
    /// The side of an earlier triangle along the base, if any.
    parent: u32,
}

/// The stack.
#[derive(Clone, Debug, Default)]
pub(super) struct Room(Vec<Stretch>);

/// See [`super::Filler::fill`].
pub(super) fn fill(border: Border<'_>, patch: &mut Patch, room: &mut Room) -> Option<Edges> {
    let n = border.len()?;
    patch.corners.clear();
    patch.across.clear();
    patch.rim.clear();
    patch.rim.resize(n as usize - 1, Patch::BORDER);
    patch.base = 0;
    room.0.clear();
    room.0.push(Stretch { first: 0, last: n - 1, parent: Patch::BORDER });
    while let Some(Stretch { first, last, parent }) = room.0.pop() {
        let corner = best_corner(border, first, last)?;
        // Counter-clockwise first → last → corner; the other two sides are rims or bases of stretches.
        let base = patch.corners.len() as u32;
        patch.corners.extend([first, last, corner]);
        patch.across.extend([parent, Patch::BORDER, Patch::BORDER]);
        if parent != Patch::BORDER {
            patch.across[parent as usize] = base;
        }
        for (first, last, side) in [(corner, last, base + 1), (first, corner, base + 2)] {
            if first + 1 == last {
                patch.rim[first as usize] = side;
            } else {
                room.0.push(Stretch { first, last, parent: side });
            }
        }
    }
    Some(Edges::Legal)
}

/// Of the vertices strictly between and left of the base, the one whose circle holds none of the others.
fn best_corner(border: Border<'_>, first: u32, last: u32) -> Option<u32> {
    let mut best: Option<u32> = None;
    for v in first + 1..last {
        let is_better = best.is_none_or(|b| border.is_inside([first, last, b], v));
        if is_better && border.is_ccw([first, last, v]) {
            best = Some(v);
        }
    }
    best
}
