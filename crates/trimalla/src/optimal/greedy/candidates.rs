//! Pairs of vertices that may be edges of the greedy triangulation.
//!
//! # The diamond test
//! Draw an isosceles triangle with base angles of 22.5 degrees on either side of a pair. If there is a vertex inside
//! each of the two, the pair is no edge: some shorter pair crosses it and comes first.
//!
//! ```text
//!             ·
//!         a      ·             a and b are inside: pq is left out
//!      ·             ·
//!    p ────────────────q
//!      ·       b     ·
//!         ·      ·
//!             ·
//! ```
//!
//! # Dead sectors
//! To find the partners of p, divide the directions from p into sectors. A vertex a near p is inside one of the
//! triangles of every longer pair that starts in a direction within 22.5 degrees of a: of the left one for directions
//! clockwise of a, of the right one for the others. When a sector has a vertex for either side, it is *dead* from some
//! length on. It is dead, too, where the hull ends. The vertices are in a tree of boxes; the boxes are searched from
//! the nearest to the farthest, except those whose vertices could neither be partners of p nor rule out others.
//!
//! Everything here is rounded, with margins on the side of keeping a pair: a candidate too many does no harm.
//!
//! # Complexity
//! Expected O(log n) a vertex for points spread evenly; at worst all pairs are candidates.
//!
//! # Source
//! `[DasJoseph89]` for the property; `[DickersonEtAl97]` for the use of it.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::check_pairs;
use crate::geometry::math::{atan2, cos, power_of_two_scale, sin};
use crate::geometry::{BoundingBox, Orientation, Point, Vector, orient2d};
use crate::half_edge::{HalfEdgeId, VertexId};
use crate::optimal::OptimalError;
use crate::trace::Trace;
use crate::triangulation::Triangulation;

/// The base angle in radians: 22.5 degrees.
const BASE: f64 = std::f64::consts::PI / 8.0;
/// Cosine and sine of the base angle less a margin.
const LESS: [f64; 2] = [0.924_061, 0.382_252];
/// How many sectors there are; a multiple of four.
const SECTORS: usize = 128;
/// Within how many sectors the base angle lies: none is narrower than a quarter of its share of the circle times pi /
/// 2.
const REACH: usize = 13;
/// Vertices in a leaf of the tree.
const LEAF: usize = 8;
/// Squares below this are not to be trusted: their pairs are kept.
const LEAST: f64 = 1e-280;

/// The pairs that pass the diamond test, roughly; the smaller vertex first.
pub(super) fn by_diamonds(
    points: &[Point],
    vertices: &[u32],
    trace: &(impl Trace + ?Sized),
) -> Result<Vec<[u32; 2]>, OptimalError> {
    let tree = Tree::of(points, vertices);
    let (mut sectors, hull) = (Sectors::new(), Hull::of(&tree.sites));
    let (mut found, mut near, mut waiting) = (Vec::new(), Vec::new(), BinaryHeap::new());
    for site in &tree.sites {
        if trace.is_cancelled() {
            return Err(OptimalError::Cancelled);
        }
        sectors.begin(site.place, &hull);
        near.clear();
        tree.search(*site, &mut sectors, &mut waiting, &mut near);
        // The sectors know more now than when the first vertices were met.
        let alive = near.iter().filter(|(other, way)| site.vertex < *other && !sectors.is_dead_at(*way));
        found.extend(alive.map(|&(other, _)| [site.vertex, other]));
        check_pairs(found.len())?;
    }
    Ok(found)
}

/// A vertex in the frame of the search.
#[derive(Clone, Copy, Debug)]
struct Site {
    place: Point,
    vertex: u32,
}

