//! The lattice of equilateral triangles: the best filling of a plane without features.
//!
//! ```text
//!      o───o───o───o         Rows lie √3/2 of the spacing apart, every other one half a spacing further.
//!     / \ / \ / \ /
//!    o───o───o───o
//!     \ / \ / \ / \
//!      o───o───o───o
//! ```
//!
//! Nodes are jittered by a ten-thousandth of the spacing, by a hash of their row and column. An exact lattice would put
//! six nodes on a circle and hundreds on a line, and each predicate on them would need exact arithmetic.

use std::ops::ControlFlow;

use crate::geometry::{BoundingBox, Point};

/// The largest jitter of a node along each axis, in spacings.
const JITTER: f64 = 1e-4;
/// The area bound over the area of a triangle without jitter: more than the jitter of its corners can add.
const SLACK: f64 = 1.0 + 10.0 * JITTER;
/// The largest number of rows and columns.
const MOST_ROWS: f64 = (1u32 << 30) as f64;
/// Lengths up to this one, and down to its inverse, have ordinary squares.
const GREATEST: f64 = 1e150;

/// A lattice over a box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::refine) struct Lattice {
    origin: Point,
    spacing: f64,
}

impl Lattice {
    /// The lattice whose triangles just meet a bound on areas; `None` where rounding would deform it.
    pub(in crate::refine) fn for_area(bounds: BoundingBox, max_area: f64) -> Option<Self> {
        // An equilateral triangle of side s has area √3/4 s².
        let spacing = (max_area / SLACK * (4.0 / 3f64.sqrt())).sqrt();
        let extent = 2.0 * bounds.half_width().max(bounds.half_height());
        let largest = extent.max(bounds.largest_coordinate());
        let is_sound = largest < GREATEST && largest / spacing < MOST_ROWS;
        (is_sound && spacing > 1.0 / GREATEST).then_some(Self { origin: bounds.min, spacing })
    }

    /// The distance of neighbours.
    pub(in crate::refine) const fn spacing(self) -> f64 {
        self.spacing
    }

    /// The distance of rows.
    fn row_height(self) -> f64 {
        self.spacing * (3f64.sqrt() / 2.0)
    }

    /// The mean number of nodes in a region of this area.
    pub(in crate::refine) fn nodes_in_area(self, area: f64) -> f64 {
        area / (self.spacing * self.row_height())
    }

    /// An upper bound on the number of rows that cross a triangle.
    pub(in crate::refine) fn rows_across(self, corners: [Point; 3]) -> f64 {
        let [low, high] = span(corners);
        (high - low) / self.row_height() + 1.0
    }

    /// Calls `call` with every node of a triangle, row by row, until a call breaks. A node on an edge belongs to one of
    /// the two triangles beside it.
    ///
    /// A row along a triangle that is flat but for rounding may hold many more nodes than the area suggests.
    ///
    /// # Complexity
    /// Linear in the rows that cross the triangle and in the nodes.
    pub(in crate::refine) fn try_for_each_node_in(
        self,
        corners: [Point; 3],
        mut call: impl FnMut(Point) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let height = self.row_height();
        let [low, high] = span(corners).map(|y| ((y - self.origin.y) / height).ceil());
        for row in whole(low)..whole(high) {
            let y = self.origin.y + row as f64 * height;
            let offset = if row % 2 == 0 { 0.0 } else { 0.5 };
            let Some(cut) = cut_at(corners, y) else { continue };
            // Rounded, but to the same values for both triangles at an edge.
            let [first, end] = cut.map(|x| ((x - self.origin.x) / self.spacing - offset).ceil());
            for column in whole(first)..whole(end) {
                let x = self.origin.x + (column as f64 + offset) * self.spacing;
                let [dx, dy] = jitter(row, column).map(|d| d * JITTER * self.spacing);
                call(Point::new(x + dx, y + dy))?;
            }
        }
        ControlFlow::Continue(())
    }
}

/// The lowest and the highest y.
fn span(corners: [Point; 3]) -> [f64; 2] {
    let [a, b, c] = corners.map(|p| p.y);
    [a.min(b).min(c), a.max(b).max(c)]
}

/// Where a level line enters and leaves a triangle; the lower ends of its edges count, the upper ones do not.
fn cut_at([a, b, c]: [Point; 3], y: f64) -> Option<[f64; 2]> {
    let crossing = |p: Point, q: Point| {
        let (low, high) = if (p.y, p.x) < (q.y, q.x) { (p, q) } else { (q, p) };
        (low.y <= y && y < high.y).then(|| low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x))
    };
    let mut crossings = [crossing(a, b), crossing(b, c), crossing(c, a)].into_iter().flatten();
    let (first, second) = (crossings.next()?, crossings.next()?);
    Some([first.min(second), first.max(second)])
}

