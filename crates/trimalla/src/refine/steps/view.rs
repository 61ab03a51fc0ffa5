//! What a step may look at.

use crate::constrained::ConstrainedTriangulation;
use crate::refine::measure::ruler::Ruler;
use crate::refine::recipe::options::Criteria;
use crate::size::SizeBounds;

/// What a step may look at.
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
    /// Vertices may have any degree there: walks across their slivers get longer with the mesh, and what lies so far
    /// off is no help for the triangle that the walk began at.
    const LONGEST_WALK: usize = 1 << 10;

    /// How many triangles a walk may cross with that step 4.
    pub(in crate::refine) fn longest_walk(keeps_delaunay: bool) -> usize {
        if keeps_delaunay { usize::MAX } else { Self::LONGEST_WALK }
    }
}