/// The directions from a vertex.
#[derive(Clone, Debug)]
struct Sectors {
    /// For each sector the squared length from which on every pair in it has a vertex inside the triangle on its left.
    left: [f64; SECTORS],
    /// The same on the right.
    right: [f64; SECTORS],
    /// For each sector a squared length that no pair in it passes: the hull ends before.
    hull: [f64; SECTORS],
    /// The squared length from which on every sector is dead.
    all_dead_from: f64,
    /// For each sector and each of those after it: the factor from the squared distance of a vertex in the first to the
    /// squared length from which on it is inside the triangle of pairs in the other.
    factors: Vec<[f64; REACH + 1]>,
}

impl Sectors {
    fn new() -> Self {
        let nothing = [f64::INFINITY; SECTORS];
        let factors = (0..SECTORS).map(factors_from).collect();
        Self { left: nothing, right: nothing, hull: nothing, all_dead_from: f64::INFINITY, factors }
    }

    /// Begins at a vertex.
    fn begin(&mut self, place: Point, hull: &Hull) {
        self.left = [f64::INFINITY; SECTORS];
        self.right = [f64::INFINITY; SECTORS];
        self.hull = hull.squared_lengths_from(place);
        self.look_around();
    }

    /// Notes a vertex in some direction.
    ///
    /// ```text
    ///    ╲  right  ╱             pairs in these sectors have the vertex on their right,
    ///      ╲     ╱
    ///        ╲ ╱ ── vertex
    ///      p  ╳                  pairs in these on their left
    ///          ╲  left
    /// ```
    fn add(&mut self, way: Vector) {
        let [cosine, sine] = LESS;
        let clockwise = Vector::new(cosine * way.x + sine * way.y, cosine * way.y - sine * way.x);
        let counter = Vector::new(cosine * way.x - sine * way.y, cosine * way.y + sine * way.x);
        let [first, middle, last] = [clockwise, way, counter].map(turn);
        let length_sq = way.length_sq();
        let own = sector_of(middle);
        let factors = &self.factors;
        for sector in between(first, middle) {
            let steps = (own + SECTORS - sector) % SECTORS;
            let from = length_sq * factors[sector].get(steps).copied().unwrap_or(f64::INFINITY);
            self.left[sector] = self.left[sector].min(from);
        }
        for sector in between(middle, last) {
            let steps = (sector + SECTORS - own) % SECTORS;
            let from = length_sq * factors[own].get(steps).copied().unwrap_or(f64::INFINITY);
            self.right[sector] = self.right[sector].min(from);
        }
    }

    /// Looks from which length on every sector is dead.
    fn look_around(&mut self) {
        self.all_dead_from = (0..SECTORS).fold(0.0, |most, sector| self.dead_from(sector).max(most));
    }

    /// The squared length from which on a sector is dead.
    fn dead_from(&self, sector: usize) -> f64 {
        self.left[sector].max(self.right[sector]).min(self.hull[sector])
    }

    /// Whether a pair that goes some way is ruled out.
    fn is_dead_at(&self, way: Vector) -> bool {
        let length_sq = way.length_sq();
        length_sq > LEAST && length_sq > self.dead_from(sector_of(turn(way)))
    }

    /// Whether all pairs from a place into a box are ruled out, and it has no vertex that could rule out others.
    fn is_dead_in(&self, place: Point, around: &BoundingBox, length_sq: f64) -> bool {
        let Some([start, end]) = silhouette(place, around) else { return false };
        let (first, last) = (sector_of(turn(start - place)), sector_of(turn(end - place)));
        let across = (last + SECTORS - first) % SECTORS + 2 * REACH;
        let mut met = (0..=across).map(|i| (first + SECTORS - REACH + i) % SECTORS);
        met.all(|sector| length_sq > self.dead_from(sector))
    }
}

/// The sectors that lie between two directions, with a margin.
fn between(start: f64, end: f64) -> impl Iterator<Item = usize> {
    const MARGIN: f64 = 1e-9;
    let end = if end < start { end + 4.0 } else { end };
    let in_sectors = |turn: f64| turn * (SECTORS as f64 / 4.0);
    let (first, after) = ((in_sectors(start) + MARGIN).ceil() as usize, (in_sectors(end) - MARGIN).floor() as usize);
    (first..after).map(|sector| sector % SECTORS)
}

