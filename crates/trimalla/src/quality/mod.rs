//! How good a mesh is, and whether it is the mesh of its input.
//!
//! * [`Statistics`] counts and measures a mesh; it prints as a table with histograms;
//! * [`below_bound()`] lists the triangles with an angle below a bound, by the exact certificate;
//! * [`against_input()`] compares a mesh with the drawing it was made from;
//! * [`aspect_ratio`] measures one triangle;
//! * [`angle_ceiling()`] says of a domain what smallest angle no mesh of it can pass, [`angle_floor()`] and
//!   [`shell_floor`] what refinement keeps in spite of its [`smallest_input_angle`].
//!
//! What takes an [`IndexedMesh`](crate::drawing::IndexedMesh) may be given a broken one, and
//! answers the same on every platform. What a sound mesh is, says
//! [`check_mesh`](crate::triangulation::check_mesh).

mod against_input;
mod angle_ceiling;
mod angle_floor;
mod below_bound;
mod cover;
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
pub use histogram::{Classes, Histogram};
pub use measure::{Spread, aspect_ratio};
pub(crate) use sectors::for_each_sector;
pub use statistics::{AngleAt, Bins, Statistics};
