//! Whether plain arrays are a sound mesh of a drawing: a second opinion, exact and fast enough for every mesh that a
//! fuzzer makes.
//!
//! 1. Indices are in range, coordinates finite, input vertices first, bit for bit.
//! 2. Every triangle is counter-clockwise, every directed edge used once.
//! 3. No two triangles share an inner point, and no vertex of a triangle lies inside an edge of the boundary. (That
//!    areas add up to what the boundary encloses would prove nothing: where directed edges are used once, it follows.)
//! 4. Every subsegment is an edge of a triangle, every edge of the boundary a subsegment.
//! 5. Every other edge passes the circle test, if the caller asks for it.
//! 6. Every input segment is a chain of edges, except where it runs outside the mesh.
//!
//! Signs are exact. Part 6 has the only tolerance: a vertex made by rounding may lie beside its segment by
//! [`BESIDE_ULPS`] units in the last place of the segment's largest coordinate.

use std::cmp::Ordering;
use std::fmt;

use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Point;

use super::exact::{in_circle, is_within, lexicographic, on_open_segment, order_along, orient};

/// How far a vertex of a chain may lie beside its segment.
pub const BESIDE_ULPS: f64 = 64.0;

/// A flaw of a mesh. Numbers are indices of vertices, triangles and segments.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Flaw {
    /// A triangle or subsegment names a vertex that is not there, or one vertex twice.
    Index(usize),
    /// A vertex is not finite.
    NotFinite(usize),
    /// An input vertex is missing or has other bits.
    InputVertex(usize),
    /// A triangle is clockwise or flat.
    NotCounterClockwise(usize),
    /// Two triangles lie on the same side of an edge.
    EdgeTwice([u32; 2]),
    /// Two triangles share an inner point.
    Overlap([usize; 2]),
    /// A vertex of a triangle lies inside an edge of the boundary.
    VertexOnBoundary(u32, [u32; 2]),
    /// A subsegment is no edge of a triangle.
    NoEdge([u32; 2]),
    /// An edge of the boundary is no subsegment.
    OpenBoundary([u32; 2]),
    /// A vertex lies inside the circle beyond an edge that is no subsegment.
    Circle([u32; 2], u32),
    /// An input segment runs through a triangle.
    SegmentNotCovered(usize),
}

impl Flaw {
    /// The kind in a few words, equal for all flaws of the kind.
    #[must_use]
    pub const fn key(&self) -> &'static str {
        match self {
            Self::Index(_) => "index",
            Self::NotFinite(_) => "not finite",
            Self::InputVertex(_) => "input vertex changed",
            Self::NotCounterClockwise(_) => "not counter-clockwise",
            Self::EdgeTwice(_) => "edge used twice",
            Self::Overlap(_) => "triangles overlap",
            Self::VertexOnBoundary(..) => "vertex on boundary edge",
            Self::NoEdge(_) => "subsegment is no edge",
            Self::OpenBoundary(_) => "boundary edge is no subsegment",
            Self::Circle(..) => "circle test",
            Self::SegmentNotCovered(_) => "segment not covered",
        }
    }
}

impl fmt::Display for Flaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Index(i) => write!(f, "triangle or subsegment {i} has a wrong index"),
            Self::NotFinite(v) => write!(f, "vertex {v} is not finite"),
            Self::InputVertex(v) => write!(f, "input vertex {v} is missing or has other bits"),
            Self::NotCounterClockwise(t) => write!(f, "triangle {t} is not counter-clockwise"),
            Self::EdgeTwice(e) => write!(f, "two triangles lie on one side of edge {e:?}"),
            Self::Overlap([s, t]) => write!(f, "triangles {s} and {t} overlap"),
            Self::VertexOnBoundary(v, e) => write!(f, "vertex {v} lies inside the boundary edge {e:?}"),
            Self::NoEdge(e) => write!(f, "subsegment {e:?} is no edge"),
            Self::OpenBoundary(e) => write!(f, "boundary edge {e:?} is no subsegment"),
            Self::Circle(e, v) => write!(f, "vertex {v} lies inside the circle beyond edge {e:?}"),
            Self::SegmentNotCovered(s) => write!(f, "input segment {s} runs through a triangle"),
        }
    }
}

