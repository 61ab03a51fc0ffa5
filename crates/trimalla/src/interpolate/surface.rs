//! A terrain: triangles between vertices that have heights.
//!
//! ```text
//!          c                 height at p = (A hₐ + B h_b + C h_c) / (A + B + C),
//!         /|\                where A, B, C are the areas of the triangles pbc, pca, pab
//!        / p \
//!       / / \ \
//!      a ───── b
//! ```
//!
//! 1. The triangle of the point is found by a walk from the point before; exactly.
//! 2. On a vertex the height is that of the vertex. On an edge it is interpolated between two ends, in a triangle
//!    between three corners, by areas that are computed with the point as the origin; of a flat triangle by exact
//!    areas.
//! 3. The result is confined between the lowest and the highest of these heights, so that no rounding makes a summit.
//!
//! # Source
//! `[Triangulaciones]`, where the height of a point depends on the triangle that contains it.

use super::error::InterpolateError;
use super::in_curve_order;
use super::locator::Locator;
use crate::geometry::{Frame, Point, Segment, Triangle, Vector, barycentric};
use crate::half_edge::{FaceId, VertexId};
use crate::locate::Locus;
use crate::triangulation::Triangulation;

/// A triangulation whose vertices have heights.
///
/// Any triangulation will do: Delaunay or not, with constraints or without, of a hull or a domain.
#[doc(alias = "terrain")]
#[doc(alias = "TIN")]
#[doc(alias = "mapa de alturas")]
#[derive(Clone, Copy, Debug)]
pub struct Surface<'a> {
    t: &'a Triangulation,
    heights: &'a [f64],
}

impl<'a> Surface<'a> {
    /// A triangulation with a height for each vertex slot; those of vertices that are not used do not matter.
    ///
    /// # Errors
    /// [`InterpolateError::Count`] and [`InterpolateError::Height`].
    pub fn new(triangulation: &'a Triangulation, heights: &'a [f64]) -> Result<Self, InterpolateError> {
        let t = triangulation;
        if heights.len() != t.points().len() {
            return Err(InterpolateError::Count { heights: heights.len(), vertices: t.points().len() });
        }
        match t.used_vertices().find(|v| !heights[v.index()].is_finite()) {
            Some(vertex) => {
                Err(InterpolateError::Height { vertex, at: t.point(vertex), height: heights[vertex.index()] })
            }
            None => Ok(Self { t, heights }),
        }
    }

    /// The triangulation.
    #[must_use]
    pub fn triangulation(&self) -> &'a Triangulation {
        self.t
    }

    /// The height of a vertex.
    #[must_use]
    pub fn height(&self, v: VertexId) -> f64 {
        self.heights[v.index()]
    }

    /// The lowest and the highest height of a vertex in use; `None` without any.
    #[must_use]
    pub fn range(&self) -> Option<[f64; 2]> {
        let heights = self.t.used_vertices().map(|v| self.height(v));
        heights.fold(None, |range, h| Some(range.map_or([h, h], |[low, high]: [f64; 2]| [low.min(h), high.max(h)])))
    }

    /// The height at a point, by the triangle that contains it; `None` outside.
    ///
    /// # Guarantees
    /// See [`heights_at`](Self::heights_at).
    ///
    /// # Complexity
    /// That of locating a point without a hint, about √n; linear outside of a domain.
    #[must_use]
    pub fn height_at(&self, p: Point) -> Option<f64> {
        self.height_in(Locator::new(self.t).locate(p)?, p)
    }

    /// The heights at points, by the triangles that contain them.
    ///
    /// # Shape
    /// One entry for each point, in order; `None` outside, and for points that are not finite.
    ///
    /// # Guarantees
    /// On a vertex the height is that of the vertex, bit for bit. Elsewhere it lies between the lowest and the highest
    /// of the corners. Whether a point lies outside is exact.
    ///
    /// # Complexity
    /// O(m log m) for m points, and the triangles between each and the one before along a space-filling curve.
    #[must_use]
    pub fn heights_at(&self, points: &[Point]) -> Vec<Option<f64>> {
        let mut locator = Locator::new(self.t);
        in_curve_order(points, |p| self.height_in(locator.locate(p)?, p))
    }

    fn height_in(&self, locus: Locus, p: Point) -> Option<f64> {
        let mut weights = Vec::with_capacity(3);
        linear_weights(self.t, locus, p, &mut weights)?;
        Some(self.weighted(&weights))
    }

    /// The mean of heights by weights that sum to 1, between the lowest and the highest.
    pub(super) fn weighted(&self, weights: &[(VertexId, f64)]) -> f64 {
        let start = (0.0, f64::INFINITY, f64::NEG_INFINITY);
        let (sum, low, high) = weights.iter().fold(start, |(sum, low, high), &(v, weight)| {
            let h = self.height(v);
            (sum + weight * h, low.min(h), high.max(h))
        });
        sum.max(low).min(high)
    }
}

