//! Step 3: the lightest triangulation of a face with one walk, by dynamic programming over its diagonals.
//!
//! The corners have numbers along the walk. The part of the face between the diagonal of corners `i` and `j` and the
//! walk from `i` to `j` is triangulated by the triangle `i k j` and the parts beyond its other two sides:
//!
//! ```text
//!        j ─── …                weight(i, j) = |i j| + the least weight(i, k) + weight(k, j),
//!      ╱ │ ╲                    i < k < j, where i k and k j are sides of the walk, which weigh nothing,
//!    …   │   k                  or possible diagonals in these corners
//!      ╲ │ ╱
//!        i ─── …
//! ```
//!
//! Shorter stretches of the walk come first; each corner lists the pairs above and below it that are done, in order,
//! and `k` runs through what the lists of `i` and `j` share. Weights are rounded, with bounds; where these do not
//! decide, the edges of both parts are compared exactly.

use std::cmp::Ordering;

use super::walks::{Corner, Plane};
use super::weight::Weight;
use crate::geometry::{Orientation, orient2d};
use crate::trace::Trace;

/// Why a face is not triangulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stop {
    OutOfBudget,
    Cancelled,
}

/// What may still be spent, and what is known about the result.
#[derive(Clone, Copy, Debug)]
pub(super) struct Work {
    /// The steps that are left.
    pub(super) steps: u64,
    /// Whether every comparison was decided.
    pub(super) is_sure: bool,
}

impl Work {
    pub(super) fn spend(&mut self, steps: u64) -> Result<(), Stop> {
        self.steps = self.steps.checked_sub(steps).ok_or(Stop::OutOfBudget)?;
        Ok(())
    }
}

/// A triangulation of a face.
#[derive(Clone, Debug)]
pub(super) struct Part {
    pub(super) triangles: Vec<[u32; 3]>,
    /// The edges inside that count.
    pub(super) edges: Vec<[u32; 2]>,
    /// Their weight.
    pub(super) weight: Weight,
}

/// Whether one set of edges is lighter than another, whose weights are given.
pub(super) fn is_lighter(
    plane: &Plane<'_>,
    [new, old]: [Weight; 2],
    edges: impl FnOnce() -> [Vec<[u32; 2]>; 2],
    work: &mut Work,
) -> Result<bool, Stop> {
    if let Some(order) = new.order(old) {
        return Ok(order == Ordering::Less);
    }
    let [new, old] = edges();
    work.spend(STEPS_PER_EDGE * (new.len() + old.len()) as u64)?;
    let difference = plane.lengths.difference(&new, &old);
    work.spend(STEPS_PER_ROOT * difference.len() as u64)?;
    let order = difference.sign();
    work.is_sure &= order.is_some();
    Ok(order == Some(Ordering::Less))
}

/// What it costs to strike out an edge, and to compute a root, measured in pairs of diagonals.
const STEPS_PER_EDGE: u64 = 50;
const STEPS_PER_ROOT: u64 = 10_000;

/// A diagonal or a side between two corners.
#[derive(Clone, Copy, Debug)]
struct Pair {
    ends: [u32; 2],
    weight: Weight,
    /// The pairs on the other two sides of the triangle; none on a side of the walk.
    parts: Option<[u32; 2]>,
}

struct Program<'a> {
    plane: &'a Plane<'a>,
    corners: &'a [Corner],
    pairs: Vec<Pair>,
    /// For each corner the higher corners of pairs that are done, ascending, with the pairs.
    up: Vec<Vec<[u32; 2]>>,
    /// For each corner the lower corners of pairs that are done, descending, with the pairs.
    down: Vec<Vec<[u32; 2]>>,
}

