//! From a triangulation to plain arrays.

use super::attributes::Attributes;
use super::pslg::Pslg;
use crate::constrained::ConstrainedDelaunay;
use crate::mesh::{FaceId, HalfEdgeId, VertexId};
use crate::triangulation::IndexedMesh;

/// Marker of edges and vertices that bound the domain where the input has no marker.
const BOUNDARY_MARKER: i32 = 1;

impl ConstrainedDelaunay {
    /// The mesh as plain arrays: vertices with markers and attributes, triangles, subsegments with markers.
    ///
    /// Input vertices come first, in order, bit for bit, also those that are unused; Steiner vertices follow in the
    /// order of their slots. Attributes are interpolated linearly: along the input segment, or in the triangulation of the
    /// input alone.
    ///
    /// # Complexity
    /// Linear.
    #[must_use]
    pub fn to_indexed(&self, pslg: &Pslg) -> IndexedMesh {
        let ids = self.output_ids();
        let kept: Vec<VertexId> =
            (0..self.points().len()).map(VertexId::from_index).filter(|v| ids[v.index()] != u32::MAX).collect();
        let id = |v: VertexId| ids[v.index()];
        let segments: Vec<HalfEdgeId> = self.marked_edges().collect();
        let segment_markers: Vec<i32> = segments.iter().map(|&h| self.edge_marker(h, pslg)).collect();
        let mut mesh = IndexedMesh {
            points: kept.iter().map(|&v| self.point(v)).collect(),
            triangles: self.real_faces().map(|f| self.face_vertices(f).map(id)).collect(),
            segments: segments.iter().map(|&h| [id(self.origin(h)), id(self.dest(h))]).collect(),
            segment_markers: segment_markers.clone(),
            attributes_per_point: pslg.attributes_per_point,
            holes: pslg.holes.clone(),
            input_points: self.input_points,
            ..IndexedMesh::default()
        };
        mesh.point_markers = self.point_markers(&kept, &segments, &segment_markers, pslg);
        mesh.point_attributes = Attributes::new(self, pslg).of(&kept);
        if !self.regions.is_empty() {
            let attribute = |f: FaceId| self.region_rule(f).map_or(0.0, |rule| rule.attribute);
            mesh.attributes_per_triangle = 1;
            mesh.triangle_attributes = self.real_faces().map(attribute).collect();
        }
        mesh
    }

    /// The output id of each vertex slot, `u32::MAX` for unused Steiner slots.
    fn output_ids(&self) -> Vec<u32> {
        let mut next = 0;
        (0..self.points().len())
            .map(VertexId::from_index)
            .map(|v| {
                if v.index() >= self.given_points && !self.is_used(v) {
                    return u32::MAX;
                }
                next += 1;
                next - 1
            })
            .collect()
    }

    /// The marker of a subsegment: that of its lowest segment with one; 1 on the border, 0 inside otherwise.
    fn edge_marker(&self, h: HalfEdgeId, pslg: &Pslg) -> i32 {
        let on_border = self.is_boundary(h) || self.is_boundary(self.twin(h));
        let given =
            self.segments_of(h).iter().filter_map(|&s| pslg.segment_markers.get(s as usize)).copied().find(|&m| m != 0);
        given.unwrap_or(if on_border { BOUNDARY_MARKER } else { 0 })
    }

    /// Input markers where given; otherwise that of a subsegment at the vertex, border ones first.
    fn point_markers(&self, kept: &[VertexId], segments: &[HalfEdgeId], markers: &[i32], pslg: &Pslg) -> Vec<i32> {
        let mut at = vec![0; self.points().len()];
        for on_border in [false, true] {
            for (&h, &m) in segments.iter().zip(markers) {
                if on_border == (self.is_boundary(h) || self.is_boundary(self.twin(h))) && m != 0 {
                    at[self.origin(h).index()] = m;
                    at[self.dest(h).index()] = m;
                }
            }
        }
        kept.iter()
            .map(|&v| match pslg.point_markers.get(v.index()) {
                Some(&m) if m != 0 => m,
                _ => at[v.index()],
            })
            .collect()
    }
}
