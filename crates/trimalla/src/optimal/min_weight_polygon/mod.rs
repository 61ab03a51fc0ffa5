//! `min-weight-polygon`: the triangulation of a polygon with the least total length, by dynamic programming.
//!
//! # Idea
//! For points nobody knows a fast way to the triangulation with the least sum of edge lengths, and there is none unless
//! P = NP. A polygon without vertices inside is different: every diagonal cuts it in two, and the best triangulations
//! of the parts do not depend on each other. So a table of the best triangulation behind each diagonal is filled, short
//! diagonals first.
//!
//! ```text
//!    3 ───── 2        best(0, 3) = the least of          1 as third corner: best(1, 3) + |1 3|
//!    │ ╲     │                                           2 as third corner: best(0, 2) + |0 2|
//!    │   ╲   │        Here |1 3| < |0 2|.
//!    0 ───── 1
//! ```
//!
//! # Steps
//! 1. Keep the boundary of the domain and its constrained edges, and walk around each face between them.
//! 2. Find the diagonals of each face, and fill the table: [`decompose`].
//! 3. Read the triangles from the table.
//!
//! # Degenerate cases
//! Constrained edges that hang into a face, and faces that touch themselves in a vertex, are fine. A hole is not,
//! unless constrained edges join it to the outline; nor is a vertex inside: both are refused.
//!
//! # Guarantees
//! Lengths are added with about 100 binary places: [`total`]. Two sums that differ by less than 2^-88 of themselves
//! count as equal, and the first one found is taken. If they then consist of the same lengths, they are equal indeed;
//! otherwise `is_proved` is false, and the total is the least up to these 2^-88.
//!
//! # Complexity
//! O(n³) time, O(d) memory for d diagonals, at most n² / 2.
//!
//! # Source
//! `[Klincsek80]`.

mod total;

use super::decompose;
use super::input::in_order;
use super::mesh::Mesh;
use super::{Optimal, OptimalError, OptimalInput};
use crate::geometry::Segment;
use crate::half_edge::edges_of;
use crate::trace::Trace;
use total::TotalLength;

/// The triangulation of a domain of faces without holes with the least total length.
pub(super) fn triangulate(
    input: &OptimalInput<'_>,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Optimal, OptimalError> {
    let method = "min-weight-polygon";
    let start = input.start()?;
    let domain = input.domain.ok_or(OptimalError::DomainOnly { method })?;
    let mesh = Mesh::new(start, &domain.segments);
    let objective = TotalLength::new(input.points);
    let triangles = decompose::fill(&mesh, &[], method, trace, |walk, trace| {
        let best = decompose::triangulate(input.points, walk, &objective, trace)?;
        Ok(best.map_or_else(Vec::new, |best| best.triangles))
    })?;
    let value = total_length(input, &triangles);
    Ok(Optimal { triangles: in_order(triangles), is_proved: !objective.was_open(), value })
}

/// The sum of the lengths of all edges, rounded.
fn total_length(input: &OptimalInput<'_>, triangles: &[[u32; 3]]) -> f64 {
    let length = |ends: [u32; 2]| {
        let [a, b] = ends.map(|v| input.points[v as usize]);
        Segment::new(a, b).length()
    };
    edges_of(triangles).into_iter().map(|edge| length(edge.ends())).sum()
}