/// Converts a whole number, which the lattice keeps small.
#[allow(clippy::cast_possible_truncation, reason = "the cast saturates")]
fn whole(x: f64) -> i64 {
    x as i64
}

/// Two pseudo-random numbers between −1 and 1.
fn jitter(row: i64, column: i64) -> [f64; 2] {
    let mut h = (row as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (column as u64).wrapping_mul(0xd1b5_4a32_d192_ed03);
    h ^= h >> 32;
    h = h.wrapping_mul(0xbf58_476d_1ce4_e5b9);
    h ^= h >> 29;
    [h >> 32, h & 0xffff_ffff].map(|half| half as f64 / f64::from(1u32 << 31) - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Triangle;

    fn bounds(side: f64) -> BoundingBox {
        BoundingBox { min: Point::new(-side, -side), max: Point::new(side, side) }
    }

    fn nodes_in(lattice: Lattice, corners: [[f64; 2]; 3]) -> Vec<Point> {
        let mut nodes = Vec::new();
        let all = lattice.try_for_each_node_in(corners.map(Point::from), |node| {
            nodes.push(node);
            ControlFlow::Continue(())
        });
        assert!(all.is_continue(), "nothing breaks off");
        nodes
    }

    #[test]
    fn triangles_share_no_node_and_leave_none_out() {
        let lattice = Lattice::for_area(bounds(8.0), 0.05).expect("sound");
        let corners = [[-8.0, -8.0], [8.0, -8.0], [8.0, 8.0], [-8.0, 8.0]];
        let [a, b, c, d] = corners;
        let whole: Vec<Point> = [nodes_in(lattice, [a, b, c]), nodes_in(lattice, [a, c, d])].concat();
        let expected = lattice.nodes_in_area(256.0);
        assert!((whole.len() as f64 - expected).abs() < 0.05 * expected, "{} of {expected}", whole.len());
        for apex in [[0.0, 0.0], [0.3, -2.0], [7.9, 7.9], [-5.0, 8.0 / 3.0]] {
            let mut parts: Vec<Point> = [[a, b], [b, c], [c, d], [d, a]]
                .into_iter()
                .flat_map(|[p, q]| nodes_in(lattice, [p, q, apex]))
                .collect();
            assert_eq!(parts.len(), whole.len(), "{apex:?}");
            let order = |p: &Point, q: &Point| p.y.total_cmp(&q.y).then(p.x.total_cmp(&q.x));
            let mut sorted = whole.clone();
            sorted.sort_by(order);
            parts.sort_by(order);
            assert_eq!(parts, sorted, "{apex:?}");
        }
    }

    #[test]
    fn jittered_triangles_stay_below_the_bound() {
        let lattice = Lattice::for_area(bounds(8.0), 0.05).expect("sound");
        let nodes = nodes_in(lattice, [[-6.0, -6.0], [6.0, -6.0], [0.0, 7.0]]);
        let near = |p: Point, q: Point| (p - q).length_sq() < 1.1 * lattice.spacing() * lattice.spacing();
        let mut largest = 0f64;
        for (i, &p) in nodes.iter().enumerate().step_by(7) {
            let around: Vec<Point> = nodes[..i].iter().copied().filter(|&q| near(p, q)).collect();
            for (k, &q) in around.iter().enumerate() {
                for &r in around[..k].iter().filter(|&&r| near(q, r)) {
                    largest = largest.max(Triangle::new(p, q, r).area());
                }
            }
        }
        assert!((0.0499..=0.05).contains(&largest), "{largest}");
    }

    #[test]
    fn where_rounding_would_deform_it_there_is_none() {
        for (side, area) in [(1.0, 1e-30), (1.0, 5e-324), (1e200, 1e300), (f64::MAX, 1.0), (1.0, f64::MAX)] {
            let lattice = Lattice::for_area(bounds(side), area);
            assert!(lattice.is_none() || area == f64::MAX, "{side}, {area}: {lattice:?}");
        }
    }

    #[test]
    fn scaled_by_a_power_of_two_it_is_the_same() {
        let [small, large] = [1.0, 1024.0].map(|scale| {
            let lattice = Lattice::for_area(bounds(scale), 0.01 * scale * scale).expect("sound");
            nodes_in(lattice, [[-scale, -scale], [scale, -0.5 * scale], [0.0, scale]])
        });
        let scaled: Vec<Point> = small.iter().map(|p| Point::new(1024.0 * p.x, 1024.0 * p.y)).collect();
        assert!(large.len() > 50);
        assert_eq!(scaled, large);
    }
}
