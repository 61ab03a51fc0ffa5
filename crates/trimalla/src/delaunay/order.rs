//! The order of insertion: along a space-filling curve, by rounds.
//!
//! 1. Points are quantised to 2¹⁶ × 2¹⁶ cells and sorted by their place on a Hilbert curve, with a
//!    radix sort; crowded cells are sorted again by a finer curve of their own.
//! 2. A biased randomised insertion order (BRIO) takes a sixteenth of the points first, then a
//!    sixteenth of the rest is held for the round after, and so on: each round runs along the curve.
//!    The coin is a hash of the position, so the order is a function of the input alone.
//!
//! # Source
//! `[AmentaChoiRote03]` for the rounds; Hilbert's curve for the order within.

use crate::geometry::{BoundingBox, Point, hilbert_key_16};

/// A cell with more points than this is sorted again by its own finer curve.
const CROWDED: usize = 16;
/// Each earlier round holds one point in 2⁴.
const ROUND_SHIFT: u32 = 4;
/// Below this many points rounds cost more than they save.
const ROUNDS_FROM: usize = 2000;
/// More rounds than any array of 32-bit indices can need.
const MAX_ROUND: u32 = 7;

/// Positions 0..n in the order of a Hilbert curve.
///
/// # Complexity
/// Linear, but for crowded cells: those take one more linear pass for each 2¹⁶-fold refinement.
pub(crate) fn along_curve(points: &[Point]) -> Vec<u32> {
    let mut keyed = sort_by_key(keys(points, 0..points.len()));
    refine_crowded_cells(points, &mut keyed);
    keyed.into_iter().map(low).collect()
}

/// The positions of `0..n` in insertion order: round after round, each along the storage.
pub(crate) fn rounds(n: usize) -> Vec<u32> {
    #[allow(clippy::cast_possible_truncation, reason = "bounded by the number of vertex ids")]
    let all = 0..n as u32;
    if n < ROUNDS_FROM {
        return all.collect();
    }
    let mut size = [0usize; MAX_ROUND as usize + 1];
    for i in all.clone() {
        size[round_of(i) as usize] += 1;
    }
    let mut next = [0usize; MAX_ROUND as usize + 1];
    let mut start = 0;
    for r in (0..size.len()).rev() {
        next[r] = start;
        start += size[r];
    }
    let firsts = next;
    let mut order = vec![0; n];
    for i in all {
        let r = round_of(i) as usize;
        order[next[r]] = i;
        next[r] += 1;
    }
    // Every other round runs backwards: the last point of one is near the first of the next.
    for r in (1..size.len()).step_by(2) {
        order[firsts[r]..firsts[r] + size[r]].reverse();
    }
    order
}

/// The round that a position is held back for: a hash's trailing zeros, four to a round.
#[inline]
fn round_of(i: u32) -> u32 {
    let mut h = i.wrapping_mul(0x9e37_79b1);
    h ^= h >> 15;
    h = h.wrapping_mul(0x85eb_ca77);
    h ^= h >> 13;
    (h.trailing_zeros() / ROUND_SHIFT).min(MAX_ROUND)
}

/// Curve key in the high half, position in the low half.
fn keys(points: &[Point], positions: impl ExactSizeIterator<Item = usize> + Clone) -> Vec<u64> {
    let cells = CurveCells::around(BoundingBox::of(positions.clone().map(|i| points[i])));
    positions.map(|i| u64::from(cells.key(points[i])) << 32 | i as u64).collect()
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

/// Radix sort by the high half, stable: three passes of eleven bits.
fn sort_by_key(mut a: Vec<u64>) -> Vec<u64> {
    const BITS: u32 = 11;
    const SIZE: usize = 1 << BITS;
    if a.len() < 256 {
        a.sort_unstable();
        return a;
    }
    let digit = |k: u64, pass: usize| (k >> (32 + BITS * pass as u32)) as usize & (SIZE - 1);
    let mut counts = vec![[0u32; SIZE]; 3];
    for &k in &a {
        for (pass, count) in counts.iter_mut().enumerate() {
            count[digit(k, pass)] += 1;
        }
    }
    let mut b = vec![0u64; a.len()];
    for (pass, count) in counts.iter_mut().enumerate() {
        let mut start = 0;
        for c in count.iter_mut() {
            start += std::mem::replace(c, start);
        }
        for &k in &a {
            let slot = &mut count[digit(k, pass)];
            b[*slot as usize] = k;
            *slot += 1;
        }
        std::mem::swap(&mut a, &mut b);
    }
    a
}

/// Sorts every crowded cell by a curve over its own points, and so on for its crowded cells.
fn refine_crowded_cells(points: &[Point], keyed: &mut [u64]) {
    let mut work: Vec<(usize, usize)> = vec![(0, keyed.len())];
    while let Some((start, end)) = work.pop() {
        let mut i = start;
        while i < end {
            let key = keyed[i] >> 32;
            let run = keyed[i..end].iter().take_while(|&&k| k >> 32 == key).count();
            if run > CROWDED && run < end - start {
                let cell = &mut keyed[i..i + run];
                let finer =
                    sort_by_key(keys(points, cell.iter().map(|&k| low(k) as usize).collect::<Vec<_>>().into_iter()));
                cell.copy_from_slice(&finer);
                work.push((i, i + run));
            }
            i += run;
        }
    }
}

#[allow(clippy::cast_possible_truncation, reason = "the low half is the position")]
fn low(k: u64) -> u32 {
    k as u32
}
