//! Triangulation by visible pairs: every two vertices that see each other are joined, unless an earlier edge is in the
//! way.
//!
//! The lecture notes' greedy method for polygons, which they say works for every planar straight-line graph. It asks
//! nothing of the order of pairs, and every order leads to a triangulation: when no edge can be added, every bounded
//! face is a triangle, as a larger one would have a diagonal.
//!
//! ```text
//!     d-----------c           The pairs in order: a c is added. b d would cross it, and
//!     | \       / |           is refused. Were it the first one, a c would be refused.
//!     |   \   /   |
//!     |     x     |
//!     |   /   \   |
//!     a-----------b
//! ```
//!
//! # Steps
//! 1. The segments are edges, divided at the vertices on them.
//! 2. For each vertex, look at each later one. Refuse the pair if a vertex lies between them, or an edge crosses; in a
//!    polygon, also if the pair leaves its first vertex to the outside. Otherwise add it as an edge.
//! 3. Two edges that follow each other around a vertex, with an edge between their far ends, bound a triangle.
//!
//! # Degenerate cases
//! Of points at one place the first one stands for all. Points on one line are joined to their neighbours, and have no
//! triangles. Segments may overlap and may be repeated; segments that cross are refused. For polygons that is as in
//! [`seidel`](super::seidel()).
//!
//! # Complexity
//! O(n³): n²/2 pairs, each held against all edges. The lecture notes call the cost very high.
//!
//! # Source
//! `[Triangulaciones]`, second part.

use std::cmp::Ordering;

use super::angles::{clockwise, steps};
use super::{Polygon, PolygonError, TrapezoidMap};
use crate::geometry::{
    BoundingBox, Orientation, Point, Segment, lexicographic, orient2d, segments_cross_properly, strictly_between,
};
use crate::trace::{NoTrace, Shape, Trace};

/// Triangulates a polygon with holes by joining the vertices that see each other.
///
/// # Shape
/// Indices into the points of the polygon, each triangle counter-clockwise by the exact test; `n - 2 + 2h` of them for
/// `n` corners and `h` holes, if no rings touch.
///
/// # Errors
/// A ring without area, sides that cross or overlap, a hole that is not in the outline, cancelled.
///
/// # Complexity
/// O(n³).
///
/// # Source
/// `[Triangulaciones]`
///
/// # Examples
/// ```
/// use trimalla::Point;
/// use trimalla::polygon::{Polygon, visible_pairs};
/// use trimalla::trace::NoTrace;
///
/// let points = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (1.0, 1.0), (3.0, 1.0), (2.0, 3.0)]
///     .map(|(x, y)| Point::new(x, y));
/// let polygon = Polygon::new(&points, &[4, 7])?;
/// assert_eq!(visible_pairs(polygon, &mut NoTrace)?.len(), 7 - 2 + 2);
/// # Ok::<(), trimalla::polygon::PolygonError>(())
/// ```
pub fn visible_pairs(polygon: Polygon<'_>, trace: &mut (impl Trace + ?Sized)) -> Result<Vec<[u32; 3]>, PolygonError> {
    // The trapezoids prove that nothing crosses, and know which vertices touch which sides.
    let map = TrapezoidMap::new(polygon, 0, &mut NoTrace)?;
    let sides: Vec<[u32; 2]> = map.boundary().iter().flat_map(|ring| steps(ring)).collect();
    let mut vertices: Vec<u32> = sides.iter().map(|side| side[0]).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let mut pairs = Pairs::new(polygon.points(), vertices, Some(Inside::of(&sides)));
    for side in sides {
        pairs.add(side);
    }
    pairs.join_all(trace)?;
    Ok(pairs.triangles(trace))
}