/// The factors from a sector on, with a margin.
///
/// A vertex at the distance r, seen at the angle d from the direction of a pair, is inside the triangle on the pair if
/// the pair is longer than r sin(d + base) / sin(base): the other side of the triangle passes through the vertex then.
fn factors_from(sector: usize) -> [f64; REACH + 1] {
    const MARGIN: f64 = 1.0 + 1e-9;
    std::array::from_fn(|steps| {
        // The largest angle between directions in the two sectors, which the margin of the base angle limits.
        let widest = (boundary(sector + steps + 1) - boundary(sector)).min(BASE);
        let factor = sin(widest + BASE) / sin(BASE);
        factor * factor * MARGIN
    })
}

/// The angle at which a sector begins, in radians.
fn boundary(sector: usize) -> f64 {
    let quarter = SECTORS / 4;
    let along = (sector % quarter) as f64 / quarter as f64;
    (sector / quarter) as f64 * std::f64::consts::FRAC_PI_2 + atan2(along, 1.0 - along)
}

/// Half-planes around the convex hull: no pair leaves them.
#[derive(Debug)]
struct Hull {
    normals: [Vector; SIDES],
    /// How far the hull goes in the direction of each normal.
    extents: [f64; SIDES],
    /// For each sector and half-plane: how long a pair in the sector may be for each unit of distance to the line.
    factors: Vec<[f64; SIDES]>,
}

/// How many half-planes there are.
const SIDES: usize = 16;

impl Hull {
    fn of(sites: &[Site]) -> Self {
        let unit = |angle: f64| Vector::new(cos(angle), sin(angle));
        let normals: [Vector; SIDES] =
            std::array::from_fn(|side| unit(side as f64 * std::f64::consts::TAU / SIDES as f64));
        let extents = normals.map(|n| {
            let along = sites.iter().map(|site| n.x * site.place.x + n.y * site.place.y);
            along.fold(f64::NEG_INFINITY, f64::max)
        });
        let factors_of = |sector: usize| {
            let ends = [boundary(sector), boundary(sector + 1)].map(unit);
            normals.map(|n| {
                let cosine = ends[0].dot(n).min(ends[1].dot(n));
                if cosine > 1e-3 { 1.0 / cosine } else { f64::INFINITY }
            })
        };
        Self { normals, extents, factors: (0..SECTORS).map(factors_of).collect() }
    }

    fn squared_lengths_from(&self, place: Point) -> [f64; SECTORS] {
        /// More than all is rounded, in a frame of size one to four.
        const MARGIN: f64 = 1e-12;
        let room: [f64; SIDES] = std::array::from_fn(|side| {
            let n = self.normals[side];
            self.extents[side] - (n.x * place.x + n.y * place.y) + MARGIN
        });
        std::array::from_fn(|sector| {
            let factors = &self.factors[sector];
            let longest = (0..SIDES).fold(f64::INFINITY, |least, side| least.min(room[side] * factors[side]));
            longest * longest
        })
    }
}

/// The direction of a vector that is not zero, from 0 to 4 for a whole turn; it grows with the angle, though not
/// evenly.
fn turn(v: Vector) -> f64 {
    let size = v.x.abs() + v.y.abs();
    let (quarter, along) = match (v.x >= 0.0, v.y >= 0.0) {
        (true, true) => (0.0, v.y),
        (false, true) => (1.0, -v.x),
        (false, false) => (2.0, -v.y),
        (true, false) => (3.0, v.x),
    };
    quarter + along / size
}

/// The sector of a direction.
fn sector_of(turn: f64) -> usize {
    (turn * (SECTORS as f64 / 4.0)) as usize % SECTORS
}