/// The lightest triangulation of a face bounded by one walk; none if the possible edges allow none.
///
/// `corner_of` is scratch, one entry a half-edge.
pub(super) fn lightest(
    plane: &Plane<'_>,
    corners: &[Corner],
    corner_of: &mut [u32],
    work: &mut Work,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Option<Part>, Stop> {
    let count = corners.len();
    if count < 3 {
        return Ok(None);
    }
    let mut program =
        Program { plane, corners, pairs: Vec::new(), up: vec![Vec::new(); count], down: vec![Vec::new(); count] };
    let last = count as u32 - 1;
    for i in 0..last {
        program.push(Pair { ends: [i, i + 1], weight: Weight::ZERO, parts: None });
    }
    for ends in diagonals(plane, corners, corner_of) {
        if trace.is_cancelled() {
            return Err(Stop::Cancelled);
        }
        program.solve(ends, program.length_of(ends), work)?;
    }
    Ok(program.solve([0, last], Weight::ZERO, work)?.map(|top| program.part(top)))
}

/// The pairs of corners that diagonals join, shorter stretches first.
fn diagonals(plane: &Plane<'_>, corners: &[Corner], corner_of: &mut [u32]) -> Vec<[u32; 2]> {
    let mut found = Vec::new();
    for (i, &corner) in (0..).zip(corners) {
        for h in plane.diagonals_at(corner) {
            corner_of[h as usize] = i;
        }
    }
    for (i, &corner) in (0..).zip(corners) {
        let others = plane.diagonals_at(corner).map(|h| corner_of[plane.fans.twin[h as usize] as usize]);
        found.extend(others.filter(|&j| i < j).map(|j| [i, j]));
    }
    found.sort_unstable_by_key(|&[i, j]| [j - i, i]);
    found
}

impl Program<'_> {
    fn vertex(&self, corner: u32) -> u32 {
        self.corners[corner as usize].vertex
    }

    fn length_of(&self, ends: [u32; 2]) -> Weight {
        self.plane.lengths.of(ends.map(|corner| self.vertex(corner)))
    }

    /// A pair that is done.
    fn push(&mut self, pair: Pair) -> u32 {
        let index = self.pairs.len() as u32;
        let [i, j] = pair.ends;
        self.up[i as usize].push([j, index]);
        self.down[j as usize].push([i, index]);
        self.pairs.push(pair);
        index
    }

    /// The least weight of a pair, if there is any triangle on it.
    fn solve(&mut self, ends: [u32; 2], length: Weight, work: &mut Work) -> Result<Option<u32>, Stop> {
        let [i, j] = ends;
        let mut best: Option<(Weight, [u32; 2])> = None;
        let (up, down) = (&self.up[i as usize], &self.down[j as usize]);
        let (mut a, mut b) = (0, down.len());
        work.spend((up.len() + down.len()) as u64)?;
        while a < up.len() && b > 0 {
            let ([k, left], [m, right]) = (up[a], down[b - 1]);
            a += usize::from(k <= m);
            b -= usize::from(m <= k);
            if k != m {
                continue;
            }
            let parts = [left, right];
            let weight = self.pairs[left as usize].weight.plus(self.pairs[right as usize].weight);
            let is_better = match best {
                None => true,
                Some((old, others)) => {
                    is_lighter(self.plane, [weight, old], || [self.edges(parts), self.edges(others)], work)?
                }
            };
            if is_better && self.is_ccw([i, k, j]) {
                best = Some((weight, parts));
            }
        }
        Ok(best.map(|(weight, parts)| self.push(Pair { ends, weight: weight.plus(length), parts: Some(parts) })))
    }

    fn is_ccw(&self, corners: [u32; 3]) -> bool {
        let [a, b, c] = corners.map(|corner| self.plane.points[self.vertex(corner) as usize]);
        orient2d(a, b, c) == Orientation::CounterClockwise
    }

    /// The diagonals of two pairs and of all parts below them.
    fn edges(&self, parts: [u32; 2]) -> Vec<[u32; 2]> {
        let mut edges = Vec::new();
        let mut open = parts.to_vec();
        while let Some(pair) = open.pop() {
            let pair = self.pairs[pair as usize];
            if let Some(parts) = pair.parts {
                edges.push(pair.ends.map(|corner| self.vertex(corner)));
                open.extend(parts);
            }
        }
        edges
    }

    /// The triangulation below a pair, whose own edge does not count.
    fn part(&self, top: u32) -> Part {
        let mut triangles = Vec::new();
        let mut open = vec![top];
        while let Some(pair) = open.pop() {
            let Pair { ends: [i, j], parts, .. } = self.pairs[pair as usize];
            if let Some([left, right]) = parts {
                let k = self.pairs[left as usize].ends[1];
                triangles.push([i, k, j].map(|corner| self.vertex(corner)));
                open.extend([left, right]);
            }
        }
        let Pair { weight, parts, .. } = self.pairs[top as usize];
        Part { triangles, edges: parts.map_or_else(Vec::new, |parts| self.edges(parts)), weight }
    }
}
