//! The cost of a triangle.

use std::cmp::Ordering;

use crate::geometry::{AngleMeasure, HeightMeasure, Point, SlopeMeasure, largest_corner};

/// What makes a triangle bad.
pub(super) trait Criterion {
    /// How bad a triangle is.
    type Cost: Clone;

    /// The cost of a counter-clockwise triangle.
    fn cost(&self, t: [u32; 3]) -> Self::Cost;

    /// The order of costs: the greater, the worse.
    fn compare(&self, a: &Self::Cost, b: &Self::Cost) -> Ordering;

    /// What the cost is as a number.
    fn value(&self, cost: &Self::Cost) -> f64;

    /// Where a point lies.
    fn point(&self, v: u32) -> Point;

    /// The corners of a triangle.
    fn corners(&self, t: [u32; 3]) -> [Point; 3] {
        t.map(|v| self.point(v))
    }
}

/// The largest angle.
pub(super) struct LargestAngle<'a>(pub(super) &'a [Point]);

impl Criterion for LargestAngle<'_> {
    type Cost = AngleMeasure;

    fn cost(&self, t: [u32; 3]) -> AngleMeasure {
        AngleMeasure::new(from_largest(self.corners(t)))
    }

    fn compare(&self, a: &AngleMeasure, b: &AngleMeasure) -> Ordering {
        a.compare(b)
    }

    fn value(&self, cost: &AngleMeasure) -> f64 {
        cost.radians()
    }

    fn point(&self, v: u32) -> Point {
        self.0[v as usize]
    }
}

/// The smallest height; the smaller, the worse.
pub(super) struct SmallestHeight<'a>(pub(super) &'a [Point]);

impl Criterion for SmallestHeight<'_> {
    type Cost = HeightMeasure;

    fn cost(&self, t: [u32; 3]) -> HeightMeasure {
        HeightMeasure::new(from_largest(self.corners(t)))
    }

    fn compare(&self, a: &HeightMeasure, b: &HeightMeasure) -> Ordering {
        b.compare(a)
    }

    fn value(&self, cost: &HeightMeasure) -> f64 {
        cost.length()
    }

    fn point(&self, v: u32) -> Point {
        self.0[v as usize]
    }
}

/// The slope of the surface over a triangle.
pub(super) struct Slope<'a> {
    pub(super) points: &'a [Point],
    pub(super) heights: &'a [f64],
}

impl Criterion for Slope<'_> {
    type Cost = SlopeMeasure;

    fn cost(&self, mut t: [u32; 3]) -> SlopeMeasure {
        let first = (0..3).min_by_key(|&k| t[k]).unwrap_or(0);
        t.rotate_left(first);
        SlopeMeasure::new(t, self.corners(t), t.map(|v| self.heights[v as usize]))
    }

    fn compare(&self, a: &SlopeMeasure, b: &SlopeMeasure) -> Ordering {
        a.compare(b)
    }

    fn value(&self, cost: &SlopeMeasure) -> f64 {
        cost.slope()
    }

    fn point(&self, v: u32) -> Point {
        self.points[v as usize]
    }
}

/// The corners, that with the largest angle first.
fn from_largest(corners: [Point; 3]) -> [Point; 3] {
    let first = largest_corner(corners);
    [0, 1, 2].map(|k| corners[(first + k) % 3])
}
