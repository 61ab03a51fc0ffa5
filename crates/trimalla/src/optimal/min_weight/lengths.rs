//! Lengths of edges and sums of them, compared exactly.
//!
//! 1. A sum is first an interval of doubles around it, rounded outward, and a sum of two doubles with a bound of its
//!    error (`weight.rs`). Where two of these are apart, they decide.
//! 2. Otherwise the edges that both sums have are struck out, also edges of equal length.
//! 3. Coordinates are integers times a common power of two, so a squared length is an integer `D`. The rest of each sum
//!    is computed with square roots of 256 binary places. Each is rounded down, so that `k` roots are wrong by less
//!    than `k` last places; what is farther apart is decided.
//! 4. What is nearer may be equal. √D and √E are rational multiples of each other if and only if `D E` is a square.
//!    Edges are put into classes by this test, and `√E = √(D E) / D` counts in multiples of `√D / D`. Square roots of
//!    different classes are linearly independent over the rationals, so the sums are equal if and only if the counts of
//!    each class are.
//! 5. Sums that are neither equal nor told apart are computed with 1024 and 4096 places. After that nobody knows.
//!
//! # Source
//! Ours. The independence of the square roots of different square-free integers is a classical theorem of Besicovitch.

use std::cmp::Ordering;

use super::weight::{Weight, order_of_ways};
use crate::geometry::math::power_of_two_scale;
use crate::geometry::{Natural, Point, Vector};
use crate::half_edge::EdgeKey;

/// The digits of 64 bits behind the point of a square root, one round after the other.
const PLACES: [usize; 3] = [4, 16, 64];

/// Coordinates whose magnitudes are 0 or between these neither overflow nor vanish in what we compute (2^-400, 2^400).
const ORDINARY: std::ops::RangeInclusive<f64> = f64::from_bits((1023 - 400) << 52)..=f64::from_bits((1023 + 400) << 52);

/// The lengths between points.
#[derive(Clone, Debug)]
pub(super) struct Lengths<'a> {
    points: &'a [Point],
    /// The points, scaled by a power of two to about one.
    near: Vec<Point>,
    /// Whether scaling is exact and squares of differences neither overflow nor vanish.
    is_ordinary: bool,
    /// Coordinates are integers times two to this power.
    unit: i32,
    /// The integers, where they are small.
    whole: Vec<[i64; 2]>,
}

impl<'a> Lengths<'a> {
    /// The lengths between finite points.
    pub(super) fn new(points: &'a [Point]) -> Self {
        let coordinates = || points.iter().flat_map(|p| [p.x, p.y]).filter(|&x| x != 0.0);
        let largest = coordinates().fold(0.0, |most: f64, x| most.max(x.abs()));
        let scale = power_of_two_scale(largest);
        let is_ordinary = coordinates().all(|x| ORDINARY.contains(&(x * scale).abs()) && x * scale / scale == x);
        let near = points.iter().map(|p| Point::new(p.x * scale, p.y * scale)).collect();
        let unit = coordinates().map(|x| parts(x).1).min().unwrap_or(0);
        let is_small = coordinates().all(|x| bits_above(x, unit) <= 61);
        let whole =
            if is_small { points.iter().map(|p| [small(p.x, unit), small(p.y, unit)]).collect() } else { Vec::new() };
        Self { points, near, is_ordinary, unit, whole }
    }

    /// Whether rounded lengths and angles tell anything.
    pub(super) const fn is_ordinary(&self) -> bool {
        self.is_ordinary
    }

    /// The rounded way from one vertex to another, in the scale of all points.
    #[inline]
    pub(super) fn way(&self, from: u32, to: u32) -> Vector {
        self.near[to as usize] - self.near[from as usize]
    }

    /// The length of an edge, in the scale of all points.
    pub(super) fn of(&self, [a, b]: [u32; 2]) -> Weight {
        if self.is_ordinary { Weight::of(self.near[a as usize], self.near[b as usize]) } else { Weight::UNKNOWN }
    }

    /// The sum of the lengths of edges, rounded, in the caller's units.
    pub(super) fn sum(&self, edges: impl Iterator<Item = [u32; 2]>) -> f64 {
        let length =
            |[a, b]: [u32; 2]| crate::geometry::Segment::new(self.points[a as usize], self.points[b as usize]).length();
        edges.map(length).sum()
    }

    /// Compares the lengths of two edges.
    pub(super) fn compare(&self, one: [u32; 2], two: [u32; 2]) -> Ordering {
        if self.is_ordinary {
            let order = order_of_ways(self.way(one[0], one[1]), self.way(two[0], two[1]));
            if let Some(order) = order {
                return order;
            }
        }
        match (self.small_square(one), self.small_square(two)) {
            (Some(a), Some(b)) => a.cmp(&b),
            _ => self.square(one).cmp(&self.square(two)),
        }
    }

