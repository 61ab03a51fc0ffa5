//! Topology, coordinates and marks of a triangulation, and its invariants.
//!
//! [`Triangulation`] is any triangulation: it promises that its faces are strictly counter-clockwise by
//! the exact test and closed by ghosts, not that it is Delaunay. It is closed by its convex hull or by
//! the boundary of a domain ([`Closure`]), and every dimension from −1 to 2 is a legal state.
//!
//! [`Triangulation::check`] names every broken invariant; tests call it after every change.

mod blocks;
mod canonical;
mod check;
mod check_indexed;
mod compact;
mod from_indexed;
mod operators;
#[expect(clippy::module_inception, reason = "the room's one type has the room's name")]
mod triangulation;
mod undo;

pub(crate) use blocks::{TriangleInBlock, corners_of_two};
pub use check::Fault;
pub(crate) use check_indexed::vertex as mesh_vertex;
pub use check_indexed::{MeshFault, MeshVertex, check_mesh, check_mesh_delaunay};
pub use compact::CompactMap;
pub(crate) use from_indexed::closed_half_edges;
pub use triangulation::{Closure, Triangulation};
