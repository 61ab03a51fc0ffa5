//! `min-weight`: a triangulation whose edges are the shortest in all.
//!
//! The problem is NP-hard `[MulzerRote08]`, and yet random points are easy: most edges of the optimum are found by
//! looking at a few points around, and small polygons are left.
//!
//! ```text
//!   1 diamond test          2 LMT-skeleton            3 dynamic programming
//!
//!     p ◁▷ q  both halves     ·───·───·  certain        ·───·───·
//!     occupied: no edge       │ ╲ │ ╳ │  no other       │ ╲ │ ╱ │   each face that is left:
//!                             ·───·───·  edge crosses   ·───·───·   the lightest way
//! ```
//!
//! 1. *Diamond test* (`candidates.rs`): an edge with points in both of its isosceles triangles of base angle π/4.6 is
//!    in no optimum. About 11 candidates a point are left where points are uniform.
//! 2. *LMT-skeleton* (`skeleton.rs`): an edge is impossible if no pair of empty triangles makes it locally minimal.
//!    This makes other edges impossible, until nothing changes. An edge that no possible edge crosses is certain.
//! 3. *Faces* (`faces.rs`, `polygon_program.rs`): the certain edges bound faces, most of them triangles. Each other
//!    face is triangulated by dynamic programming over the possible edges in it. In a face with components inside, all
//!    ways to connect them are tried.
//! 4. *Sums* (`lengths.rs`): sums of lengths are compared as intervals of doubles, then by square roots of 256 and more
//!    binary places. Sums that are still equal are equal if their roots, class by class, are.
//!
//! The budget counts pairs of diagonals that are looked at. Small faces come first. If the budget runs out, or a
//! comparison is never decided, the result is a triangulation all the same, and `is_proved` is false: a face without
//! its optimum is triangulated by the constrained Delaunay triangulation and flips.
//!
//! Degenerate cases: of equal points the one of lowest index is used. Collinear points have no triangle. An edge never
//! passes through a point: what is hidden is not seen. Points on circles and grids tie often; ties go to the edge whose
//! vertices come first, in the skeleton, and then to the apex that comes first along the walk. Where the magnitudes of
//! coordinates differ by more than 2^400, and in domains, the diamond test is left out and all visible pairs are
//! candidates.
//!
//! # Complexity
//! For uniform points linear in practice, besides sorting: docs/performance.md has seconds.
//! In the worst case exponential in the number of components inside one face, which the budget stops, and cubic in its
//! corners: 56 s for 1000 points on a circle. Without the diamond test, also in domains, the candidates are quadratic
//! and their triangles cubic: some hundred vertices.
//!
//! # Source
//! `[DasJoseph89]` and `[DrysdaleMcElfreshSnoeyink01]` for the diamond and its angle; `[DickersonKeilMontague97]` and
//! `[BeiroutiSnoeyink98]` for the skeleton; `[Klincsek80]` for the polygons; `[Haas18]` for the stack of edges and the
//! proof that large instances can be solved. The cones of step 1 and step 4 are ours.

mod base;
mod candidates;
mod empty_triangles;
mod faces;
mod fallback;
mod fans;
mod lengths;
mod polygon_program;
mod skeleton;
mod walks;
mod weight;

use base::Base;
use empty_triangles::EmptyTriangles;
use faces::{Face, Solver};
use fans::Fans;
use lengths::Lengths;
use polygon_program::{Stop, Work};
use walks::Plane;

use super::input::in_order;
use super::{Optimal, OptimalError, OptimalInput};
use crate::geometry::{Point, segments_cross_properly};
use crate::half_edge::{EdgeKey, edges_of};
use crate::trace::{Shape, Trace};

/// What the search for a triangulation of least weight may cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WeightBudget {
    /// The most candidate edges.
    pub edges: usize,
    /// The most empty triangles of them; if there are more, all candidates count as possible.
    pub triangles: usize,
    /// The most steps of the dynamic program: pairs of diagonals looked at. The skeleton may take an eighth as many
    /// pairs of triangles; edges that are not looked at then count as possible.
    pub steps: u64,
}

/// Enough for a million uniform points; the memory stays below some gigabytes.
impl Default for WeightBudget {
    fn default() -> Self {
        Self { edges: 15_000_000, triangles: 20_000_000, steps: 10_000_000_000 }
    }
}

