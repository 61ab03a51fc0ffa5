//! A local frame: coordinates relative to a point of the figure, scaled by a power of two to about one.
//!
//! In the frame squares neither overflow nor vanish, and scaling itself is exact, so a construction carried out in it
//! rounds as it would for a figure of ordinary size at the origin.

use super::math::power_of_two_scale;
use super::{Point, Vector};

/// Coordinates beyond this are shrunk before they are subtracted, lest the difference overflows.
const LARGE: f64 = f64::from_bits((1023 + 1020) << 52); // 2^1020
/// The exact factor by which they are shrunk.
const SHRINK: f64 = 0.125;

/// A frame of reference for one small figure.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    /// The origin, shrunk.
    origin: Vector,
    shrink: f64,
    scale: f64,
}

impl Frame {
    /// The frame with the given origin in which the given points have coordinates of magnitude below four.
    #[inline]
    pub(super) fn new<const N: usize>(origin: Point, points: [Point; N]) -> Self {
        let largest =
            points.iter().chain(core::iter::once(&origin)).fold(0.0_f64, |m, p| m.max(p.x.abs()).max(p.y.abs()));
        let shrink = if largest > LARGE { SHRINK } else { 1.0 };
        let mut frame = Self { origin: Vector::new(origin.x * shrink, origin.y * shrink), shrink, scale: 1.0 };
        let reach = points.iter().fold(0.0_f64, |m, p| {
            let Vector { x, y } = frame.local(*p);
            m.max(x.abs()).max(y.abs())
        });
        frame.scale = power_of_two_scale(reach);
        frame
    }

    /// A point as seen in the frame.
    #[inline]
    pub(super) fn local(&self, point: Point) -> Vector {
        let x = point.x * self.shrink - self.origin.x;
        let y = point.y * self.shrink - self.origin.y;
        Vector::new(x * self.scale, y * self.scale)
    }

    /// The point that the frame sees at `local`.
    #[inline]
    pub(super) fn point(&self, local: Vector) -> Point {
        Point::new(
            (self.origin.x + local.x / self.scale) / self.shrink,
            (self.origin.y + local.y / self.scale) / self.shrink,
        )
    }

    /// A length measured in the frame, in the caller's units.
    #[inline]
    pub(super) fn length(&self, local: f64) -> f64 {
        local / self.scale / self.shrink
    }

    /// An area or squared length measured in the frame, in the caller's units; infinite or zero where it must be.
    #[inline]
    pub(super) fn area(&self, local: f64) -> f64 {
        self.length(self.length(local))
    }
}
