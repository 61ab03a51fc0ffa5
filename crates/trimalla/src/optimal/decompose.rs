//! The best triangulation of a polygon by dynamic programming, also of one that touches itself.
//!
//! # Idea
//! A triangulation of a polygon has a triangle at each side. It leaves two smaller polygons, each cut off by a
//! diagonal, and if the whole is best, so are the two. So the best triangulation behind every diagonal is found once,
//! behind short ones first, and long ones are put together from them.
//!
//! ```text
//!          m                  The polygon behind the diagonal i j has the corners i, i + 1, …, j. Its triangle at i j
//!        ╱   ╲                has some third corner m. What is best behind i m and behind m j is known already:
//!      ╱       ╲
//!     ╱ i…m  m…j ╲            best(i, j) = the least of best(i, m) + best(m, j) + the edges i m and m j,
//!    i ─────────── j
//!     ╲           ╱           where + is the sum of lengths, or the longer of two, or what else is minimised.
//!      ╲ the rest╱
//! ```
//!
//! A *walk* around a face of a planar graph may come back to a vertex: where a tree of edges hangs into the face, the
//! walk goes along one side of each edge and back along the other. The places of the walk are the corners then, and a
//! vertex is several of them. A diagonal ends at a place: the walk arrives there by one edge and leaves by the next,
//! and the diagonal must run between the two.
//!
//! # Steps
//! 1. Find the diagonals: pairs of places that see each other inside the polygon.
//! 2. For each diagonal, those between near places first, take the best third corner.
//! 3. Follow the choices from the side between the last place and the first.
//!
//! # Degenerate cases
//! Corners in line: a diagonal that passes through a vertex is none, so no flat triangle is made. A face with a second
//! walk (a hole), or with a vertex inside, cannot be decomposed this way: [`fill`] refuses it.
//!
//! # Complexity
//! O(k³) time for k places, O(d) memory for d diagonals. Where few diagonals exist, or are allowed, the time is that of
//! finding them, O(k) for each allowed pair, and of joining the lists of diagonals at both ends of each.
//!
//! # Source
//! `[Klincsek80]`.

use std::cmp::Ordering;

use super::OptimalError;
use super::mesh::{Face, Mesh};
use crate::geometry::{BoundingBox, Orientation, Point, Segment, orient2d, segments_cross_properly, strictly_between};
use crate::trace::{Shape, Trace};

/// The most corners of a polygon of which any two may be joined.
const MOST_CORNERS: usize = 5792;

/// The most diagonals and sides, which need about 2 GB.
const MOST_DIAGONALS: usize = MOST_CORNERS * (MOST_CORNERS - 1) / 2;

/// What is minimised over the edges inside a polygon.
pub(crate) trait Objective {
    /// A cost: of one edge, or of several.
    type Value: Clone;

    /// The cost of an edge.
    fn edge(&self, edge: [u32; 2]) -> Self::Value;

    /// The cost of two parts together: not less than that of either, and the better the parts, the better.
    fn join(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;

    /// The order of costs.
    fn compare(&self, a: &Self::Value, b: &Self::Value) -> Ordering;

    /// Whether an edge may be used.
    fn is_allowed(&self, _edge: [u32; 2]) -> bool {
        true
    }
}

/// The best triangulation of a polygon.
pub(crate) struct Best<V> {
    /// Counter-clockwise triangles, one less than there are sides but one.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The cost of the edges inside; `None` without any.
    pub(crate) value: Option<V>,
}

/// The best triangulation of the polygon inside a closed walk.
///
/// # Shape
/// The walk runs with the inside on its left, along edges that do not cross; its last vertex is joined to the first. A
/// vertex may come several times. No vertex lies inside.
///
/// # Guarantees
/// `None` if no triangulation has allowed edges only. Of equally good third corners the first on the walk is taken.
///
/// # Errors
/// Cancelled; more diagonals than memory is meant for: as many as a convex polygon of 5792 corners has.
pub(crate) fn triangulate<O: Objective>(
    points: &[Point],
    walk: &[u32],
    objective: &O,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Option<Best<O::Value>>, OptimalError> {
    if walk.len() < 3 {
        return Ok(Some(Best { triangles: Vec::new(), value: None }));
    }
    let mut table = Table::new(Places { points, walk }, objective, trace)?;
    for i in (0..walk.len()).rev() {
        if trace.is_cancelled() {
            return Err(OptimalError::Cancelled);
        }
        table.settle_from(i, objective);
    }
    Ok(table.best())
}

/// The corners of the polygon: the places of the walk.
#[derive(Clone, Copy)]
struct Places<'a> {
    points: &'a [Point],
    walk: &'a [u32],
}

impl Places<'_> {
    fn at(self, i: usize) -> Point {
        self.points[self.walk[i] as usize]
    }

