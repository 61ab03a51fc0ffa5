//! Delaunay triangulation by divide and conquer.
//!
//! # Idea
//! Points sorted along a direction fall into two halves that a line separates. Each half is triangulated on its own,
//! and the two triangulations are sewn together along the line. Sewing destroys some edges inside the halves and
//! creates only edges from one half to the other, each found by a circle that rises through the gap between them:
//! [`merge`] has the details.
//!
//! # Steps
//! 1. Gather the sites: the points in lexicographic order, beside each other in memory.
//! 2. Cut the sites by vertical lines, in halves, until a *strip* holds about `√(n log n)` of them.
//! 3. Sort the strip by height and cut it by horizontal lines, in halves, until two or three sites are left.
//! 4. Two sites make an edge, three make a triangle or, on one line, a chain of two edges.
//! 5. Merge the halves of the strip, upwards; then hand over the strip's leftmost and rightmost vertex instead of its
//!    lowest and highest.
//! 6. Merge the strips, rightwards.
//! 7. Rename the sites to the caller's indices.
//!
//! Steps 3 and 5 are Dwyer's. With vertical cuts alone, the slabs become so narrow that nearly every triangle of a
//! slab is a needle that the next merge destroys; in strips that end in nearly square cells most triangles survive.
//! The answer is the same, because the triangulation is unique.
//!
//! # One merge for both directions
//! Nothing in a merge knows what *right* or *up* is. Lexicographic order by `(x, y)` is the order along a direction
//! turned infinitesimally from the x-axis, order by `(y, x)` the same for the y-axis, and a rotation of the plane
//! changes neither orientations nor circles. So the halves are called *first* and *last*, and the drawings show the
//! horizontal case.
//!
//! # Invariants
//! * Between two merges the edges are the Delaunay triangulations of separated sets of sites.
//! * [`Hull`] holds, for each such set, one edge of the outer face at its first vertex and one at its last.
//! * A record of an erased edge holds one fixed value, and is reused before a new one is made.
//!
//! # Degenerate cases
//! * *Cocircular points*: `in_circle_perturbed` never answers `On`, and its answers are those of one convex surface,
//!   so the circle rises through cocircular points as through any others. The result is the one triangulation of the
//!   tie rule.
//! * *Collinear points*: the base cases and the merges leave the chain of edges between neighbours; its only face is
//!   the outer one.
//! * *Collinear points of the hull* stay on it: the tangent of a merge joins the nearest pair of sites among equals.
//! * *No site or one site*: no edges.
//! * *Equal points* are the caller's to remove. Should they come nevertheless, every loop still ends; the edges mean
//!   nothing then.
//!
//! # Complexity
//! `O(n log n)` at worst, besides the caller's sort; `O(n log log n)` expected for points spread evenly. The
//! recursion is at most `⌈log2 n⌉` deep.
//!
//! # Source
//! `[GuibasStolfi85]`, section 9; its quad-edges are reduced to edges, because the dual is not asked for.
//! `[Valenzuela09]`, section 4.2, describes the same algorithm; there the candidates are compared by a rounded
//! in-circle test, here by an exact one. The cuts are those of `[Dwyer87]`.

mod build;
mod convert;
mod edge_records;
mod merge;
#[cfg(test)]
mod tests;

use std::cmp::Ordering;
use std::ops::Range;

use crate::geometry::{Orientation, Point, orient2d};

pub(super) use build::build;
use edge_records::{Edge, EdgeRecords};

/// The largest number of points that fits: a record and a half-edge for each of six directed edges a point, all
/// numbered in 32 bits, with room for two marks.
pub(crate) const MAX_POINTS: usize = (u32::MAX as usize - 1) / 6;

/// Triangulates the points of `order`, so that no circle through the corners of a triangle holds another point.
///
/// # Shape
/// `order` lists indices into `points`, lexicographically by coordinates (x, then y), each place once: the points are
/// distinct. It may leave out points. It holds at most [`MAX_POINTS`] indices. Origins of the edges are indices into
/// `points`.
///
/// # Guarantees
/// The Delaunay triangulation under the tie rule, which is unique; records come in an order that depends on nothing
/// but the points. Records close to each other are mostly close in the plane, too.
///
/// # Complexity
/// See the module.
///
/// # Source
/// `[GuibasStolfi85]`, section 9; `[Dwyer87]`.
pub(crate) fn triangulate(points: &[Point], order: &[u32]) -> EdgeRecords {
    debug_assert!(order.len() <= MAX_POINTS, "more points than 32-bit edges can join");
    let mut division = Division::new(points, order);
    if order.len() >= 2 {
        let hull = division.divide_into_strips(0..order.len());
        division.records.set_outer(hull.cw_from_last);
    }
    division.finish()
}

/// A point to be joined, and the caller's index of it.
#[derive(Clone, Copy, Debug)]
struct Site {
    point: Point,
    index: u32,
}

/// Where to take hold of the triangulation of a run of sites: an edge of the outer face at either end.
///
/// ```text
///              ___----o
///          o--         \
///         /             o  last     cw_from_last leaves it clockwise round the hull,
///        /             /            the outer face on its left
///  first o--___      ./
///              `-> o
///    ccw_from_first leaves it counter-clockwise, the outer face on its right
/// ```
#[derive(Clone, Copy, Debug)]
struct Hull {
    ccw_from_first: Edge,
    cw_from_last: Edge,
}