    /// The order of edges: by length, then by their vertices.
    pub(super) fn order(&self, one: [u32; 2], two: [u32; 2]) -> Ordering {
        self.compare(one, two).then_with(|| EdgeKey::of(one).cmp(&EdgeKey::of(two)))
    }

    /// What two sums of lengths do not have in common.
    pub(super) fn difference(&self, one: &[[u32; 2]], two: &[[u32; 2]]) -> Difference {
        Difference(if self.whole.is_empty() {
            rest(one.iter().map(|&e| self.square(e)), two.iter().map(|&e| self.square(e)))
        } else {
            let square = |&e: &[u32; 2]| self.small_square(e).unwrap_or(0);
            let small = rest(one.iter().map(square), two.iter().map(square));
            small.into_iter().map(|(square, count)| (Natural::shifted(square, 0), count)).collect()
        })
    }

    /// The squared length in units, where coordinates are small.
    fn small_square(&self, [a, b]: [u32; 2]) -> Option<u128> {
        let ([ax, ay], [bx, by]) = (*self.whole.get(a as usize)?, *self.whole.get(b as usize)?);
        let (x, y) = (u128::from(ax.abs_diff(bx)), u128::from(ay.abs_diff(by)));
        Some(x * x + y * y)
    }

    /// The squared length in units.
    fn square(&self, [a, b]: [u32; 2]) -> Natural {
        let (p, q) = (self.points[a as usize], self.points[b as usize]);
        let (x, y) = (self.distance(p.x, q.x), self.distance(p.y, q.y));
        let mut square = x.times(&x);
        square.add(&y.times(&y));
        square
    }

    /// The distance of two coordinates in units.
    fn distance(&self, a: f64, b: f64) -> Natural {
        let magnitude = |x: f64| {
            let (digits, exponent) = parts(x);
            Natural::shifted(u128::from(digits), usize::try_from(exponent - self.unit).unwrap_or(0))
        };
        let (one, two) = (magnitude(a), magnitude(b));
        if (a < 0.0) == (b < 0.0) {
            return Natural::distance(one, two);
        }
        let mut sum = one;
        sum.add(&two);
        sum
    }
}

/// The magnitude of a number as an odd integer times a power of two; zero is `(0, 0)`.
fn parts(x: f64) -> (u64, i32) {
    if x == 0.0 {
        return (0, 0);
    }
    let bits = x.to_bits();
    let exponent = ((bits >> 52) & 0x7ff) as i32;
    let fraction = bits & ((1 << 52) - 1);
    let (digits, exponent) = if exponent == 0 { (fraction, -1074) } else { (fraction | (1 << 52), exponent - 1075) };
    let zeros = digits.trailing_zeros();
    (digits >> zeros, exponent + zeros as i32)
}

/// The binary digits of a nonzero number as a multiple of `2^unit`.
fn bits_above(x: f64, unit: i32) -> i32 {
    let (digits, exponent) = parts(x);
    64 - digits.leading_zeros() as i32 + exponent - unit
}

/// A number as a multiple of `2^unit`; it has at most 61 binary digits.
fn small(x: f64, unit: i32) -> i64 {
    let (digits, exponent) = parts(x);
    let magnitude = if digits == 0 { 0 } else { (digits << (exponent - unit)) as i64 };
    if x < 0.0 { -magnitude } else { magnitude }
}

/// A sum of square roots of integers, each with its count.
#[derive(Clone, Debug)]
pub(super) struct Difference(Vec<(Natural, i64)>);

impl Difference {
    /// The number of different roots.
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// Its sign, as the order of the sums; nothing if 4096 binary places do not tell.
    pub(super) fn sign(&self) -> Option<Ordering> {
        sign_of_sum(&self.0)
    }
}

/// Step 2: each number once, with how often the first list has it more often than the second; zeros left out.
fn rest<T: Ord>(one: impl Iterator<Item = T>, two: impl Iterator<Item = T>) -> Vec<(T, i64)> {
    let mut all: Vec<(T, i64)> = one.map(|square| (square, 1)).chain(two.map(|square| (square, -1))).collect();
    all.sort_unstable_by(|a, b| a.0.cmp(&b.0));
    let mut terms: Vec<(T, i64)> = Vec::with_capacity(all.len());
    for (square, count) in all {
        match terms.last_mut() {
            Some(last) if last.0 == square => last.1 += count,
            _ => terms.push((square, count)),
        }
    }
    terms.retain(|&(_, count)| count != 0);
    terms
}

