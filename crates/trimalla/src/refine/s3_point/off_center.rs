//! `off-center`: the circumcenter, or a point nearer to the shortest edge with which the new triangle just meets the
//! angle bound.
//!
//! # Source
//! `[Ungor09]`; section 2.5.1.4 of `[MeshSuite]`, figure 15. The off-center O of these sources lies at half of cot(α/2)
//! times the length of the shortest edge from its middle, where the angle at O is the bound α: `off-center-exact`. At
//! 95 % of that, as `off-center` has it, the new triangle is strictly good, and no rounding makes it bad.

use super::circumcenter::center_of;
use crate::geometry::{Angle, Point, Triangle, angle_at_least, lexicographically_less, math};
use crate::half_edge::FaceId;
use crate::refine::steps::{Places, PointStep, Proposal, View};

/// The number of roundings of the exact off-center that are tried, each a last place or two nearer to the shortest
/// edge.
const ROUNDINGS: u32 = 8;

/// Step 3, `off-center` and `off-center-exact`.
#[derive(Clone, Copy, Debug)]
pub(super) struct OffCenter {
    /// Height of the off-center over the middle of a shortest edge of length one.
    reach: f64,
    /// The squared cosine of the bound, if the angle at the off-center has to meet the bound as nearly as rounding
    /// allows.
    exact: Option<f64>,
}

impl OffCenter {
    /// 95 % of the half.
    const FACTOR: f64 = 0.475;

    /// For an angle bound in radians; at 0 the reach is infinite and every point a circumcenter.
    pub(super) fn new(min_angle: f64) -> Self {
        Self { reach: Self::FACTOR / math::tan(min_angle / 2.0), exact: None }
    }

    /// The off-center at which the angle is the bound, in radians.
    pub(super) fn exact(min_angle: f64) -> Self {
        let exact = Some(Angle::from_radians(min_angle).cos_sq());
        Self { reach: 0.5 / math::tan(min_angle / 2.0), exact }
    }
}

impl OffCenter {
    /// The off-center of a face, rounded.
    pub(super) fn place(self, view: View<'_>, face: FaceId) -> Option<Point> {
        let corners = view.cdt.corners(face);
        let [a, b, c] = corners;
        let center = Triangle::new(a, b, c).circumcenter().filter(|p| p.is_finite())?;
        if self.reach == f64::INFINITY {
            return Some(center);
        }
        let (p, q) = shortest_edge(corners, view);
        let middle = Point::midpoint(p, q);
        let height_sq = view.ruler.length_sq(middle, center);
        let reach_sq = self.reach * self.reach * view.ruler.length_sq(p, q);
        // Towards the circumcenter, but no farther: a quotient of lengths, so units cancel.
        if reach_sq >= height_sq {
            return Some(center);
        }
        let share = (reach_sq / height_sq).sqrt();
        Some(match self.exact {
            None => Point::lerp(middle, center, share),
            Some(cos_sq) => just_good([p, q], [middle, center], share, cos_sq),
        })
    }
}

/// The point at this share of the way from the middle to the center; if rounding has made its angle over the edge
/// smaller than the bound, the first point some last places nearer whose angle meets it.
#[cold] // Out of the way of the default.
#[inline(never)]
fn just_good([p, q]: [Point; 2], [middle, center]: [Point; 2], share: f64, cos_sq: f64) -> Point {
    let nearer = |i: u32| Point::lerp(middle, center, share * (1.0 - f64::from(i * i) * f64::EPSILON));
    let is_good = |&point: &Point| angle_at_least(point, p, q, cos_sq);
    (0..ROUNDINGS).map(nearer).find(is_good).unwrap_or_else(|| nearer(0))
}

impl PointStep for OffCenter {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places) {
        // No iterator chain: places are large, and a chain would copy them.
        if let Some(point) = self.place(view, face) {
            if let Some(place) = Proposal::towards(view, face, point) {
                return places.push(place);
            }
        }
        propose_center(view, face, places);
    }
}

/// Proposes the circumcenter, for a face whose off-center does not exist or cannot be reached.
#[cold]
#[inline(never)]
fn propose_center(view: View<'_>, face: FaceId, places: &mut Places) {
    places.extend(center_of(view, face).and_then(|point| Proposal::towards(view, face, point)));
}

/// The ends of the shortest edge; of equal ones the edge with the first middle, whichever corner comes first.
fn shortest_edge([a, b, c]: [Point; 3], view: View<'_>) -> (Point, Point) {
    let edges = [(a, b), (b, c), (c, a)];
    let lengths = edges.map(|(p, q)| view.ruler.length_sq(p, q));
    let middle = |i: usize| Point::midpoint(edges[i].0, edges[i].1);
    let less = |i: usize, j: usize| {
        lengths[i] < lengths[j] || lengths[i] == lengths[j] && lexicographically_less(middle(i), middle(j))
    };
    edges[(1..3).fold(0, |best, i| if less(i, best) { i } else { best })]
}
