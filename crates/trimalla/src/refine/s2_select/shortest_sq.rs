//! The shortest edge of a triangle, for orders by length.

use crate::geometry::Point;
use crate::half_edge::FaceId;
use crate::refine::measure::ruler::Ruler;
use crate::refine::steps::View;

/// The square of the shortest edge of a face.
pub(super) fn shortest_sq(view: View<'_>, face: FaceId) -> f64 {
    shortest_sq_of(view.ruler, view.cdt.face_points(face))
}

/// The square of the shortest edge of a triangle: the same number whatever the order of its corners.
#[inline]
pub(super) fn shortest_sq_of(ruler: Ruler, [a, b, c]: [Point; 3]) -> f64 {
    let [a, b, c] = [a, b, c].map(|p| ruler.vector(Point::default(), p));
    let lesser = |x: f64, y: f64| if x < y { x } else { y };
    lesser(lesser((b - a).length_sq(), (c - b).length_sq()), (a - c).length_sq())
}
