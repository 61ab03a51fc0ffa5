//! The order of insertion: along a space-filling curve, by rounds.
//!
//! 1. Points are quantised to 2¹⁶ × 2¹⁶ cells and sorted by their place on a Hilbert curve, with a
//!    radix sort; crowded cells are sorted again by a finer curve of their own.
//! 2. A biased randomised insertion order (BRIO): of every sixteen neighbours on the curve one is drawn, of
//!    every sixteen of those one, and so on. Rounds begin with the fewest; each runs along the curve.
//!    Draws are hashes of positions, so the order is a function of the input alone.
//!
//! *Departure from the source:* a coin for each point would leave gaps and crowds in a round; one of sixteen
//! neighbours does not, and the order need not be stored.
//!
//! # Source
//! `[AmentaChoiRote03]` for the rounds; Hilbert's curve for the order within.

use super::radix_sort::{Keyed, sort_by_key};
use crate::geometry::{BoundingBox, Point, hilbert_key_16};
use crate::mesh::VertexId;

/// A cell with more points than this is sorted again by its own finer curve.
const CROWDED: usize = 16;
/// Each earlier round holds one point in 2⁴.
const ROUND_SHIFT: u32 = 4;
/// Below this many points rounds cost more than they save.
const ROUNDS_FROM: usize = 2000;

/// Points in the order of a Hilbert curve, named by their positions.
///
/// # Complexity
/// Linear, but for crowded cells: those take one more linear pass for each 2¹⁶-fold refinement.
pub(crate) fn along_curve(points: &[Point]) -> Vec<VertexId> {
    keyed_along_curve(points).0.into_iter().map(|k| VertexId(k.position)).collect()
}

/// [`along_curve`] with the keys, and memory that the sort has no more use for.
pub(super) fn keyed_along_curve(points: &[Point]) -> (Vec<Keyed>, Vec<Keyed>) {
    let mut keyed = keys(points, 0..points.len());
    let mut spare = vec![Keyed::default(); keyed.len()];
    sort_by_key(&mut keyed, &mut spare);
    refine_crowded_cells(points, &mut keyed);
    (keyed, spare)
}

/// Positions 0..n in the order in which a triangulation takes them.
///
/// # Complexity
/// That of [`along_curve`].
pub(crate) fn insertion_order(points: &[Point]) -> impl Iterator<Item = u32> {
    let along = along_curve(points);
    rounds(points.len()).map(move |i| along[i as usize].0)
}

/// The positions of `0..n` in insertion order: round after round, each along the storage, every other one backwards, so that
/// the last point of one is near the first of the next.
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

/// The sixteenth of a block that is inserted with it; a hash draws it.
#[inline]
fn chosen_child(block: u32, round: u32) -> u32 {
    let mut h = (block ^ round << 28).wrapping_mul(0x9e37_79b1);
    h ^= h >> 15;
    h = h.wrapping_mul(0x85eb_ca77);
    block << ROUND_SHIFT | h >> (32 - ROUND_SHIFT)
}

/// Points of the given positions with their keys.
#[allow(clippy::cast_possible_truncation, reason = "bounded by the number of vertex ids")]
fn keys(points: &[Point], positions: impl ExactSizeIterator<Item = usize> + Clone) -> Vec<Keyed> {
    let cells = CurveCells::around(BoundingBox::of(positions.clone().map(|i| points[i])));
    positions.map(|i| Keyed { key: cells.key(points[i]), position: i as u32 }).collect()
}

/// A grid of 2¹⁶ × 2¹⁶ cells over a box.
#[derive(Clone, Debug)]
pub(crate) struct CurveCells {
    min: Point,
    /// Cells a unit; coordinates are halved before subtraction so that nothing overflows.
    scale: f64,
}

impl CurveCells {
    pub(crate) fn around(bounds: Option<BoundingBox>) -> Self {
        let Some(bounds) = bounds else { return Self { min: Point::default(), scale: 0.0 } };
        let scale = 65535.0 / bounds.half_width().max(bounds.half_height());
        Self { min: bounds.min, scale: if scale.is_finite() { scale } else { 0.0 } }
    }

    #[inline]
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the cast saturates, and the cell is an order only"
    )]
    pub(crate) fn key(&self, p: Point) -> u32 {
        let cell = |c: f64, min: f64| ((c * 0.5 - min * 0.5) * self.scale) as u16;
        hilbert_key_16(cell(p.x, self.min.x), cell(p.y, self.min.y))
    }
}

/// Sorts every crowded cell by a curve over its own points, and so on for its crowded cells.
fn refine_crowded_cells(points: &[Point], keyed: &mut [Keyed]) {
    let mut work: Vec<(usize, usize)> = vec![(0, keyed.len())];
    while let Some((start, end)) = work.pop() {
        let mut i = start;
        while i < end {
            let key = keyed[i].key;
            let run = keyed[i..end].iter().take_while(|k| k.key == key).count();
            if run > CROWDED && run < end - start {
                let cell = &mut keyed[i..i + run];
                let positions: Vec<usize> = cell.iter().map(|k| k.position as usize).collect();
                let mut finer = keys(points, positions.into_iter());
                sort_by_key(&mut finer, &mut vec![Keyed::default(); run]);
                cell.copy_from_slice(&finer);
                work.push((i, i + run));
            }
            i += run;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