/// The first and the last corner of a box, counter-clockwise, as seen from a place outside of it.
fn silhouette(place: Point, around: &BoundingBox) -> Option<[Point; 2]> {
    let BoundingBox { min, max } = *around;
    let [low_left, low_right] = [min, Point::new(max.x, min.y)];
    let [up_left, up_right] = [Point::new(min.x, max.y), max];
    let (is_left, is_right) = (place.x < min.x, place.x > max.x);
    let (is_below, is_above) = (place.y < min.y, place.y > max.y);
    let start = match (is_left, is_right, is_below, is_above) {
        (true, _, true, _) | (false, false, true, _) => low_right,
        (true, ..) => low_left,
        (_, true, false, true) | (false, false, _, true) => up_left,
        (_, true, ..) => up_right,
        _ => return None,
    };
    let end = match (is_left, is_right, is_below, is_above) {
        (true, _, _, true) | (false, false, _, true) => up_right,
        (true, ..) => up_left,
        (_, true, true, _) | (false, false, true, _) => low_left,
        _ => low_right,
    };
    Some([start, end])
}

/// The vertices in halves, quarters, … of boxes. Node 0 is the whole; the children of a node have its double number and
/// 1, and its double number and 2.
#[derive(Debug)]
struct Tree {
    sites: Vec<Site>,
    boxes: Vec<BoundingBox>,
}

impl Tree {
    fn of(points: &[Point], vertices: &[u32]) -> Self {
        let at = |v: u32| points[v as usize];
        let largest = vertices.iter().fold(0.0_f64, |m, &v| m.max(at(v).x.abs()).max(at(v).y.abs()));
        let scale = power_of_two_scale(largest);
        let site = |&vertex: &u32| Site { place: Point::new(at(vertex).x * scale, at(vertex).y * scale), vertex };
        let mut tree = Self { sites: vertices.iter().map(site).collect(), boxes: Vec::new() };
        tree.halve(0..vertices.len(), 0);
        tree
    }

    fn halve(&mut self, range: std::ops::Range<usize>, node: usize) {
        let around = BoundingBox::of(self.sites[range.clone()].iter().map(|site| site.place)).unwrap_or_default();
        if self.boxes.len() <= node {
            self.boxes.resize(node + 1, BoundingBox::default());
        }
        self.boxes[node] = around;
        if range.len() <= LEAF {
            return;
        }
        let is_wide = around.max.x - around.min.x > around.max.y - around.min.y;
        let key = |site: &Site| if is_wide { site.place.x } else { site.place.y };
        let half = range.len() / 2;
        self.sites[range.clone()]
            .select_nth_unstable_by(half, |a, b| key(a).total_cmp(&key(b)).then(a.vertex.cmp(&b.vertex)));
        self.halve(range.start..range.start + half, 2 * node + 1);
        self.halve(range.start + half..range.end, 2 * node + 2);
    }

    /// Collects the vertices that are not ruled out, with the way to each; nearer boxes first.
    fn search(&self, from: Site, sectors: &mut Sectors, waiting: &mut BinaryHeap<Node>, near: &mut Vec<(u32, Vector)>) {
        waiting.clear();
        waiting.push(Node { length_sq: 0.0, number: 0, begin: 0, end: self.sites.len() });
        while let Some(Node { length_sq, number, begin, end }) = waiting.pop() {
            if length_sq > LEAST && length_sq > sectors.all_dead_from {
                return;
            }
            if length_sq > LEAST && sectors.is_dead_in(from.place, &self.boxes[number], length_sq) {
                continue;
            }
            if end - begin <= LEAF {
                for other in self.sites[begin..end].iter().filter(|other| other.vertex != from.vertex) {
                    let way = other.place - from.place;
                    if !sectors.is_dead_at(way) {
                        near.push((other.vertex, way));
                    }
                    if way.length_sq() > LEAST {
                        sectors.add(way);
                    }
                }
                sectors.look_around();
                continue;
            }
            let half = begin + (end - begin) / 2;
            for (number, begin, end) in [(2 * number + 1, begin, half), (2 * number + 2, half, end)] {
                let length_sq = way_to(from.place, &self.boxes[number]).length_sq();
                waiting.push(Node { length_sq, number, begin, end });
            }
        }
    }
}

