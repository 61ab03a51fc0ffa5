//! Affine maps of the plane.

use trimalla::geometry::math::{cos, sin};
use trimalla::geometry::{Point, Vector};

use super::sketch::{Path, Piece, Vertex};

/// The map `(x, y) -> (a x + c y + e, b x + d y + f)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Affine(pub(super) [f64; 6]);

impl Affine {
    pub(super) const IDENTITY: Self = Self([1.0, 0.0, 0.0, 1.0, 0.0, 0.0]);

    pub(super) fn translation(x: f64, y: f64) -> Self {
        Self([1.0, 0.0, 0.0, 1.0, x, y])
    }

    pub(super) fn scale(x: f64, y: f64) -> Self {
        Self([x, 0.0, 0.0, y, 0.0, 0.0])
    }

    /// A turn by an angle in degrees, exact for multiples of a right angle.
    pub(super) fn rotation(degrees: f64) -> Self {
        let (c, s) = match degrees.rem_euclid(360.0) {
            0.0 => (1.0, 0.0),
            90.0 => (0.0, 1.0),
            180.0 => (-1.0, 0.0),
            270.0 => (0.0, -1.0),
            other => (cos(other.to_radians()), sin(other.to_radians())),
        };
        Self([c, s, -s, c, 0.0, 0.0])
    }

    /// The map that does `first`, and then this one.
    #[must_use]
    pub(super) fn after(&self, first: &Self) -> Self {
        let Self([a, b, c, d, e, f]) = *self;
        let Self([p, q, r, s, t, u]) = *first;
        Self([a * p + c * q, b * p + d * q, a * r + c * s, b * r + d * s, a * t + c * u + e, b * t + d * u + f])
    }

    pub(super) fn point(&self, p: Point) -> Point {
        let Self([a, b, c, d, e, f]) = *self;
        Point::new(a * p.x + c * p.y + e, b * p.x + d * p.y + f)
    }

    pub(super) fn vector(&self, v: Vector) -> Vector {
        let Self([a, b, c, d, ..]) = *self;
        Vector::new(a * v.x + c * v.y, b * v.x + d * v.y)
    }

    pub(super) fn vertex(&self, v: Vertex) -> Vertex {
        Vertex { at: self.point(v.at), ..v }
    }

    /// A point `[x w, y w, w]`.
    pub(super) fn weighted(&self, [x, y, w]: [f64; 3]) -> [f64; 3] {
        let Self([a, b, c, d, e, f]) = *self;
        [a * x + c * y + e * w, b * x + d * y + f * w, w]
    }

    /// A path under the map; its ends are computed then, unless the map moves nothing.
    pub(super) fn path(&self, path: &Path) -> Path {
        if *self == Self::IDENTITY {
            return path.clone();
        }
        let piece = |piece: &Piece| match piece {
            Piece::Line(to) => Piece::Line(self.vertex(*to)),
            Piece::Arc(arc) => Piece::Arc(Box::new(arc.transformed(self))),
            Piece::Bezier(curve) => Piece::Bezier(Box::new(curve.transformed(self))),
        };
        Path {
            start: self.vertex(path.start),
            pieces: path.pieces.iter().map(piece).collect(),
            is_closed: path.is_closed,
            has_stated_ends: false,
        }
    }
}
