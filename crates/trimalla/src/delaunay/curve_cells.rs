//! Grids of cells over points, whose cells a curve visits in order.
//!
//! In a heavy-tailed set a few points are very far out, and nearly all others would lie in a few cells of a grid over
//! all points. So the grid covers the core only, which a sample finds; the points outside of the core come last, all
//! with one key.

use crate::geometry::{BoundingBox, Point, hilbert_key_16};

/// From so many points on a sample looks for a core.
const SAMPLED_FROM: usize = 4096;
/// Points of a sample.
const SAMPLE: usize = 1024;
/// One in so many of the sample is left out of the core, on each of its sides.
const OUTERMOST: usize = 64;
/// A set is heavy-tailed where its box has more than this many times the extent of its core.
const HEAVY: f64 = 16.0;

/// A grid of 2¹⁶ × 2¹⁶ cells over a box.
#[derive(Clone, Debug)]
pub(crate) struct CurveCells {
    min: Point,
    /// Cells a unit; coordinates are halved before subtraction so that nothing overflows.
    scale: f64,
}

impl CurveCells {
    pub(crate) fn around(bounds: Option<BoundingBox>) -> Self {
        let Some(bounds) = bounds else { return Self { min: Point::default(), scale: 0.0 } };
        let scale = 65535.0 / half_extent(bounds);
        Self { min: bounds.min, scale: if scale.is_finite() { scale } else { 0.0 } }
    }

    #[inline]
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the cast saturates, and the cell is an order only"
    )]
    pub(crate) fn key(&self, p: Point) -> u32 {
        let cell = |c: f64, min: f64| ((c * 0.5 - min * 0.5) * self.scale) as u16;
        hilbert_key_16(cell(p.x, self.min.x), cell(p.y, self.min.y))
    }
}

/// The grid over a set of points, or over its core where the set is heavy-tailed.
#[derive(Clone, Debug)]
pub(super) struct CoreCells {
    cells: CurveCells,
    core: Option<BoundingBox>,
}

impl CoreCells {
    /// The grid over `point(0)`, `point(1)`, …, `point(len - 1)`, all finite.
    ///
    /// # Complexity
    /// Linear.
    pub(super) fn over(len: usize, point: impl Fn(usize) -> Point) -> Self {
        let bounds = BoundingBox::of_finite((0..len).map(&point));
        let core = bounds.and_then(|bounds| core(len, &point, bounds));
        Self { cells: CurveCells::around(core.or(bounds)), core }
    }

    /// The place of a point on the curve; the last one for all points outside of the core.
    #[inline]
    pub(super) fn key(&self, p: Point) -> u32 {
        match self.core {
            Some(core) if !core.contains(p) => u32::MAX,
            _ => self.cells.key(p),
        }
    }
}

/// The box around the core of a set in `bounds`; `None` where the set is not heavy-tailed.
///
/// # Guarantees
/// At least three quarters of the points lie in the core, whatever the sample was: so sorting the others again takes a
/// bounded share of the time.
fn core(len: usize, point: impl Fn(usize) -> Point, bounds: BoundingBox) -> Option<BoundingBox> {
    if len < SAMPLED_FROM {
        return None;
    }
    let sample: Vec<Point> = (0..SAMPLE).map(|i| point(i * (len / SAMPLE))).collect();
    let [x, y] = [inner_range(sample.iter().map(|p| p.x)), inner_range(sample.iter().map(|p| p.y))];
    let inner = BoundingBox { min: Point::new(x[0], y[0]), max: Point::new(x[1], y[1]) };
    if half_extent(bounds) <= HEAVY * half_extent(inner) {
        return None;
    }
    let core = widened(inner, bounds);
    let outside = (0..len).filter(|&i| !core.contains(point(i))).count();
    (outside <= len / 4).then_some(core)
}

/// The least and the greatest value without the outermost ones.
fn inner_range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let mut values: Vec<f64> = values.collect();
    let left_out = values.len() / OUTERMOST;
    [left_out, values.len() - 1 - left_out].map(|i| *values.select_nth_unstable_by(i, f64::total_cmp).1)
}

/// The box with a quarter of its extents added on each side, as far as `bounds` reach.
fn widened(inner: BoundingBox, bounds: BoundingBox) -> BoundingBox {
    let margin = Point::new(inner.half_width() / 2.0, inner.half_height() / 2.0);
    let min = Point::new(inner.min.x - margin.x, inner.min.y - margin.y);
    let max = Point::new(inner.max.x + margin.x, inner.max.y + margin.y);
    BoundingBox { min: bounds.clamp(min), max: bounds.clamp(max) }
}

/// Half the larger extent, always finite.
fn half_extent(bounds: BoundingBox) -> f64 {
    bounds.half_width().max(bounds.half_height())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The core of points that are evenly spread, each so many times as far out as `tail` says.
    fn core_of(len: usize, tail: impl Fn(usize) -> f64) -> Option<BoundingBox> {
        let point = |i: usize| {
            let [x, y] = [i * 7919 % len, i * 104_729 % len].map(|c| c as f64 / len as f64 - 0.5);
            Point::new(x * tail(i), y * tail(i))
        };
        core(len, point, BoundingBox::of((0..len).map(point))?)
    }

    #[test]
    fn only_a_heavy_tailed_set_has_a_core() {
        assert_eq!(core_of(10_007, |_| 1.0), None);
        assert_eq!(core_of(10_007, |i| if i % 100 == 1 { 10.0 } else { 1.0 }), None);
        assert_eq!(core_of(4001, |i| if i % 100 == 1 { 1e6 } else { 1.0 }), None, "few points need none");
        let core = core_of(10_007, |i| if i % 100 == 1 { 1e6 } else { 1.0 }).expect("one in a hundred is far out");
        assert!(half_extent(core) < 1.0, "{core:?}");
        assert!(core.contains(Point::new(0.45, -0.45)));
    }

    #[test]
    fn a_core_holds_most_points_whatever_the_sample_says() {
        // The sample has every ninth point of these, all in the middle.
        assert_eq!(core_of(9 * 1024, |i| if i % 9 == 0 { 1e-6 } else { 1.0 }), None);
        assert!(core_of(9 * 1024, |i| if i % 9 == 1 { 1e6 } else { 1.0 }).is_some());
    }

    #[test]
    fn a_core_at_the_end_of_the_numbers_is_finite() {
        let far = |i: usize| if i == 1 { Point::new(-f64::MAX, f64::MAX) } else { Point::new(f64::MAX, i as f64) };
        let bounds = BoundingBox { min: Point::new(-f64::MAX, 0.0), max: Point::new(f64::MAX, f64::MAX) };
        let core = core(5000, far, bounds).expect("heavy-tailed");
        assert!(core.min.is_finite() && core.max.is_finite(), "{core:?}");
    }
}
