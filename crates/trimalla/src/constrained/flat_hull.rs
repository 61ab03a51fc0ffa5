//! Triangles at the convex hull that are flat but for rounding.
//!
//! ```text
//!          c                       a, c and b were meant to lie on one line. Rounded, c lies a few last places inside
//!     a ‾‾‾‾‾‾‾‾‾ b                the hull, and the triangle between has no angle that a mesh could keep.
//! ```
//!
//! A mesh leaves them out: the domain then ends at a–c–b. A Delaunay triangulation keeps them, as it is exact.

use super::constrained_triangulation::ConstrainedTriangulation;
use crate::geometry::{Segment, last_places};
use crate::half_edge::{HalfEdgeId, VertexId};

/// Marks the flat triangles at the hull as outside.
///
/// It stops at segments, and at a vertex that bounds the domain already: so the domain stays in one piece and keeps all
/// its vertices.
///
/// # Complexity
/// O(n log n) in the sides of the hull, and linear.
pub(crate) fn leave_out(cdt: &ConstrainedTriangulation, outside: &mut [bool]) {
    let mut bounds = vec![false; cdt.points().len()];
    let mut sides: Vec<([VertexId; 2], HalfEdgeId)> = Vec::new();
    for h in cdt.ghost_faces().filter_map(|f| cdt.ghost_edge(f)).map(|ghost| cdt.twin(ghost)) {
        let ends = [cdt.origin(h), cdt.dest(h)];
        ends.iter().for_each(|v| bounds[v.index()] = true);
        sides.push((ends, h));
    }
    // A vertex near two sides goes to the first: their order must not depend on slots.
    sides.sort_unstable();
    for (_, side) in sides {
        let [a, b] = cdt.edge_points(side);
        let segment = Segment::new(a, b);
        let mut inwards = vec![side];
        // Each face is marked once.
        while let Some(h) = inwards.pop() {
            let (face, apex) = (h.face().index(), cdt.apex(h));
            let is_flat = !cdt.is_marked(h) && !outside[face] && !bounds[apex.index()];
            if is_flat && segment.passes_within(last_places::ON_HULL, cdt.point(apex)) {
                outside[face] = true;
                bounds[apex.index()] = true;
                inwards.extend([cdt.twin(h.next()), cdt.twin(h.prev())]);
            }
        }
    }
}