/// The first flaw of a mesh, in the order of the parts above.
///
/// # Shape
/// `input` is the drawing that the mesh was made from; without it parts about input vertices and segments are left out.
/// `is_delaunay` says whether part 5 is asked for.
///
/// # Complexity
/// Linear, except part 3, which compares neighbours along the x axis: quadratic in the worst case.
///
/// # Examples
/// ```
/// use trimalla::{geometry::Point, drawing::IndexedMesh};
/// use trimalla_testkit::oracles::{Flaw, first_flaw};
/// let points = vec![Point::new(0.0, 0.0), Point::new(1.0, 0.0), Point::new(0.0, 1.0)];
/// let mesh = IndexedMesh { points, triangles: vec![[0, 2, 1]], ..IndexedMesh::default() };
/// assert_eq!(first_flaw(&mesh, None, true), Some(Flaw::NotCounterClockwise(0)));
/// ```
#[must_use]
pub fn first_flaw(mesh: &IndexedMesh, input: Option<&Pslg>, is_delaunay: bool) -> Option<Flaw> {
    if let Some(flaw) = numbers(mesh, input) {
        return Some(flaw);
    }
    let sides = Sides::of(&mesh.triangles);
    clockwise(mesh)
        .or_else(|| sides.first_twice())
        .or_else(|| first_overlap(mesh))
        .or_else(|| on_boundary(mesh, &sides))
        .or_else(|| subsegments(mesh, &sides))
        .or_else(|| is_delaunay.then(|| circles(mesh, &sides)).flatten())
        .or_else(|| input.and_then(|pslg| uncovered(mesh, pslg, &sides)))
}

/// Part 1.
fn numbers(mesh: &IndexedMesh, input: Option<&Pslg>) -> Option<Flaw> {
    let n = mesh.points.len();
    let is_wrong = |ids: &[u32]| ids.iter().enumerate().any(|(i, &v)| v as usize >= n || ids[..i].contains(&v));
    let bits = |p: &Point| [p.x.to_bits(), p.y.to_bits()];
    let wild = mesh.points.iter().position(|p| !(p.x.is_finite() && p.y.is_finite()));
    let triangle = mesh.triangles.iter().position(|t| is_wrong(t));
    let subsegment = mesh.segments.iter().position(|s| is_wrong(s));
    let of_input = input.map_or(&[][..], |pslg| &pslg.points);
    let moved = (0..of_input.len()).find(|&i| mesh.points.get(i).map(bits) != Some(bits(&of_input[i])));
    wild.map(Flaw::NotFinite)
        .or_else(|| triangle.or(subsegment).map(Flaw::Index))
        .or_else(|| moved.map(Flaw::InputVertex))
}

/// One side of an edge: the triangle left of the way from `ends[0]` to `ends[1]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Side {
    ends: [u32; 2],
    apex: u32,
}

/// Every side of every edge, sorted by its ends.
struct Sides(Vec<Side>);

impl Sides {
    fn of(triangles: &[[u32; 3]]) -> Self {
        let of_triangle = |t: &[u32; 3]| {
            let [a, b, c] = *t;
            [(a, b, c), (b, c, a), (c, a, b)].map(|(from, to, apex)| Side { ends: [from, to], apex })
        };
        let mut sides: Vec<Side> = triangles.iter().flat_map(of_triangle).collect();
        sides.sort_unstable();
        Self(sides)
    }

    fn first_twice(&self) -> Option<Flaw> {
        self.0.windows(2).find(|w| w[0].ends == w[1].ends).map(|w| Flaw::EdgeTwice(w[0].ends))
    }

    /// The vertex that makes a triangle left of the way from `a` to `b`.
    fn apex(&self, a: u32, b: u32) -> Option<u32> {
        self.0.binary_search_by(|s| s.ends.cmp(&[a, b])).ok().map(|i| self.0[i].apex)
    }

    fn joins(&self, a: u32, b: u32) -> bool {
        self.apex(a, b).or_else(|| self.apex(b, a)).is_some()
    }

    /// Edges with a triangle on their left side alone.
    fn boundary(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.0.iter().map(|s| s.ends).filter(|&[a, b]| self.apex(b, a).is_none())
    }

    /// Vertices joined to `v`, some of them twice.
    fn neighbours(&self, v: u32) -> impl Iterator<Item = u32> + '_ {
        let first = self.0.partition_point(|s| s.ends[0] < v);
        self.0[first..].iter().take_while(move |s| s.ends[0] == v).flat_map(|s| [s.ends[1], s.apex])
    }

    fn is_used(&self, v: u32) -> bool {
        self.neighbours(v).next().is_some()
    }
}

