//! The triangles of a mesh with its smallest and its largest angle, found behind a filter that skips nearly all
//! triangles.
//!
//! The filter tests two triangles at a time, with few products and no division, in the units of the drawing and from
//! any corner. A triangle that it passes is good, and has neither of the extreme angles; its margin is far above
//! rounding. [`Extremes::include`] measures the other triangles, and the caller tests whether they are bad.

use super::bad_triangles::SufficientBounds;
use crate::geometry::lanes::{Number, Two};
use crate::geometry::math::power_of_two_scale;
use crate::geometry::{BoundingBox, Point, Triangle};
use crate::half_edge::FaceId;
use crate::refine::measure::ruler::Ruler;

/// Bound on the relative error of every sum and quotient of products here.
const SLACK: f64 = 1e-12;
/// A product of four lengths that is at least this has not lost digits to underflow.
const ORDINARY: f64 = 1e-280;
/// Coordinates up to this have finite differences.
const HUGE: f64 = 1e307;
/// The filter passes no triangle with a squared side above this; products of four sides below it are finite.
const LARGE: f64 = 1e70;

/// The squared sides of a triangle (or of two, in lanes) in ascending order, and twice its area. Rounded.
struct Sides<N> {
    short: N,
    middle: N,
    long: N,
    doubled_area: N,
}

impl<N: Number> Sides<N> {
    #[inline(always)] // In the loop over all triangles.
    fn of([[ax, ay], [bx, by], [cx, cy]]: [[N; 2]; 3]) -> Self {
        Self::of_vectors([[bx - ax, by - ay], [cx - bx, cy - by], [ax - cx, ay - cy]])
    }

    #[inline(always)] // In the loop over all triangles.
    fn of_vectors([[ux, uy], [vx, vy], [wx, wy]]: [[N; 2]; 3]) -> Self {
        let (p, q, r) = (ux * ux + uy * uy, vx * vx + vy * vy, wx * wx + wy * wy);
        let (low, high) = (p.lesser(q), p.greater(q));
        Self {
            short: low.lesser(r),
            middle: low.greater(high.lesser(r)),
            long: high.greater(r),
            doubled_area: ux * vy - uy * vx,
        }
    }

    /// Twice the dot product of the two shorter sides at their common corner.
    #[inline(always)] // In the loop over all triangles.
    fn excess(&self) -> N {
        self.short + self.middle - self.long
    }
}

impl Sides<f64> {
    /// The sides of one triangle, in a unit that makes the longest square at least one.
    fn near_one([a, b, c]: [Point; 3]) -> Self {
        // Differences of finite numbers may overflow; halves of such large numbers are exact.
        let half = if BoundingBox::around(a).including(b).including(c).largest_coordinate() > HUGE { 0.5 } else { 1.0 };
        let side = |p: Point, q: Point| [q.x * half - p.x * half, q.y * half - p.y * half];
        let sides = [side(a, b), side(b, c), side(c, a)];
        let scale = power_of_two_scale(sides.as_flattened().iter().fold(0.0, |largest, x| x.abs().max(largest)));
        Self::of_vectors(sides.map(|side| side.map(|x| x * scale)))
    }

    /// The squared sine of the smallest angle, the one between the two longer sides.
    fn sine_sq(&self) -> f64 {
        (self.doubled_area / self.long) * (self.doubled_area / self.middle)
    }

    /// Four times the squared cosine of the largest angle, the one between the two shorter sides, with the sign of the
    /// cosine; `None` where the product of their squares underflows.
    fn cosine_sq(&self) -> Option<f64> {
        let (excess, product) = (self.excess(), self.short * self.middle);
        (product >= f64::MIN_POSITIVE).then(|| excess * excess.abs() / product)
    }
}

/// The triangles with the smallest and with the largest angle, among those included so far.
pub(in crate::refine) struct Extremes {
    pub(in crate::refine) sharpest: Option<FaceId>,
    pub(in crate::refine) bluntest: Option<FaceId>,
    /// The squared sine of the smallest angle.
    least_sine_sq: f64,
    /// Four times the signed square of the cosine of the largest angle.
    least_cosine_sq: f64,
    /// A triangle that keeps these is good.
    sufficient: SufficientBounds,
    filter: Filter,
}

/// The bounds that a triangle must keep so that the filter passes it. Each is in both lanes.
struct Filter {
    /// The square of twice the area is above this, so that it has not underflowed.
    least_area_sq: Two,
    /// The squared sine of the smallest angle is above this.
    least_sine_sq: Two,
    /// Four times the signed square of the cosine of the largest angle is above this.
    least_cosine_sq: Two,
    /// Twice the area is below this.
    most_doubled_area: Two,
}

