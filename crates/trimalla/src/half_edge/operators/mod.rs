//! The operators that rewire a mesh, each with its drawing.
//!
//! | operator | before → after | inverse |
//! |---|---|---|
//! | [`split_face`](HalfEdgeMesh::split_face) | 1 → 3 faces | [`unsplit_face`](HalfEdgeMesh::unsplit_face) |
//! | [`split_edge`](HalfEdgeMesh::split_edge) | 2 → 4 faces | [`unsplit_edge`](HalfEdgeMesh::unsplit_edge) |
//! | [`flip`](HalfEdgeMesh::flip) | 2 → 2 faces | itself, three times more |
//! | [`start_chain`](HalfEdgeMesh::start_chain) | point → two-point chain | [`end_chain`](HalfEdgeMesh::end_chain) |
//! | [`extend_chain`](HalfEdgeMesh::extend_chain) | chain → longer chain | [`shorten_chain`](HalfEdgeMesh::shorten_chain) |
//! | [`attach_outside`](HalfEdgeMesh::attach_outside) | a run of ghosts → real faces around a new vertex | [`detach_outside`](HalfEdgeMesh::detach_outside) |
//! | [`carve`](HalfEdgeMesh::carve) | faces outside the domain → ghosts along its boundary | rollback |
//! | [`add_face`](HalfEdgeMesh::add_face) | 0 → 1 face, checked | [`remove_face`](HalfEdgeMesh::remove_face) |
//! | [`refill`](HalfEdgeMesh::refill) | a cavity's faces → others with the same rim | rollback |
//! | [`fill_star`](HalfEdgeMesh::fill_star) | a cavity's faces → a fan around a new vertex | rollback |
//!
//! Operators move constraint marks along with the edges they move, keep every vertex's half-edge
//! valid, and write through the journal alone. They look at no coordinate: whoever calls one has
//! proved that the faces it makes are counter-clockwise.
#[cfg(doc)]
use super::HalfEdgeMesh;

mod carve;
mod chain;
mod faces;
mod flip;
mod outside;
mod patch;
mod refill;
mod split;
mod star;
mod unsplit;

pub(crate) use carve::Boundary;
pub use faces::FaceError;
pub(crate) use patch::{Patch, Side, Triangle};
pub(crate) use refill::Half;
pub(crate) use star::RimEdge;