/// A triangulation of least weight, and how it was found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MinimumWeight {
    /// The triangulation; its value is the sum of the lengths of its edges, rounded.
    pub optimal: Optimal,
    /// The number of edges that pass the diamond test.
    pub candidates: usize,
    /// The number of these for which a locally minimal pair of triangles is left.
    pub possible: usize,
    /// The certain edges, lower vertex first, sorted: one triangulation of least weight has all of them.
    pub skeleton: Vec<[u32; 2]>,
    /// The number of faces of the skeleton that are not triangles.
    pub faces: usize,
    /// The number of these that have components inside.
    pub faces_with_components: usize,
    /// The most corners and ends of possible diagonals in one face.
    pub largest_face: usize,
}

/// Finds a triangulation of points, or of a domain, the sum of whose edges is least.
///
/// # Shape
/// Triangles are counter-clockwise triples of indices into the points, each from its smallest index on, sorted.
///
/// # Guarantees
/// If `is_proved`, no triangulation is lighter, by exact comparison of sums of square roots.
///
/// # Errors
/// See [`OptimalError`].
///
/// # Complexity
/// See the head of the module's file: seconds for ten thousand uniform points, and bounded by the budget.
///
/// # Examples
/// ```
/// use trimalla::geometry::Point;
/// use trimalla::optimal::{OptimalInput, WeightBudget, minimum_weight};
/// use trimalla::trace::NoTrace;
///
/// // A flat rhombus: the short diagonal is 2 long, the long one 8.
/// let points = [[-4.0, 0.0], [0.0, -1.0], [4.0, 0.0], [0.0, 1.0]].map(Point::from);
/// let found = minimum_weight(&OptimalInput::of_points(&points), WeightBudget::default(), &mut NoTrace)?;
/// assert_eq!(found.optimal.triangles, [[0, 1, 3], [1, 2, 3]]);
/// assert!(found.optimal.is_proved && found.skeleton.contains(&[1, 3]));
/// # Ok::<(), trimalla::optimal::OptimalError>(())
/// ```
#[doc(alias = "MWT")]
#[doc(alias = "triangulación de peso mínimo")]
pub fn minimum_weight(
    input: &OptimalInput<'_>,
    budget: WeightBudget,
    trace: &mut (impl Trace + ?Sized),
) -> Result<MinimumWeight, OptimalError> {
    let segments = input.prepare()?.segments;
    let base = Base::new(input)?;
    let lengths = Lengths::new(base.points);
    let Some(mut edges) = candidates::candidates(&base, &lengths, budget.edges, trace)? else {
        return Ok(unproved(&base, &lengths));
    };
    let place = |edge: [u32; 2]| edge.map(|v| base.points[v as usize]);
    let crosses = |[a, b]: [Point; 2], [c, d]: [Point; 2]| segments_cross_properly(a, b, c, d);
    edges.retain(|&edge| !segments.iter().any(|&segment| crosses(place(edge), place(segment))));
    for &edge in &edges {
        trace.look(Shape::Edge(edge), "passes the diamond test");
    }
    let fans = Fans::new(base.points, edges);
    let is_outside = outside(&base, &fans);
    let must_stay = must_stay(&fans, &is_outside, &segments);
    let is_possible = possible(&base, &lengths, &fans, (&is_outside, &must_stay), budget, trace)?;
    let is_certain = skeleton::certain(base.points, &fans, &is_possible);
    let plane = Plane { points: base.points, lengths: &lengths, fans: &fans, is_possible, is_certain };
    solve(plane, &is_outside, budget, trace)
}

/// The half-edges that have the outside on their left.
fn outside(base: &Base<'_>, fans: &Fans) -> Vec<bool> {
    let mut is_outside = vec![false; fans.to.len()];
    for [a, b] in base.boundary() {
        if let Some(h) = fans.between(b, a) {
            is_outside[h as usize] = true;
        }
    }
    is_outside
}

/// The edges of the boundary, and those along segments.
fn must_stay(fans: &Fans, is_outside: &[bool], segments: &[[u32; 2]]) -> Vec<bool> {
    let mut must_stay = vec![false; fans.edges.len()];
    let boundary = (0..is_outside.len()).filter(|&h| is_outside[h]);
    let inside = segments.iter().filter_map(|&[a, b]| fans.between(a, b)).map(|h| h as usize);
    for h in boundary.chain(inside) {
        must_stay[fans.edge[h] as usize] = true;
    }
    must_stay
}

