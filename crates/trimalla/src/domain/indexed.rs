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
        let kept = Kept::of(self);
        let points = kept.vertices().map(|v| self.point(v)).collect();
        let corners = self.real_triangles().map(|(_, corners)| corners.map(|v| kept.id(v)));
        let mut triangles = Vec::with_capacity(self.live_faces());
        triangles.extend(corners);
        IndexedMesh { points, triangles, ..self.indexed_around(pslg, &kept) }
    }

    /// [`to_indexed`](Self::to_indexed), which takes the memory over where all vertices are kept.
    #[must_use]
    pub fn into_indexed(mut self, pslg: &Pslg) -> IndexedMesh {
        let kept = Kept::of(&self);
        if matches!(kept, Kept::Some { .. }) {
            return self.to_indexed(pslg);
        }
        let mesh = self.indexed_around(pslg, &kept);
        IndexedMesh { points: std::mem::take(&mut self.t.points), triangles: self.t.mesh.into_triangles(), ..mesh }
    }

    /// All but points and triangles.
    fn indexed_around(&self, pslg: &Pslg, kept: &Kept) -> IndexedMesh {
        let segments: Vec<HalfEdgeId> = self.marked_edges().collect();
        let segment_markers: Vec<i32> = segments.iter().map(|&h| self.edge_marker(h, pslg)).collect();
        let mut mesh = IndexedMesh {
            segments: segments.iter().map(|&h| [self.origin(h), self.dest(h)].map(|v| kept.id(v))).collect(),
            segment_markers: segment_markers.clone(),
            attributes_per_point: pslg.attributes_per_point,
            holes: pslg.holes.clone(),
            input_points: self.input_points,
            ..IndexedMesh::default()
        };
        mesh.point_markers = self.point_markers(kept, &segments, &segment_markers, pslg);
        mesh.point_attributes = Attributes::new(self, pslg).of(kept.vertices());
        if !self.regions.is_empty() {
            let attribute = |f: FaceId| self.region_rule(f).map_or(0.0, |rule| rule.attribute);
            mesh.attributes_per_triangle = 1;
            mesh.triangle_attributes = self.real_faces().map(attribute).collect();
        }
        mesh
    }

    /// The marker of a subsegment: that of its lowest segment with one; 1 on the border, 0 inside otherwise.
    fn edge_marker(&self, h: HalfEdgeId, pslg: &Pslg) -> i32 {
        let on_border = self.is_boundary(h) || self.is_boundary(self.twin(h));
        let given =
            self.segments_of(h).iter().filter_map(|&s| pslg.segment_markers.get(s as usize)).copied().find(|&m| m != 0);
        given.unwrap_or(if on_border { BOUNDARY_MARKER } else { 0 })
    }

    /// Input markers where given; otherwise that of a subsegment at the vertex, border ones first.
    fn point_markers(&self, kept: &Kept, segments: &[HalfEdgeId], markers: &[i32], pslg: &Pslg) -> Vec<i32> {
        let mut at = vec![0; self.points().len()];
        for on_border in [false, true] {
            for (&h, &m) in segments.iter().zip(markers) {
                if on_border == (self.is_boundary(h) || self.is_boundary(self.twin(h))) && m != 0 {
                    at[self.origin(h).index()] = m;
                    at[self.dest(h).index()] = m;
                }
            }
        }
        for (marker, &given) in at.iter_mut().zip(&pslg.point_markers) {
            *marker = if given != 0 { given } else { *marker };
        }
        match kept {
            Kept::All { .. } => at,
            Kept::Some { vertices, .. } => vertices.iter().map(|v| at[v.index()]).collect(),
        }
    }
}

/// The vertices that a mesh as plain arrays has: all but unused Steiner slots.
enum Kept {
    All {
        count: usize,
    },
    /// Those kept, and the output id of each slot.
    Some {
        vertices: Vec<VertexId>,
        ids: Vec<u32>,
    },
}

impl Kept {
    fn of(cdt: &ConstrainedDelaunay) -> Self {
        let count = cdt.points().len();
        let is_kept = |v: &VertexId| v.index() < cdt.given_points || cdt.is_used(*v);
        let slots = || (0..count).map(VertexId::from_index);
        if slots().all(|v| is_kept(&v)) {
            return Self::All { count };
        }
        let vertices: Vec<VertexId> = slots().filter(is_kept).collect();
        let mut ids = vec![u32::MAX; count];
        for (id, v) in (0..).zip(&vertices) {
            ids[v.index()] = id;
        }
        Self::Some { vertices, ids }
    }

    /// The output id of a vertex.
    fn id(&self, v: VertexId) -> u32 {
        match self {
            Self::All { .. } => v.0,
            Self::Some { ids, .. } => ids[v.index()],
        }
    }

    /// The vertices, by output id.
    fn vertices(&self) -> impl ExactSizeIterator<Item = VertexId> + '_ {
        let (count, some) = match self {
            Self::All { count } => (*count, None),
            Self::Some { vertices, .. } => (vertices.len(), Some(vertices)),
        };
        (0..count).map(move |i| some.map_or(VertexId::from_index(i), |vertices| vertices[i]))
    }
}
