//! The order of insertion: along a space-filling curve, by rounds.
//!
//! 1. Points are quantised to 2¹⁶ × 2¹⁶ cells and sorted by their place on a Hilbert curve, with a
//!    radix sort; crowded cells are sorted again by a finer curve of their own. Of heavy-tailed sets the cells cover
//!    the core, and the points outside of it are one more crowded cell ([`super::curve_cells`]).
//! 2. A biased randomised insertion order (BRIO): of every sixteen neighbours on the curve one is drawn, of
//!    every sixteen of those one, and so on. Rounds begin with the fewest; each runs along the curve.
//!    Draws are hashes of positions, so the order is a function of the input alone.
//!
//! *Departure from the source:* a coin for each point would leave gaps and crowds in a round; one of sixteen
//! neighbours does not, and the order need not be stored.
//!
//! # Source
//! `[AmentaChoiRote03]` for the rounds; Hilbert's curve for the order within.

use std::ops::Range;

use super::curve_cells::CoreCells;
use super::radix_sort::{Keyed, sort_by_key};
use crate::geometry::Point;
use crate::half_edge::VertexId;

/// A cell with more points than this is sorted again by its own finer curve.
const CROWDED: usize = 16;
/// Each earlier round holds one point in 2⁴.
const ROUND_SHIFT: u32 = 4;
/// Below this many points rounds cost more than they save.
const ROUNDS_FROM: usize = 2000;

/// Points sorted along a Hilbert curve.
pub(super) struct Curve {
    /// The sorted entries, followed by scratch of the same length.
    keyed: Vec<Keyed>,
}

impl Curve {
    /// The positions of the points, in order.
    pub(super) fn positions(&self) -> impl Iterator<Item = u32> {
        self.keyed[..self.keyed.len() / 2].iter().map(|k| k.position)
    }

    /// Gives the allocation away for reuse.
    pub(super) fn into_memory(self) -> Vec<Keyed> {
        self.keyed
    }
}

/// Points in the order of a Hilbert curve, named by their positions.
///
/// # Complexity
/// Linear, except for crowded cells: they take another linear pass for each 2¹⁶-fold refinement, and the points outside
/// of a core, at most a quarter of all, one for each core.
pub(crate) fn along_curve(points: &[Point]) -> Vec<VertexId> {
    sorted_along_curve(points).positions().map(VertexId).collect()
}

/// [`along_curve`] with the scratch of the sort, which the caller may reuse.
pub(super) fn sorted_along_curve(points: &[Point]) -> Curve {
    let mut keyed = Vec::with_capacity(2 * points.len());
    keyed.extend(keys(points));
    keyed.resize(2 * points.len(), Keyed::default());
    let (sorted, spare) = keyed.split_at_mut(points.len());
    sort_by_key(sorted, spare);
    refine_crowded_cells(points, sorted, spare);
    Curve { keyed }
}

/// Positions 0..n in the order in which a triangulation takes them.
///
/// # Complexity
/// That of [`along_curve`].
pub(crate) fn insertion_order(points: &[Point]) -> impl Iterator<Item = u32> {
    let along = along_curve(points);
    rounds(points.len()).map(move |i| along[i as usize].0)
}

/// The positions of `0..n` in insertion order: round after round, each along the storage, every other one backwards, so
/// that the last point of one is near the first of the next.
pub(super) fn rounds(n: usize) -> impl Iterator<Item = u32> {
    #[allow(clippy::cast_possible_truncation, reason = "bounded by the number of vertex ids")]
    let n = n as u32;
    let first = if (n as usize) < ROUNDS_FROM { 0 } else { n.ilog2() / ROUND_SHIFT };
    (0..=first).rev().flat_map(move |round| {
        let blocks = n.div_ceil(1 << (ROUND_SHIFT * round));
        let along = (0..blocks).map(move |i| if round % 2 == 0 { i } else { blocks - 1 - i });
        let new = along.filter(move |&block| round == first || block != chosen_child(block >> ROUND_SHIFT, round + 1));
        new.map(move |block| representative(block, round)).filter(move |&position| position < n)
    })
}

/// The position that stands for a block of 16^`round` positions: that of the block's chosen sixteenth.
#[inline]
fn representative(block: u32, round: u32) -> u32 {
    (1..=round).rev().fold(block, chosen_child)
}

/// Which sixteenth of a block is inserted with the block; a hash draws it.
#[inline]
fn chosen_child(block: u32, round: u32) -> u32 {
    let mut h = (block ^ round << 28).wrapping_mul(0x9e37_79b1);
    h ^= h >> 15;
    h = h.wrapping_mul(0x85eb_ca77);
    block << ROUND_SHIFT | h >> (32 - ROUND_SHIFT)
}

/// The positions of all points with their keys.
#[allow(clippy::cast_possible_truncation, reason = "bounded by the number of vertex ids")]
fn keys(points: &[Point]) -> impl Iterator<Item = Keyed> {
    let cells = CoreCells::over(points.len(), |i| points[i]);
    points.iter().enumerate().map(move |(i, &p)| Keyed { key: cells.key(p), position: i as u32 })
}

