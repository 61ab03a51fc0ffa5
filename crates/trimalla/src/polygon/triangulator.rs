//! Many polygons, one after the other.

use super::corners::Corners;
use super::stack::{Stacks, Triangles};
use super::sweep::Sweep;
use super::{Polygon, PolygonError};
use crate::trace::{NoTrace, Trace};

/// Triangulates polygons, and keeps its memory from one to the next.
#[derive(Clone, Debug, Default)]
pub struct Triangulator {
    corners: Corners,
    sweep: Sweep,
    stacks: Stacks,
    triangles: Vec<[u32; 3]>,
}

impl Triangulator {
    /// A triangulator without memory.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Triangulates a polygon.
    ///
    /// # Errors
    /// Sides that cross or overlap.
    pub fn triangulate(&mut self, polygon: Polygon<'_>) -> Result<&[[u32; 3]], PolygonError> {
        self.by_sweep(polygon, &mut NoTrace)?;
        Ok(&self.triangles)
    }

    fn by_sweep(&mut self, polygon: Polygon<'_>, trace: &mut (impl Trace + ?Sized)) -> Result<(), PolygonError> {
        self.triangles.clear();
        self.corners.fill(polygon)?;
        self.triangles.reserve(self.corners.count + 2 * self.corners.ring_count);
        self.sweep.run(&mut self.corners, &mut Triangles::new(&mut self.stacks, &mut self.triangles, trace))
    }
}
