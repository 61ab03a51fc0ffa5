//! Geometry that steps, forecast and loop share: lengths, pieces of segments, longest-edge paths, the lattice.

pub(super) mod joints;
pub(super) mod lattice;
pub mod lepp;
pub(super) mod mirror;
pub(super) mod ruler;
