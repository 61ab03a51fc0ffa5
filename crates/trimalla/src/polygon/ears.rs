//! `ears`: corners are cut off one after the other.
//!
//! An *ear* is a corner whose inside angle is less than a half-turn, and in whose triangle no other corner lies. Every
//! polygon with more than three corners has two (`[Meisters75]`), so cutting off any of them never gets stuck.
//!
//! ```text
//!         b                    1. Prove the polygon valid, find its loops, and join holes by bridges (`loops.rs`).
//!        / \                   2. Go round the loop. A corner b between a and c is an ear if a, b, c turn left, and no
//!       /   \    .--          corner that is not convex lies in the triangle a b c, boundary included.
//!      a - - c--'             3. Cut it off: the triangle is done, and a and c are neighbours now. Go on after c, so
//!     /                          that the triangles do not all meet in one corner.
//!    '---                     4. Stop when two corners are left.
//! ```
//!
//! *Why corners that are not convex suffice in step 2.* Of the corners in the triangle take the one nearest to b. No
//! side passes between it and b, so the inside is on that side of it, and its angle is a half-turn or more.
//!
//! *Corners at a corner of the triangle* do not count. A loop keeps to one part of the inside, so the sides at such a
//! corner do not lead into the triangle, unless to a corner inside it, which counts.
//!
//! *Degenerate cases.* A flat corner is not an ear; it becomes a corner of other triangles. The boundary of the
//! triangle belongs to it in step 2, so no diagonal passes through a vertex.
//!
//! # Complexity
//! O(n log n) for step 1, O(n²) for the rest at worst. A grid of the corners that are not convex makes most tests
//! short.
//!
//! # Source
//! `[Meisters75]`; `[ORourke98]`, section 1.6, for the algorithm.

use super::loops::Loops;
use super::{Polygon, PolygonError};
use crate::geometry::{BoundingBox, Point, ccw, left_on};
use crate::trace::{Shape, Trace};

/// Triangulates a polygon with holes by cutting off ears.
///
/// # Shape
/// Counter-clockwise triangles; `n - 2 + 2h` of them for `n` corners and `h` holes, if no rings touch.
///
/// # Errors
/// Flat rings, sides that cross or overlap, holes outside the outline, `Cancelled`.
///
/// # Complexity
/// O(n²) at worst.
///
/// # Source
/// `[Meisters75]`
///
/// ```
/// use trimalla::geometry::Point;
/// use trimalla::polygon::{Polygon, ears};
/// use trimalla::trace::NoTrace;
///
/// let arrow = [[0.0, 0.0], [4.0, 2.0], [0.0, 4.0], [1.0, 2.0]].map(Point::from);
/// let triangles = ears(Polygon::new(&arrow, &[4])?, &mut NoTrace)?;
/// assert_eq!(triangles.len(), 2);
/// # Ok::<(), trimalla::polygon::PolygonError>(())
/// ```
pub fn ears(polygon: Polygon<'_>, trace: &mut (impl Trace + ?Sized)) -> Result<Vec<[u32; 3]>, PolygonError> {
    let mut loops = Loops::of(polygon, trace)?;
    let grid = Grid::of(&loops);
    let mut triangles = Vec::with_capacity(loops.points.len());
    for which in 0..loops.begins.len() {
        cut_ears(&mut loops, which, &grid, &mut triangles, trace)?;
    }
    Ok(triangles)
}

/// Cuts off the ears of a loop until two corners are left.
fn cut_ears(
    loops: &mut Loops,
    which: usize,
    grid: &Grid,
    triangles: &mut Vec<[u32; 3]>,
    trace: &mut (impl Trace + ?Sized),
) -> Result<(), PolygonError> {
    let mut at = loops.begins[which];
    let mut refused_from = at;
    loop {
        let [before, after] = [loops.previous[at as usize], loops.next[at as usize]];
        if before == after {
            return Ok(());
        }
        if trace.is_cancelled() {
            return Err(PolygonError::Cancelled);
        }
        let triangle = [before, at, after].map(|c| loops.vertices[c as usize]);
        if is_ear(loops, grid, [before, at, after]) {
            trace.add(Shape::Triangle(triangle), "an ear is cut off");
            triangles.push(triangle);
            loops.link(before, after);
            loops.previous[at as usize] = at;
            loops.next[at as usize] = at;
            at = loops.next[after as usize];
            refused_from = at;
            continue;
        }
        trace.refuse(Shape::Triangle(triangle), "no ear");
        at = after;
        if at == refused_from {
            // Only a loop that is no valid polygon has no ear.
            let first = loops.vertices[at as usize];
            return Err(PolygonError::Flat { ring: 0, first });
        }
    }
}

