//! Which triangles of a mesh have the extreme angles, and which can be bad: nearly all are passed over at a glance.
//!
//! The glance takes few products and no quotient, in the units of the drawing, from any corner on. It is sure of what
//! it says by a margin that is far above rounding; what it is not sure of, [`Extremes`] decides, and the test of the
//! criteria.

use super::bad_triangles::SureBounds;
use super::ruler::Ruler;
use crate::geometry::lanes::{Number, Two};
use crate::geometry::math::power_of_two_scale;
use crate::geometry::{BoundingBox, Point, Triangle};
use crate::half_edge::FaceId;

/// More than any sum or quotient of products is off by rounding, relatively.
const SLACK: f64 = 1e-12;
/// Products of four lengths from here on have lost nothing to underflow.
const ORDINARY: f64 = 1e-280;
/// Differences of coordinates up to this are finite.
const HUGE: f64 = 1e307;
/// No square of a side above this is glanced at: products of four of them are finite.
const LARGE: f64 = 1e70;

/// Squares of the sides of a triangle, or of two, sorted, and twice the area. Rounded.
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

    #[inline(always)] // As above.
    fn excess(&self) -> N {
        self.short + self.middle - self.long
    }
}

impl Sides<f64> {
    /// The sides of one triangle in units that fit it, whatever its size is: the longest square is at least one.
    fn near_one([a, b, c]: [Point; 3]) -> Self {
        // Differences of finite numbers may overflow; halves are exact where they do.
        let half = if BoundingBox::around(a).including(b).including(c).largest_coordinate() > HUGE { 0.5 } else { 1.0 };
        let side = |p: Point, q: Point| [q.x * half - p.x * half, q.y * half - p.y * half];
        let sides = [side(a, b), side(b, c), side(c, a)];
        let scale = power_of_two_scale(sides.as_flattened().iter().fold(0.0, |largest, x| x.abs().max(largest)));
        Self::of_vectors(sides.map(|side| side.map(|x| x * scale)))
    }

    /// The squared sine of the smallest angle, which lies between the two longer sides.
    fn sine_sq(&self) -> f64 {
        (self.doubled_area / self.long) * (self.doubled_area / self.middle)
    }

    /// Four times the squared cosine of the largest angle, which lies between the two shorter sides, with the cosine's
    /// sign; `None` where the shortest side is too short to be squared beside the others.
    fn cosine_sq(&self) -> Option<f64> {
        let (excess, product) = (self.excess(), self.short * self.middle);
        (product >= f64::MIN_POSITIVE).then(|| excess * excess.abs() / product)
    }
}

/// The triangles of the smallest and of the largest angle among those seen so far.
pub(super) struct Extremes {
    pub(super) sharpest: Option<FaceId>,
    pub(super) bluntest: Option<FaceId>,
    /// The squared sine of the one, four times the squared cosine of the other.
    least_sine: f64,
    least_cosine: f64,
    /// No triangle within these is bad.
    sure: SureBounds,
    glance: Glance,
}

/// What a triangle must surpass so that a glance is enough.
struct Glance {
    /// The square of twice the area.
    area_sq: Two,
    sine_sq: Two,
    cosine_sq: Two,
    /// This is to be surpassed by it.
    doubled_area: Two,
}

impl Extremes {
    /// No triangles so far.
    pub(super) fn new(ruler: Ruler, sure: SureBounds) -> Self {
        let scale = ruler.scale();
        let unit = (scale * scale) * (scale * scale);
        // Ordinary in the units of the ruler, too.
        let area_sq = ORDINARY.max(ORDINARY / unit);
        Self {
            sharpest: None,
            bluntest: None,
            least_sine: f64::INFINITY,
            least_cosine: f64::INFINITY,
            sure,
            // Not infinite: times zero that would be no number.
            glance: Glance {
                area_sq: Two::of(area_sq),
                sine_sq: Two::of(f64::MAX),
                cosine_sq: Two::of(f64::MAX),
                doubled_area: Two::of(sure.doubled_area),
            },
        }
    }

