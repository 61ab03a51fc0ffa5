//! Delaunay triangulations: two ways to build them, and how they change.
//!
//! | key | algorithm | file |
//! |---|---|---|
//! | `incremental` | points in curve order, by rounds; walk, split, flip | `incremental.rs` |
//! | `divide-and-conquer` | halves merged bottom up | `divide_and_conquer/` |
//!
//! Both give the same [canonical form](crate::triangulation::Triangulation::canonical), also on grids and
//! circles: ties in the circle test are broken by one symbolic perturbation
//! ([`in_circle_perturbed`](crate::geometry::in_circle_perturbed)), which makes the triangulation unique.
//!
//! [`Delaunay`] owns the invariant: whatever is inserted, removed or moved, every edge passes the circle
//! test afterwards.

mod algorithm;
mod cavity;
mod curve_cells;
#[expect(clippy::module_inception, reason = "the room's one type has the room's name")]
mod delaunay;
mod divide_and_conquer;
mod incremental;
mod insert;
mod lawson;
mod order;
mod radix_sort;
mod remove;
#[cfg(test)]
mod tests;

pub use algorithm::{Algorithm, AlgorithmKey, DivideAndConquer, Incremental};
pub(crate) use cavity::Cavity;
pub(crate) use curve_cells::CurveCells;
#[cfg(test)]
pub(crate) use delaunay::limit_of_test;
pub(crate) use delaunay::max_points;
pub use delaunay::{BuildError, Delaunay, Inserted};
pub(crate) use insert::insert_at;
pub(crate) use lawson::Lawson;
pub(crate) use order::{along_curve, insertion_order};
pub use remove::RemoveError;
pub(crate) use remove::{Hole, flip_spokes_away, legalise_hole, remove_vertex};
