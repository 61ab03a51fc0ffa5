//! Sums of lengths with about 100 binary places.

use std::cell::Cell;
use std::cmp::Ordering;

use crate::geometry::Point;
use crate::geometry::math::power_of_two_scale;
use crate::optimal::decompose::Objective;
use crate::optimal::twofold::Twofold;

/// Sums that differ by less than this part of themselves count as equal: 2^-88. A length is off by less than 2^-100 of
/// itself, and so is an addition.
const EQUAL: f64 = f64::from_bits((1023 - 88) << 52);

/// The sum of lengths is minimised.
pub(super) struct TotalLength {
    /// The points, scaled by a power of two so that nothing overflows.
    points: Vec<Point>,
    /// Whether two sums could not be told apart.
    is_open: Cell<bool>,
}

/// A sum of lengths.
#[derive(Clone, Copy, Debug)]
pub(super) struct Total {
    length: Twofold,
    /// Equal for sums of the same lengths: the sum of hashes of their squares.
    fingerprint: u64,
}

impl TotalLength {
    /// The lengths between points.
    pub(super) fn new(points: &[Point]) -> Self {
        let largest = points.iter().fold(0.0_f64, |m, p| m.max(p.x.abs()).max(p.y.abs()));
        let scale = power_of_two_scale(largest);
        let points = points.iter().map(|p| Point::new(p.x * scale, p.y * scale)).collect();
        Self { points, is_open: Cell::new(false) }
    }

    /// Whether two different sums could not be told apart.
    pub(super) fn was_open(&self) -> bool {
        self.is_open.get()
    }
}

impl Objective for TotalLength {
    type Value = Total;

    fn edge(&self, [a, b]: [u32; 2]) -> Total {
        let [p, q] = [self.points[a as usize], self.points[b as usize]];
        let square = Twofold::distance_sq(p, q);
        Total { length: square.root(), fingerprint: square.hash() }
    }

    fn join(&self, a: &Total, b: &Total) -> Total {
        let fingerprint = a.fingerprint.wrapping_add(b.fingerprint);
        Total { length: a.length.plus(b.length), fingerprint }
    }

    fn compare(&self, a: &Total, b: &Total) -> Ordering {
        let excess = a.length.plus(b.length.negated()).head;
        if excess.abs() > EQUAL * (a.length.head + b.length.head) {
            return excess.total_cmp(&0.0);
        }
        if a.fingerprint != b.fingerprint {
            self.is_open.set(true);
        }
        Ordering::Equal
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_of_the_same_lengths_are_equal() {
        let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from);
        let total = TotalLength::new(&points);
        let [one, two] = [[0, 2], [1, 3]].map(|edge| total.edge(edge));
        assert_eq!(total.compare(&one, &two), Ordering::Equal);
        assert!(!total.was_open());
        let side = total.edge([0, 1]);
        assert_eq!(total.compare(&side, &one), Ordering::Less);
        // √2 + √2 = √8, which only its root shows.
        let points = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]].map(Point::from);
        let total = TotalLength::new(&points);
        let twice = total.join(&total.edge([0, 1]), &total.edge([1, 2]));
        assert_eq!(total.compare(&twice, &total.edge([0, 2])), Ordering::Equal);
        assert!(total.was_open());
    }
}