impl Extremes {
    /// No triangles so far; `sufficient` are the bounds that make a triangle good.
    pub(in crate::refine) fn new(ruler: Ruler, sufficient: SufficientBounds) -> Self {
        let scale = ruler.scale();
        let unit = (scale * scale) * (scale * scale);
        // Products in the units of the ruler must not underflow either.
        let least_area_sq = ORDINARY.max(ORDINARY / unit);
        Self {
            sharpest: None,
            bluntest: None,
            least_sine_sq: f64::INFINITY,
            least_cosine_sq: f64::INFINITY,
            sufficient,
            // The largest finite number, since infinity times zero is NaN.
            filter: Filter {
                least_area_sq: Two::of(least_area_sq),
                least_sine_sq: Two::of(f64::MAX),
                least_cosine_sq: Two::of(f64::MAX),
                most_doubled_area: Two::of(sufficient.doubled_area),
            },
        }
    }

    /// Whether the filter passes each of two triangles with these corners: the triangle is certainly good, and its
    /// angles are certainly neither below nor above all those included so far.
    ///
    /// The error of twice the area is a few last places of the longest squared side, from whatever corner the area is
    /// measured. The squared sides are the same from every corner, and in units of any other power of two.
    #[inline(always)] // In the loop over all triangles.
    pub(in crate::refine) fn are_passed(&self, corners: [[Point; 2]; 3]) -> [bool; 2] {
        let sides = Sides::of(corners.map(Two::coordinates));
        let margin = Two::of(SLACK) * sides.long;
        let least_area = sides.doubled_area - margin;
        let (area_sq, excess) = (least_area * least_area, sides.excess());
        // Each term is positive if and only if one property is certain. `lesser` drops a NaN. That is safe: products of
        // sides that are not large are numbers, so wherever a term is NaN the last one is NaN or negative.
        let Two(least) = least_area
            .lesser(area_sq - self.filter.least_area_sq)
            .lesser(area_sq - self.filter.least_sine_sq * (sides.long * sides.middle))
            .lesser(excess * excess.abs() - self.filter.least_cosine_sq * (sides.short * sides.middle))
            .lesser(self.filter.most_doubled_area - (sides.doubled_area + margin))
            .lesser(Two::of(LARGE) - sides.long);
        least.map(|least| least > 0.0)
    }

    /// Includes a face with these corners, the newest first.
    pub(in crate::refine) fn include(&mut self, f: FaceId, corners: [Point; 3]) {
        let sides = Sides::near_one(corners);
        let (sine_sq, cosine_sq) = (sides.sine_sq(), sides.cosine_sq().unwrap_or_else(|| measured_cosine_sq(corners)));
        if sine_sq < self.least_sine_sq {
            (self.least_sine_sq, self.sharpest) = (sine_sq, Some(f));
            self.filter.least_sine_sq = Two::of(sine_sq.max(self.sufficient.sine_sq) * (1.0 + SLACK));
        }
        if cosine_sq < self.least_cosine_sq {
            (self.least_cosine_sq, self.bluntest) = (cosine_sq, Some(f));
            self.filter.least_cosine_sq = Two::of(cosine_sq + SLACK);
        }
    }
}

/// [`Sides::cosine_sq`] from the largest angle itself, where the product underflows.
#[cold]
fn measured_cosine_sq([a, b, c]: [Point; 3]) -> f64 {
    let cosine = Triangle::new(a, b, c).max_angle().cos();
    4.0 * cosine * cosine.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn extremes() -> Extremes {
        let sufficient = SufficientBounds { sine_sq: 0.1, doubled_area: f64::INFINITY };
        Extremes::new(Ruler::for_box(None), sufficient)
    }

    fn scaled(by: f64, corners: [[f64; 2]; 3]) -> [Point; 3] {
        corners.map(|[x, y]| Point::new(x * by, y * by))
    }

    const EQUILATERAL: [[f64; 2]; 3] = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.7]];
    const RIGHT: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

    #[test]
    fn the_first_triangle_is_measured_and_better_ones_are_passed() {
        let mut extremes = extremes();
        let [first, better] = [scaled(1.0, RIGHT), scaled(1.0, EQUILATERAL)];
        let two = [0, 1, 2].map(|i| [first[i], better[i]]);
        assert_eq!(extremes.are_passed(two), [false; 2]);
        extremes.include(FaceId(0), first);
        assert_eq!(extremes.are_passed(two), [false, true], "one as sharp may come first elsewhere");
        extremes.include(FaceId(1), better);
        assert_eq!((extremes.sharpest, extremes.bluntest), (Some(FaceId(0)), Some(FaceId(0))));
    }

    #[test]
    fn triangles_whose_products_underflow_or_overflow_are_not_passed() {
        for has_first in [false, true] {
            let mut extremes = extremes();
            if has_first {
                extremes.include(FaceId(0), scaled(1.0, RIGHT));
            }
            for by in [5e-324, 1e-300, 1e-170, 1e-90, 1e40, 1e100, 1e170, 8e307] {
                let corners = scaled(by, EQUILATERAL);
                assert_eq!(extremes.are_passed(corners.map(|p| [p, p])), [false; 2], "{by} {has_first}");
            }
        }
    }
}
