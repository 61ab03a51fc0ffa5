//! Edge insertion: the worst triangle is broken by an edge from one of its corners, until no such edge helps.
//!
//! # Idea
//! Flips get stuck: no flip improves the worst triangle, and yet there are better triangulations. Edge insertion
//! changes more at once. It takes any edge, removes all edges that cross it, and triangulates the two polygons beside
//! it anew.
//!
//! ```text
//!              s                   s               T = q p r is the worst triangle, q its anchor: every better
//!            ╱   ╲               ╱ │ ╲             triangulation has an edge from q that crosses p r. It is q s here.
//!          b ───── a           b   │   a           The edges p r, p b and a b cross q s and go; on either side of q s,
//!          │    ╱  │           │ ╲ │ ╱ │           ears are cut off one after the other, each of them better than T:
//!          │  ╱    │    →      │   │   │           q b s, q r b on the left, q a s, q p a on the right.
//!          r ───── p           r   │   p
//!            ╲ T ╱               ╲ │ ╱
//!              q                   q
//! ```
//!
//! A criterion is the cost of the worst triangle. It must have *anchors*: each triangle has a corner, its anchor, such
//! that every triangulation whose triangles are all better has an edge from that corner into the triangle. Then (cake
//! cutting lemma): if the edge q s is in a triangulation that is better than the current one, the polygons on both
//! sides of q s can be triangulated with triangles better than T, and it does not matter which ears are cut first. Each
//! convex corner of these polygons is an ear: no other corner lies in it.
//!
//! | criterion | file | anchor | cost |
//! |---|---|---|---|
//! | largest angle, smallest height | `by_walk.rs` | the corner with the largest angle | O(n² log n) |
//! | largest slope | `by_trial.rs` | one of the three | O(n³) |
//!
//! Edges of the boundary and constrained edges are never crossed, so holes need no care.
//!
//! # Source
//! `[EdelsbrunnerTanWaupotitsch92]` for angles; `[BernEtAl93]` for the paradigm.

mod by_trial;
mod by_walk;
mod cavity;
mod chain;
mod criteria;
mod worst;

pub(super) use by_trial::min_max_slope;
pub(super) use by_walk::{max_min_height, min_max_angle};

use super::input::in_order;
use super::mesh::Mesh;
use super::{Optimal, OptimalError, OptimalInput};
use crate::trace::{Shape, Trace};
use cavity::Cavity;
use criteria::Criterion;
use worst::Worst;

/// Improves the worst triangle as long as a search finds how; where it finds nothing, the triangle stays, and the next
/// one is the worst.
///
/// The search is given the mesh, the worst triangle and its cost. It returns `None` only if no triangulation is better.
fn improve<C: Criterion, T: Trace + ?Sized>(
    criterion: &C,
    input: &OptimalInput<'_>,
    trace: &mut T,
    mut search: impl FnMut(&C, &Mesh, (u32, &C::Cost), &mut T) -> Option<Cavity>,
) -> Result<Optimal, OptimalError> {
    let start = input.start()?;
    for &t in &start {
        trace.add(Shape::Triangle(t), "to begin with");
    }
    let mut mesh = Mesh::new(start, input.domain.map_or(&[], |domain| &domain.segments));
    let mut worst = Worst::new(criterion, &mesh.triangles);
    let mut value = None;
    while let Some((slot, bound)) = worst.get() {
        if trace.is_cancelled() {
            return Err(OptimalError::Cancelled);
        }
        let t = mesh.triangles[slot as usize];
        trace.look(Shape::Triangle(t), "the worst triangle");
        if let Some(cavity) = search(criterion, &mesh, (slot, bound), trace) {
            cavity.apply(criterion, &mut mesh, &mut worst, trace);
        } else {
            value = value.or(Some(criterion.value(bound)));
            trace.look(Shape::Triangle(t), "stays: no triangulation is better here");
            mesh.seal(slot);
            worst.retire(criterion, slot);
        }
    }
    Ok(Optimal { triangles: in_order(mesh.triangles), is_proved: true, value: value.unwrap_or(0.0) })
}
