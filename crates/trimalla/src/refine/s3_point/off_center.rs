//! `off-center`: the circumcenter, or nearer to the shortest edge the point that makes its triangle just good.
//!
//! # Source
//! `[Ungor09]`. The true off-center lies at half of cot(α/2) times the edge's length from its middle; 95 % of that leaves
//! the new triangle strictly good.

use super::circumcenter::center_of;
use crate::geometry::{Point, Triangle, lexicographically_less, math};
use crate::half_edge::FaceId;
use crate::refine::steps::{PointStep, Proposal, View};

/// Step 3, `off-center`.
#[derive(Clone, Copy, Debug)]
pub(super) struct OffCenter {
    /// Height of the off-center over the middle of a shortest edge of length one.
    reach: f64,
}

impl OffCenter {
    /// 95 % of the half.
    const FACTOR: f64 = 0.475;

    /// For an angle bound in radians; at 0 the reach is infinite and every point a circumcenter.
    pub(super) fn new(min_angle: f64) -> Self {
        Self { reach: Self::FACTOR / math::tan(min_angle / 2.0) }
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
        // Towards the circumcenter, but no farther than it: a quotient of lengths, free of units.
        Some(if reach_sq < height_sq { Point::lerp(middle, center, (reach_sq / height_sq).sqrt()) } else { center })
    }
}

impl PointStep for OffCenter {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Vec<Proposal>) {
        // Not chained: each place is as large as a handful of numbers, and copied for each link.
        if let Some(point) = self.place(view, face) {
            if let Some(place) = Proposal::towards(view, face, point) {
                return places.push(place);
            }
        }
        propose_center(view, face, places);
    }
}

/// Proposes the circumcenter, where there is no off-center or no way to it.
#[cold]
#[inline(never)]
fn propose_center(view: View<'_>, face: FaceId, places: &mut Vec<Proposal>) {
    places.extend(center_of(view, face).and_then(|point| Proposal::towards(view, face, point)));
}

/// The ends of the shortest edge; of equal ones that with the first middle, whichever corner comes first.
fn shortest_edge([a, b, c]: [Point; 3], view: View<'_>) -> (Point, Point) {
    let edges = [(a, b), (b, c), (c, a)];
    let lengths = edges.map(|(p, q)| view.ruler.length_sq(p, q));
    let middle = |i: usize| Point::midpoint(edges[i].0, edges[i].1);
    let less = |i: usize, j: usize| {
        lengths[i] < lengths[j] || lengths[i] == lengths[j] && lexicographically_less(middle(i), middle(j))
    };
    edges[(1..3).fold(0, |best, i| if less(i, best) { i } else { best })]
}
