//! The triangulation in the hands of steps 1 and 5.

use super::proposal::Proposal;
use super::view::View;
use crate::half_edge::VertexId;

/// How released segments are recovered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bring {
    /// They are halved until each of them is a chain of edges; those that the limits leave missing are inserted as
    /// whole edges.
    BySplitting,
    /// Each is inserted as one edge: the faces that it crosses are triangulated anew on both sides of it `[Vigo97]`.
    AsWholeEdges,
}

/// What steps 1 and 5 may read and change.
///
/// # Guarantees
/// Whatever a step calls, the triangulation keeps its invariants, input vertices stay where they are, and the budget
/// and the length floor hold. Every change is counted in the report and can be taken back with the step.
pub trait StepEdit {
    /// The triangulation, and what makes a triangle bad.
    fn view(&self) -> View<'_>;

    /// Inserts a vertex at a place, as step 4 does; if a subsegment is in the way, queues its split instead. Returns
    /// whether anything was done: not if the place is not [true](Proposal::is_true) or has no room, or if the budget is
    /// spent.
    fn put(&mut self, place: Proposal) -> bool;

    /// Deletes a vertex that is on no segment and not in the input; returns whether it was possible.
    fn delete(&mut self, v: VertexId) -> bool;

    /// The ends of the released pieces of segments that are no edges now, sorted.
    fn missing(&self) -> Vec<[VertexId; 2]>;

    /// Recovers some of the [missing](Self::missing) pieces as whole edges; returns how many of them are edges now.
    /// Inserts vertices where such an edge crosses another one.
    fn bring_back(&mut self, pieces: &[[VertexId; 2]]) -> usize;

    /// Recovers all missing pieces, in slices; a run can be cancelled between two slices.
    fn bring_all_back(&mut self, how: Bring);
}