/// Step 2: which candidates are possible; all of them, if the budget does not suffice for their triangles.
fn possible(
    base: &Base<'_>,
    lengths: &Lengths<'_>,
    fans: &Fans,
    (is_outside, must_stay): (&[bool], &[bool]),
    budget: WeightBudget,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Vec<bool>, OptimalError> {
    match EmptyTriangles::new(base.points, fans, is_outside, budget.triangles) {
        Some(triangles) => {
            skeleton::possible(base.points, lengths, fans, &triangles, must_stay, budget.steps / 8, trace)
        }
        None => Ok(vec![true; fans.edges.len()]),
    }
}

/// Step 3: the faces.
fn solve(
    plane: Plane<'_>,
    is_outside: &[bool],
    budget: WeightBudget,
    trace: &mut (impl Trace + ?Sized),
) -> Result<MinimumWeight, OptimalError> {
    let fans = plane.fans;
    let (mut triangles, faces) = faces::faces(&plane, is_outside);
    let edges_where =
        |is: &[bool]| -> Vec<[u32; 2]> { (0..is.len()).filter(|&e| is[e]).map(|e| fans.edges[e]).collect() };
    let skeleton = edges_where(&plane.is_certain);
    for &edge in &skeleton {
        trace.add(Shape::Edge(edge), "certain: no possible edge crosses it");
    }
    let mut result = MinimumWeight {
        candidates: fans.edges.len(),
        possible: plane.is_possible.iter().filter(|is| **is).count(),
        faces: faces.len(),
        faces_with_components: faces.iter().filter(|face| face.starts.len() > 1).count(),
        largest_face: faces.iter().map(|face| face.size).max().unwrap_or(0),
        ..MinimumWeight::default()
    };
    let mut solver = Solver::new(plane, Work { steps: budget.steps, is_sure: true });
    let mut fixed = skeleton.clone();
    let mut left = Vec::new();
    for face in faces {
        match solver.solve(&face.starts, trace) {
            Ok(Some(part)) => {
                for &edge in &part.edges {
                    trace.add(Shape::Edge(edge), "part of the lightest triangulation of its face");
                }
                triangles.extend(part.triangles);
                fixed.extend(part.edges);
            }
            Ok(None) | Err(Stop::OutOfBudget) => left.push(face),
            Err(Stop::Cancelled) => return Err(OptimalError::Cancelled),
        }
    }
    result.skeleton = skeleton;
    let is_proved = left.is_empty() && solver.work.is_sure;
    fill(&solver.plane, &fixed, &left, &mut triangles);
    result.optimal = finished(solver.plane.lengths, triangles, is_proved);
    Ok(result)
}

/// Triangulates the faces that are left, in some way.
fn fill(plane: &Plane<'_>, fixed: &[[u32; 2]], left: &[Face], triangles: &mut Vec<[u32; 3]>) {
    if left.is_empty() {
        return;
    }
    let starts: Vec<_> = left.iter().flat_map(|face| face.starts.iter().copied()).collect();
    if let Some(mut filled) = fallback::triangulate(plane, fixed, &starts) {
        fallback::flip_to_shorter(plane.points, plane.lengths, &mut filled, FLIP_ROUNDS);
        triangles.extend(filled);
    }
}

/// After so many rounds of flips what is not proved is good enough.
const FLIP_ROUNDS: usize = 50;

/// The triangles of the base, made lighter by flips.
fn unproved(base: &Base<'_>, lengths: &Lengths<'_>) -> MinimumWeight {
    let mut triangles = base.triangles.clone();
    fallback::flip_to_shorter(base.points, lengths, &mut triangles, FLIP_ROUNDS);
    MinimumWeight { optimal: finished(lengths, triangles, false), ..MinimumWeight::default() }
}

/// The result with its triangles in order.
fn finished(lengths: &Lengths<'_>, triangles: Vec<[u32; 3]>, is_proved: bool) -> Optimal {
    let triangles = in_order(triangles);
    let value = lengths.sum(edges_of(&triangles).into_iter().map(EdgeKey::ends));
    Optimal { triangles, is_proved, value }
}
