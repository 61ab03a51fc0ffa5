//! Constrained Delaunay triangulations: segments that must be edges.
//!
//! A segment goes in in two phases: a [`SegmentPlan`] lists what it crosses, then the crossed faces are
//! replaced by a filling of the pseudo-polygons on both sides. Vertices exactly on a segment split it,
//! overlapping segments share edges, and crossing segments are refused or split, as [`Crossings`] says.
//!
//! | type | what it is |
//! |---|---|
//! | [`ConstrainedTriangulation`] | the data: any triangulation with segments, provenances and regions; changed through a journal |
//! | [`Workspace`] | scratch lists, lent to operations; they keep nothing from one operation to the next |
//! | [`Edit`] | the two together with a journal: every operation |
//! | [`ConstrainedDelaunay`] | data and workspace that stay constrained Delaunay: the operations that keep that promise |
//! | [`Legalising`] | a triangulation that becomes constrained Delaunay, in slices |

mod apply;
mod by_cavity;
mod carve;
mod check;
mod classes;
mod columns;
mod constrained_delaunay;
mod constrained_triangulation;
mod crossing_pairs;
mod edit;
mod error;
mod flat_hull;
mod input_sides;
mod insert_segment;
mod legalising;
mod lines;
mod merge;
mod move_vertex;
mod outside;
mod overlaps;
mod plan;
mod provenance;
mod pseudo_polygon;
mod recover;
mod recursion;
mod regions;
mod remove_segment;
mod split_crossings;
mod split_subsegment;
#[cfg(test)]
mod tests;
mod workspace;

pub use crate::drawing::SegmentId;
pub(crate) use by_cavity::SplitCavity;
pub use constrained_delaunay::ConstrainedDelaunay;
pub use constrained_triangulation::ConstrainedTriangulation;
pub use crossing_pairs::crossing_pairs;
pub use edit::Edit;
pub use error::{ConstraintError, CrossingPair};
pub(crate) use flat_hull::leave_out;
pub(crate) use input_sides::Beside;
pub use insert_segment::Crossings;
pub use legalising::Legalising;
pub use move_vertex::MoveError;
pub use plan::SegmentPlan;
pub use provenance::Provenance;
pub use pseudo_polygon::Filling;
pub(crate) use recover::{Changed, Recovery, Released, SplitLimits};
pub use recursion::{Recursion, RecursionCall};
pub use regions::RegionRule;
pub use split_subsegment::SplitError;
pub use workspace::Workspace;
