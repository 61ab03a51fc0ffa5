//! Criteria: which triangles are bad and why, which vertices encroach, and how short an edge may become.

pub(super) mod bad_triangles;
pub(super) mod badness;
pub(super) mod encroachment;
pub(super) mod extremes;
pub(super) mod floors;
pub(super) mod reason;