/// Part 2, first half.
fn clockwise(mesh: &IndexedMesh) -> Option<Flaw> {
    let is_wrong = |t: &[u32; 3]| {
        let [a, b, c] = corners(mesh, *t);
        orient(a, b, c) <= 0
    };
    mesh.triangles.iter().position(is_wrong).map(Flaw::NotCounterClockwise)
}

fn corners(mesh: &IndexedMesh, t: [u32; 3]) -> [Point; 3] {
    t.map(|v| mesh.points[v as usize])
}

/// The smallest box around points: least and greatest abscissa, least and greatest ordinate.
#[derive(Clone, Copy)]
struct Extent {
    x: [f64; 2],
    y: [f64; 2],
}

impl Extent {
    fn of(points: &[Point]) -> Self {
        let range = |of: fn(&Point) -> f64| {
            let least = points.iter().map(of).fold(f64::INFINITY, f64::min);
            [least, points.iter().map(of).fold(f64::NEG_INFINITY, f64::max)]
        };
        Self { x: range(|p| p.x), y: range(|p| p.y) }
    }

    fn meets(&self, other: &Self) -> bool {
        let meet = |a: [f64; 2], b: [f64; 2]| a[0] <= b[1] && b[0] <= a[1];
        meet(self.x, other.x) && meet(self.y, other.y)
    }
}

/// Part 3, first half: neighbours along the x axis are compared.
fn first_overlap(mesh: &IndexedMesh) -> Option<Flaw> {
    let mut order: Vec<(usize, [Point; 3], Extent)> = mesh
        .triangles
        .iter()
        .map(|&t| corners(mesh, t))
        .enumerate()
        .map(|(i, points)| (i, points, Extent::of(&points)))
        .collect();
    order.sort_by(|a, b| a.2.x[0].total_cmp(&b.2.x[0]));
    for (k, (i, p, extent)) in order.iter().enumerate() {
        let near = order[k + 1..].iter().take_while(|(.., other)| other.x[0] <= extent.x[1]);
        for (j, q, other) in near {
            if extent.meets(other) && !is_apart(*p, *q) && !is_apart(*q, *p) {
                return Some(Flaw::Overlap([*i.min(j), *i.max(j)]));
            }
        }
    }
    None
}

/// Whether a side of the counter-clockwise `p` has all of `q` on its right or on it.
fn is_apart(p: [Point; 3], q: [Point; 3]) -> bool {
    (0..3).any(|k| q.iter().all(|&c| orient(p[k], p[(k + 1) % 3], c) <= 0))
}

/// Part 3, second half.
fn on_boundary(mesh: &IndexedMesh, sides: &Sides) -> Option<Flaw> {
    let place = |v: u32| mesh.points[v as usize];
    let mut used: Vec<u32> = sides.0.iter().map(|s| s.ends[0]).collect();
    used.dedup();
    used.sort_by(|&a, &b| place(a).x.total_cmp(&place(b).x));
    for [a, b] in sides.boundary() {
        let (p, q) = (place(a), place(b));
        let [least, greatest] = [p.x.min(q.x), p.x.max(q.x)];
        let from = used.partition_point(|&v| place(v).x < least);
        let near = used[from..].iter().take_while(|&&v| place(v).x <= greatest);
        if let Some(&v) = near.filter(|&&v| v != a && v != b).find(|&&v| on_open_segment(place(v), p, q)) {
            return Some(Flaw::VertexOnBoundary(v, [a, b]));
        }
    }
    None
}

/// Part 4.
fn subsegments(mesh: &IndexedMesh, sides: &Sides) -> Option<Flaw> {
    let no_edge = mesh.segments.iter().find(|&&[a, b]| !sides.joins(a, b));
    let marked = marked_edges(mesh);
    let open = || sides.boundary().find(|&e| !is_marked(&marked, e));
    no_edge.map(|&e| Flaw::NoEdge(e)).or_else(|| open().map(Flaw::OpenBoundary))
}

/// The subsegments, lower end first, sorted.
fn marked_edges(mesh: &IndexedMesh) -> Vec<[u32; 2]> {
    let mut marked: Vec<[u32; 2]> = mesh.segments.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
    marked.sort_unstable();
    marked
}

fn is_marked(marked: &[[u32; 2]], [a, b]: [u32; 2]) -> bool {
    marked.binary_search(&[a.min(b), a.max(b)]).is_ok()
}