/// The triangulation under construction; origins are positions in `sites`.
#[derive(Debug)]
struct Division {
    sites: Vec<Site>,
    records: EdgeRecords,
    strip_len: usize,
}

impl Division {
    /// Step 1: gathers the sites.
    fn new(points: &[Point], order: &[u32]) -> Self {
        let sites: Vec<Site> = order.iter().map(|&index| Site { point: points[index as usize], index }).collect();
        debug_assert!(sites.is_sorted_by(|a, b| by_x(a, b) == Ordering::Less), "points equal or out of order");
        let records = EdgeRecords::with_capacity(sites.len());
        let strip_len = strip_len(sites.len());
        Self { sites, records, strip_len }
    }

    /// Steps 2 and 6: triangulates a run of sites in lexicographic order, halving it by vertical cuts down to strips.
    fn divide_into_strips(&mut self, run: Range<usize>) -> Hull {
        if run.len() <= self.strip_len {
            return self.triangulate_strip(run);
        }
        let middle = run.start + run.len() / 2;
        let first = self.divide_into_strips(run.start..middle);
        let last = self.divide_into_strips(middle..run.end);
        merge::merge(&self.sites, &mut self.records, first, last)
    }

    /// Steps 3 and 5: sorts a strip by height, triangulates it, and turns its hull back.
    fn triangulate_strip(&mut self, run: Range<usize>) -> Hull {
        self.sites[run.clone()].sort_unstable_by(by_y);
        let upright = self.divide_strip(run);
        self.hull_by_x(upright)
    }

    /// Steps 3 to 5: triangulates a run of sites sorted by height, halving it by horizontal cuts.
    fn divide_strip(&mut self, run: Range<usize>) -> Hull {
        match run.len() {
            0..=2 => return self.two_sites(run.start as u32),
            3 => return self.three_sites(run.start as u32),
            _ => {}
        }
        let middle = run.start + run.len() / 2;
        let first = self.divide_strip(run.start..middle);
        let last = self.divide_strip(middle..run.end);
        merge::merge(&self.sites, &mut self.records, first, last)
    }

    /// Step 4: joins the sites `a` and `a + 1`.
    fn two_sites(&mut self, a: u32) -> Hull {
        let ab = self.records.add(a, a + 1);
        Hull { ccw_from_first: ab, cw_from_last: ab.twin() }
    }

    /// Step 4: joins the sites `a`, `b = a + 1` and `c = a + 2`, sorted along a direction.
    ///
    /// ```text
    ///    counter-clockwise          clockwise             on one line
    ///
    ///          _o c                  b o_
    ///       _-  |                     /   -_              a o---o---o c
    ///    a o_   |                    /      o c                 b
    ///        -_ |                   /   __-
    ///          `o b              a o_--
    /// ```
    fn three_sites(&mut self, a: u32) -> Hull {
        let (b, c) = (a + 1, a + 2);
        let ab = self.records.add(a, b);
        let bc = self.records.add_from(ab.twin(), c);
        let along = Hull { ccw_from_first: ab, cw_from_last: bc.twin() };
        match orient2d(self.point(a), self.point(b), self.point(c)) {
            Orientation::Collinear => along,
            Orientation::CounterClockwise => {
                self.records.connect(bc, ab);
                along
            }
            Orientation::Clockwise => {
                let ca = self.records.connect(bc, ab);
                Hull { ccw_from_first: ca.twin(), cw_from_last: ca }
            }
        }
    }

    /// Step 5: exchanges the lowest and highest vertex of a hull for the leftmost and rightmost, by a walk round it.
    fn hull_by_x(&self, hull: Hull) -> Hull {
        let site = |e: &Edge| &self.sites[self.records.origin(*e) as usize];
        let (mut leftmost, mut rightmost) = (hull.cw_from_last, hull.cw_from_last);
        for e in self.records.left_face(hull.cw_from_last) {
            if by_x(site(&e), site(&leftmost)) == Ordering::Less {
                leftmost = e;
            }
            if by_x(site(&e), site(&rightmost)) == Ordering::Greater {
                rightmost = e;
            }
        }
        Hull { ccw_from_first: self.records.ccw(leftmost), cw_from_last: rightmost }
    }

    /// Step 7: renames the sites to the caller's indices.
    fn finish(mut self) -> EdgeRecords {
        self.records.rename(|site| self.sites[site as usize].index);
        self.records
    }

    fn point(&self, site: u32) -> Point {
        self.sites[site as usize].point
    }
}

/// How many sites a strip holds at most: at least three, so that no half is left with a single site.
///
/// # Source
/// `[Dwyer87]` cuts n evenly spread points into `√(n / log n)` strips.
fn strip_len(sites: usize) -> usize {
    let log = sites.max(1).ilog2() as usize;
    (sites * log).isqrt().max(3)
}

/// Lexicographic order: from left to right, and upwards at equal abscissa.
fn by_x(a: &Site, b: &Site) -> Ordering {
    compare(a.point.x, b.point.x).then_with(|| compare(a.point.y, b.point.y))
}

/// Order by height: upwards, and from left to right at equal height.
fn by_y(a: &Site, b: &Site) -> Ordering {
    compare(a.point.y, b.point.y).then_with(|| compare(a.point.x, b.point.x))
}

/// Order of finite numbers; both zeros are equal.
fn compare(a: f64, b: f64) -> Ordering {
    a.partial_cmp(&b).unwrap_or(Ordering::Equal)
}
