//! Pairs of vertices that are near each other, by a grid of cells.

use std::collections::BTreeMap;

use super::graph::Graph;
use crate::geometry::Point;

/// A vertex is compared with so many of a neighbouring cell. All vertices of one cell are near each other.
const COMPARED: usize = 8;

/// Two vertices at different places, nearer than the tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct NearPair {
    /// The lower vertex first.
    pub(super) vertices: [u32; 2],
    pub(super) distance: f64,
}

/// The pairs, ascending. Of three vertices or more that are all near each other within half of the tolerance, each is
/// paired with the lowest alone.
///
/// # Complexity
/// n log n.
pub(super) fn near_pairs(graph: &Graph<'_>, tolerance: f64) -> Vec<NearPair> {
    // Two points in a cell are nearer than the tolerance.
    let side = tolerance / 2.0;
    let cell = |p: Point| [(p.x / side).floor() as i64, (p.y / side).floor() as i64];
    let mut cells: BTreeMap<[i64; 2], Vec<u32>> = BTreeMap::new();
    for v in graph.places() {
        cells.entry(cell(graph.point(v))).or_default().push(v);
    }
    let mut pairs = Vec::new();
    let mut add = |a: u32, b: u32| {
        let distance = distance(graph.point(a), graph.point(b));
        if distance <= tolerance {
            pairs.push(NearPair { vertices: [a.min(b), a.max(b)], distance });
        }
    };
    for (&[x, y], members) in &cells {
        members[1..].iter().for_each(|&v| add(members[0], v));
        for [dx, dy] in BEFORE {
            let Some(others) = cells.get(&[x.saturating_add(dx), y.saturating_add(dy)]) else { continue };
            for &v in members.iter().take(COMPARED) {
                others.iter().take(COMPARED).for_each(|&w| add(v, w));
            }
        }
    }
    pairs.sort_unstable_by_key(|pair| pair.vertices);
    pairs.dedup_by_key(|pair| pair.vertices);
    pairs
}

/// The twelve cells around one, out of those up to two away, that come before it: points further away are further
/// than the tolerance.
const BEFORE: [[i64; 2]; 12] =
    [[-2, -2], [-2, -1], [-2, 0], [-2, 1], [-2, 2], [-1, -2], [-1, -1], [-1, 0], [-1, 1], [-1, 2], [0, -2], [0, -1]];

/// The distance of two points.
pub(super) fn distance(a: Point, b: Point) -> f64 {
    crate::geometry::Segment::new(a, b).length()
}