/// A box that waits to be searched.
#[derive(Clone, Copy, Debug)]
struct Node {
    /// Its squared distance.
    length_sq: f64,
    number: usize,
    begin: usize,
    end: usize,
}

/// The nearest first.
impl Ord for Node {
    fn cmp(&self, other: &Self) -> Ordering {
        other.length_sq.total_cmp(&self.length_sq).then(other.number.cmp(&self.number))
    }
}

impl PartialOrd for Node {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Node {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Node {}

/// The lengths of the way from a place to a box along either axis.
fn way_to(place: Point, around: &BoundingBox) -> Vector {
    Vector::new(
        (around.min.x - place.x).max(place.x - around.max.x).max(0.0),
        (around.min.y - place.y).max(place.y - around.max.y).max(0.0),
    )
}

/// The pairs of vertices of a domain that see each other and are not separated by a vertex between them; the smaller
/// vertex first.
///
/// # Complexity
/// Linear in the triangles that each vertex sees a part of.
pub(super) fn by_sight(t: &Triangulation, trace: &(impl Trace + ?Sized)) -> Result<Vec<[u32; 2]>, OptimalError> {
    let mut found: Vec<[u32; 2]> = t.edges().map(|h| [t.origin(h).0, t.dest(h).0]).collect();
    found.iter_mut().for_each(|pair| pair.sort_unstable());
    let mut cones = Vec::new();
    for p in t.used_vertices() {
        if trace.is_cancelled() {
            return Err(OptimalError::Cancelled);
        }
        let faces = t.star(p).filter(|h| t.is_real(h.face()));
        cones.extend(faces.map(|h| Cone { edge: h.next(), right: t.dest(h), left: t.apex(h) }));
        while let Some(cone) = cones.pop() {
            cone.look_beyond(t, p, &mut cones, &mut found);
        }
        check_pairs(found.len())?;
    }
    Ok(found)
}

/// What a vertex sees through an edge: the directions between two vertices.
#[derive(Clone, Copy, Debug)]
struct Cone {
    /// The edge, from right to left as seen from the vertex, on the near side.
    edge: HalfEdgeId,
    right: VertexId,
    left: VertexId,
}

impl Cone {
    /// Looks through the edge into the triangle beyond.
    ///
    /// ```text
    ///      left      c          the corner c of the triangle beyond is seen if it is strictly inside the cone,
    ///        ╲ ╲   ╱ │          which is divided there
    ///         ╲  ╲   │
    ///          p ─ ─ right
    /// ```
    fn look_beyond(self, t: &Triangulation, p: VertexId, cones: &mut Vec<Self>, found: &mut Vec<[u32; 2]>) {
        let beyond = t.twin(self.edge);
        if !t.is_real(beyond.face()) {
            return;
        }
        let apex = t.apex(beyond);
        let side_of = |bound: VertexId| orient2d(t.point(p), t.point(bound), t.point(apex));
        let (from_right, from_left) = (side_of(self.right), side_of(self.left));
        let is_left_of_right = from_right == Orientation::CounterClockwise;
        let is_right_of_left = from_left == Orientation::Clockwise;
        if is_left_of_right && is_right_of_left && p < apex {
            found.push([p.0, apex.0]);
        }
        // The right part ends at the apex, or at the left bound where the apex is beyond that.
        if is_left_of_right {
            let left = if is_right_of_left { apex } else { self.left };
            cones.push(Self { edge: beyond.next(), right: self.right, left });
        }
        if is_right_of_left {
            let right = if is_left_of_right { apex } else { self.right };
            cones.push(Self { edge: beyond.prev(), right, left: self.left });
        }
    }
}
