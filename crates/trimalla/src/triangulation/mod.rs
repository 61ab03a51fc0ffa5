//! Topology, coordinates and marks of a triangulation, and its invariants.
mod indexed;
pub use indexed::IndexedMesh;
