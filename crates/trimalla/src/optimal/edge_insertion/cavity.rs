//! A change to the mesh: some triangles and those that take their place.

use super::criteria::Criterion;
use super::worst::Worst;
use crate::optimal::mesh::Mesh;
use crate::trace::{Shape, Trace};

/// The triangles that an edge crosses, and better ones for the same place.
pub(super) struct Cavity {
    /// The slots of the triangles that go.
    pub(super) slots: Vec<u32>,
    /// As many new triangles.
    pub(super) triangles: Vec<[u32; 3]>,
    /// The edge that is inserted.
    pub(super) edge: [u32; 2],
}

impl Cavity {
    /// Replaces the triangles.
    pub(super) fn apply<C: Criterion>(
        self,
        criterion: &C,
        mesh: &mut Mesh,
        worst: &mut Worst<C>,
        trace: &mut (impl Trace + ?Sized),
    ) {
        for &slot in &self.slots {
            trace.remove(Shape::Triangle(mesh.triangles[slot as usize]), "crossed by the new edge");
        }
        trace.add(Shape::Edge(self.edge), "inserted");
        for &t in &self.triangles {
            trace.add(Shape::Triangle(t), "an ear, better than the worst triangle");
        }
        mesh.replace(&self.slots, &self.triangles);
        for (&slot, &t) in self.slots.iter().zip(&self.triangles) {
            worst.update(criterion, slot, t);
        }
    }
}
