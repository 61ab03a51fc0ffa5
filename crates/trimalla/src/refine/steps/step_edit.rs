//! The triangulation in the hands of steps 1 and 5.

use super::proposal::Proposal;
use super::view::View;
use crate::half_edge::VertexId;

/// How segments that were let go come back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bring {
    /// They are halved until each of them is a chain of edges; what limits leave missing goes in as whole edges.
    BySplitting,
    /// Each goes in as one edge: the faces that it crosses are triangulated anew on both sides of it `[Vigo97]`.
    AsWholeEdges,
}

/// What steps 1 and 5 may read and change.
///
/// # Guarantees
/// Whatever is called, the triangulation keeps its invariants, input vertices stay where they are, and the budget and
/// the length floor hold. Every change is counted in the report and can be taken back with the step.
pub trait StepEdit {
    /// The triangulation, and what makes a triangle bad.
    fn view(&self) -> View<'_>;

    /// Puts a vertex in at a place, as step 4 does; a subsegment in the way waits for its split instead. Says whether
    /// anything was done: not where the place is not [true](Proposal::is_true), or has no room, or the budget is spent.
    fn put(&mut self, place: Proposal) -> bool;

    /// Deletes a vertex that is on no segment and did not come with the input; says whether it could.
    fn delete(&mut self, v: VertexId) -> bool;

    /// The ends of the pieces of segments that were let go and are no edges now, sorted.
    fn missing(&self) -> Vec<[VertexId; 2]>;

    /// Brings back some of the [missing](Self::missing) pieces as whole edges; returns how many are there now. Vertices
    /// go in where such an edge crosses another one.
    fn bring_back(&mut self, pieces: &[[VertexId; 2]]) -> usize;

    /// Lets the loop bring back everything that is missing, in slices that can be cancelled between.
    fn bring_all_back(&mut self, how: Bring);
}
