//! From a triangulation to plain arrays.

use super::attributes::Attributes;
use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation};
use crate::drawing::{IndexedMesh, Pslg, SegmentId};
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};

/// Marker of edges and vertices that bound the domain where the input has no marker.
const BOUNDARY_MARKER: i32 = 1;

impl ConstrainedTriangulation {
    /// The mesh as plain arrays: vertices with markers and attributes, triangles, subsegments with markers.
    ///
    /// Input vertices come first, in order, bit for bit, also those that are unused; Steiner vertices follow in the
    /// order of their slots. Subsegments come in the order of the input's segments, from end to end. Attributes are
    /// interpolated linearly: along the input segment, or in the triangulation of the input alone.
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

    /// [`to_indexed`](Self::to_indexed) that reuses the allocations if all vertices are kept.
    #[must_use]
    pub fn into_indexed(self, pslg: &Pslg) -> IndexedMesh {
        let kept = Kept::of(&self);
        if matches!(kept, Kept::Some { .. }) {
            return self.to_indexed(pslg);
        }
        let mesh = self.indexed_around(pslg, &kept);
        let (points, triangles) = self.into_triangulation().into_points_and_triangles();
        IndexedMesh { points, triangles, ..mesh }
    }

    /// The mesh without its points and triangles.
    fn indexed_around(&self, pslg: &Pslg, kept: &Kept) -> IndexedMesh {
        let subsegments = self.subsegments(pslg);
        let mut mesh = IndexedMesh {
            segments: subsegments.iter().map(|s| s.ends.map(|v| kept.id(v))).collect(),
            segment_markers: subsegments.iter().map(|s| s.marker).collect(),
            attributes_per_point: pslg.attribute_width(),
            holes: pslg.holes.clone(),
            input_points: self.input_points(),
            ..IndexedMesh::default()
        };
        mesh.point_markers = self.point_markers(kept, &subsegments, pslg);
        mesh.point_attributes = Attributes::new(self, pslg).of(kept.vertices());
        if !self.regions().is_empty() {
            let attribute = |f: FaceId| self.region_rule(f).map_or(0.0, |rule| rule.attribute);
            mesh.attributes_per_triangle = 1;
            mesh.triangle_attributes = self.real_faces().map(attribute).collect();
        }
        mesh
    }

    /// All subsegments in the order of the input's segments, those of a segment from its start to its end, and so
    /// directed. Where segments overlap, the lowest counts.
    ///
    /// # Complexity
    /// Linear, and a sort of each segment's pieces.
    fn subsegments(&self, pslg: &Pslg) -> Vec<Subsegment> {
        let markers = if pslg.segment_markers.iter().all(|&m| m == 0) { &[][..] } else { &pslg.segment_markers };
        let count = self.segments().len();
        // Until the subsegments are in order each place holds where those of its segment start, after that where they
        // end. Those of no segment come last.
        let mut places = vec![0_usize; count + 2];
        let mut found = Vec::new();
        // A loop instead of `collect`: the nested iterators would compile to a state machine. Subsegments are looked at
        // in the order of slots: in the order of segments each would wait for its faces.
        self.for_each_marked_edge(|h| {
            let segment = self.first_segment_of(h);
            let place = segment.map_or(count, SegmentId::index);
            places[place + 1] += 1;
            found.push((place as u32, self.subsegment(h, segment, markers)));
        });
        for i in 0..=count {
            places[i + 1] += places[i];
        }
        let mut sorted = vec![Subsegment::NONE; found.len()];
        for (place, subsegment) in found {
            let at = &mut places[place as usize];
            sorted[*at] = subsegment;
            *at += 1;
        }
        let mut start = 0;
        for &end in &places[..=count] {
            if end - start > 1 {
                sorted[start..end]
                    .sort_unstable_by(|a, b| a.along.total_cmp(&b.along).then_with(|| a.ends.cmp(&b.ends)));
            }
            start = end;
        }
        sorted
    }

    /// The subsegment of an edge. Its marker is that of its lowest segment with a marker other than 0; else 1 on the
    /// boundary, 0 inside.
    fn subsegment(&self, h: HalfEdgeId, segment: Option<SegmentId>, markers: &[i32]) -> Subsegment {
        let on_boundary = self.is_boundary_edge(h);
        let marker_of = |s: SegmentId| markers.get(s.index()).copied().filter(|&m| m != 0);
        // Nearly always the first has one.
        let given = segment.filter(|_| !markers.is_empty()).and_then(|first| {
            let others = || self.segments_of(h).into_iter().find_map(marker_of);
            marker_of(first).or_else(others)
        });
        let marker = given.unwrap_or(if on_boundary { BOUNDARY_MARKER } else { 0 });
        let mut ends = [self.origin(h), self.dest(h)];
        let mut along = 0.0;
        if let Some(segment) = segment {
            let places = ends.map(|v| self.parameter(segment, v));
            along = places[0].min(places[1]);
            if places[1] < places[0] {
                ends.reverse();
            }
        } else {
            ends.sort_unstable();
        }
        Subsegment { ends, along, on_boundary, marker }
    }

    /// Input markers where given; otherwise that of a subsegment at the vertex, boundary ones first.
    fn point_markers(&self, kept: &Kept, subsegments: &[Subsegment], pslg: &Pslg) -> Vec<i32> {
        let mut at = vec![0; self.points().len()];
        for on_boundary in [false, true] {
            for s in subsegments.iter().filter(|s| s.on_boundary == on_boundary && s.marker != 0) {
                s.ends.iter().for_each(|v| at[v.index()] = s.marker);
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

impl ConstrainedDelaunay {
    /// [`to_indexed`](ConstrainedTriangulation::to_indexed) that reuses the allocations if all vertices are kept.
    #[must_use]
    pub fn into_indexed(self, pslg: &Pslg) -> IndexedMesh {
        ConstrainedTriangulation::from(self).into_indexed(pslg)
    }
}

/// A subsegment as plain arrays have it.
#[derive(Clone, Copy, Debug)]
struct Subsegment {
    /// In the direction of its segment.
    ends: [VertexId; 2],
    /// The parameter on the lowest segment that it is part of at which it starts.
    along: f64,
    on_boundary: bool,
    marker: i32,
}

impl Subsegment {
    /// A placeholder.
    const NONE: Self = Self { ends: [VertexId::INFINITE; 2], along: 0.0, on_boundary: false, marker: 0 };
}

/// The vertices that a mesh as plain arrays has: all but unused Steiner slots.
enum Kept {
    All {
        count: usize,
    },
    /// The kept vertices, and the output id of each slot.
    Some {
        vertices: Vec<VertexId>,
        ids: Vec<u32>,
    },
}

impl Kept {
    fn of(cdt: &ConstrainedTriangulation) -> Self {
        let count = cdt.points().len();
        let is_kept = |v: &VertexId| v.index() < cdt.given_points() || cdt.is_used(*v);
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
