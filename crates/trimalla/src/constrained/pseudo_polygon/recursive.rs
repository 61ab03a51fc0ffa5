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

use super::{Across, Filled, is_ccw, is_inside};
use crate::geometry::Point;

/// A base and where its triangle is to be linked.
struct Task {
    first: u32,
    last: u32,
    /// The side of an earlier triangle that this base is.
    parent: Across,
}

/// See [`super::fill`].
pub(super) fn fill(points: &[Point]) -> Option<Vec<Filled>> {
    let n = u32::try_from(points.len()).ok().filter(|&n| n >= 3)?;
    let mut filled: Vec<Filled> = Vec::with_capacity(points.len() - 2);
    let mut tasks = vec![Task { first: 0, last: n - 1, parent: Across::Base }];
    while let Some(Task { first, last, parent }) = tasks.pop() {
        let corner = best_corner(points, first, last)?;
        let this = u32::try_from(filled.len()).ok()?;
        if let Across::Triangle(t, s) = parent {
            filled[t as usize].across[s as usize] = Across::Triangle(this, 0);
        }
        // Counter-clockwise first → last → corner; the side last → corner is the base of corner..last.
        let mut across = [parent, Across::Rim(corner), Across::Rim(first)];
        if corner + 1 < last {
            across[1] = Across::Triangle(this, 1); // overwritten by the child
            tasks.push(Task { first: corner, last, parent: Across::Triangle(this, 1) });
        }
        if first + 1 < corner {
            across[2] = Across::Triangle(this, 2);
            tasks.push(Task { first, last: corner, parent: Across::Triangle(this, 2) });
        }
        filled.push(Filled { vertices: [first, last, corner], across });
    }
    Some(filled)
}

/// Of the vertices strictly between and left of the base, the one whose circle holds none of the others.
fn best_corner(points: &[Point], first: u32, last: u32) -> Option<u32> {
    let mut best: Option<u32> = None;
    for v in first + 1..last {
        if !is_ccw(points, [first, last, v]) {
            continue;
        }
        if best.is_none_or(|b| is_inside(points, [first, last, b], v)) {
            best = Some(v);
        }
    }
    best
}