/// Part 5.
fn circles(mesh: &IndexedMesh, sides: &Sides) -> Option<Flaw> {
    let marked = marked_edges(mesh);
    let inner = sides.0.iter().filter(|s| s.ends[0] < s.ends[1] && !is_marked(&marked, s.ends));
    inner.filter_map(|s| sides.apex(s.ends[1], s.ends[0]).map(|beyond| (s, beyond))).find_map(|(s, beyond)| {
        let [a, b, c] = corners(mesh, [s.ends[0], s.ends[1], s.apex]);
        let is_inside = in_circle(a, b, c, mesh.points[beyond as usize]) > 0;
        is_inside.then_some(Flaw::Circle(s.ends, beyond))
    })
}

/// Part 6.
fn uncovered(mesh: &IndexedMesh, input: &Pslg, sides: &Sides) -> Option<Flaw> {
    let stands_for = used_twins(input, sides);
    let is_uncovered = |&[a, b]: &[u32; 2]| {
        let ends = [a, b].map(|v| stands_for.get(v as usize).copied().flatten());
        let [Some(a), Some(b)] = ends else { return false };
        a != b && Line::new(mesh, a, b).runs_through_a_triangle(sides)
    };
    input.segments.iter().position(is_uncovered).map(Flaw::SegmentNotCovered)
}

/// For each input vertex a used vertex at its place, if there is one.
fn used_twins(input: &Pslg, sides: &Sides) -> Vec<Option<u32>> {
    let mut order: Vec<u32> = (0..).take(input.points.len()).collect();
    let place = |v: u32| input.points[v as usize];
    order.sort_by(|&a, &b| lexicographic(place(a), place(b)));
    let mut twins = vec![None; order.len()];
    for same in order.chunk_by(|&a, &b| place(a) == place(b)) {
        let used = same.iter().copied().filter(|&v| sides.is_used(v)).min();
        same.iter().for_each(|&v| twins[v as usize] = used);
    }
    twins
}

/// The smallest positive number: rounding moves a coordinate by at least this.
const SMALLEST: f64 = 5e-324;

/// An input segment between two used vertices.
struct Line<'a> {
    mesh: &'a IndexedMesh,
    ends: [u32; 2],
    places: [Point; 2],
    /// How far beside the segment counts as on it.
    reach: f64,
}

impl<'a> Line<'a> {
    fn new(mesh: &'a IndexedMesh, from: u32, to: u32) -> Self {
        let places @ [a, b] = [from, to].map(|v| mesh.points[v as usize]);
        let largest = [a.x, a.y, b.x, b.y].into_iter().fold(0.0_f64, |m, c| m.max(c.abs()));
        let reach = BESIDE_ULPS * (f64::EPSILON * largest + SMALLEST);
        Self { mesh, ends: [from, to], places, reach }
    }

    fn place(&self, v: u32) -> Point {
        self.mesh.points[v as usize]
    }

    /// The side of the line on which a vertex lies, 1 on the left; 0 for what counts as on it.
    fn side(&self, v: u32) -> i32 {
        let p = self.place(v);
        if is_within(self.places, p, self.reach) { 0 } else { orient(self.places[0], self.places[1], p) }
    }

    /// Which of two vertices comes first along the segment.
    fn order(&self, v: u32, w: u32) -> Ordering {
        order_along(self.places, self.place(v), self.place(w))
    }

    /// Whether a vertex is on the segment.
    fn holds(&self, v: u32) -> bool {
        let [a, b] = self.ends;
        let is_between = || self.order(a, v).is_le() && self.order(v, b).is_le();
        self.ends.contains(&v) || is_between() && self.side(v) == 0
    }

    /// Whether no chain of edges leads from end to end, and what is missing lies in a triangle.
    fn runs_through_a_triangle(&self, sides: &Sides) -> bool {
        let (stop, reached) = self.chain(sides, self.ends[0]);
        if reached {
            return false;
        }
        let (start, _) = self.chain(sides, self.ends[1]);
        self.mesh.triangles.iter().any(|&t| self.pierces(stop, start, t))
    }

