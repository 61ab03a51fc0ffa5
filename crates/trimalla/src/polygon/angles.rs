//! The boundary of the inside of a polygon as closed walks, and angles around a vertex.

use std::cmp::Ordering;

use super::TrapezoidMap;
use crate::geometry::{Orientation, Point, lexicographic, orient2d};

/// The walks round the inside of a polygon: edges have the inside on their left, and at each vertex a walk goes on
/// along the next edge clockwise, so that nothing but inside is between two edges that follow each other.
///
/// Rings that only touch are joined so, or parted: a part of the inside that is connected and has no holes is bounded
/// by one walk. A vertex may be in a walk several times.
pub(super) fn walks(map: &TrapezoidMap<'_>, points: &[Point]) -> Vec<Vec<u32>> {
    let mut edges: Vec<[u32; 2]> = map.boundary().iter().flat_map(|ring| steps(ring)).collect();
    edges.sort_unstable();
    let leaving = |vertex: u32| {
        let first = edges.partition_point(|edge| edge[0] < vertex);
        first..edges.partition_point(|edge| edge[0] <= vertex)
    };
    let next = |[from, at]: [u32; 2]| {
        let point = |i: usize| points[edges[i][1] as usize];
        let order = |&i: &usize, &j: &usize| clockwise(points[at as usize], points[from as usize], point(i), point(j));
        leaving(at).min_by(order)
    };
    let mut is_done = vec![false; edges.len()];
    let mut walks = Vec::new();
    for first in 0..edges.len() {
        let mut walk = Vec::new();
        let mut at = Some(first);
        while let Some(edge) = at.filter(|&i| !is_done[i]) {
            is_done[edge] = true;
            walk.push(edges[edge][0]);
            at = next(edges[edge]);
        }
        if !walk.is_empty() {
            walks.push(walk);
        }
    }
    walks
}

/// The edges of a closed walk.
pub(super) fn steps(walk: &[u32]) -> impl Iterator<Item = [u32; 2]> + '_ {
    let next = move |i: usize| walk[if i + 1 == walk.len() { 0 } else { i + 1 }];
    walk.iter().enumerate().map(move |(i, &v)| [v, next(i)])
}

/// Which of `a` and `b` comes first when the ray from `center` through `from` is turned clockwise. `from` itself comes
/// last. Exact.
pub(super) fn clockwise(center: Point, from: Point, a: Point, b: Point) -> Ordering {
    let half = |p: Point| match orient2d(center, from, p) {
        Orientation::Clockwise => 0,
        Orientation::Collinear if lexicographic(p, center) != lexicographic(from, center) => 1,
        Orientation::CounterClockwise => 2,
        Orientation::Collinear => 3,
    };
    half(a).cmp(&half(b)).then_with(|| match orient2d(center, a, b) {
        Orientation::Clockwise => Ordering::Less,
        Orientation::Collinear => Ordering::Equal,
        Orientation::CounterClockwise => Ordering::Greater,
    })
}

/// Tells whether `p` is strictly inside of the angle at `center` from the ray through `from` counter-clockwise to the
/// ray through `to`; if both are one ray, everything beside it is. Exact.
pub(super) fn is_in_angle(center: Point, from: Point, to: Point, p: Point) -> bool {
    clockwise(center, to, p, from) == Ordering::Less
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_ordered_clockwise() {
        let around =
            [(1.0, 2.0), (2.0, 2.0), (3.0, 0.0), (2.0, -2.0), (0.0, -1.0), (-2.0, -2.0), (-1.0, 0.0), (-1.0, 1.0)];
        let points: Vec<Point> = around.iter().map(|&(x, y)| Point::new(x, y)).collect();
        let center = Point::new(0.0, 0.0);
        for from in 0..8 {
            let turned = |k: usize| points[(from + k) % 8];
            for (i, j) in (1..=8).flat_map(|i| (1..=8).map(move |j| (i, j))) {
                assert_eq!(clockwise(center, points[from], turned(i), turned(j)), i.cmp(&j));
                let is_between = is_in_angle(center, turned(j), points[from], turned(i));
                assert_eq!(is_between, i < j, "{from} {i} {j}");
            }
        }
    }
}
