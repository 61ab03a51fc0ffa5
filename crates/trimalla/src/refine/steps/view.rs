//! The data that a step may read.

use crate::constrained::ConstrainedTriangulation;
use crate::refine::measure::ruler::Ruler;
use crate::refine::recipe::options::Criteria;
use crate::size::SizeBounds;

/// The data that a step may read.
#[derive(Clone, Copy, Debug)]
pub struct View<'a> {
    /// The triangulation.
    pub cdt: &'a ConstrainedTriangulation,
    /// What makes a triangle bad.
    pub criteria: &'a Criteria,
    /// How large a triangle may be where.
    pub size: &'a SizeBounds,
    /// How lengths are measured.
    pub ruler: Ruler,
    /// A walk to a place for a new vertex crosses no more triangles than this.
    pub(in crate::refine) longest_walk: usize,
}

impl View<'_> {
    /// Triangles that a walk may cross where step 4 does not keep the circle test.
    ///
    /// Vertices may have any degree there: walks across their slivers get longer with the mesh, and a point so far away
    /// does not improve the triangle from which the walk started.
    const LONGEST_WALK: usize = 1 << 10;

    /// The number of triangles that a walk may cross, with or without the circle test.
    pub(in crate::refine) fn longest_walk(keeps_delaunay: bool) -> usize {
        if keeps_delaunay { usize::MAX } else { Self::LONGEST_WALK }
    }
}
