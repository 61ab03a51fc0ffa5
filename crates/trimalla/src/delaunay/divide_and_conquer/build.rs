//! From points to a triangulation: sort, drop duplicates, triangulate, convert.

use super::{MAX_POINTS, triangulate};
use crate::geometry::{Point, lexicographic};
use crate::half_edge::{HalfEdgeId, HalfEdgeMesh, NoJournal, VertexId};
use crate::triangulation::{Closure, Triangulation};

/// Triangulates `points[i]` for `i` in `subset` (all where `None`); ids are indices into `points`.
///
/// Equal points become one vertex, the one of lowest index.
pub(in crate::delaunay) fn build(points: &[Point], subset: Option<&[VertexId]>) -> Triangulation {
    let mut order: Vec<u32> = match subset {
        Some(s) => s.iter().map(|v| v.0).collect(),
        None => (0..points.len()).map(|i| VertexId::from_index(i).0).collect(),
    };
    debug_assert!(order.len() <= MAX_POINTS, "checked at the door");
    order.sort_unstable_by(|&a, &b| lexicographic(points[a as usize], points[b as usize]).then(a.cmp(&b)));
    let mut duplicates = Vec::new();
    order.dedup_by(|later, first| {
        let same = points[*later as usize] == points[*first as usize];
        if same {
            duplicates.push((VertexId(*later), VertexId(*first)));
        }
        same
    });
    duplicates.sort_unstable();
    let mut t = Triangulation::of_unused(points.to_vec());
    t.duplicates = duplicates;
    connect(&mut t, points, &order);
    t
}

fn connect(t: &mut Triangulation, points: &[Point], order: &[u32]) {
    if let [only] = *order {
        t.set_state(0, Closure::Hull, Some(VertexId(only)), &mut NoJournal);
    }
    if order.len() < 2 {
        return;
    }
    let arrays = triangulate(points, order).into_half_edges();
    let origin = arrays.origin.into_iter().map(VertexId).collect();
    let twin = arrays.twin.into_iter().map(HalfEdgeId).collect();
    t.mesh = HalfEdgeMesh::from_arrays(origin, twin, points.len());
    let dimension = if t.mesh.real_faces().next().is_some() { 2 } else { 1 };
    t.set_state(dimension, Closure::Hull, None, &mut NoJournal);
}
