//! Attributes of Steiner vertices.
//!
//! On a segment they are interpolated between its ends; free vertices take theirs from the triangle of the input's own
//! constrained triangulation in which they lie. So a function that is linear over the drawing is kept, and every value
//! lies within the range of those around it.

use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, Crossings, Provenance};
use crate::drawing::{Pslg, SegmentId};
use crate::geometry::{Point, Segment, Triangle};
use crate::half_edge::{FaceId, VertexId};
use crate::locate::Locus;

/// Computes attributes of vertices from those of the input.
pub(super) struct Attributes<'a> {
    mesh: &'a ConstrainedTriangulation,
    pslg: &'a Pslg,
    /// The constrained triangulation of the input alone, if there are free vertices.
    base: Option<ConstrainedDelaunay>,
}

impl<'a> Attributes<'a> {
    /// # Complexity
    /// That of triangulating the input, where it has attributes.
    pub(super) fn new(mesh: &'a ConstrainedTriangulation, pslg: &'a Pslg) -> Self {
        let wanted = pslg.attribute_width() > 0 && mesh.steiner_vertices() > 0;
        let base = wanted.then(|| ConstrainedDelaunay::new(&pslg.points, &pslg.segments, Crossings::Split).ok());
        Self { mesh, pslg, base: base.flatten() }
    }

    /// The attributes of vertices, row after row.
    pub(super) fn of(&self, kept: impl ExactSizeIterator<Item = VertexId>) -> Vec<f64> {
        let n = self.pslg.attribute_width();
        let mut rows = vec![0.0; if n == 0 { 0 } else { kept.len().saturating_mul(n) }];
        let mut near = FaceId(0);
        for (row, v) in rows.chunks_mut(n.max(1)).zip(kept) {
            match (&self.base, self.along_segment(self.mesh, v)) {
                (_, Some(stretch)) => self.write(row, &stretch),
                (Some(base), None) => self.write(row, &self.inside(base, &mut near, self.mesh.point(v))),
                (None, None) => {}
            }
        }
        rows
    }

    /// Writes weighted sums of input rows.
    fn write(&self, row: &mut [f64], weights: &[(VertexId, f64)]) {
        let n = self.pslg.attribute_width();
        let given = |v: VertexId, k: usize| self.pslg.point_attributes.get(v.index() * n + k).copied().unwrap_or(0.0);
        for (k, value) in row.iter_mut().enumerate() {
            // A single weight copies the bits.
            *value = match weights {
                [(v, _)] => given(*v, k),
                _ => {
                    let values = || weights.iter().map(|&(v, _)| given(v, k));
                    let (least, most) =
                        values().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
                    let sum: f64 = weights.iter().map(|&(v, w)| w * given(v, k)).sum();
                    if least <= most { sum.clamp(least, most) } else { sum }
                }
            };
        }
    }

    /// Weights of input vertices for a vertex of the input or on one of its segments.
    fn along_segment(&self, cdt: &ConstrainedTriangulation, v: VertexId) -> Option<Vec<(VertexId, f64)>> {
        let between = |segment: SegmentId, t: f64| {
            let [a, b] = cdt.segments()[segment.index()];
            vec![(a, 1.0 - t), (b, t)]
        };
        if v.index() < self.pslg.points.len() {
            return Some(vec![(v, 1.0)]);
        }
        match cdt.provenance(v) {
            Provenance::OnSegment { segment, t } | Provenance::Shell { segment, t, .. } => Some(between(segment, t)),
            Provenance::Crossing { segments: [s, _] } => Some(between(s, cdt.parameter(s, v))),
            _ => None,
        }
    }

    /// Weights of input vertices for a point among them.
    fn inside(&self, base: &ConstrainedTriangulation, near: &mut FaceId, p: Point) -> Vec<(VertexId, f64)> {
        let corners: Vec<(VertexId, f64)> = match base.locate_from(*near, p) {
            Locus::Vertex(v) => vec![(v, 1.0)],
            Locus::Edge(h) => {
                let [a, b] = base.edge_points(h);
                let t = Segment::new(a, b).parameter_of(p);
                vec![(base.origin(h), 1.0 - t), (base.dest(h), t)]
            }
            Locus::Face(f) => {
                *near = f;
                base.face_vertices(f).into_iter().zip(barycentric(base.face_points(f), p)).collect()
            }
            _ => Vec::new(),
        };
        // Corners where segments cross are made of input vertices themselves.
        let resolved = corners.into_iter().flat_map(|(v, w)| {
            let parts = self.along_segment(base, v).unwrap_or_default();
            parts.into_iter().map(move |(u, share)| (u, w * share))
        });
        resolved.collect()
    }
}

/// The weights of three corners for a point in their triangle: they add up to 1.
fn barycentric([a, b, c]: [Point; 3], p: Point) -> [f64; 3] {
    let areas = [(b, c), (c, a), (a, b)].map(|(q, r)| Triangle::new(q, r, p).area());
    let total: f64 = areas.iter().sum();
    if total > 0.0 && total.is_finite() { areas.map(|area| area / total) } else { [1.0 / 3.0; 3] }
}