/// Steps 3 to 5: the sign of a sum of square roots, each with its count.
fn sign_of_sum(terms: &[(Natural, i64)]) -> Option<Ordering> {
    if terms.is_empty() {
        return Some(Ordering::Equal);
    }
    let mut may_be_equal = true;
    for places in PLACES {
        let decided = rounded_sign(terms, places);
        if decided.is_some() {
            return decided;
        }
        if may_be_equal && is_zero(terms) {
            return Some(Ordering::Equal);
        }
        may_be_equal = false;
    }
    None
}

/// Step 3: the sign, if roots of so many digits behind the point tell it.
fn rounded_sign(terms: &[(Natural, i64)], places: usize) -> Option<Ordering> {
    let mut sums = [Natural::default(), Natural::default()];
    let mut error = 0;
    for (square, count) in terms {
        let root = square.raised(2 * places).root();
        sums[usize::from(*count < 0)].add(&root.times_small(count.unsigned_abs()));
        error += count.unsigned_abs();
    }
    let [plus, minus] = sums;
    let sign = plus.cmp(&minus);
    (Natural::distance(plus, minus) > Natural::shifted(u128::from(error), 0)).then_some(sign)
}

/// Step 4: whether the counts of each class add up to nothing.
fn is_zero(terms: &[(Natural, i64)]) -> bool {
    let mut classes: Vec<(&Natural, [Natural; 2])> = Vec::new();
    for (square, count) in terms.iter().filter(|(square, _)| !square.is_zero()) {
        let side = usize::from(*count < 0);
        let found = classes.iter_mut().find_map(|(first, sums)| Some((first.times(square).exact_root()?, sums)));
        if let Some((root, sums)) = found {
            sums[side].add(&root.times_small(count.unsigned_abs()));
        } else {
            let mut sums = [Natural::default(), Natural::default()];
            sums[side] = square.times_small(count.unsigned_abs());
            classes.push((square, sums));
        }
    }
    classes.iter().all(|(_, [plus, minus])| plus == minus)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sign(terms: &[(u128, i64)]) -> Option<Ordering> {
        let terms: Vec<(Natural, i64)> =
            terms.iter().map(|&(square, count)| (Natural::shifted(square, 0), count)).collect();
        sign_of_sum(&terms)
    }

    #[test]
    fn equal_sums_of_square_roots_are_known_to_be_equal() {
        // √8 + √18 = 5 √2 = √50, and √27 = 3 √3.
        assert_eq!(sign(&[(8, 1), (18, 1), (50, -1)]), Some(Ordering::Equal));
        assert_eq!(sign(&[(8, 1), (18, 1), (27, 1), (50, -1), (3, -3)]), Some(Ordering::Equal));
        assert_eq!(sign(&[(8, 1), (18, 1), (51, -1)]), Some(Ordering::Less));
        assert_eq!(sign(&[(2, 1), (3, 1), (10, -1)]), Some(Ordering::Less));
        assert_eq!(sign(&[(4, 1), (9, -1), (1, 1)]), Some(Ordering::Equal));
    }

    #[test]
    fn sums_that_differ_in_the_fortieth_place_are_told_apart() {
        // √(n - 1) + √(n + 1) is less than 2 √n, by about n^(-3/2) / 4.
        let n = 1_u128 << 100;
        assert_eq!(sign(&[(n - 1, 1), (n + 1, 1), (n, -2)]), Some(Ordering::Less));
        assert_eq!(sign(&[(n - 1, -1), (n + 1, -1), (n, 2)]), Some(Ordering::Greater));
    }

    #[test]
    fn lengths_of_all_magnitudes_are_compared() {
        for points in [
            [(0.0, 0.0), (3.0, 4.0), (5.0, 0.0), (0.0, 5.0 + 1e-14)],
            [(0.0, 0.0), (3e-320, 4e-320), (5e-320, 0.0), (0.0, 6e-320)],
            [(-1e300, 0.0), (1e300, 0.0), (-1e300, 2e300), (1e300, 2e300)],
        ] {
            let points = points.map(|(x, y)| Point::new(x, y));
            let lengths = Lengths::new(&points);
            for one in [[0, 1], [0, 2], [1, 2]] {
                for two in [[0, 1], [0, 2], [0, 3], [2, 3]] {
                    let order = lengths.compare(one, two);
                    assert_eq!(order, lengths.square(one).cmp(&lengths.square(two)));
                    assert_eq!(lengths.difference(&[one], &[two]).sign(), Some(order));
                    assert_eq!(lengths.difference(&[two, [1, 3]], &[[1, 3], one]).sign(), Some(order.reverse()));
                }
            }
        }
    }
}
