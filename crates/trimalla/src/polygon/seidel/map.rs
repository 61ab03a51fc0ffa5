//! The trapezoids of a polygon: how they are made, and what can be asked about them.

use super::insert::Inserter;
use super::structure::{Cell, LEFT, NONE, Place, RIGHT, ROOT, Side, Structure, upwards};
use crate::geometry::{Containment, Orientation, Point};
use crate::polygon::{Polygon, PolygonError};
use crate::trace::Trace;
use std::cmp::Ordering;

/// A trapezoid inside of a polygon: between two sides, and between the horizontal lines through two vertices.
#[doc(alias = "trapezoide")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Trapezoid {
    /// The vertex on its upper line.
    pub top: u32,
    /// The vertex on its lower line.
    pub bottom: u32,
    /// The side on its left, or a piece of a side that touches vertices: lower and upper end.
    pub left: [u32; 2],
    /// The side on its right: lower and upper end.
    pub right: [u32; 2],
}

/// A chord of the horizontal visibility map: from a vertex horizontally through the inside to the next side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chord {
    /// The vertex.
    pub from: u32,
    /// The side that it sees: lower and upper end.
    pub onto: [u32; 2],
    /// The point of the side that it sees, its abscissa rounded.
    pub at: Point,
}

/// The horizontal visibility map of a polygon: its trapezoids, with a query structure that finds points in them.
///
/// The module documentation of [`seidel`](super::seidel) tells how it is built.
#[doc(alias = "mapa de visibilidad horizontal")]
#[doc(alias = "horizontal visibility map")]
#[derive(Clone, Debug)]
pub struct TrapezoidMap<'a> {
    polygon: Polygon<'a>,
    pub(super) structure: Structure<'a>,
    /// The trapezoids inside, in the order in which they were made.
    pub(super) inside: Vec<u32>,
    /// The vertex that stands for each point.
    same: Vec<u32>,
    /// Vertices inside sides: the point from which the side leaves, and the vertex.
    touches: Vec<(u32, u32)>,
}

impl<'a> TrapezoidMap<'a> {
    /// Builds the map of a polygon; sides are inserted in an order that the seed determines.
    ///
    /// # Errors
    /// A ring without area, sides that cross or overlap, a hole that is not in the outline, cancelled.
    ///
    /// # Complexity
    /// Expected O(n log* n).
    pub fn new(polygon: Polygon<'a>, seed: u64, trace: &mut (impl Trace + ?Sized)) -> Result<Self, PolygonError> {
        let sides = Sides::of(polygon)?;
        let n = polygon.points().len();
        let mut inserter = Inserter {
            structure: Structure::new(polygon.points()),
            same: vec![NONE; n],
            hints: vec![ROOT; n],
            touches: Vec::new(),
            next: sides.next,
            trace,
        };
        let rounds = Rounds::new(sides.origins, seed);
        let mut is_inserted = vec![false; n];
        for (round, is_followed) in rounds.all() {
            for (count, &i) in round.iter().enumerate() {
                if count % 1024 == 0 && inserter.trace.is_cancelled() {
                    return Err(PolygonError::Cancelled);
                }
                inserter.insert(i, sides.inside_is_right[i as usize])?;
                is_inserted[i as usize] = true;
            }
            if is_followed {
                inserter.follow_rings(polygon, |i| is_inserted[i as usize])?;
            }
        }
        inserter.refuse_crossings_at_vertices()?;
        let Inserter { structure, same, touches, .. } = inserter;
        let inside = structure.inside(polygon)?;
        Ok(Self { polygon, structure, inside, same, touches })
    }

