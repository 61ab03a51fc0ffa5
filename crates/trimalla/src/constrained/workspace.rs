//! Lists and places that operations work with, kept from one to the next.

use super::apply::Corridor;
use super::plan::SegmentPlan;
use super::pseudo_polygon::Filling;
use crate::delaunay::{Cavity, Lawson};
use crate::half_edge::FaceId;

/// What operations on a [`ConstrainedTriangulation`](super::ConstrainedTriangulation) work with: lists, so that none
/// allocates, and the face at which a search begins.
///
/// Nothing in it changes what an operation does, but [`set_filling`](Self::set_filling): one workspace serves any
/// number of triangulations, and a new one is as good as an old one.
#[derive(Clone, Debug)]
pub struct Workspace {
    /// Edges that wait for the circle test.
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
    /// Chooses how regions beside new segments are filled: the result is the same.
    pub fn set_filling(&mut self, filling: Filling) {
        self.filling = filling;
    }
}
