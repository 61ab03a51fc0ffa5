//! Scratch of operations, kept from one to the next.

use super::apply::Corridor;
use super::plan::SegmentPlan;
use super::pseudo_polygon::Filling;
use crate::delaunay::{Cavity, Lawson};
use crate::half_edge::FaceId;

/// Scratch lists of the operations on a [`ConstrainedTriangulation`](super::ConstrainedTriangulation), so that none
/// allocates, and the face at which the next point location starts.
///
/// Nothing in it but [`set_filling`](Self::set_filling) changes what an operation does: one workspace serves any number
/// of triangulations, and a new one is as good as an old one.
#[derive(Clone, Debug)]
pub struct Workspace {
    /// Edges to be tested by the circle test.
    pub(super) lawson: Lawson,
    /// The faces that a new vertex replaces.
    pub(super) cavity: Cavity,
    /// What a segment crosses.
    pub(super) plan: Option<Box<SegmentPlan>>,
    /// The faces that a segment replaces.
    pub(super) corridor: Corridor,
    /// Where a search begins.
    pub(super) hint: FaceId,
    /// How regions beside new segments are filled.
    pub(super) filling: Filling,
}

impl Default for Workspace {
    fn default() -> Self {
        Self {
            lawson: Lawson::default(),
            cavity: Cavity::default(),
            plan: None,
            corridor: Corridor::default(),
            hint: FaceId(0),
            filling: Filling::default(),
        }
    }
}

impl Workspace {
    /// Chooses how regions beside new segments are filled; the result does not depend on it.
    pub fn set_filling(&mut self, filling: Filling) {
        self.filling = filling;
    }
}