    /// The trapezoids inside of the polygon.
    pub fn trapezoids(&self) -> impl ExactSizeIterator<Item = Trapezoid> + '_ {
        self.inside.iter().map(|&at| {
            let Cell { top, bottom, sides: [left, right], .. } = *self.structure.cell(at);
            Trapezoid { top, bottom, left: self.side(left), right: self.side(right) }
        })
    }

    /// The corners of a trapezoid, for a picture: lower left, lower right, upper right, upper left. The abscissas are
    /// rounded; two corners are one where the trapezoid is a triangle.
    #[must_use]
    pub fn corners(&self, trapezoid: &Trapezoid) -> [Point; 4] {
        let Trapezoid { top, bottom, left, right } = *trapezoid;
        [(left, bottom), (right, bottom), (right, top), (left, top)].map(|(side, vertex)| self.corner(side, vertex))
    }

    /// The chords of the horizontal visibility map, by their vertices.
    ///
    /// # Complexity
    /// O(n log n), for the order.
    #[must_use]
    pub fn chords(&self) -> Vec<Chord> {
        let mut ends = Vec::new();
        for &at in &self.inside {
            let cell = self.structure.cell(at);
            for vertex in [cell.top, cell.bottom] {
                let seen = cell.sides.into_iter().filter(|&side| !self.structure.is_on(vertex, side));
                ends.extend(seen.map(|side| (vertex, side)));
            }
        }
        ends.sort_unstable();
        ends.dedup();
        let chord = |(from, side)| {
            let onto = self.side(side);
            Chord { from, onto, at: self.corner(onto, from) }
        };
        let mut chords: Vec<Chord> = ends.into_iter().map(chord).collect();
        chords.sort_unstable_by_key(|chord| (chord.from, chord.onto));
        chords
    }

    /// Tells whether a point is in the polygon. Exact; a point that is not finite is outside.
    ///
    /// # Complexity
    /// Expected O(log n).
    #[must_use]
    pub fn contains(&self, p: Point) -> Containment {
        match self.place(p) {
            Some(Place::In { cell, on: NONE }) if self.is_inside(cell) => Containment::Inside,
            None | Some(Place::In { on: NONE, .. }) => Containment::Outside,
            _ => Containment::On,
        }
    }

    /// The trapezoid that has a point inside, or on one of its lines; none for a point outside or on a side.
    ///
    /// # Complexity
    /// Expected O(log n).
    #[must_use]
    pub fn trapezoid_at(&self, p: Point) -> Option<Trapezoid> {
        match self.place(p)? {
            Place::In { cell, on: NONE } if self.is_inside(cell) => {
                let Cell { top, bottom, sides: [left, right], .. } = *self.structure.cell(cell);
                Some(Trapezoid { top, bottom, left: self.side(left), right: self.side(right) })
            }
            _ => None,
        }
    }

    /// The boundary of the polygon: one closed walk a ring, the inside on its left.
    ///
    /// # Shape
    /// No vertex is followed by itself, and every vertex that touches a side is there between the ends of that side, so
    /// that the edges of the walks are the boundary edges of the triangulation.
    #[must_use]
    pub fn boundary(&self) -> Vec<Vec<u32>> {
        let mut touches = self.touches.clone();
        touches.sort_unstable();
        let rings = self.polygon.rings().enumerate();
        let walk = |(number, ring): (usize, std::ops::Range<usize>)| {
            let mut walk: Vec<u32> = Vec::with_capacity(ring.len());
            let mut go_to = |vertex| {
                if walk.last() != Some(&vertex) {
                    walk.push(vertex);
                }
            };
            for i in ring.clone() {
                // A point between two at its place was never looked up.
                if self.same[i] != NONE {
                    go_to(self.same[i]);
                }
                let first = touches.partition_point(|&(origin, _)| (origin as usize) < i);
                let end = touches.partition_point(|&(origin, _)| origin as usize <= i);
                let mut inside: Vec<u32> = touches[first..end].iter().map(|&(_, vertex)| vertex).collect();
                inside.sort_by(|&v, &w| upwards(self.structure.point(v), self.structure.point(w)));
                let next = if i + 1 == ring.end { ring.start } else { i + 1 };
                if upwards(self.structure.points[next], self.structure.points[i]) == Ordering::Less {
                    inside.reverse();
                }
                inside.into_iter().for_each(&mut go_to);
            }
            while walk.len() > 1 && walk.first() == walk.last() {
                walk.pop();
            }
            let is_counter_clockwise = self.polygon.ring(ring).orientation() == Orientation::CounterClockwise;
            if is_counter_clockwise == (number > 0) {
                walk.reverse();
            }
            walk
        };
        rings.map(walk).collect()
    }

    /// How many nodes of the query structure and how many trapezoids were visited: the cost of building the map.
    #[must_use]
    pub const fn steps(&self) -> u64 {
        self.structure.steps
    }

    fn place(&self, p: Point) -> Option<Place> {
        p.is_finite().then(|| self.structure.locate(ROOT, p, LEFT, &mut 0))
    }

    fn is_inside(&self, cell: u32) -> bool {
        let [left, right] = self.structure.cell(cell).sides;
        left != NONE && right != NONE && self.structure.sides[left as usize].inside_is_right
    }

    fn side(&self, side: u32) -> [u32; 2] {
        let Side { lower, upper, .. } = self.structure.sides[side as usize];
        [lower, upper]
    }

    /// Where the horizontal line through a vertex meets a side.
    fn corner(&self, [lower, upper]: [u32; 2], vertex: u32) -> Point {
        let p = self.structure.point(vertex);
        if vertex == lower || vertex == upper {
            return p;
        }
        let (a, b) = (self.structure.point(lower), self.structure.point(upper));
        Point::new(abscissa(a, b, p.y), p.y)
    }
}