    /// Whether a glance tells that a triangle, of two with these corners, is not bad, and that neither of its extreme
    /// angles is one of the mesh so far.
    ///
    /// Twice the area is off by some last places of the longest side's square, wherever it is measured from. The
    /// squares of the sides are the same from every corner, and in other units.
    #[inline(always)] // In the loop over all triangles.
    pub(super) fn are_plain(&self, corners: [[Point; 2]; 3]) -> [bool; 2] {
        let sides = Sides::of(corners.map(Two::coordinates));
        let margin = Two::of(SLACK) * sides.long;
        let least_area = sides.doubled_area - margin;
        let (area_sq, excess) = (least_area * least_area, sides.excess());
        // Each is positive where something is sure. What is no number is lost on the way, but the last one is none
        // then, or negative: products of what is not large are numbers.
        let Two(least) = least_area
            .lesser(area_sq - self.glance.area_sq)
            .lesser(area_sq - self.glance.sine_sq * (sides.long * sides.middle))
            .lesser(excess * excess.abs() - self.glance.cosine_sq * (sides.short * sides.middle))
            .lesser(self.glance.doubled_area - (sides.doubled_area + margin))
            .lesser(Two::of(LARGE) - sides.long);
        least.map(|least| least > 0.0)
    }

    /// Looks at a triangle with these corners, the newest first.
    pub(super) fn see(&mut self, f: FaceId, corners: [Point; 3]) {
        let sides = Sides::near_one(corners);
        let (sine_sq, cosine_sq) = (sides.sine_sq(), sides.cosine_sq().unwrap_or_else(|| measured_cosine_sq(corners)));
        if sine_sq < self.least_sine {
            (self.least_sine, self.sharpest) = (sine_sq, Some(f));
            self.glance.sine_sq = Two::of(sine_sq.max(self.sure.sine_sq) * (1.0 + SLACK));
        }
        if cosine_sq < self.least_cosine {
            (self.least_cosine, self.bluntest) = (cosine_sq, Some(f));
            self.glance.cosine_sq = Two::of(cosine_sq + SLACK);
        }
    }
}

/// What [`Sides::cosine_sq`] tells, by the largest angle.
#[cold]
fn measured_cosine_sq([a, b, c]: [Point; 3]) -> f64 {
    let cosine = Triangle::new(a, b, c).max_angle().cos();
    4.0 * cosine * cosine.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn extremes() -> Extremes {
        let sure = SureBounds { sine_sq: 0.1, doubled_area: f64::INFINITY };
        Extremes::new(Ruler::for_box(None), sure)
    }

    fn scaled(by: f64, corners: [[f64; 2]; 3]) -> [Point; 3] {
        corners.map(|[x, y]| Point::new(x * by, y * by))
    }

    const EQUILATERAL: [[f64; 2]; 3] = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.7]];
    const RIGHT: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

    #[test]
    fn the_first_is_looked_at_closely_and_better_ones_are_not() {
        let mut extremes = extremes();
        let [first, better] = [scaled(1.0, RIGHT), scaled(1.0, EQUILATERAL)];
        let two = [0, 1, 2].map(|i| [first[i], better[i]]);
        assert_eq!(extremes.are_plain(two), [false; 2]);
        extremes.see(FaceId(0), first);
        assert_eq!(extremes.are_plain(two), [false, true], "one as sharp may come first elsewhere");
        extremes.see(FaceId(1), better);
        assert_eq!((extremes.sharpest, extremes.bluntest), (Some(FaceId(0)), Some(FaceId(0))));
    }

    #[test]
    fn what_underflows_or_overflows_is_looked_at_closely() {
        for seen in [false, true] {
            let mut extremes = extremes();
            if seen {
                extremes.see(FaceId(0), scaled(1.0, RIGHT));
            }
            for by in [5e-324, 1e-300, 1e-170, 1e-90, 1e40, 1e100, 1e170, 8e307] {
                let corners = scaled(by, EQUILATERAL);
                assert_eq!(extremes.are_plain(corners.map(|p| [p, p])), [false; 2], "{by} {seen}");
            }
        }
    }
}
