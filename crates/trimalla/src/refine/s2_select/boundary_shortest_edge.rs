//! `boundary-shortest-edge`: triangles with a side on the boundary first, then all others; each by the shortest edge.
//!
//! # Source
//! `[MeshSuite]` 4.3.

use super::shortest_sq::shortest_sq;
use crate::half_edge::FaceId;
use crate::refine::steps::{SelectStep, View};

/// Step 2, `boundary-shortest-edge`.
#[derive(Clone, Copy, Debug)]
pub(super) struct BoundaryShortestEdge;

/// A factor that makes every squared length less than those of other triangles, and keeps their order.
const FIRST: f64 = f64::from_bits((1023 - 110) << 52); // 2^-110

impl SelectStep for BoundaryShortestEdge {
    fn priority(&self, view: View<'_>, face: FaceId, _: u64) -> f64 {
        let on_boundary = face.half_edges().into_iter().any(|h| view.cdt.is_inner_side_of_boundary(h));
        shortest_sq(view, face) * if on_boundary { FIRST } else { 1.0 }
    }
}
