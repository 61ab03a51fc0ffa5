//! All triangles with their corners, read block by block.
//!
//! Vertices keep the caller's order, so that the corners of a triangle lie anywhere in memory. A loop that tests one
//! triangle at a time waits for a cache miss at nearly each. Loading the corners of a block of triangles before testing
//! any of them lets the misses overlap.

use super::triangulation::Triangulation;
use crate::geometry::Point;
use crate::half_edge::FaceId;

/// Triangles in a block.
const BLOCK: usize = 64;

/// A real face with its corners.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TriangleInBlock {
    pub(crate) face: FaceId,
    /// The coordinates of its vertices.
    pub(crate) corners: [Point; 3],
}

impl TriangleInBlock {
    const NONE: Self = Self { face: FaceId(0), corners: [Point::new(0.0, 0.0); 3] };
}

/// The first, the second and the third corners of two triangles.
#[inline(always)] // In loops over all triangles.
pub(crate) fn corners_of_two([s, t]: &[TriangleInBlock; 2]) -> [[Point; 2]; 3] {
    [0, 1, 2].map(|i| [s.corners[i], t.corners[i]])
}

impl Triangulation {
    /// Calls `look` with the triangles two at a time, in the order of slots, so that it can measure both at once, and
    /// with how many there are: the last call may have one only, and anything in the place of the second.
    ///
    /// # Complexity
    /// Linear.
    #[inline]
    pub(crate) fn for_each_two_triangles(&self, mut look: impl FnMut(&[TriangleInBlock; 2], usize)) {
        let mut block = [[TriangleInBlock::NONE; 2]; BLOCK / 2];
        let mut triangles = self.mesh.real_triangles();
        loop {
            let mut read = 0_usize;
            for (place, (face, vertices)) in block.as_flattened_mut().iter_mut().zip(&mut triangles) {
                *place = TriangleInBlock { face, corners: vertices.map(|v| self.point(v)) };
                read += 1;
            }
            for (k, two) in block[..read.div_ceil(2)].iter().enumerate() {
                look(two, (read - 2 * k).min(2));
            }
            if read < BLOCK {
                return;
            }
        }
    }

    /// Calls `look` with real faces, in this order, and their corners from that of the newest vertex on.
    #[inline]
    pub(crate) fn for_each_with_corners(&self, faces: &[FaceId], mut look: impl FnMut(FaceId, [Point; 3])) {
        let mut corners = [[Point::default(); 3]; BLOCK];
        for block in faces.chunks(BLOCK) {
            for (place, &f) in corners.iter_mut().zip(block) {
                *place = self.corners_from_newest(f);
            }
            for (&corners, &f) in corners.iter().zip(block) {
                look(f, corners);
            }
        }
    }
}