/// The abscissa of the segment from `a` up to `b` at a height, rounded.
#[inline]
pub(super) fn abscissa(a: Point, b: Point, y: f64) -> f64 {
    let height = 0.5 * b.y - 0.5 * a.y;
    let t = if height > 0.0 { ((0.5 * y - 0.5 * a.y) / height).clamp(0.0, 1.0) } else { 0.0 };
    Point::lerp(a, b, t).x
}

impl Structure<'_> {
    /// The trapezoids inside. Both sides of each must say the same.
    fn inside(&self, polygon: Polygon<'_>) -> Result<Vec<u32>, PolygonError> {
        let is_right = |side: u32| (side != NONE).then(|| self.sides[side as usize].inside_is_right);
        let mut inside = Vec::new();
        for (at, cell) in (0..).zip(&self.cells) {
            let by_left = is_right(cell.sides[LEFT]) == Some(true);
            let by_right = is_right(cell.sides[RIGHT]) == Some(false);
            if by_left != by_right {
                let faulty = cell.sides.into_iter().filter(|&side| side != NONE);
                // Of two rings the later one is the hole.
                let origin = faulty.map(|side| self.sides[side as usize].origin as usize).max().unwrap_or(0);
                let ring = polygon.rings().position(|ring| ring.contains(&origin)).unwrap_or(0);
                return Err(PolygonError::Misplaced { ring, at: polygon.points()[origin] });
            }
            if by_left {
                inside.push(at);
            }
        }
        Ok(inside)
    }
}

/// The sides of a polygon.
struct Sides {
    /// The point after each point in its ring.
    next: Vec<u32>,
    /// The points from which a side leaves: all but those before a point at the same place.
    origins: Vec<u32>,
    /// Whether the inside is on the right of the side that leaves from each point.
    inside_is_right: Vec<bool>,
}

impl Sides {
    fn of(polygon: Polygon<'_>) -> Result<Self, PolygonError> {
        let n = polygon.points().len();
        let mut sides = Self { next: vec![0; n], origins: Vec::with_capacity(n), inside_is_right: vec![false; n] };
        for (number, ring) in polygon.rings().enumerate() {
            let turn = polygon.ring(ring.clone()).orientation();
            if turn == Orientation::Collinear {
                return Err(PolygonError::Flat { ring: number, first: ring.start as u32 });
            }
            let is_hole = number > 0;
            let inside_is_right = (turn == Orientation::Clockwise) != is_hole;
            for i in ring.clone() {
                let j = if i + 1 == ring.end { ring.start } else { i + 1 };
                sides.next[i] = j as u32;
                sides.inside_is_right[i] = inside_is_right;
                if polygon.points()[i] != polygon.points()[j] {
                    sides.origins.push(i as u32);
                }
            }
        }
        Ok(sides)
    }
}

/// Sides in the order in which they are inserted: in rounds, each about twice as large as all before it. Which round a
/// side is in is random, and the sides of a round are in the order of the rings.
struct Rounds {
    order: Vec<u32>,
    /// Where each round ends.
    ends: Vec<usize>,
}

/// The most rounds. In each but the first one a side stays for the next round with probability 1/2.
const ROUNDS: usize = 32;

impl Rounds {
    /// Puts sides into rounds (xorshift, `[Marsaglia03]`).
    fn new(sides: Vec<u32>, seed: u64) -> Self {
        let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
        let mut sizes = [0; ROUNDS];
        let mut draw = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            ROUNDS - 1 - (state.leading_zeros() as usize).min(ROUNDS - 1)
        };
        let drawn: Vec<u8> = sides.iter().map(|_| draw() as u8).collect();
        for &round in &drawn {
            sizes[usize::from(round)] += 1;
        }
        let mut ends = Vec::with_capacity(ROUNDS);
        let mut places = [0; ROUNDS];
        let mut total = 0;
        for (place, size) in places.iter_mut().zip(sizes) {
            *place = total;
            total += size;
            if size > 0 {
                ends.push(total);
            }
        }
        let mut order = vec![0; sides.len()];
        for (side, round) in sides.into_iter().zip(drawn) {
            order[places[usize::from(round)]] = side;
            places[usize::from(round)] += 1;
        }
        Self { order, ends }
    }

    /// The rounds, and after which of them the rings are followed: once `n / log n`, `n / log log n`, … sides are
    /// inserted, and never after all are.
    fn all(&self) -> impl Iterator<Item = (&[u32], bool)> {
        let n = self.order.len();
        let mut log = n.max(1).ilog2() as usize;
        let mut begin = 0;
        self.ends.iter().map(move |&end| {
            let round = &self.order[begin..end];
            begin = end;
            let is_followed = log > 2 && end < n && end * log >= n;
            while log > 2 && end * log >= n {
                log = log.ilog2() as usize;
            }
            (round, is_followed)
        })
    }
}
