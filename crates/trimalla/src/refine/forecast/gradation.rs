//! Sources of a graded size field: how large features are, and how small triangles are asked to be.
//!
//! A refinement makes small triangles at small features. Away from them they grow as fast as good angles allow. With
//! sources of their sizes at all features the growth is bounded: see [`Graded`](crate::size::Graded).

use super::feet::Footed;
use super::sizes::Sizes;
use crate::constrained::ConstrainedTriangulation;
use crate::geometry::Segment;
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};
use crate::refine::criteria::floors::{length_floor, precision_floor};
use crate::refine::recipe::options::RefineOptions;
use crate::size::{SizeBounds, SizeField, SizeSource, TriangleInRegion};

/// The sizes of features, and those that the bounds ask for at vertices and along segments, none of which is larger
/// than another one plus `growth` times their distance along edges of the triangulation.
///
/// # Complexity
/// That of the [`forecast()`](super::forecast()).
pub(crate) fn gradation(
    cdt: &ConstrainedTriangulation,
    options: &RefineOptions,
    size: &SizeBounds,
    growth: f64,
) -> Vec<SizeSource> {
    let footed = Footed::of(cdt);
    let bounds = cdt.bounding_box();
    let (floor, _) = length_floor(bounds, options, footed.ruler);
    let (precision, scale) = (precision_floor(bounds, footed.ruler), footed.ruler.scale());
    let cdt = &footed.cdt;
    let length_in = |f: FaceId| size.bound(&TriangleInRegion::of(cdt, f)).edge();
    let asked = least_at_vertices(cdt, length_in);
    let sizes = Sizes::under(&footed, growth, floor, precision, |v| scale * asked[v.index()]);
    let at_vertices = cdt.used_vertices().map(|v| SizeSource::at(cdt.point(v), sizes.at(v) / scale));
    // Between two vertices far apart a segment may bound a region with small triangles.
    let along_segments = cdt.edges().filter(|&h| cdt.is_marked(h)).map(|h| {
        let sides = [h.face(), cdt.twin(h).face()].into_iter().filter(|&f| cdt.is_real(f));
        SizeSource::along(segment_of(cdt, h), sides.map(length_in).fold(f64::INFINITY, f64::min))
    });
    at_vertices.chain(along_segments).filter(|source| source.length > 0.0 && source.length.is_finite()).collect()
}

/// For each vertex the least length that is asked for in a face at it.
fn least_at_vertices(cdt: &ConstrainedTriangulation, length_in: impl Fn(FaceId) -> f64) -> Vec<f64> {
    let mut least = vec![f64::INFINITY; cdt.points().len()];
    for f in cdt.real_faces() {
        let length = length_in(f);
        for v in cdt.face_vertices(f) {
            let known: &mut f64 = &mut least[VertexId::index(v)];
            *known = known.min(length);
        }
    }
    least
}

fn segment_of(cdt: &ConstrainedTriangulation, h: HalfEdgeId) -> Segment {
    let [a, b] = cdt.edge_points(h);
    Segment::new(a, b)
}
