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
/// Figures whose reach lies between these bounds need no scale: no square of them overflows or vanishes (2^-200,
/// 2^200).
const ORDINARY: core::ops::RangeInclusive<f64> =
    f64::from_bits((1023 - 200) << 52)..=f64::from_bits((1023 + 200) << 52);

/// The largest of a number and the magnitudes of two others; NaN is ignored.
#[inline(always)]
fn larger(most: f64, x: f64, y: f64) -> f64 {
    let greater = |a: f64, b: f64| if b > a { b } else { a };
    greater(greater(most, x.abs()), y.abs())
}

/// A frame of reference for one small figure.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    /// The origin, shrunk.
    origin: Vector,
    shrink: f64,
    scale: f64,
    /// One over the scale: both are powers of two, so that multiplying is exact where dividing would be.
    unscale: f64,
}

impl Frame {
    /// Whether coordinates near a point need not be shrunk.
    #[inline]
    pub(super) fn is_plain_at(p: Point) -> bool {
        p.x.abs() < SHRINK * LARGE && p.y.abs() < SHRINK * LARGE
    }

    /// The frame that neither shrinks nor scales: what [`new`](Self::new) gives for ordinary figures.
    #[inline]
    pub(super) fn plain(origin: Point) -> Self {
        Self { origin: Vector::new(origin.x, origin.y), shrink: 1.0, scale: 1.0, unscale: 1.0 }
    }

    /// The frame with the given origin in which the given points have coordinates whose squares are ordinary numbers.
    #[inline]
    pub(crate) fn new<const N: usize>(origin: Point, points: [Point; N]) -> Self {
        let largest = points.iter().chain(core::iter::once(&origin)).fold(0.0, |m, p| larger(m, p.x, p.y));
        let shrink = if largest > LARGE { SHRINK } else { 1.0 };
        let mut frame =
            Self { origin: Vector::new(origin.x * shrink, origin.y * shrink), shrink, scale: 1.0, unscale: 1.0 };
        let reach = points.iter().fold(0.0, |m, p| {
            let Vector { x, y } = frame.local(*p);
            larger(m, x, y)
        });
        if !ORDINARY.contains(&reach) {
            frame.scale = power_of_two_scale(reach);
            frame.unscale = 1.0 / frame.scale;
        }
        frame
    }

    /// A point as seen in the frame.
    #[inline]
    pub(crate) fn local(&self, point: Point) -> Vector {
        let x = point.x * self.shrink - self.origin.x;
        let y = point.y * self.shrink - self.origin.y;
        Vector::new(x * self.scale, y * self.scale)
    }

    /// The point that the frame sees at `local`.
    #[inline]
    pub(super) fn point(&self, local: Vector) -> Point {
        let grow = 1.0 / self.shrink;
        Point::new((self.origin.x + local.x * self.unscale) * grow, (self.origin.y + local.y * self.unscale) * grow)
    }

    /// A length measured in the frame, in the caller's units.
    #[inline]
    pub(crate) fn length(&self, local: f64) -> f64 {
        local * self.unscale / self.shrink
    }

    /// An area or squared length measured in the frame, in the caller's units; infinite or zero where it must be.
    #[inline]
    pub(super) fn area(&self, local: f64) -> f64 {
        self.length(self.length(local))
    }
}
