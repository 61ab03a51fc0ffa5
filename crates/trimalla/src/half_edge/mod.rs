//! Half-edges without coordinates: the topology of a mesh.
//!
//! The mesh closes every triangulation to a sphere. A *ghost face* joins each boundary edge to one
//! vertex at infinity, [`VertexId::INFINITE`], so every half-edge has a twin and no operator asks
//! whether it stands at the boundary.
//!
//! ```text
//!   half-edge h   origin(h) ── h ──> dest(h)         face(h)  = h / 3
//!                      \            /                next(h), prev(h): arithmetic in the triple
//!                       \  face(h) /                 twin(h): stored, the other side
//!                        \        /
//!                         apex(h)
//! ```
//!
//! * [`HalfEdgeMesh`] holds one flat array of pairs `origin`, `twin`, and one half-edge a vertex;
//! * `operators` rewire it, each with its drawing;
//! * [`Journal`] notes what an operator overwrites, so that it can be taken back exactly;
//! * circulators ([`HalfEdgeMesh::star`], …) walk a neighbourhood;
//! * [`EdgeKey`] and [`TriangleKey`] name edges and triangles by their vertices;
//! * [`SideTable`] keeps user data beside elements.
//!
//! This room knows no coordinates; [`crate::triangulation`] adds them.

mod circulators;
mod edges;
mod half_edges;
mod ids;
mod journal;
mod keys;
mod operators;
mod push_if;
mod side_table;
mod slots;
#[cfg(test)]
mod tests;

pub use circulators::{BoundaryLoop, Star};
pub use half_edges::HalfEdgeMesh;
pub(crate) use ids::id_type;
pub use ids::{EdgeId, FaceId, HalfEdgeId, VertexId};
pub use journal::{Checkpoint, Column, Entry, Journal, NoJournal, UndoLog};
pub(crate) use journal::{Room, columns};
pub(crate) use keys::edges_of;
pub use keys::{EdgeKey, TriangleKey};
pub use operators::FaceError;
pub(crate) use operators::{Boundary, Half, Patch, RimEdge, Side, Triangle};
pub(crate) use push_if::push_if;
pub use side_table::SideTable;