/// Triangulates a planar straight-line graph: the convex hull of the points, with the segments as edges.
///
/// # Shape
/// Indices into the points, each triangle counter-clockwise by the exact test. A segment with vertices on it is several
/// edges. Empty if all points lie on one line.
///
/// # Errors
/// [`PolygonError::Crossing`] for segments that cross in a point inside both, [`PolygonError::SegmentEnd`]; a point
/// that is not finite, too many points, cancelled.
///
/// # Complexity
/// O(n³).
///
/// # Source
/// `[Triangulaciones]`
///
/// # Examples
/// ```
/// use trimalla::Point;
/// use trimalla::polygon::visible_pairs_of_graph;
/// use trimalla::trace::NoTrace;
///
/// let points = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (1.0, 2.0)].map(|(x, y)| Point::new(x, y));
/// let triangles = visible_pairs_of_graph(&points, &[[1, 3]], &mut NoTrace)?;
/// assert_eq!(triangles.len(), 4);
/// # Ok::<(), trimalla::polygon::PolygonError>(())
/// ```
pub fn visible_pairs_of_graph(
    points: &[Point],
    segments: &[[u32; 2]],
    trace: &mut (impl Trace + ?Sized),
) -> Result<Vec<[u32; 3]>, PolygonError> {
    Polygon::new(points, &[])?;
    let same = representatives(points);
    let vertices = (0..).take(points.len()).filter(|&v| same[v as usize] == v).collect();
    let mut pairs = Pairs::new(points, vertices, None);
    for (number, &ends) in segments.iter().enumerate() {
        if trace.is_cancelled() {
            return Err(PolygonError::Cancelled);
        }
        if let Some(&vertex) = ends.iter().find(|&&v| v as usize >= points.len()) {
            return Err(PolygonError::SegmentEnd { segment: number, vertex });
        }
        pairs.add_segment(ends.map(|v| same[v as usize]))?;
    }
    pairs.join_all(trace)?;
    Ok(pairs.triangles(trace))
}

/// The first point at the place of each point.
fn representatives(points: &[Point]) -> Vec<u32> {
    let mut order: Vec<u32> = (0..).take(points.len()).collect();
    order.sort_by(|&i, &j| lexicographic(points[i as usize], points[j as usize]));
    let mut same = vec![0; points.len()];
    for group in order.chunk_by(|&i, &j| points[i as usize] == points[j as usize]) {
        for &i in group {
            same[i as usize] = group[0];
        }
    }
    same
}

/// The vertices, and the edges between them so far.
struct Pairs<'a> {
    points: &'a [Point],
    vertices: Vec<u32>,
    edges: Vec<([u32; 2], BoundingBox)>,
    /// The neighbours of each vertex.
    neighbours: Vec<Vec<u32>>,
    inside: Option<Inside>,
}

impl<'a> Pairs<'a> {
    fn new(points: &'a [Point], vertices: Vec<u32>, inside: Option<Inside>) -> Self {
        Self { points, vertices, edges: Vec::new(), neighbours: vec![Vec::new(); points.len()], inside }
    }

    fn point(&self, vertex: u32) -> Point {
        self.points[vertex as usize]
    }

    fn add(&mut self, [a, b]: [u32; 2]) {
        let bounds = Segment::new(self.point(a), self.point(b)).bounding_box();
        self.edges.push(([a, b], bounds));
        self.neighbours[a as usize].push(b);
        self.neighbours[b as usize].push(a);
    }

    /// Adds a segment as edges between the vertices on it.
    fn add_segment(&mut self, [a, b]: [u32; 2]) -> Result<(), PolygonError> {
        let (p, q) = (self.point(a), self.point(b));
        let mut on: Vec<u32> =
            self.vertices.iter().copied().filter(|&v| strictly_between(p, q, self.point(v))).collect();
        on.sort_by(|&v, &w| lexicographic(self.point(v), self.point(w)));
        if lexicographic(p, q) == Ordering::Greater {
            on.reverse();
        }
        on.insert(0, a);
        on.push(b);
        for pair in on.windows(2) {
            let edge = [pair[0], pair[1]];
            if edge[0] == edge[1] || self.neighbours[edge[0] as usize].contains(&edge[1]) {
                continue;
            }
            if let Some(other) = self.first_crossed(edge) {
                let [one, two] = [other, edge].map(|e| Segment::new(self.point(e[0]), self.point(e[1])));
                let at = one.crossing_point(two).unwrap_or(p);
                return Err(PolygonError::Crossing { sides: [other, edge], at });
            }
            self.add(edge);
        }
        Ok(())
    }

    /// The first edge that crosses a pair.
    fn first_crossed(&self, [a, b]: [u32; 2]) -> Option<[u32; 2]> {
        let (p, q) = (self.point(a), self.point(b));
        let bounds = Segment::new(p, q).bounding_box();
        let crosses = |&&([c, d], other): &&([u32; 2], BoundingBox)| {
            bounds.meets(other) && segments_cross_properly(p, q, self.point(c), self.point(d))
        };
        self.edges.iter().find(crosses).map(|&(edge, _)| edge)
    }

