//! How good a mesh is, and whether it is the mesh of its input.
//!
//! * [`Statistics`] counts and measures a mesh; it prints as a table with histograms;
//! * [`below_bound`] lists the triangles with an angle below a bound, by the exact certificate;
//! * [`against_input`] compares a mesh with the drawing it was made from;
//! * [`aspect_ratio`] measures one triangle.
//!
//! Everything here takes an [`IndexedMesh`](crate::triangulation::IndexedMesh), may be given a broken one, and
//! answers the same on every platform. What a sound mesh is, says
//! [`check_mesh`](crate::triangulation::check_mesh).

mod against_input;
mod below_bound;
mod histogram;
mod measure;
mod pieces;
mod statistics;
mod table;

pub use against_input::{Comparison, InputFault, against_input};
pub use below_bound::below_bound;
pub use histogram::Histogram;
pub use measure::{Spread, aspect_ratio};
pub use statistics::{AngleAt, Bins, Statistics};
