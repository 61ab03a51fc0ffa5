//! Delaunay triangulations: five ways to build them, and how they change.
//!
//! | key | algorithm | file |
//! |---|---|---|
//! | `incremental` | points in curve order, by rounds; walk, split, flip | `incremental.rs` |
//! | `divide-and-conquer` | halves merged bottom up | `divide_and_conquer/` |
//! | `lift` | lower convex hull of the points on a paraboloid | `lift.rs` |
//! | `flip` | any triangulation, illegal edges flipped | `flip.rs` |
//! | `voronoi` | Fortune's sweep, its dual then | `voronoi/` |
//!
//! The first two are fast; the others are those of the lecture notes, and tell their steps. All give the same
//! [canonical form](crate::triangulation::Triangulation::canonical), also on grids and circles: ties in the circle
//! test are broken by one symbolic perturbation ([`in_circle_perturbed`](crate::geometry::in_circle_perturbed)), which
//! makes the triangulation unique.
//!
//! [`Delaunay`] owns the invariant: whatever is inserted, removed or moved, every edge passes the circle
//! test afterwards.

mod algorithm;
mod cavity;
mod curve_cells;
#[expect(clippy::module_inception, reason = "the room's one type has the room's name")]
mod delaunay;
mod divide_and_conquer;
mod flip;
mod incremental;
mod insert;
mod lawson;
mod lift;
mod order;
mod radix_sort;
mod remove;
mod sites;
#[cfg(test)]
mod tests;
mod triangulator;
mod voronoi;

pub use algorithm::{Algorithm, AlgorithmKey, DivideAndConquer, Flip, Incremental, Lift, Voronoi};
pub(crate) use cavity::Cavity;
pub(crate) use curve_cells::CurveCells;
#[cfg(test)]
pub(crate) use delaunay::limit_of_test;
pub(crate) use delaunay::max_points;
pub use delaunay::{BuildError, Delaunay, Inserted};
pub use flip::flip_to_delaunay;
pub(crate) use flip::{flip_illegal, sweep};
pub use incremental::Insertion;
pub(crate) use insert::insert_at;
pub(crate) use lawson::Lawson;
pub(crate) use order::{along_curve, insertion_order};
pub use remove::RemoveError;
pub(crate) use remove::{Hole, flip_spokes_away, legalise_hole, remove_vertex};
pub use triangulator::Triangulator;
