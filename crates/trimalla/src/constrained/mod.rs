//! Constrained Delaunay triangulations: segments that must be edges.
//!
//! A segment goes in in two phases: a [`SegmentPlan`] lists what it crosses, then the crossed faces are
//! replaced by a filling of the pseudo-polygons on both sides. Vertices exactly on a segment part it,
//! overlapping segments share edges, and crossing segments are refused or split, as [`Crossings`] says.

mod apply;
mod area_map;
mod by_cavity;
mod check;
#[expect(clippy::module_inception, reason = "the room's one type has the room's name")]
mod constrained;
mod constraints;
mod crossing_pairs;
mod error;
mod input_sides;
mod insert_segment;
mod lines;
mod merge;
mod outside;
mod overlaps;
mod plan;
mod provenance;
mod pseudo_polygon;
mod recover;
mod remove_segment;
mod split_crossings;
mod split_subsegment;
#[cfg(test)]
mod tests;

pub(crate) use area_map::AreaMap;
pub use constrained::{ConstrainedDelaunay, RegionRule, SegmentId};
pub use crossing_pairs::crossing_pairs;
pub use error::{ConstraintError, CrossingPair};
pub(crate) use input_sides::Beside;
pub use insert_segment::Crossings;
pub(crate) use outside::Outside;
pub use plan::SegmentPlan;
pub use provenance::Provenance;
pub use pseudo_polygon::Filling;
pub(crate) use recover::{Changed, Recovery, Released, SplitLimits};
pub use split_subsegment::SplitError;