    fn edge(self, i: usize, j: usize) -> [u32; 2] {
        [self.walk[i], self.walk[j]]
    }

    /// Whether two places that are no neighbours see each other inside the polygon.
    fn see(self, i: usize, j: usize) -> bool {
        let (a, b) = (self.at(i), self.at(j));
        a != b && self.opens_to(i, b) && self.opens_to(j, a) && self.is_free(a, b)
    }

    /// Whether the way from a place to a point starts between the edges before and after the place.
    fn opens_to(self, i: usize, x: Point) -> bool {
        let k = self.walk.len();
        let (before, p, after) = (self.at((i + k - 1) % k), self.at(i), self.at((i + 1) % k));
        let is_left = |a: Point, b: Point, c: Point| orient2d(a, b, c) == Orientation::CounterClockwise;
        match orient2d(before, p, after) {
            Orientation::CounterClockwise => is_left(p, after, x) && is_left(p, x, before),
            Orientation::Clockwise => {
                orient2d(p, before, x) == Orientation::Clockwise || orient2d(p, x, after) == Orientation::Clockwise
            }
            Orientation::Collinear if strictly_between(before, after, p) => is_left(p, after, x),
            // The walk turns back: all directions are open but that of the edge.
            Orientation::Collinear => orient2d(p, after, x) != Orientation::Collinear || strictly_between(after, x, p),
        }
    }

    /// Whether no edge of the walk crosses a segment, and no vertex of it lies inside.
    fn is_free(self, a: Point, b: Point) -> bool {
        let around = Segment::new(a, b).bounding_box();
        let k = self.walk.len();
        (0..k).all(|m| {
            let (c, d) = (self.at(m), self.at((m + 1) % k));
            is_apart(around, c, d) || !(segments_cross_properly(a, b, c, d) || strictly_between(a, b, c))
        })
    }
}

/// Whether a segment lies on one side of a box.
fn is_apart(around: BoundingBox, c: Point, d: Point) -> bool {
    c.x.max(d.x) < around.min.x
        || c.x.min(d.x) > around.max.x
        || c.y.max(d.y) < around.min.y
        || c.y.min(d.y) > around.max.y
}

/// A side or diagonal, seen from one of its places.
#[derive(Clone)]
struct Link<V> {
    /// The other place.
    to: u32,
    /// Its row in the table.
    row: u32,
    /// Whether the polygon behind it can be triangulated.
    is_filled: bool,
    /// The cost of the best triangulation behind it, and its own if it is a diagonal; `None` for a side.
    value: Option<V>,
}

/// The triangle at a side or diagonal.
#[derive(Clone, Copy)]
struct Choice {
    /// The place of its third corner.
    corner: u32,
    /// The rows of its other two sides.
    rows: [u32; 2],
}

/// All sides and diagonals.
///
/// Costs stand in both lists of links, so that the loop over third corners reads memory in order.
struct Table<'a, V> {
    places: Places<'a>,
    /// From each place to later ones, ascending.
    up: Vec<Vec<Link<V>>>,
    /// From each place to earlier ones, descending as they are settled; only those that are filled.
    down: Vec<Vec<Link<V>>>,
    /// The triangle behind each side and diagonal, if there is one.
    choices: Vec<Option<Choice>>,
}

impl<'a, V: Clone> Table<'a, V> {
    /// Step 1.
    fn new<O: Objective<Value = V>>(
        places: Places<'a>,
        objective: &O,
        trace: &mut (impl Trace + ?Sized),
    ) -> Result<Self, OptimalError> {
        let k = places.walk.len();
        let mut table = Self { places, up: vec![Vec::new(); k], down: vec![Vec::new(); k], choices: Vec::new() };
        for i in 0..k {
            if trace.is_cancelled() {
                return Err(OptimalError::Cancelled);
            }
            for j in i + 1..k {
                let is_side = j == i + 1 || (i == 0 && j == k - 1);
                let edge = places.edge(i, j);
                if is_side {
                    table.add(i, j, None);
                } else if objective.is_allowed(edge) && places.see(i, j) {
                    if table.choices.len() >= MOST_DIAGONALS {
                        return Err(OptimalError::TooMany { count: k, limit: MOST_CORNERS });
                    }
                    trace.look(Shape::Edge(edge), "a diagonal");
                    table.add(i, j, Some(objective.edge(edge)));
                }
            }
        }
        Ok(table)
    }

