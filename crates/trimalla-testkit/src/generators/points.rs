//! Point sets that have broken triangulators.

use core::f64::consts::TAU;

use trimalla::geometry::Point;

use super::rng::SplitMix64;

/// The next double above a positive one; `f64::next_up` is younger than our oldest supported
/// compiler.
#[must_use]
pub fn next_up(value: f64) -> f64 {
    assert!(value > 0.0 && value.is_finite(), "{value} is not positive and finite");
    f64::from_bits(value.to_bits() + 1)
}

/// The next double below a positive one.
#[must_use]
pub fn next_down(value: f64) -> f64 {
    assert!(value > 0.0 && value.is_finite(), "{value} is not positive and finite");
    f64::from_bits(value.to_bits() - 1)
}

/// Declares the kinds once: name, key, description, maker.
macro_rules! point_set_kinds {
    ($($(#[doc = $doc:literal])+ $kind:ident = $key:literal => $maker:expr;)+) => {
        /// A kind of point set.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum PointSetKind { $($(#[doc = $doc])+ $kind,)+ }

        impl PointSetKind {
            /// Every kind.
            pub const ALL: [Self; [$($key),+].len()] = [$(Self::$kind),+];

            /// The name of the kind in messages and files.
            #[must_use]
            pub const fn key(self) -> &'static str {
                match self { $(Self::$kind => $key,)+ }
            }
        }

        /// The points of a kind.
        ///
        /// # Shape
        /// About `n` points, never more; kinds with a fixed set give that set, cut to `n`. Orders
        /// are shuffled unless the kind says otherwise.
        #[must_use]
        pub fn point_set(kind: PointSetKind, n: usize, seed: u64) -> Vec<Point> {
            let rng = &mut SplitMix64::new(seed);
            let make: fn(usize, &mut SplitMix64) -> Vec<Point> = match kind { $(PointSetKind::$kind => $maker,)+ };
            let mut points = make(n, rng);
            points.truncate(n);
            points
        }
    };
}

point_set_kinds! {
    /// Uniform in the unit square.
    Uniform = "uniform" => |n, rng| repeat(n, rng, |_, rng| Point::new(rng.unit(), rng.unit()));
    /// Four gaussian clusters of width 1e-9 at the corners of the unit square (A18).
    GaussianClusters = "gaussian-clusters" => gaussian_clusters;
    /// Integer grid: every cell is cocircular (A09).
    IntegerGrid = "integer-grid" => |n, rng| grid(n, rng, Point::new);
    /// Integer grid times 0.1: cells are only nearly cocircular, rows only nearly straight.
    TenthGrid = "tenth-grid" => |n, rng| grid(n, rng, |i, j| Point::new(0.1 * i, 0.1 * j));
    /// Grid of quarters with offset: exactly representable (A11).
    QuarterGrid = "quarter-grid" =>
        |n, rng| grid(n, rng, |i, j| Point::new(0.25 + 0.25 * i, 0.5 + 0.25 * j));
    /// Integer grid rotated by a whole number of degrees (A10).
    RotatedGrid = "rotated-grid" => rotated_grid;
    /// Centimetre grid at an UTM offset (A23).
    UtmGrid = "utm-grid" =>
        |n, rng| grid(n, rng, |i, j| Point::new(500_000.0 + i * 0.001, 4_649_776.0 + j * 0.001));
    /// The 36 integer points of x² + y² = 65² (A12).
    Cocircular65 = "cocircular-65" => |_, rng| integer_circle(65, rng);
    /// The 108 integer points of x² + y² = 1105² (A12).
    Cocircular1105 = "cocircular-1105" => |_, rng| integer_circle(1105, rng);
    /// The 36 integer points of x² + y² = 65² and the centre (A12).
    CocircularWithCentre = "cocircular-with-centre" =>
        |_, rng| with_centre(integer_circle(65, rng));
    /// Rounded points of the unit circle (A13).
    RoundedCircle = "rounded-circle" => |n, rng| shuffled(circle(n, 1.0), rng);
    /// Two rings of radii 1 and 1 + ulp (A14).
    TwinRings = "twin-rings" =>
        |n, rng| shuffled([circle(n / 2, 1.0), circle(n - n / 2, next_up(1.0))].concat(), rng);
    /// A hub in a ring: one vertex of the highest degree (A14).
    Hub = "hub" => |n, rng| with_centre(shuffled(circle(n.saturating_sub(1), 1.0), rng));
    /// Exactly collinear, both coordinates changing, and one point beside the line.
    CollinearExact = "collinear-exact" =>
        |n, rng| shuffled(beside(Point::new(0.0, 1.0), n, |i| Point::new(3.0 * i, 2.0 * i)), rng);
    /// Nearly collinear by rounding: (0.1 i, 0.3 i) (A02).
    CollinearRounded = "collinear-rounded" =>
        |n, rng| shuffled(indexed(n, |i| Point::new(0.1 * i, 3.0 * (0.1 * i))), rng);
    /// All on a vertical line (A02).
    VerticalLine = "vertical-line" => |n, rng| shuffled(indexed(n, |i| Point::new(0.0, i)), rng);
    /// All on a horizontal line (A02).
    HorizontalLine = "horizontal-line" =>
        |n, rng| shuffled(indexed(n, |i| Point::new(i, 0.0)), rng);
    /// All on the diagonal (A02).
    DiagonalLine = "diagonal-line" => |n, rng| shuffled(indexed(n, |i| Point::new(i, i)), rng);
    /// All on the diagonal, each twice.
    DiagonalTwice = "diagonal-twice" =>
        |n, rng| shuffled(indexed(n, |i| Point::new((i / 2.0).floor(), (i / 2.0).floor())), rng);
    /// All equal (A03).
    AllEqual = "all-equal" => |n, _| indexed(n, |_| Point::new(0.3, 0.7));
    /// All equal except one (A04).
    AllEqualButOne = "all-equal-but-one" =>
        |n, rng| shuffled(beside(Point::new(1.0, 1.0), n, |_| Point::new(0.3, 0.7)), rng);
    /// Uniform, three in ten repeat an earlier one (A05).
    Duplicates = "duplicates" => duplicates;
    /// Points that differ in the sign of a zero only, on a small grid (A06).
    SignedZeros = "signed-zeros" =>
        |n, rng| repeat(n, rng, |_, rng| Point::new(signed_small(rng), signed_small(rng)));
    /// A 3 × 3 block of neighbours 1 ulp apart at (1, 1) in a square of ±10 (A07).
    UlpBlock = "ulp-block" =>
        |n, rng| ulp_block(n, rng, 3, 1.0, &[(-10.0, -10.0), (10.0, -10.0), (10.0, 10.0), (-10.0, 10.0)]);
    /// A block of neighbours 1 ulp apart at (0.5, 0.5) against (12, 12) and (24, 24) (A08).
    UlpBlockOnLine = "ulp-block-on-line" =>
        |n, rng| ulp_block(n, rng, 64, 0.5, &[(12.0, 12.0), (24.0, 24.0)]);
    /// Exponents from 1e-300 to 1e300, both signs, zeros among them.
    MixedExponents = "mixed-exponents" =>
        |n, rng| repeat(n, rng, |_, rng| Point::new(wild(rng, 300.0), wild(rng, 300.0)));
    /// Exponents from 2^-60 to 2^60.
    ModerateExponents = "moderate-exponents" =>
        |n, rng| repeat(n, rng, |_, rng| Point::new(wild(rng, 18.0), wild(rng, 18.0)));
    /// Ordinates 5.6e141, abscissas from 1e-313 to 5e141, and one point below (A21).
    MixedMagnitudes = "mixed-magnitudes" => mixed_magnitudes;
    /// Uniform, rounded to 12 bits: many ties and duplicates (A24 in small).
    CoarseUniform = "coarse-uniform" =>
        |n, rng| repeat(n, rng, |_, rng| Point::new(coarse(rng), coarse(rng)));
    /// Uniform, rounded through `f32` (A24).
    F32Rounded = "f32-rounded" =>
        |n, rng| repeat(n, rng, |_, rng| Point::new(through_f32(rng.unit()), through_f32(rng.unit())));
    /// Zero to five points, as the seed says (A01).
    Tiny = "tiny" => tiny;
    /// (i, i²), in order (A16).
    Parabola = "parabola" => |n, _| indexed(n, |i| Point::new(i, i * i));
    /// (2^i, 0 or 1) for i from −140 (A16).
    Exponential = "exponential" =>
        |n, rng| shuffled(indexed(n, |i| Point::new(libm::exp2((i / 2.0).floor() - 140.0), i % 2.0)), rng);
    /// Archimedean spiral, in order (A16).
    Spiral = "spiral" => |n, _| indexed(n, |i| polar(1.0 + 0.05 * i, 0.3 * i));
    /// A rotated straight side: its points are nearly collinear and on the hull; one point above it
    /// (A15).
    NearCollinearHull = "near-collinear-hull" => near_collinear_hull;
    /// The square of ±1e308: differences overflow (A20).
    HugeSquare = "huge-square" => |n, rng| square(n, rng, 1e308);
    /// The square of ±1e300 (A20).
    LargeSquare = "large-square" => |n, rng| square(n, rng, 1e300);
    /// The square of ±1e-300: products vanish (A20).
    MinuteSquare = "minute-square" => |n, rng| square(n, rng, 1e-300);
    /// The smallest triangle there is and neighbours on the subnormal grid (A20).
    SubnormalTriangle = "subnormal-triangle" => subnormal_triangle;
    /// A disc and three points at 1e15: a finite super-triangle loses hull triangles (A25).
    FarTriangle = "far-triangle" => far_triangle;
    /// A box of width one ulp (A19).
    UlpWideBox = "ulp-wide-box" =>
        |n, rng| repeat(n, rng, |i, rng| Point::new(if i % 2 == 0 { 1.0 } else { next_up(1.0) }, rng.unit()));
    /// Random walk, in order: neighbours in the list are neighbours in the plane.
    RandomWalk = "random-walk" => random_walk;
}

/// `n` points from a maker that gets the index and the generator.
fn repeat(n: usize, rng: &mut SplitMix64, mut make: impl FnMut(usize, &mut SplitMix64) -> Point) -> Vec<Point> {
    (0..n).map(|i| make(i, rng)).collect()
}

/// `n` points from a maker that gets the index as a number.
fn indexed(n: usize, make: impl Fn(f64) -> Point) -> Vec<Point> {
    (0..n).map(|i| make(i as f64)).collect()
}

/// Points in random order.
pub(super) fn shuffled(mut points: Vec<Point>, rng: &mut SplitMix64) -> Vec<Point> {
    rng.shuffle(&mut points);
    points
}

/// One point and `n − 1` others.
fn beside(point: Point, n: usize, make: impl Fn(f64) -> Point) -> Vec<Point> {
    [vec![point], indexed(n.saturating_sub(1), make)].concat()
}

/// The origin before the points.
fn with_centre(points: Vec<Point>) -> Vec<Point> {
    [vec![Point::new(0.0, 0.0)], points].concat()
}

/// The rounded point at a distance and an angle in radians.
pub(super) fn polar(radius: f64, angle: f64) -> Point {
    Point::new(radius * libm::cos(angle), radius * libm::sin(angle))
}

/// `n` rounded points of a circle about the origin, counter-clockwise.
pub(super) fn circle(n: usize, radius: f64) -> Vec<Point> {
    indexed(n, |i| polar(radius, TAU * (i / n as f64)))
}

/// A square grid of at most `n` points, shuffled.
fn grid(n: usize, rng: &mut SplitMix64, make: impl Fn(f64, f64) -> Point) -> Vec<Point> {
    let side = n.isqrt();
    let cells = (0..side * side).map(|k| make((k % side) as f64, (k / side) as f64));
    shuffled(cells.collect(), rng)
}

/// An integer grid turned by 1 to 359 degrees, rounded.
fn rotated_grid(n: usize, rng: &mut SplitMix64) -> Vec<Point> {
    let angle = ((1 + rng.below(359)) as f64).to_radians();
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    grid(n, rng, |i, j| Point::new(i * cos - j * sin, i * sin + j * cos))
}

/// All integer points at an integer distance from the origin, shuffled.
fn integer_circle(radius: i32, rng: &mut SplitMix64) -> Vec<Point> {
    let across = (-radius..=radius).flat_map(|x| {
        let y = (radius * radius - x * x).isqrt();
        let whole = x * x + y * y == radius * radius;
        let both = if y == 0 { vec![0] } else { vec![y, -y] };
        both.into_iter().filter(move |_| whole).map(move |y| Point::new(f64::from(x), f64::from(y)))
    });
    shuffled(across.collect(), rng)
}

/// See [`PointSetKind::GaussianClusters`].
fn gaussian_clusters(n: usize, rng: &mut SplitMix64) -> Vec<Point> {
    repeat(n, rng, |i, rng| {
        let corner = Point::new((i % 2) as f64, (i / 2 % 2) as f64);
        Point::new(corner.x + 1e-9 * rng.gaussian(), corner.y + 1e-9 * rng.gaussian())
    })
}

/// See [`PointSetKind::Duplicates`].
fn duplicates(n: usize, rng: &mut SplitMix64) -> Vec<Point> {
    let mut points: Vec<Point> = Vec::with_capacity(n);
    for i in 0..n {
        let again = i > 0 && rng.below(10) < 3;
        let point = if again { points[rng.below(i)] } else { Point::new(rng.unit(), rng.unit()) };
        points.push(point);
    }
    points
}

/// −1, −0, 0 or 1.
fn signed_small(rng: &mut SplitMix64) -> f64 {
    [-1.0, -0.0, 0.0, 1.0][rng.below(4)]
}

/// Four in five from the upper end of the range are points of a block of 1-ulp steps; the rest are
/// the given ones.
fn ulp_block(n: usize, rng: &mut SplitMix64, side: usize, corner: f64, far: &[(f64, f64)]) -> Vec<Point> {
    let step = next_up(corner) - corner;
    let mut block: Vec<Point> = (0..side * side)
        .map(|k| Point::new(corner + (k % side) as f64 * step, corner + (k / side) as f64 * step))
        .collect();
    rng.shuffle(&mut block);
    let mut points: Vec<Point> = far.iter().map(|&(x, y)| Point::new(x, y)).chain(block).collect();
    points.truncate(n);
    shuffled(points, rng)
}

/// Zero, or a number of random sign and random decimal exponent up to `decades`.
fn wild(rng: &mut SplitMix64, decades: f64) -> f64 {
    if rng.below(12) == 0 {
        return 0.0;
    }
    let sign = if rng.below(2) == 0 { -1.0 } else { 1.0 };
    sign * rng.range(1.0, 2.0) * libm::exp10(rng.range(-decades, decades))
}

/// See [`PointSetKind::MixedMagnitudes`].
fn mixed_magnitudes(n: usize, rng: &mut SplitMix64) -> Vec<Point> {
    let top = |rng: &mut SplitMix64| Point::new(libm::exp10(rng.range(-313.0, 141.69)), 5.6e141);
    repeat(n, rng, |i, rng| if i == 0 { Point::new(6e-271, -5e260) } else { top(rng) })
}

/// A multiple of 2⁻¹² in [0, 1).
fn coarse(rng: &mut SplitMix64) -> f64 {
    rng.below(4096) as f64 / 4096.0
}

/// The nearest `f32`, widened again.
fn through_f32(v: f64) -> f64 {
    f64::from(v as f32)
}

/// See [`PointSetKind::Tiny`].
fn tiny(n: usize, rng: &mut SplitMix64) -> Vec<Point> {
    let size = rng.below(6).min(n);
    repeat(size, rng, |_, rng| Point::new(rng.below(3) as f64, rng.below(3) as f64))
}

/// See [`PointSetKind::NearCollinearHull`].
fn near_collinear_hull(n: usize, rng: &mut SplitMix64) -> Vec<Point> {
    let side = n.saturating_sub(1).max(1) as f64;
    let points = beside(Point::new(0.5, 0.5), n, |i| polar(i / side, 0.3));
    shuffled(points, rng)
}

/// The corners of a square about the origin and random points in it.
fn square(n: usize, rng: &mut SplitMix64, half: f64) -> Vec<Point> {
    let sign = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let inner = |rng: &mut SplitMix64| (2.0 * rng.unit() - 1.0) * half;
    repeat(n, rng, |i, rng| match sign.get(i) {
        Some(&(x, y)) => Point::new(x * half, y * half),
        None => Point::new(inner(rng), inner(rng)),
    })
}

/// See [`PointSetKind::SubnormalTriangle`].
fn subnormal_triangle(n: usize, rng: &mut SplitMix64) -> Vec<Point> {
    let step = |k: u64| f64::from_bits(k);
    let corners = [(0, 0), (1, 0), (0, 1)];
    repeat(n, rng, |i, rng| match corners.get(i) {
        Some(&(x, y)) => Point::new(step(x), step(y)),
        None => Point::new(step(rng.next_u64() % 8), step(rng.next_u64() % 8)),
    })
}

/// See [`PointSetKind::FarTriangle`].
fn far_triangle(n: usize, rng: &mut SplitMix64) -> Vec<Point> {
    let far = circle(3, 1e15);
    repeat(n, rng, |i, rng| match far.get(i) {
        Some(&p) => p,
        None => polar(rng.unit().sqrt(), rng.range(0.0, TAU)),
    })
}

/// See [`PointSetKind::RandomWalk`].
fn random_walk(n: usize, rng: &mut SplitMix64) -> Vec<Point> {
    let mut at = Point::new(0.0, 0.0);
    repeat(n, rng, |_, rng| {
        at = Point::new(at.x + rng.gaussian(), at.y + rng.gaussian());
        at
    })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::oracles::{convex_hull, convex_hull_size, in_circle};

    #[test]
    fn every_kind_is_finite_deterministic_and_small_enough() {
        let keys: BTreeSet<&str> = PointSetKind::ALL.iter().map(|k| k.key()).collect();
        assert_eq!(keys.len(), PointSetKind::ALL.len(), "keys are unique");
        for kind in PointSetKind::ALL {
            for n in [0, 1, 2, 3, 7, 200] {
                let points = point_set(kind, n, 9);
                assert!(points.len() <= n, "{kind:?}");
                assert!(points.iter().all(|p| p.x.is_finite() && p.y.is_finite()), "{kind:?}");
                assert_eq!(points, point_set(kind, n, 9), "{kind:?}");
            }
        }
    }

    #[test]
    fn circles_of_integers_are_exact() {
        assert_eq!(point_set(PointSetKind::Cocircular65, 1000, 0).len(), 36);
        let big = point_set(PointSetKind::Cocircular1105, 1000, 0);
        assert_eq!(big.len(), 108);
        assert!(big.iter().all(|&p| in_circle(
            Point::new(1105.0, 0.0),
            Point::new(0.0, 1105.0),
            Point::new(-1105.0, 0.0),
            p
        ) == 0));
    }

    #[test]
    fn lines_are_lines_and_rounded_lines_are_not() {
        for kind in [PointSetKind::VerticalLine, PointSetKind::HorizontalLine, PointSetKind::DiagonalLine] {
            assert_eq!(convex_hull(&point_set(kind, 100, 1)).len(), 2, "{kind:?}");
        }
        assert!(convex_hull_size(&point_set(PointSetKind::CollinearRounded, 100, 1)) > 2);
        assert!(convex_hull(&point_set(PointSetKind::CollinearRounded, 100, 1)).len() > 2);
    }
}
