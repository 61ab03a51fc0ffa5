//! All triangles with their corners, read block by block.
//!
//! Vertices keep the caller's order, so that the corners of a triangle may lie anywhere in memory. Whoever tests one triangle
//! after the other waits for the corners of nearly each; those of a block, read before any of them is tested, arrive side by
//! side.

use super::triangulation::{Triangulation, from_newest};
use crate::geometry::Point;
use crate::mesh::{FaceId, VertexId};

/// Triangles in a block.
const BLOCK: usize = 64;

/// A real face with its corners.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TriangleInBlock {
    pub(crate) face: FaceId,
    pub(crate) vertices: [VertexId; 3],
    /// Where they lie.
    pub(crate) corners: [Point; 3],
}

impl TriangleInBlock {
    const NONE: Self = Self { face: FaceId(0), vertices: [VertexId::DEAD; 3], corners: [Point::new(0.0, 0.0); 3] };

    /// The corners from that of the newest vertex on, as [`Triangulation::corners_from_newest`].
    #[inline(always)] // In the loop over all triangles.
    pub(crate) fn corners_from_newest(&self) -> [Point; 3] {
        from_newest(self.vertices, self.corners)
    }
}

impl Triangulation {
    /// Calls `look` with every triangle, in the order of slots.
    ///
    /// # Complexity
    /// Linear.
    #[inline]
    pub(crate) fn for_each_triangle(&self, mut look: impl FnMut(&TriangleInBlock)) {
        let mut block = [TriangleInBlock::NONE; BLOCK];
        let mut triangles = self.mesh.real_triangles();
        loop {
            let mut read = 0;
            for (place, (face, vertices)) in block.iter_mut().zip(&mut triangles) {
                *place = TriangleInBlock { face, vertices, corners: vertices.map(|v| self.point(v)) };
                read += 1;
            }
            for triangle in &block[..read] {
                look(triangle);
            }
            if read < BLOCK {
                return;
            }
        }
    }
}