/// Slopes.
impl Surface<'_> {
    /// The gradient of a triangle, rounded: how much the height grows along x and along y; `None` for a ghost.
    ///
    /// It points uphill; its length is the slope. It is infinite where it passes the largest number.
    #[doc(alias = "pendiente")]
    #[must_use]
    pub fn gradient(&self, f: FaceId) -> Option<Vector> {
        if !self.t.is_real(f) {
            return None;
        }
        let corners = self.t.face_vertices(f);
        let [a, b, c] = corners.map(|v| self.t.point(v));
        let [at_a, at_b, at_c] = corners.map(|v| self.height(v));
        let frame = Frame::new(a, [b, c]);
        let (u, v) = (frame.local(b), frame.local(c));
        let (rise_u, rise_v) = (at_b - at_a, at_c - at_a);
        let over = frame.length(1.0) * u.cross(v);
        Some(Vector::new((rise_u * v.y - rise_v * u.y) / over, (rise_v * u.x - rise_u * v.x) / over))
    }

    /// The gradient at a vertex, rounded: the mean of those of the triangles around it, by their areas; `None` without
    /// triangles.
    #[must_use]
    pub fn gradient_at(&self, v: VertexId) -> Option<Vector> {
        if v.index() >= self.t.points().len() {
            return None;
        }
        let faces: Vec<(Vector, f64)> = self.t.faces_around(v).filter_map(|f| self.weighted_gradient(f)).collect();
        let total: f64 = faces.iter().map(|(_, area)| area).sum();
        let is_useful = total.is_finite() && total > 0.0;
        let weight = |area: f64| if is_useful { area / total } else { 1.0 / faces.len() as f64 };
        let mean = faces.iter().map(|(g, area)| g.scaled(weight(*area)));
        mean.reduce(|sum, g| Vector::new(sum.x + g.x, sum.y + g.y))
    }

    fn weighted_gradient(&self, f: FaceId) -> Option<(Vector, f64)> {
        let [a, b, c] = self.t.face_points(f);
        Some((self.gradient(f)?, Triangle::new(a, b, c).area()))
    }
}

/// Step 2: the vertices that a height depends on, with weights that sum to 1.
pub(super) fn linear_weights(
    t: &Triangulation,
    locus: Locus,
    p: Point,
    weights: &mut Vec<(VertexId, f64)>,
) -> Option<()> {
    weights.clear();
    match locus {
        Locus::Vertex(v) => weights.push((v, 1.0)),
        Locus::Edge(h) => {
            let [a, b] = t.edge_points(h);
            let by = Segment::new(a, b).nearest_parameter(p);
            weights.extend([(t.origin(h), 1.0 - by), (t.dest(h), by)]);
        }
        Locus::Face(f) => {
            let corners = t.face_vertices(f);
            let places = corners.map(|v| t.point(v));
            let shares = plain_shares(places, p).unwrap_or_else(|| barycentric(places, p));
            weights.extend(corners.into_iter().zip(shares));
        }
        Locus::Outside(_) | Locus::Beyond(_) | Locus::OffLine(_) | Locus::Nowhere => return None,
    }
    Some(())
}

/// The shares of three areas, in floating-point arithmetic; `None` for a flat triangle, where they would not be exact
/// enough.
fn plain_shares(corners: [Point; 3], p: Point) -> Option<[f64; 3]> {
    let frame = Frame::new(p, corners);
    let [a, b, c] = corners.map(|q| frame.local(q));
    let areas = [b.cross(c), c.cross(a), a.cross(b)].map(|area| area.max(0.0));
    let total: f64 = areas.iter().sum();
    let longest = [b - a, c - b, a - c].map(Vector::length_sq).into_iter().fold(0.0, f64::max);
    (total > longest / FLAT).then(|| areas.map(|area| area / total))
}

/// A triangle is flat if its longest side is so many times its height.
const FLAT: f64 = 256.0;