/// Sorts every crowded cell by a curve over its own points, and so on for its crowded cells.
fn refine_crowded_cells(points: &[Point], keyed: &mut [Keyed], spare: &mut [Keyed]) {
    let mut work: Vec<Range<usize>> = std::iter::once(0..keyed.len()).collect();
    while let Some(mut part) = work.pop() {
        let all = part.len();
        while let Some(cell) = first_crowded_cell(keyed, part.clone()) {
            if cell.len() < all {
                sort_cell(points, &mut keyed[cell.clone()], &mut spare[cell.clone()]);
                work.push(cell.clone());
            }
            part.start = cell.end;
        }
    }
}

/// The first crowded cell in a part of the sorted positions.
fn first_crowded_cell(keyed: &[Keyed], part: Range<usize>) -> Option<Range<usize>> {
    let rest = &keyed[part.clone()];
    let first = rest.windows(CROWDED + 1).position(|w| w[0].key == w[CROWDED].key)?;
    let count = rest[first..].partition_point(|k| k.key == rest[first].key);
    let start = part.start + first;
    Some(start..start + count)
}

/// Sorts the points of one cell by a curve of their own.
fn sort_cell(points: &[Point], cell: &mut [Keyed], spare: &mut [Keyed]) {
    let cells = CoreCells::over(cell.len(), |i| points[cell[i].position as usize]);
    for k in cell.iter_mut() {
        k.key = cells.key(points[k.position as usize]);
    }
    sort_by_key(cell, spare);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers from 0 to 1.
    fn spread(n: usize) -> impl Iterator<Item = f64> {
        (1..=n as u64).map(|i| (i.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 11) as f64 / (1_u64 << 53) as f64)
    }

    /// Points in all directions, at distances that a function makes of numbers from 0 to 1.
    fn around_origin(n: usize, distance: impl Fn(f64) -> f64) -> Vec<Point> {
        let at = |(i, u): (usize, f64)| {
            let t = (i % 101) as f64 / 50.0 - 1.0;
            let (cos, sin) = ((1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t));
            let r = if i % 2 == 0 { distance(u) } else { -distance(u) };
            Point::new(r * cos, r * sin)
        };
        spread(n).enumerate().map(at).collect()
    }

    fn assert_orders_all(points: &[Point]) {
        let mut order = along_curve(points);
        order.sort_unstable();
        assert!(order.into_iter().eq((0..points.len()).map(VertexId::from_index)));
    }

    #[test]
    fn a_heavy_tailed_set_has_few_crowded_cells() {
        // A Kuzmin disc: half of it within 2 of the middle, the outermost at 100 000.
        let points = around_origin(100_000, |u| (1.0 / (u * u) - 1.0).sqrt());
        assert_orders_all(&points);
        let mut keyed: Vec<Keyed> = keys(&points).collect();
        keyed.sort_by_key(|k| k.key);
        let crowded: Vec<usize> =
            keyed.chunk_by(|a, b| a.key == b.key).map(<[_]>::len).filter(|&n| n > CROWDED).collect();
        assert!(crowded.len() == 1 && crowded[0] < points.len() / 4, "{crowded:?}");
    }

    #[test]
    fn hostile_sets_are_ordered_as_well() {
        const N: usize = 10_000;
        assert_orders_all(&around_origin(N, |u| 2_f64.powi((2000.0 * u) as i32 - 1000)));
        assert_orders_all(&around_origin(N, |u| f64::MAX * u));
        assert_orders_all(&around_origin(N, |u| 1e-320 * u));
        assert_orders_all(&around_origin(N, |u| if u < 0.1 { f64::MAX } else { 5e-324 }));
        assert_orders_all(&around_origin(N, |u| if u < 0.1 { 1.0 } else { 0.0 }));
        assert_orders_all(&vec![Point::new(1.0, -1.0); N]);
        // Each sample sees one place only, as far as it can be told in advance.
        let rare = |i: usize| if i % (N / 1024) == 0 { Point::default() } else { Point::new(i as f64, 1.0) };
        assert_orders_all(&(0..N).map(rare).collect::<Vec<_>>());
        // One more point at each power of two, the others at the origin.
        let powers =
            |i: usize| if i % 5 == 0 { Point::new(2_f64.powi(i as i32 / 5 - 1000), 0.0) } else { Point::default() };
        assert_orders_all(&(0..N).map(powers).collect::<Vec<_>>());
    }

    #[test]
    fn rounds_meet_every_position_once() {
        for n in [0, 1, 15, 16, 17, 1999, 2000, 2001, 4095, 4096, 5000, 70_000] {
            let mut order: Vec<u32> = rounds(n).collect();
            assert_eq!(order.len(), n);
            order.sort_unstable();
            assert!(order.into_iter().eq(0..n as u32));
        }
    }

    #[test]
    fn a_sixteenth_of_each_round_comes_before_it() {
        let order: Vec<u32> = rounds(1 << 16).collect();
        for round in [1, 2, 3] {
            let mut earlier: Vec<u32> = order[..1 << (16 - 4 * round)].iter().map(|i| i >> (4 * round)).collect();
            earlier.sort_unstable();
            assert!(earlier.into_iter().eq(0..1 << (16 - 4 * round)), "one of each block");
        }
    }
}
