//! The part of an edge in a box.
//!
//! A Voronoi vertex may lie as far away as the nearest thing to infinity, and its rounded coordinates say little then.
//! So the part of an edge in a box is taken from the bisector itself:
//!
//! ```text
//!         ┌─────────box─────────┐        m middle of the two sites
//!  r ·····│───────── m ─────────│····· l   d direction of the edge, sites[0] on its left
//!         │  t = low    t = high│        the edge has the points m + t d between its ends
//!         └─────────────────────┘
//! ```
//!
//! On which side of the middle a vertex lies is exact: the center of a triangle lies beyond a side from the opposite
//! corner if the angle at that corner is obtuse, which is if the corner lies in the disk with that side as its
//! diameter.

use super::voronoi::{Voronoi, VoronoiEdge};
use crate::geometry::{BoundingBox, CircleSide, Point, Vector, in_diametral_disk};

/// Where the part of an edge in a box ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum End {
    /// At this vertex of the diagram.
    Vertex(u32),
    /// At the side of the box.
    At(Point),
}

/// The part of an edge in a box; `None` where it has none.
pub(super) fn part_in(voronoi: &Voronoi, edge: &VoronoiEdge, within: BoundingBox) -> Option<[End; 2]> {
    let inside = edge.ends.map(|end| end.filter(|&v| place(voronoi, v).is_some_and(|p| within.contains(p))));
    if let [Some(start), Some(end)] = inside {
        return Some([End::Vertex(start), End::Vertex(end)]);
    }
    let line = Bisector::of(voronoi, edge);
    let [low, high] = line.range_in(within)?;
    let start = if inside[0].is_some() { f64::NEG_INFINITY } else { line.parameter(voronoi, edge, 0) };
    let end = if inside[1].is_some() { f64::INFINITY } else { line.parameter(voronoi, edge, 1) };
    let [low, high] = [low.max(start), high.min(end)];
    if inside == [None, None] && low >= high {
        return None;
    }
    let at = |t: f64| Some(line.at(t)).filter(|p| p.is_finite()).map(|p| End::At(within.clamp(p)));
    let start = inside[0].map(End::Vertex).or_else(|| at(low))?;
    let end = inside[1].map(End::Vertex).or_else(|| at(high))?;
    Some([start, end])
}

fn place(voronoi: &Voronoi, vertex: u32) -> Option<Point> {
    voronoi.vertices()[vertex as usize].point
}

/// The bisector of two sites, rounded.
struct Bisector {
    middle: Point,
    /// Its larger coordinate is 1 or −1.
    direction: Vector,
}

impl Bisector {
    fn of(voronoi: &Voronoi, edge: &VoronoiEdge) -> Self {
        let [a, b] = edge.sites.map(|v| voronoi.sites()[v.index()]);
        // Halves, so that the difference of large coordinates is finite; not of small ones, which would vanish.
        let scale = if (b.x - a.x).is_finite() && (b.y - a.y).is_finite() { 1.0 } else { 0.5 };
        let across = Vector::new(b.x * scale - a.x * scale, b.y * scale - a.y * scale);
        let largest = across.x.abs().max(across.y.abs());
        let direction = Vector::new(-across.y / largest, across.x / largest);
        Self { middle: Point::midpoint(a, b), direction }
    }

    fn at(&self, t: f64) -> Point {
        self.middle + self.direction.scaled(t)
    }

    /// The parameters of the points in a box.
    fn range_in(&self, within: BoundingBox) -> Option<[f64; 2]> {
        let Self { middle, direction } = self;
        let axes =
            [(middle.x, direction.x, within.min.x, within.max.x), (middle.y, direction.y, within.min.y, within.max.y)];
        let mut range = [f64::NEG_INFINITY, f64::INFINITY];
        for (from, by, min, max) in axes {
            if by == 0.0 {
                if from < min || max < from {
                    return None;
                }
                continue;
            }
            let (one, two) = ((min - from) / by, (max - from) / by);
            range = [range[0].max(one.min(two)), range[1].min(one.max(two))];
        }
        (range[0] < range[1]).then_some(range)
    }

    /// The parameter of an end of the edge that is not in the box: infinite where it is unbounded or far away.
    fn parameter(&self, voronoi: &Voronoi, edge: &VoronoiEdge, which: usize) -> f64 {
        let outward = if which == 0 { -1.0 } else { 1.0 };
        let (Some(vertex), Some(apex)) = (edge.ends[which], edge.apexes[which]) else {
            return outward * f64::INFINITY;
        };
        let [a, b] = edge.sites.map(|v| voronoi.sites()[v.index()]);
        let sign = match in_diametral_disk(a, b, voronoi.sites()[apex.index()]) {
            CircleSide::Outside => outward,
            CircleSide::On => return 0.0,
            CircleSide::Inside => -outward,
        };
        let d = self.direction;
        let along = |p: Point| ((p.x - self.middle.x) * d.x + (p.y - self.middle.y) * d.y) / d.length_sq();
        let t = place(voronoi, vertex).map_or(f64::NAN, along);
        // Rounded to the other side, or not a number: so far away that nothing else can be said.
        if t * sign >= 0.0 { t } else { sign * f64::INFINITY }
    }
}
