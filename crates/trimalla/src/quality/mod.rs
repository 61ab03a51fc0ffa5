//! How good a mesh is, and whether it is the mesh of its input.
//!
//! * [`Statistics`] counts and measures a mesh; it prints as a table with histograms;
//! * [`below_bound()`] lists the triangles with an angle below a bound, by the exact certificate;
//! * [`against_input()`] compares a mesh with the drawing it was made from;
//! * [`aspect_ratio`] measures one triangle;
//! * [`compare_equiangularity()`] compares two triangulations by all their angles; [`DelaunayMeasures`] and
//!   [`max_detour()`] measure what a Delaunay triangulation makes best;
//! * [`angle_ceiling()`] bounds the smallest angle of every mesh of a domain from above; [`angle_floor()`] and
//!   [`shell_floor`] give the angle that refinement keeps in spite of the [`smallest_input_angle`].
//!
//! Functions that take an [`IndexedMesh`](crate::drawing::IndexedMesh) accept a broken one, and give the same answer on
//! every platform. [`check_mesh`](crate::triangulation::check_mesh) says whether a mesh is sound.

mod against_input;
mod angle_ceiling;
mod angle_floor;
mod below_bound;
mod cover;
mod equiangularity;
mod histogram;
mod measure;
mod near_ends;
mod pieces;
mod sectors;
mod statistics;
mod table;

pub use against_input::{Comparison, InputFault, against_input};
pub use angle_ceiling::{AngleCeiling, angle_ceiling};
pub use angle_floor::{InputAngle, angle_floor, shell_floor, smallest_input_angle};
pub use below_bound::below_bound;
pub use equiangularity::{DelaunayMeasures, compare_equiangularity, max_detour};
pub use histogram::{Classes, Histogram};
pub use measure::{Spread, aspect_ratio};
pub(crate) use sectors::for_each_sector;
pub use statistics::{AngleAt, Bins, Statistics};
