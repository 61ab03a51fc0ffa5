//! The order of triangulations by all their angles, and the measures that the Delaunay triangulation makes best.

use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

use crate::drawing::{IndexedMesh, is_sound};
use crate::geometry::math::hypot;
use crate::geometry::{Orientation, Point, Triangle, compare_angles, orient2d};

/// Compares two triangulations of the same points by their angles: the lists of all angles, each sorted from the
/// smallest on, in lexicographic order. `Greater` means that the first one is better.
///
/// The best triangulation in this order is called *equiangular* (the notes: *equilátera*). It is a Delaunay
/// triangulation; where four points are cocircular there are several, not all of which are equiangular, and the tie
/// rule of this library does not ask which is.
///
/// # Shape
/// Triangles that are not counter-clockwise, or name a vertex that is not there, are passed over. A list that is the
/// beginning of the other is less.
///
/// # Guarantees
/// Exact for finite points.
///
/// # Complexity
/// O(n log n).
///
/// # Source
/// `[Triangulaciones]`, part I; `[Sibson78]`.
///
/// # Examples
/// ```
/// use std::cmp::Ordering;
/// use trimalla::quality::compare_equiangularity;
/// use trimalla::{IndexedMesh, Point};
///
/// let points = [[0.0, 0.0], [4.0, -1.0], [8.0, 0.0], [4.0, 1.0]].map(Point::from).to_vec();
/// let flat = IndexedMesh { points, triangles: vec![[0, 1, 2], [0, 2, 3]], ..IndexedMesh::default() };
/// let good = IndexedMesh { triangles: vec![[0, 1, 3], [1, 2, 3]], ..flat.clone() };
/// assert_eq!(compare_equiangularity(&good, &flat), Ordering::Greater);
/// ```
#[doc(alias = "equilátera")]
#[must_use]
pub fn compare_equiangularity(one: &IndexedMesh, other: &IndexedMesh) -> Ordering {
    let (one, other) = (sorted_angles(one), sorted_angles(other));
    let pairs = one.iter().zip(&other).map(|(a, b)| compare_angles(*a, *b));
    pairs.fold(Ordering::Equal, Ordering::then).then(one.len().cmp(&other.len()))
}

/// The angles of all triangles, the smallest first: apex, and a point on either leg.
fn sorted_angles(mesh: &IndexedMesh) -> Vec<[Point; 3]> {
    let corners = corners(mesh).flat_map(|[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]]);
    let mut angles: Vec<[Point; 3]> = corners.collect();
    angles.sort_by(|a, b| compare_angles(*a, *b));
    angles
}

/// The corners of the counter-clockwise triangles.
fn corners(mesh: &IndexedMesh) -> impl Iterator<Item = [Point; 3]> + '_ {
    let sound = mesh.triangles.iter().filter(|t| is_sound(t, mesh.points.len()));
    let corners = sound.map(|t| t.map(|v| mesh.points[v as usize]));
    corners.filter(|&[a, b, c]| orient2d(a, b, c) == Orientation::CounterClockwise)
}

/// What the Delaunay triangulation makes best among all triangulations of its points; rounded.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DelaunayMeasures {
    /// The smallest angle, in radians; no triangulation has a larger one.
    pub min_angle: f64,
    /// The largest radius of the smallest circle that holds a triangle; no triangulation has a smaller one `[Rajan94]`.
    pub max_enclosing_radius: f64,
    /// The largest circumradius. `[Triangulaciones]` says that no triangulation has a smaller one; in our tests none
    /// has.
    pub max_circumradius: f64,
    /// The sum of the inradii; no triangulation has a larger one `[Lambert94]`.
    pub inradius_sum: f64,
}

impl DelaunayMeasures {
    /// Measures a mesh; zeros without triangles.
    ///
    /// # Complexity
    /// Linear.
    #[must_use]
    pub fn of(mesh: &IndexedMesh) -> Self {
        let mut measures = Self { min_angle: f64::INFINITY, ..Self::default() };
        for [a, b, c] in corners(mesh) {
            let triangle = Triangle::new(a, b, c);
            let circumradius = triangle.circumradius_sq().map_or(f64::INFINITY, f64::sqrt);
            measures.min_angle = measures.min_angle.min(triangle.min_angle().radians());
            measures.max_circumradius = measures.max_circumradius.max(circumradius);
            measures.max_enclosing_radius =
                measures.max_enclosing_radius.max(enclosing_radius(&triangle, circumradius));
            measures.inradius_sum += triangle.inradius();
        }
        if measures.min_angle.is_finite() { measures } else { Self::default() }
    }
}

/// The radius of the smallest circle that holds a triangle: half of the longest side where the angle opposite is not
/// acute, else the circumradius.
fn enclosing_radius(triangle: &Triangle, circumradius: f64) -> f64 {
    let i = triangle.longest_edge();
    let side = triangle.edge(i);
    let apex = triangle.corners[i];
    let is_acute = (side.start - apex).dot(side.end - apex) > 0.0;
    if is_acute { circumradius } else { 0.5 * side.length() }
}

/// The largest detour: how much longer the shortest way along edges between two vertices is than their distance, at
/// most.
///
/// For a Delaunay triangulation it is below 2.42, and below 1.998 by `[Xia13]`. One for fewer than two vertices;
/// infinite where two are not connected.
///
/// # Complexity
/// O(n² log n).
///
/// # Source
/// `[Triangulaciones]`, part I; `[KeilGutwin92]`.
#[must_use]
pub fn max_detour(mesh: &IndexedMesh) -> f64 {
    let edges = mesh.edges();
    let mut near = vec![Vec::new(); mesh.points.len()];
    for &[a, b] in &edges {
        let length = distance(mesh, a, b);
        near[a as usize].push((b, length));
        near[b as usize].push((a, length));
    }
    let mut used: Vec<u32> = edges.into_iter().flatten().collect();
    used.sort_unstable();
    used.dedup();
    let mut most = 1.0_f64;
    for &from in &used {
        let ways = ways_from(&near, from);
        for &to in used.iter().filter(|&&to| to > from) {
            most = most.max(ways[to as usize] / distance(mesh, from, to));
        }
    }
    most
}

fn distance(mesh: &IndexedMesh, a: u32, b: u32) -> f64 {
    let way = mesh.points[b as usize] - mesh.points[a as usize];
    hypot(way.x, way.y)
}

/// The lengths of the shortest ways from a vertex along edges: Dijkstra's algorithm.
fn ways_from(near: &[Vec<(u32, f64)>], from: u32) -> Vec<f64> {
    let mut ways = vec![f64::INFINITY; near.len()];
    ways[from as usize] = 0.0;
    // Lengths are not negative: their bits are in the order of their values.
    let mut waiting = BinaryHeap::from([Reverse((0.0_f64.to_bits(), from))]);
    while let Some(Reverse((bits, at))) = waiting.pop() {
        let way = f64::from_bits(bits);
        if way > ways[at as usize] {
            continue;
        }
        for &(to, length) in &near[at as usize] {
            let longer = way + length;
            if longer < ways[to as usize] {
                ways[to as usize] = longer;
                waiting.push(Reverse((longer.to_bits(), to)));
            }
        }
    }
    ways
}
