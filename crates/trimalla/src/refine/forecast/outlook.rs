//! The outlook: what is known of a refinement before it begins.

use super::{Feature, Forecast, Gap, extent_of, forecast_under};
use crate::constrained::{ConstrainedTriangulation, Provenance};
use crate::geometry::{Angle, Point, Segment};
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};
use crate::quality::{AngleCeiling, InputAngle, angle_ceiling, shell_floor, smallest_input_angle};
use crate::refine::criteria::floors::precision_floor;
use crate::refine::measure::joints::{Joints, common_end};
use crate::refine::measure::ruler::Ruler;
use crate::refine::recipe::Preset;
use crate::refine::recipe::options::{Protect, RefineOptions};
use crate::size::SizeBounds;
use crate::triangulation::corners_of_two;

/// The largest bound for which the angle floor is proved, in degrees.
///
/// # Source
/// `[MillerPavWalkington03]`.
const PROVED_DEG: f64 = 26.45;

/// The outlook: what is known of a refinement before it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outlook {
    /// How large the mesh will be.
    pub forecast: Forecast,
    /// The smallest angle that no mesh can exceed; `None` for a triangulation without triangles.
    pub angle_ceiling: Option<AngleCeiling>,
    /// The smallest angle between two segments.
    pub smallest_input_angle: Option<InputAngle>,
    /// The two nearest features that lie within rounding of each other: no vertex fits between them, and triangles
    /// there stay as they are. Two segments that leave a vertex that close together are an input angle, unless one of
    /// them ends there.
    pub within_rounding: Option<Gap>,
}

impl Outlook {
    /// The outlook of a carved triangulation.
    ///
    /// # Complexity
    /// That of the [`forecast()`](crate::refine::forecast()).
    #[must_use]
    pub fn of(cdt: &ConstrainedTriangulation, options: &RefineOptions) -> Self {
        Self::under(cdt, options, &SizeBounds::new(options.criteria.max_area, cdt, Vec::new()))
    }

    /// Like [`of`](Self::of), under these bounds on sizes, which include the area bound of the options.
    pub(in crate::refine) fn under(cdt: &ConstrainedTriangulation, options: &RefineOptions, size: &SizeBounds) -> Self {
        Self {
            forecast: forecast_under(cdt, options, size),
            angle_ceiling: angle_ceiling(cdt),
            smallest_input_angle: smallest_input_angle(cdt),
            within_rounding: within_rounding(cdt),
        }
    }

    /// The angle below which no angle of the finished mesh need be, the [`shell_floor`], where its argument holds: for
    /// the preset `circumcenter` at bounds of up to 26.45 degrees, without an area bound, length floor, protected
    /// segments, or features within rounding of each other.
    ///
    /// # Source
    /// `[MillerPavWalkington03]`.
    #[must_use]
    pub fn angle_floor(&self, options: &RefineOptions) -> Option<Angle> {
        let is_proved = options.recipe == Preset::Circumcenter.recipe()
            && options.criteria.min_angle.degrees() <= PROVED_DEG
            && options.criteria.max_area.is_none()
            && options.limits.length_floor.is_none()
            && options.protect == Protect::None
            && self.within_rounding.is_none();
        self.smallest_input_angle.filter(|_| is_proved).map(|input| shell_floor(input.angle))
    }
}

/// The nearest two features that lie within rounding of each other; of equally near pairs the one with the lowest
/// vertices.
///
/// # Complexity
/// Linear.
fn within_rounding(cdt: &ConstrainedTriangulation) -> Option<Gap> {
    let bounds = cdt.bounding_box();
    let ruler = Ruler::for_box(bounds);
    let precision = precision_floor(bounds, ruler);
    let precision_sq = precision * precision;
    let mut joints = None;
    let mut nearest: Option<(f64, [VertexId; 2], HalfEdgeId)> = None;
    let mut note = |width: f64, vertices: [VertexId; 2], h: HalfEdgeId| {
        if nearest.is_none_or(|(known, named, _)| (width, vertices) < (known, named)) {
            nearest = Some((width, vertices, h));
        }
    };
    let largest = precision / ruler.scale();
    let is_close = |p: Point, q: Point| ((p.x - q.x).abs() < largest) & ((p.y - q.y).abs() < largest);
    let mut candidates: Vec<FaceId> = Vec::new();
    cdt.for_each_two_triangles(|two, count| {
        let [a, b, c] = corners_of_two(two);
        for (k, triangle) in two[..count].iter().enumerate() {
            let has_close = is_close(a[k], b[k]) | is_close(b[k], c[k]) | is_close(c[k], a[k]);
            if has_close || triangle.face.half_edges().into_iter().any(|h| cdt.is_marked(h)) {
                candidates.push(triangle.face);
            }
        }
    });
    for h in candidates.into_iter().flat_map(FaceId::half_edges) {
        let [p, q] = cdt.edge_points(h);
        let length_sq = ruler.length_sq(p, q);
        let ends = || [cdt.origin(h).min(cdt.dest(h)), cdt.origin(h).max(cdt.dest(h))];
        if length_sq < precision_sq {
            note(length_sq.sqrt(), ends(), h);
        }
        if cdt.is_marked(h) {
            // An end of the edge that is as near takes precedence.
            let apex = || cdt.point(cdt.apex(h));
            let is_at_end = || cdt.edge_points(h).into_iter().any(|end| ruler.length_sq(end, apex()) < precision_sq);
            let width = distance_beside(cdt, ruler, h).filter(|&width| width < precision && !is_at_end());
            let is_free = |joints: &mut Option<Joints>| {
                if cdt.provenance(cdt.apex(h)) == Provenance::Input {
                    return true;
                }
                let joints = joints.get_or_insert_with(|| Joints::of(cdt));
                !lies_in_a_wedge(cdt, joints, h)
            };
            if let Some(width) = width.filter(|_| is_free(&mut joints)) {
                note(width, [cdt.apex(h), ends()[0]], h);
            }
        }
    }
    let (width, [one, other], h) = nearest?;
    let is_vertex = [cdt.origin(h), cdt.dest(h)].contains(&one);
    let segment = || cdt.first_segment_of(h).map_or(Feature::Hull, Feature::Segment);
    let second = if is_vertex { Feature::Vertex(other) } else { segment() };
    let width = if is_vertex { Segment::new(cdt.point(one), cdt.point(other)).length() } else { width / ruler.scale() };
    let relative_width = width / extent_of(bounds);
    Some(Gap { width, relative_width, at: cdt.point(one), between: [Feature::Vertex(one), second] })
}

/// The distance of the apex of `h` from `h`, if the apex lies beside `h`.
fn distance_beside(cdt: &ConstrainedTriangulation, ruler: Ruler, h: HalfEdgeId) -> Option<f64> {
    let [a, b] = cdt.edge_points(h);
    let (along, to_apex) = (ruler.vector(a, b), ruler.vector(a, cdt.point(cdt.apex(h))));
    let (length_sq, dot) = (along.length_sq(), along.dot(to_apex));
    (0.0 < dot && dot < length_sq).then(|| along.cross(to_apex).abs() / length_sq.sqrt())
}

/// Whether the apex of `h` is on a piece of a segment that shares an end with the piece of `h`.
fn lies_in_a_wedge(cdt: &ConstrainedTriangulation, joints: &Joints, h: HalfEdgeId) -> bool {
    let piece = joints.whole_of(cdt, h);
    let mut at_apex = cdt.edges_around(cdt.apex(h)).filter(|&g| cdt.is_marked(g));
    at_apex.any(|g| common_end(piece, joints.whole_of(cdt, g)).is_some())
}