    /// Follows edges from an end towards the other; where that stops, and whether it is the other end.
    fn chain(&self, sides: &Sides, from: u32) -> (u32, bool) {
        let (target, back) = if from == self.ends[0] { (self.ends[1], false) } else { (self.ends[0], true) };
        let is_ahead = |v: u32, of: u32| if back { self.order(v, of).is_le() } else { self.order(of, v).is_le() };
        let (mut open, mut met) = (vec![from], vec![from]);
        let mut farthest = from;
        while let Some(at) = open.pop() {
            if is_ahead(at, farthest) {
                farthest = at;
            }
            if at == target {
                return (at, true);
            }
            let next = |v: &u32| !met.contains(v) && self.holds(*v) && is_ahead(*v, at);
            let mut next: Vec<u32> = sides.neighbours(at).filter(next).collect();
            next.sort_unstable();
            next.dedup();
            met.extend(&next);
            open.append(&mut next);
        }
        (farthest, false)
    }

    /// Whether the way between two vertices on the segment has inner points of a triangle on it, farther than the
    /// tolerance from its sides.
    fn pierces(&self, from: u32, to: u32, t: [u32; 3]) -> bool {
        let [p, q] = [from, to].map(|v| self.mesh.points[v as usize]);
        let of_triangle = corners(self.mesh, t);
        let is_outside = |k: usize| {
            let (a, b) = (of_triangle[k], of_triangle[(k + 1) % 3]);
            orient(a, b, p) <= 0 && orient(a, b, q) <= 0
        };
        // Exactly, too: the vertices between which the way leads may be off the segment.
        let turns = of_triangle.map(|corner| orient(p, q, corner));
        let is_parted = turns.iter().all(|&turn| turn >= 0) || turns.iter().all(|&turn| turn <= 0);
        let beside = t.map(|v| self.side(v));
        let on_both_sides = beside.contains(&1) && beside.contains(&-1);
        p != q && on_both_sides && !is_parted && !(0..3).any(is_outside)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mesh(points: &[(f64, f64)], triangles: &[[u32; 3]], segments: &[[u32; 2]]) -> IndexedMesh {
        let points: Vec<Point> = points.iter().map(|&(x, y)| Point::new(x, y)).collect();
        let (triangles, segments) = (triangles.to_vec(), segments.to_vec());
        IndexedMesh { input_points: points.len(), points, triangles, segments, ..IndexedMesh::default() }
    }

    const SQUARE: [(f64, f64); 4] = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
    const RING: [[u32; 2]; 4] = [[0, 1], [1, 2], [2, 3], [3, 0]];
    const HALVES: [[u32; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

    #[test]
    fn a_sound_mesh_has_no_flaw() {
        let square = mesh(&SQUARE, &HALVES, &RING);
        let input = Pslg { points: square.points.clone(), segments: RING.to_vec(), ..Pslg::default() };
        assert_eq!(first_flaw(&square, Some(&input), true), None);
        let far = IndexedMesh {
            points: square.points.iter().map(|p| Point::new(p.x * 1e307, p.y * 1e307)).collect(),
            ..square
        };
        assert_eq!(first_flaw(&far, Some(&Pslg { points: far.points.clone(), ..input }), true), None);
    }

    #[test]
    fn each_flaw_is_seen() {
        let see = |m: &IndexedMesh| first_flaw(m, None, true);
        let square = mesh(&SQUARE, &HALVES, &RING);
        let with_triangles = |t: &[[u32; 3]]| IndexedMesh { triangles: t.to_vec(), ..square.clone() };
        assert_eq!(see(&with_triangles(&[[0, 1, 4]])), Some(Flaw::Index(0)));
        assert_eq!(see(&with_triangles(&[[0, 1, 0]])), Some(Flaw::Index(0)));
        assert_eq!(see(&with_triangles(&[[0, 1, 2], [3, 2, 0]])), Some(Flaw::NotCounterClockwise(1)));
        assert_eq!(see(&with_triangles(&[[0, 1, 2], [0, 1, 3]])), Some(Flaw::EdgeTwice([0, 1])));
        assert_eq!(see(&with_triangles(&[[0, 1, 2]])), Some(Flaw::NoEdge([2, 3])));
        let open = IndexedMesh { segments: RING[..3].to_vec(), ..square.clone() };
        assert_eq!(see(&open), Some(Flaw::OpenBoundary([3, 0])));
        let mut wild = square.clone();
        wild.points[2].x = f64::NAN;
        assert_eq!(see(&wild), Some(Flaw::NotFinite(2)));
    }

    #[test]
    fn circle_touch_and_fold_are_seen() {
        let kite = mesh(
            &[(0.0, 0.0), (4.0, 0.0), (2.0, 1.0), (2.0, -1.0)],
            &[[0, 1, 2], [0, 3, 1]],
            &[[1, 2], [2, 0], [0, 3], [3, 1]],
        );
        assert_eq!(first_flaw(&kite, None, true), Some(Flaw::Circle([0, 1], 3)));
        assert_eq!(first_flaw(&kite, None, false), None);
        // The tip of the second triangle lies inside a side of the first; areas add up.
        let touch = mesh(
            &[(0.0, 0.0), (4.0, 0.0), (0.0, 4.0), (2.0, 0.0), (1.0, -1.0), (3.0, -1.0)],
            &[[0, 1, 2], [3, 4, 5]],
            &[[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3]],
        );
        assert_eq!(first_flaw(&touch, None, true), Some(Flaw::VertexOnBoundary(3, [0, 1])));
        // A fan that goes round its hub twice: every side used once, every triangle counter-clockwise.
        let at = |k: i32| {
            (f64::from([2, 1, -1, -2, -1, 1][k as usize % 6]), f64::from([0, 2, 2, 0, -2, -2][k as usize % 6]))
        };
        let turns: Vec<(f64, f64)> = [(0.0, 0.0)].into_iter().chain((0..12).map(at)).collect();
        let fan: Vec<[u32; 3]> = (0..12).map(|k| [0, k + 1, (k + 1) % 12 + 1]).collect();
        let rim: Vec<[u32; 2]> = (0..12).map(|k| [k + 1, (k + 1) % 12 + 1]).collect();
        assert!(matches!(first_flaw(&mesh(&turns, &fan, &rim), None, false), Some(Flaw::Overlap(_))));
    }

    #[test]
    fn segments_are_chains_or_outside() {
        let square = mesh(&SQUARE, &HALVES, &RING);
        let with = |segments: &[[u32; 2]], points: &[Point]| Pslg {
            points: points.to_vec(),
            segments: segments.to_vec(),
            ..Pslg::default()
        };
        assert_eq!(first_flaw(&square, Some(&with(&[[2, 0]], &square.points)), true), None);
        assert_eq!(first_flaw(&square, Some(&with(&[[1, 3]], &square.points)), true), Some(Flaw::SegmentNotCovered(0)));
        let mut moved = square.points.clone();
        moved[1].x = 5.0;
        assert_eq!(first_flaw(&square, Some(&with(&[], &moved)), true), Some(Flaw::InputVertex(1)));
        // A notch: the segment that closes it is outside.
        let notch = mesh(
            &[(0.0, 0.0), (4.0, 4.0), (2.0, 0.0), (4.0, -4.0)],
            &[[0, 2, 1], [0, 3, 2]],
            &[[0, 3], [3, 2], [2, 1], [1, 0]],
        );
        assert_eq!(first_flaw(&notch, Some(&with(&[[1, 3]], &notch.points)), true), None);
        // A vertex a billionth beside a segment is not on it.
        let bent = mesh(
            &[(0.0, 0.0), (4.0, 0.0), (2.0, 4.0), (2.0, 4e-9), (2.0, -4.0)],
            &[[0, 3, 2], [3, 1, 2], [0, 4, 3], [4, 1, 3]],
            &[[0, 4], [4, 1], [1, 2], [2, 0]],
        );
        assert_eq!(first_flaw(&bent, Some(&with(&[[0, 1]], &bent.points)), true), Some(Flaw::SegmentNotCovered(0)));
    }

    #[test]
    fn segments_of_every_length_are_judged() {
        for length in [5e-324, 1e-300, 1e-216, 1e-170, 1.0] {
            // The segment 0–1 is at y = 1, and vertex 2 on it.
            let points =
                [(0.0, 1.0), (4.0 * length, 1.0), (2.0 * length, 1.0), (2.0 * length, 0.0), (2.0 * length, 2.0)];
            let rim = [[0, 3], [3, 1], [1, 4], [4, 0]];
            let covered = mesh(&points, &[[0, 3, 2], [3, 1, 2], [0, 2, 4], [2, 1, 4]], &rim);
            let pierced = mesh(&points, &[[0, 3, 4], [3, 1, 4]], &rim);
            let input = Pslg { points: covered.points.clone(), segments: vec![[0, 1]], ..Pslg::default() };
            assert_eq!(first_flaw(&covered, Some(&input), false), None, "{length:e}");
            assert_eq!(first_flaw(&pierced, Some(&input), false), Some(Flaw::SegmentNotCovered(0)), "{length:e}");
        }
    }
}