    fn add(&mut self, i: usize, j: usize, value: Option<V>) {
        self.up[i].push(Link { to: j as u32, row: self.choices.len() as u32, is_filled: j == i + 1, value });
        self.choices.push(None);
    }

    /// Step 2 for the diagonals from one place to later ones; those from later places are settled.
    fn settle_from<O: Objective<Value = V>>(&mut self, i: usize, objective: &O) {
        let mut up = std::mem::take(&mut self.up[i]);
        for at in 0..up.len() {
            let (before, [link, ..]) = up.split_at_mut(at) else { continue };
            if !link.is_filled {
                self.settle(i, before, link, objective);
            }
            if link.is_filled {
                self.down[link.to as usize].push(Link { to: i as u32, ..link.clone() });
            }
        }
        self.up[i] = up;
    }

    /// Step 2 for one diagonal: the best third corner.
    fn settle<O: Objective<Value = V>>(&mut self, i: usize, before: &[Link<V>], link: &mut Link<V>, objective: &O) {
        let j = link.to as usize;
        let is_left_turn = |m: u32| {
            let [a, b, c] = [i, m as usize, j].map(|place| self.places.at(place));
            orient2d(a, b, c) == Orientation::CounterClockwise
        };
        let mut best: Option<(Option<V>, Choice)> = None;
        let mut down = self.down[j].iter().rev().peekable();
        for first in before.iter().filter(|first| first.is_filled) {
            while down.next_if(|second| second.to < first.to).is_some() {}
            let Some(second) = down.peek().filter(|second| second.to == first.to) else { continue };
            let value = joined(objective, first.value.as_ref(), second.value.as_ref());
            let is_better = best.as_ref().is_none_or(|(old, _)| compare(objective, &value, old).is_lt());
            if is_better && is_left_turn(first.to) {
                best = Some((value, Choice { corner: first.to, rows: [first.row, second.row] }));
            }
        }
        if let Some((value, choice)) = best {
            link.value = joined(objective, link.value.as_ref(), value.as_ref());
            link.is_filled = true;
            self.choices[link.row as usize] = Some(choice);
        }
    }

    /// Step 3.
    fn best(self) -> Option<Best<V>> {
        let last = self.places.walk.len() - 1;
        let root = self.up[0].last().filter(|link| link.to as usize == last && link.is_filled)?;
        let mut triangles = Vec::with_capacity(last - 1);
        let mut open = vec![(0, last, root.row)];
        while let Some((i, j, row)) = open.pop() {
            let Some(Choice { corner, rows: [first, second] }) = self.choices[row as usize] else { continue };
            let m = corner as usize;
            triangles.push([i, m, j].map(|place| self.places.walk[place]));
            open.extend([(i, m, first), (m, j, second)]);
        }
        Some(Best { triangles, value: root.value.clone() })
    }
}

/// The cost of two parts, either of which may be nothing.
fn joined<O: Objective>(objective: &O, a: Option<&O::Value>, b: Option<&O::Value>) -> Option<O::Value> {
    match (a, b) {
        (Some(a), Some(b)) => Some(objective.join(a, b)),
        (one, other) => one.or(other).cloned(),
    }
}

/// The order of costs; nothing is the least.
fn compare<O: Objective>(objective: &O, a: &Option<O::Value>, b: &Option<O::Value>) -> Ordering {
    match (a, b) {
        (Some(a), Some(b)) => objective.compare(a, b),
        (a, b) => a.is_some().cmp(&b.is_some()),
    }
}

/// The triangles of the best triangulations of all faces that some edges of a mesh make.
///
/// # Shape
/// `kept` edges are those of the boundary and what else must stay, each from its lower vertex, sorted. `search` is
/// given the walk of a face and returns its best triangulation.
///
/// # Errors
/// A face with a hole or with a vertex inside; what `search` returns.
pub(crate) fn fill<T: Trace + ?Sized>(
    mesh: &Mesh,
    kept: &[[u32; 2]],
    method: &'static str,
    trace: &mut T,
    mut search: impl FnMut(&[u32], &mut T) -> Result<Vec<[u32; 3]>, OptimalError>,
) -> Result<Vec<[u32; 3]>, OptimalError> {
    let mut triangles = Vec::with_capacity(mesh.triangles.len());
    for Face { walk, triangle_count } in mesh.faces(|edge| kept.binary_search(&edge.ends()).is_ok()) {
        if walk.len() != triangle_count + 2 {
            return Err(OptimalError::NotOneWalk { method, vertex: walk[0] });
        }
        let found = search(&walk, trace)?;
        for &t in &found {
            trace.add(Shape::Triangle(t), "of the best triangulation of a face");
        }
        triangles.extend(found);
    }
    Ok(triangles)
}