/// Whether a corner between two others is an ear.
fn is_ear(loops: &Loops, grid: &Grid, corners: [u32; 3]) -> bool {
    let [a, b, c] = corners.map(|c| loops.at(c));
    if !ccw(a, b, c) {
        return false;
    }
    let bounds = BoundingBox::around(a).including(b).including(c);
    !grid.any(bounds, |corner| {
        let p = loops.at(corner);
        p.x >= bounds.min.x
            && p.x <= bounds.max.x
            && p.y >= bounds.min.y
            && p.y <= bounds.max.y
            && p != a
            && p != b
            && p != c
            && left_on(a, b, p)
            && left_on(b, c, p)
            && left_on(c, a, p)
            && loops.next[corner as usize] != corner
    })
}

/// The corners that are not convex, by the cells of a grid.
struct Grid {
    bounds: BoundingBox,
    /// Cells along each axis.
    side: usize,
    /// Where the corners of each cell begin in the list.
    begins: Vec<u32>,
    corners: Vec<u32>,
}

impl Grid {
    /// How many corners a cell has on average.
    const EACH: usize = 2;

    fn of(loops: &Loops) -> Self {
        let turns = |c: u32| {
            let [before, after] = [loops.previous[c as usize], loops.next[c as usize]];
            ccw(loops.at(before), loops.at(c), loops.at(after))
        };
        let all: Vec<u32> = (0..loops.points.len() as u32).filter(|&c| !turns(c)).collect();
        let bounds = BoundingBox::of(loops.points.iter().copied()).unwrap_or(BoundingBox::around(Point::default()));
        let side = ((all.len() / Self::EACH) as f64).sqrt().ceil().max(1.0) as usize;
        let mut grid = Self { bounds, side, begins: vec![0; side * side + 1], corners: vec![0; all.len()] };
        let cell = |c: u32| grid.row(loops.at(c).y) * side + grid.column(loops.at(c).x);
        let cells: Vec<usize> = all.iter().map(|&c| cell(c)).collect();
        for &cell in &cells {
            grid.begins[cell + 1] += 1;
        }
        for cell in 0..side * side {
            grid.begins[cell + 1] += grid.begins[cell];
        }
        let mut free = grid.begins.clone();
        for (&c, &cell) in all.iter().zip(&cells) {
            grid.corners[free[cell] as usize] = c;
            free[cell] += 1;
        }
        grid
    }

    /// The column of a coordinate; larger coordinates are never in an earlier one.
    fn column(&self, x: f64) -> usize {
        self.slot(x, self.bounds.min.x, self.bounds.max.x)
    }

    fn row(&self, y: f64) -> usize {
        self.slot(y, self.bounds.min.y, self.bounds.max.y)
    }

    fn slot(&self, at: f64, min: f64, max: f64) -> usize {
        // Halves, so that no difference overflows.
        let part = (0.5 * at - 0.5 * min) / (0.5 * max - 0.5 * min);
        ((part * self.side as f64) as usize).min(self.side - 1)
    }

    /// Whether any corner in the cells of a box is of some kind.
    fn any(&self, bounds: BoundingBox, mut test: impl FnMut(u32) -> bool) -> bool {
        let columns = [bounds.min.x, bounds.max.x].map(|x| self.column(x));
        (self.row(bounds.min.y)..=self.row(bounds.max.y)).any(|row| {
            let begin = self.begins[row * self.side + columns[0]] as usize;
            let end = self.begins[row * self.side + columns[1] + 1] as usize;
            self.corners[begin..end].iter().any(|&c| test(c))
        })
    }
}
