//! From points to a triangulation: sort, drop duplicates, triangulate, convert.

use super::super::sites::Sites;
use super::{MAX_POINTS, triangulate};
use crate::geometry::Point;
use crate::half_edge::{HalfEdgeId, HalfEdgeMesh, VertexId};
use crate::triangulation::Triangulation;

/// Triangulates `points[i]` for `i` in `subset` (all where `None`); ids are indices into `points`.
///
/// Equal points become one vertex, the one of lowest index.
pub(in crate::delaunay) fn build(points: &[Point], subset: Option<&[VertexId]>) -> Triangulation {
    let sites = Sites::gather(points, subset);
    debug_assert!(sites.order.len() <= MAX_POINTS, "checked at the door");
    if sites.order.len() < 2 {
        return sites.close(points, None);
    }
    let arrays = triangulate(points, &sites.order).into_half_edges();
    let origin = arrays.origin.into_iter().map(VertexId).collect();
    let twin = arrays.twin.into_iter().map(HalfEdgeId).collect();
    let mesh = HalfEdgeMesh::from_arrays(origin, twin, points.len());
    sites.close(points, Some(mesh))
}