    /// Step 2: joins each pair that may be joined.
    fn join_all(&mut self, trace: &mut (impl Trace + ?Sized)) -> Result<(), PolygonError> {
        for i in 0..self.vertices.len() {
            for j in i + 1..self.vertices.len() {
                if trace.is_cancelled() {
                    return Err(PolygonError::Cancelled);
                }
                let pair = [self.vertices[i], self.vertices[j]];
                if self.neighbours[pair[0] as usize].contains(&pair[1]) {
                    continue;
                }
                match self.refusal(pair) {
                    Some(why) => trace.refuse(Shape::Edge(pair), why),
                    None => {
                        self.add(pair);
                        trace.add(Shape::Edge(pair), "the two see each other");
                    }
                }
            }
        }
        Ok(())
    }

    /// Why a pair is not joined.
    fn refusal(&self, pair: [u32; 2]) -> Option<&'static str> {
        let (p, q) = (self.point(pair[0]), self.point(pair[1]));
        if self.inside.as_ref().is_some_and(|inside| !inside.leaves_inside(self.points, pair)) {
            return Some("runs outside");
        }
        if self.first_crossed(pair).is_some() {
            return Some("crosses an edge");
        }
        let is_between = |&v: &u32| strictly_between(p, q, self.point(v));
        self.vertices.iter().any(is_between).then_some("runs through a vertex")
    }

    /// Step 3: the triangles between the edges. Each is found at its lowest vertex.
    fn triangles(&self, trace: &mut (impl Trace + ?Sized)) -> Vec<[u32; 3]> {
        let mut triangles = Vec::new();
        for &v in &self.vertices {
            let Some(&first) = self.neighbours[v as usize].first() else { continue };
            let mut around = self.neighbours[v as usize].clone();
            let [center, from] = [v, first].map(|v| self.point(v));
            around.sort_by(|&a, &b| clockwise(center, from, self.point(b), self.point(a)));
            for (k, &a) in around.iter().enumerate() {
                let b = around[if k + 1 == around.len() { 0 } else { k + 1 }];
                let turn = orient2d(center, self.point(a), self.point(b));
                let is_found = v < a.min(b)
                    && turn == Orientation::CounterClockwise
                    && self.inside.as_ref().is_none_or(|inside| !inside.has_outside_on_left([v, a]))
                    && self.neighbours[a as usize].contains(&b);
                if is_found {
                    trace.add(Shape::Triangle([v, a, b]), "between three edges");
                    triangles.push([v, a, b]);
                }
            }
        }
        triangles
    }
}

/// The sides of a polygon, by the vertices at which they start and end.
struct Inside {
    /// The sides, sorted: the inside is on the left.
    leaving: Vec<[u32; 2]>,
    /// The sides from their ends, sorted.
    arriving: Vec<[u32; 2]>,
}

impl Inside {
    fn of(sides: &[[u32; 2]]) -> Self {
        let mut leaving = sides.to_vec();
        let mut arriving: Vec<[u32; 2]> = sides.iter().map(|&[a, b]| [b, a]).collect();
        leaving.sort_unstable();
        arriving.sort_unstable();
        Self { leaving, arriving }
    }

    fn has_outside_on_left(&self, edge: [u32; 2]) -> bool {
        self.arriving.binary_search(&edge).is_ok()
    }

    /// Whether the next side clockwise from a pair, around its first vertex, has the inside on its left.
    fn leaves_inside(&self, points: &[Point], [a, b]: [u32; 2]) -> bool {
        let [center, towards] = [a, b].map(|v| points[v as usize]);
        let at = |sides: &[[u32; 2]]| sides.partition_point(|s| s[0] < a)..sides.partition_point(|s| s[0] <= a);
        let leaving = self.leaving[at(&self.leaving)].iter().map(|side| (side[1], true));
        let arriving = self.arriving[at(&self.arriving)].iter().map(|side| (side[1], false));
        let first = leaving
            .chain(arriving)
            .min_by(|x, y| clockwise(center, towards, points[x.0 as usize], points[y.0 as usize]));
        first.is_some_and(|(_, is_leaving)| is_leaving)
    }
}
