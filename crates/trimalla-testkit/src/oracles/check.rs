//! An independent check of a finished mesh against the drawing it was made from.
//!
//! 1. Numbers: indices in range, coordinates finite, columns as long as they must be.
//! 2. Input vertices come first, bit for bit; every vertex after them is new and used.
//! 3. Triangles are counter-clockwise; every directed edge is used once; every vertex star consists
//!    of simple fans.
//! 4. Small meshes: no two triangles overlap, all pairs compared.
//! 5. Every input segment is a chain of edges, except where it runs outside the mesh; every
//!    subsegment of the mesh is an edge and belongs to an input segment or to the boundary.
//! 6. Every interior edge that is not constrained passes the circle test.
//!
//! Signs are exact. The one tolerance is that of the shared `check_mesh.py`: a vertex made by
//! rounding may be off its segment by a billionth of its length plus a few ulps of its coordinates.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Point;

use super::delaunay::{in_circle_perturbed, representatives};
use super::exact::{in_circle, orient};

/// Largest number of triangles whose pairs are all tested for overlap.
const OVERLAP_LIMIT: usize = 400;
/// Faults of one kind that are listed before the rest is only counted.
const LISTED: usize = 5;

/// Points of an uncovered stretch of a segment that are looked for inside triangles.
const GAP_SAMPLES: u32 = 16;
/// The fractional part of the golden ratio: its multiples spread evenly and rarely fall on an edge.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// What the circle test demands of interior edges that are not constrained.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DelaunayRule {
    /// Nothing: any triangulation will do.
    Ignore,
    /// No opposite vertex strictly inside the circle.
    #[default]
    Delaunay,
    /// No opposite vertex inside the circle, ties decided by the perturbation: the one canonical triangulation.
    Canonical,
}

/// Faults of a mesh, one line each; empty where all is well. Interior edges must be Delaunay, ties
/// free.
///
/// # Shape
/// With an `input` the constrained edges are those on input segments; without, those that the mesh
/// lists.
///
/// # Examples
/// ```
/// use trimalla::{geometry::Point, drawing::IndexedMesh};
/// let points = vec![Point::new(0.0, 0.0), Point::new(1.0, 0.0), Point::new(0.0, 1.0)];
/// let mesh = IndexedMesh { points, triangles: vec![[0, 2, 1]], ..IndexedMesh::default() };
/// let faults = trimalla_testkit::oracles::check_indexed(&mesh, None);
/// assert_eq!(faults, ["triangle 0 [0, 2, 1] is not counter-clockwise"]);
/// ```
#[must_use]
pub fn check_indexed(mesh: &IndexedMesh, input: Option<&Pslg>) -> Vec<String> {
    check_indexed_with(mesh, input, DelaunayRule::Delaunay)
}

/// [`check_indexed`] with a choice of the circle test.
#[must_use]
pub fn check_indexed_with(mesh: &IndexedMesh, input: Option<&Pslg>, rule: DelaunayRule) -> Vec<String> {
    let mut faults = number_faults(mesh, input);
    if !faults.is_empty() {
        return faults;
    }
    faults.extend(vertex_faults(mesh, input));
    let edges = Edges::new(&mesh.triangles);
    faults.extend(capped(
        "directed edges are used twice",
        edges.twice.iter().map(|e| format!("directed edge {e:?} is used twice")),
    ));
    faults.extend(orientation_faults(mesh));
    if !faults.is_empty() {
        return faults;
    }
    faults.extend(fan_faults(mesh));
    faults.extend(overlap_faults(mesh));
    let (constrained, segment_faults) = constrained_edges(mesh, input, &edges);
    faults.extend(segment_faults);
    faults.extend(circle_faults(mesh, &edges, &constrained, rule));
    faults
}

/// The apex left of every directed edge.
struct Edges {
    /// Apex by directed edge.
    apex: HashMap<[u32; 2], u32>,
    /// Directed edges that occur again.
    twice: Vec<[u32; 2]>,
    /// Neighbours of each vertex, in order of index.
    neighbours: BTreeMap<u32, BTreeSet<u32>>,
}

impl Edges {
    /// Collects the directed edges of all triangles.
    fn new(triangles: &[[u32; 3]]) -> Self {
        let mut edges = Self { apex: HashMap::new(), twice: Vec::new(), neighbours: BTreeMap::new() };
        for &t in triangles {
            for k in 0..3 {
                let (a, b, c) = (t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
                if edges.apex.insert([a, b], c).is_some() {
                    edges.twice.push([a, b]);
                }
                edges.neighbours.entry(a).or_default().insert(b);
                edges.neighbours.entry(b).or_default().insert(a);
            }
        }
        edges
    }

    /// Whether two vertices are joined by an edge.
    fn joins(&self, a: u32, b: u32) -> bool {
        self.apex.contains_key(&[a, b]) || self.apex.contains_key(&[b, a])
    }

    /// Whether an edge has one triangle only.
    fn is_boundary(&self, a: u32, b: u32) -> bool {
        self.apex.contains_key(&[a, b]) != self.apex.contains_key(&[b, a])
    }

    /// Vertices joined to `v`.
    fn around(&self, v: u32) -> impl Iterator<Item = u32> {
        self.neighbours.get(&v).into_iter().flatten().copied()
    }
}

/// The first few faults of a kind, and how many there are in all.
fn capped(what: &str, faults: impl Iterator<Item = String>) -> Vec<String> {
    let mut list: Vec<String> = faults.collect();
    if list.len() > LISTED {
        let all = list.len();
        list.truncate(LISTED);
        list.push(format!("… {all} {what} in all"));
    }
    list
}

/// Part 1: faults that would make the other parts fail.
fn number_faults(mesh: &IndexedMesh, input: Option<&Pslg>) -> Vec<String> {
    let n = mesh.points.len();
    let mut faults = Vec::new();
    let mut column = |name: &str, len: usize, wanted: usize| {
        if len != 0 && len != wanted {
            faults.push(format!("column {name} has {len} entries instead of {wanted}"));
        }
    };
    column("point_markers", mesh.point_markers.len(), n);
    column("point_attributes", mesh.point_attributes.len(), n * mesh.attributes_per_point);
    column("triangle_attributes", mesh.triangle_attributes.len(), mesh.triangles.len() * mesh.attributes_per_triangle);
    column("segment_markers", mesh.segment_markers.len(), mesh.segments.len());
    if mesh.input_points > n {
        faults.push(format!("{} input points of {n} points", mesh.input_points));
    }
    let wild = mesh.points.iter().enumerate().filter(|(_, p)| !p.x.is_finite() || !p.y.is_finite());
    faults.extend(capped("points are not finite", wild.map(|(i, p)| format!("point {i} is not finite: {p:?}"))));
    let far = |ids: &[u32]| ids.iter().any(|&v| v as usize >= n);
    let bad_corner =
        mesh.triangles.iter().enumerate().filter(|(_, t)| far(*t) || t[0] == t[1] || t[1] == t[2] || t[2] == t[0]);
    faults.extend(capped(
        "triangles have wrong corners",
        bad_corner.map(|(i, t)| format!("triangle {i} {t:?} repeats a corner or names one out of range")),
    ));
    let bad_end = mesh.segments.iter().enumerate().filter(|(_, s)| far(*s));
    faults.extend(capped(
        "subsegments have wrong ends",
        bad_end.map(|(i, s)| format!("subsegment {i} {s:?} is out of range")),
    ));
    let input_far = |p: &Pslg| p.segments.iter().flatten().any(|&v| v as usize >= p.points.len());
    if input.is_some_and(input_far) {
        faults.push("the input itself names a vertex out of range".to_owned());
    }
    faults
}

/// Part 2: input vertices unchanged and first, new ones distinct and used.
fn vertex_faults(mesh: &IndexedMesh, input: Option<&Pslg>) -> Vec<String> {
    let mut faults = Vec::new();
    if let Some(input) = input {
        if mesh.input_points != input.points.len() {
            faults.push(format!(
                "the mesh claims {} input points, the input has {}",
                mesh.input_points,
                input.points.len()
            ));
        }
        if mesh.points.len() < input.points.len() {
            faults.push(format!(
                "{} vertices are fewer than the {} of the input",
                mesh.points.len(),
                input.points.len()
            ));
        }
        let bits = |p: &Point| [p.x.to_bits(), p.y.to_bits()];
        let pairs = input.points.iter().zip(&mesh.points).enumerate();
        let moved = pairs.filter(|(_, (was, is))| bits(was) != bits(is));
        faults.extend(capped(
            "input vertices moved",
            moved.map(|(i, (was, is))| format!("input vertex {i} moved: {was:?} to {is:?}")),
        ));
    }
    let mut used = vec![false; mesh.points.len()];
    mesh.triangles.iter().flatten().for_each(|&v| used[v as usize] = true);
    let first = representatives(&mesh.points);
    let steiner = mesh.input_points.min(mesh.points.len())..mesh.points.len();
    let doubled = steiner.clone().filter(|&v| first[v] as usize != v);
    faults.extend(capped(
        "new vertices repeat another",
        doubled.map(|v| format!("new vertex {v} equals vertex {}", first[v])),
    ));
    let unused = steiner.filter(|&v| !used[v]);
    faults.extend(capped("new vertices are unused", unused.map(|v| format!("new vertex {v} is in no triangle"))));
    faults
}

/// Part 3, first half.
fn orientation_faults(mesh: &IndexedMesh) -> Vec<String> {
    let wrong = mesh.triangles.iter().enumerate().filter(|(_, t)| {
        let [a, b, c] = t.map(|v| mesh.points[v as usize]);
        orient(a, b, c) <= 0
    });
    capped(
        "triangles are not counter-clockwise",
        wrong.map(|(i, t)| format!("triangle {i} {t:?} is not counter-clockwise")),
    )
}

/// Part 3, second half: turning about a vertex from every start reaches all its triangles, each
/// once.
///
/// A fan starts at a triangle whose clockwise edge is boundary; several fans meet where the domain
/// touches itself.
fn fan_faults(mesh: &IndexedMesh) -> Vec<String> {
    let mut next: BTreeMap<u32, BTreeMap<u32, u32>> = BTreeMap::new();
    for t in &mesh.triangles {
        for k in 0..3 {
            next.entry(t[k]).or_default().insert(t[(k + 1) % 3], t[(k + 2) % 3]);
        }
    }
    let broken = next.iter().filter(|(_, star)| {
        let reached: BTreeSet<u32> = star.values().copied().collect();
        let open: Vec<u32> = star.keys().copied().filter(|v| !reached.contains(v)).collect();
        let starts = if open.is_empty() { star.keys().take(1).copied().collect() } else { open };
        let turned: usize = starts.iter().map(|&start| fan_length(star, start)).sum();
        turned != star.len()
    });
    capped("stars are broken", broken.map(|(v, _)| format!("the star of vertex {v} is not made of simple fans")))
}

/// Number of triangles met by turning from `start` until the fan ends or closes.
fn fan_length(star: &BTreeMap<u32, u32>, start: u32) -> usize {
    let mut at = start;
    let mut length = 0;
    while let Some(&after) = star.get(&at) {
        length += 1;
        at = after;
        if at == start || length > star.len() {
            break;
        }
    }
    length
}

/// Part 4: no two triangles share an inner point; only for meshes of at most [`OVERLAP_LIMIT`]
/// triangles.
fn overlap_faults(mesh: &IndexedMesh) -> Vec<String> {
    if mesh.triangles.len() > OVERLAP_LIMIT {
        return Vec::new();
    }
    let corners: Vec<[Point; 3]> = mesh.triangles.iter().map(|t| t.map(|v| mesh.points[v as usize])).collect();
    let pairs = (0..corners.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
    let meeting = pairs.filter(|&(i, j)| {
        !has_separating_side(&corners[i], &corners[j]) && !has_separating_side(&corners[j], &corners[i])
    });
    capped("pairs of triangles overlap", meeting.map(|(i, j)| format!("triangles {i} and {j} overlap")))
}

/// Whether some side of the counter-clockwise `t` has all of `other` on its right or on it.
fn has_separating_side(t: &[Point; 3], other: &[Point]) -> bool {
    (0..3).any(|k| other.iter().all(|&p| orient(t[k], t[(k + 1) % 3], p) <= 0))
}

/// Part 5: the constrained edges, both directions, and what is wrong with segments.
fn constrained_edges(mesh: &IndexedMesh, input: Option<&Pslg>, edges: &Edges) -> (BTreeSet<[u32; 2]>, Vec<String>) {
    let mut faults = Vec::new();
    let no_edge = mesh.segments.iter().enumerate().filter(|(_, s)| !edges.joins(s[0], s[1]));
    faults.extend(capped(
        "subsegments are no edges",
        no_edge.map(|(i, s)| format!("subsegment {i} {s:?} is not an edge of the mesh")),
    ));
    let mut constrained = BTreeSet::new();
    let Some(input) = input else {
        constrained.extend(mesh.segments.iter().flat_map(|&[a, b]| [[a, b], [b, a]]));
        return (constrained, faults);
    };
    let first = representatives(&input.points);
    let mut missing = Vec::new();
    for (i, segment) in input.segments.iter().enumerate() {
        let [a, b] = segment.map(|v| first[v as usize]);
        if a == b {
            continue;
        }
        let line = Line::new(&mesh.points, a, b);
        let pieces = line.chain(edges, a, b).unwrap_or_else(|| line.all_pieces(edges));
        if let Some(gap) = line.uncovered_inside(mesh, &pieces) {
            missing.push(format!("input segment {i} {segment:?} is not covered by edges near {gap:?}"));
        }
        constrained.extend(pieces.iter().flat_map(|&[a, b]| [[a, b], [b, a]]));
    }
    faults.extend(capped("input segments are not covered", missing.into_iter()));
    let mut orphans = Vec::new();
    for (i, &[a, b]) in mesh.segments.iter().enumerate() {
        if constrained.contains(&[a, b]) || !edges.joins(a, b) {
            continue;
        }
        // Where several vertices are on a segment within tolerance, the chain above may have taken others.
        if lies_on_a_segment(mesh, input, &first, [a, b]) {
            constrained.extend([[a, b], [b, a]]);
        } else if !edges.is_boundary(a, b) {
            orphans.push(format!("subsegment {i} [{a}, {b}] lies on no input segment"));
        }
    }
    faults.extend(capped("subsegments have no parent", orphans.into_iter()));
    (constrained, faults)
}

/// Whether both vertices are on one input segment, within tolerance.
fn lies_on_a_segment(mesh: &IndexedMesh, input: &Pslg, first: &[u32], ends: [u32; 2]) -> bool {
    input.segments.iter().any(|segment| {
        let [a, b] = segment.map(|v| first[v as usize]);
        if a == b {
            return false;
        }
        let line = Line::new(&mesh.points, a, b);
        let slack = line.tolerance / line.length_sq.sqrt();
        let on = |v: u32| line.parameter(v).is_some_and(|t| (-slack..=1.0 + slack).contains(&t));
        ends.into_iter().all(on)
    })
}

/// An input segment, in coordinates shifted and scaled so that it reaches from 0 to about 1:
/// squares stay in range.
struct Line<'a> {
    /// Coordinates of the mesh.
    points: &'a [Point],
    /// Where the segment starts.
    from: Point,
    /// The scale, a power of two.
    scale: f64,
    /// From start to end, scaled.
    along: Point,
    /// Squared scaled length.
    length_sq: f64,
    /// How far a vertex may be off the line, scaled.
    tolerance: f64,
}

impl<'a> Line<'a> {
    /// The line of a segment between two distinct points.
    fn new(points: &'a [Point], a: u32, b: u32) -> Self {
        let [from, to] = [a, b].map(|v| points[v as usize]);
        let half = Point::new(to.x / 2.0 - from.x / 2.0, to.y / 2.0 - from.y / 2.0);
        let scale = power_of_two_below(half.x.abs().max(half.y.abs()));
        let along = scaled_difference(to, from, scale);
        let length_sq = along.x * along.x + along.y * along.y;
        let largest = [from.x, from.y, to.x, to.y].into_iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        let tolerance = 1e-9 * length_sq.sqrt() + 8.0 * f64::EPSILON * (largest / scale);
        Self { points, from, scale, along, length_sq, tolerance }
    }

    /// How far along the segment a vertex is, from 0 to 1; nothing if it is off the line.
    fn parameter(&self, vertex: u32) -> Option<f64> {
        let w = scaled_difference(self.points[vertex as usize], self.from, self.scale);
        let off = (w.x * self.along.y - w.y * self.along.x).abs() / self.length_sq.sqrt();
        let t = (w.x * self.along.x + w.y * self.along.y) / self.length_sq;
        (off <= self.tolerance).then_some(t)
    }

    /// Edges from `a` to `b` along the segment: straight to `b` where an edge leads there, else to
    /// the nearest vertex ahead; nothing where the chain breaks.
    fn chain(&self, edges: &Edges, a: u32, b: u32) -> Option<Vec<[u32; 2]>> {
        let (mut at, mut done) = (a, 0.0);
        let mut pieces = Vec::new();
        while at != b {
            if edges.joins(at, b) {
                pieces.push([at, b]);
                break;
            }
            let ahead = |v: u32| self.parameter(v).filter(|&t| t > done && t < 1.0);
            let steps = edges.around(at).filter_map(|v| ahead(v).map(|t| (t, v)));
            let (t, next) = steps.min_by(|x, y| x.0.total_cmp(&y.0))?;
            pieces.push([at, next]);
            (at, done) = (next, t);
        }
        Some(pieces)
    }

    /// All edges of the mesh that lie along the segment, each from start to end.
    fn all_pieces(&self, edges: &Edges) -> Vec<[u32; 2]> {
        let slack = self.tolerance / self.length_sq.sqrt();
        let on = |v: u32| self.parameter(v).filter(|t| (-slack..=1.0 + slack).contains(t));
        let starts = edges.neighbours.keys().filter_map(|&v| on(v).map(|t| (v, t)));
        starts
            .flat_map(|(v, t)| edges.around(v).filter(move |&w| on(w).is_some_and(|u| u > t)).map(move |w| [v, w]))
            .collect()
    }

    /// A point of the segment that no piece covers although it lies inside a triangle.
    fn uncovered_inside(&self, mesh: &IndexedMesh, pieces: &[[u32; 2]]) -> Option<Point> {
        let slack = self.tolerance / self.length_sq.sqrt();
        let mut spans: Vec<[f64; 2]> = pieces.iter().map(|p| p.map(|v| self.parameter(v).unwrap_or(0.0))).collect();
        spans.push([1.0, 1.0]);
        spans.sort_by(|s, t| s[0].total_cmp(&t[0]));
        let mut reached = 0.0;
        for [start, end] in spans {
            if start > reached + slack {
                let samples = (1..=GAP_SAMPLES).map(|k| (f64::from(k) * GOLDEN).fract());
                let inside = samples.map(|u| self.at(reached + u * (start - reached))).find(|&p| lies_inside(mesh, p));
                if inside.is_some() {
                    return inside;
                }
            }
            reached = end.max(reached);
        }
        None
    }

    /// The rounded point at a parameter.
    fn at(&self, t: f64) -> Point {
        Point::new(self.from.x + t * self.along.x * self.scale, self.from.y + t * self.along.y * self.scale)
    }
}

/// `(p − q) / scale` without overflow, for a scale that is a power of two.
fn scaled_difference(p: Point, q: Point, scale: f64) -> Point {
    if scale < 1.0 {
        return Point::new((p.x - q.x) / scale, (p.y - q.y) / scale);
    }
    Point::new((p.x / 2.0 - q.x / 2.0) / (scale / 2.0), (p.y / 2.0 - q.y / 2.0) / (scale / 2.0))
}

/// The largest power of two that is not above a positive value, or the smallest double.
fn power_of_two_below(value: f64) -> f64 {
    let kept = f64::from_bits(value.to_bits() & (0x7ff << 52));
    if kept > 0.0 { kept } else { f64::MIN_POSITIVE }
}

/// Whether a point is strictly inside a triangle of the mesh.
fn lies_inside(mesh: &IndexedMesh, p: Point) -> bool {
    mesh.triangles.iter().any(|t| {
        let [a, b, c] = t.map(|v| mesh.points[v as usize]);
        orient(a, b, p) > 0 && orient(b, c, p) > 0 && orient(c, a, p) > 0
    })
}

/// Part 6: the circle test on both sides of every interior edge that is not constrained.
fn circle_faults(
    mesh: &IndexedMesh,
    edges: &Edges,
    constrained: &BTreeSet<[u32; 2]>,
    rule: DelaunayRule,
) -> Vec<String> {
    if rule == DelaunayRule::Ignore {
        return Vec::new();
    }
    let mut failing = Vec::new();
    for t in &mesh.triangles {
        for k in 0..3 {
            let (a, b, c) = (t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
            let Some(&d) = edges.apex.get(&[b, a]) else {
                continue;
            };
            if a > b || constrained.contains(&[a, b]) {
                continue;
            }
            let [pa, pb, pc, pd] = [a, b, c, d].map(|v| mesh.points[v as usize]);
            let inside = match rule {
                DelaunayRule::Canonical => in_circle_perturbed(pa, pb, pc, pd),
                _ => in_circle(pa, pb, pc, pd) > 0,
            };
            if inside {
                failing.push(format!("edge [{a}, {b}] fails the circle test: vertex {d} is inside [{a}, {b}, {c}]"));
            }
        }
    }
    capped("edges fail the circle test", failing.into_iter())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generators::{PointSetKind, PslgKind, point_set, pslg};
    use crate::oracles::{brute_force_cdt, brute_force_delaunay};

    fn mesh(points: &[(f64, f64)], triangles: &[[u32; 3]]) -> IndexedMesh {
        let points: Vec<Point> = points.iter().map(|&(x, y)| Point::new(x, y)).collect();
        IndexedMesh { input_points: points.len(), points, triangles: triangles.to_vec(), ..IndexedMesh::default() }
    }

    const SQUARE: [(f64, f64); 4] = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];

    #[test]
    fn ties_matter_only_to_the_canonical_rule() {
        let other = mesh(&SQUARE, &[[0, 1, 2], [0, 2, 3]]);
        assert!(check_indexed(&other, None).is_empty());
        assert_eq!(check_indexed_with(&other, None, DelaunayRule::Canonical).len(), 1);
        let ours = mesh(&SQUARE, &[[0, 1, 3], [1, 2, 3]]);
        assert!(check_indexed_with(&ours, None, DelaunayRule::Canonical).is_empty());
    }

    #[test]
    fn each_fault_is_seen() {
        let says = |m: &IndexedMesh, words: &str| {
            let faults = check_indexed(m, None);
            assert!(faults.iter().any(|f| f.contains(words)), "{words}: {faults:?}");
        };
        says(&mesh(&SQUARE, &[[0, 1, 9]]), "out of range");
        says(&mesh(&SQUARE, &[[0, 1, 1]]), "repeats a corner");
        says(&mesh(&SQUARE, &[[0, 1, 2], [0, 1, 3]]), "used twice");
        says(&mesh(&SQUARE, &[[0, 2, 1]]), "not counter-clockwise");
        says(&mesh(&[(0.0, 0.0), (f64::NAN, 0.0), (0.0, 1.0)], &[[0, 1, 2]]), "not finite");
        says(&mesh(&[(0.0, 0.0), (4.0, 0.0), (2.0, 1.0), (2.0, -1.0)], &[[0, 1, 2], [0, 3, 1]]), "");
    }

    #[test]
    fn a_bad_edge_fails_the_circle_test() {
        let flat = mesh(&[(0.0, 0.0), (4.0, 0.0), (2.0, 1.0), (2.0, -1.0)], &[[0, 1, 2], [0, 3, 1]]);
        let faults = check_indexed(&flat, None);
        assert_eq!(faults, ["edge [0, 1] fails the circle test: vertex 3 is inside [0, 1, 2]"]);
        assert!(check_indexed(&IndexedMesh { segments: vec![[1, 0]], ..flat }, None).is_empty());
    }

    #[test]
    fn overlap_is_seen_without_shared_edges() {
        let two =
            mesh(&[(0.0, 0.0), (4.0, 0.0), (0.0, 4.0), (1.0, 1.0), (5.0, 1.0), (1.0, 5.0)], &[[0, 1, 2], [3, 4, 5]]);
        assert_eq!(check_indexed(&two, None), ["triangles 0 and 1 overlap"]);
    }

    #[test]
    fn segments_are_chains_of_edges() {
        let input = Pslg {
            points: SQUARE.iter().map(|&(x, y)| Point::new(x, y)).collect(),
            segments: vec![[0, 2]],
            ..Pslg::default()
        };
        let good = mesh(&SQUARE, &[[0, 1, 2], [0, 2, 3]]);
        assert!(check_indexed(&good, Some(&input)).is_empty());
        let wrong = mesh(&SQUARE, &[[0, 1, 3], [1, 2, 3]]);
        let faults = check_indexed(&wrong, Some(&input));
        assert!(faults.iter().any(|f| f.contains("not covered")), "{faults:?}");
        let mut split = mesh(
            &[SQUARE[0], SQUARE[1], SQUARE[2], SQUARE[3], (0.5, 0.5)],
            &[[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
        );
        split.input_points = 4;
        assert!(check_indexed(&split, Some(&input)).is_empty());
        split.points[0].x = -0.0;
        assert!(check_indexed(&split, Some(&input))[0].contains("moved"));
        split.points[0].x = 0.0;
        split.segments = vec![[1, 4]];
        assert!(check_indexed(&split, Some(&input))[0].contains("lies on no input segment"));
    }

    #[test]
    fn a_segment_outside_the_mesh_may_be_absent() {
        // A notched shape: the segment 1-3 closes the notch and is outside.
        let shape = [(0.0, 0.0), (4.0, 4.0), (2.0, 0.0), (4.0, -4.0)];
        let m = mesh(&shape, &[[0, 2, 1], [0, 3, 2]]);
        let input = Pslg { points: m.points.clone(), segments: vec![[1, 3]], ..Pslg::default() };
        assert!(check_indexed(&m, Some(&input)).is_empty());
    }

    #[test]
    fn brute_force_meshes_pass() {
        for kind in PointSetKind::ALL {
            let points = point_set(kind, 16, 3);
            let triangles = brute_force_delaunay(&points);
            let m = IndexedMesh { input_points: points.len(), points, triangles, ..IndexedMesh::default() };
            let faults = check_indexed_with(&m, None, DelaunayRule::Canonical);
            assert!(faults.is_empty(), "{kind:?}: {faults:?}");
        }
        for kind in PslgKind::ALL.into_iter().filter(|k| k.is_clean()) {
            let input = pslg(kind, 16, 3);
            if input.points.len() > 48 {
                continue;
            }
            let triangles = brute_force_cdt(&input.points, &input.segments);
            let points = input.points.clone();
            let m = IndexedMesh { input_points: points.len(), points, triangles, ..IndexedMesh::default() };
            let faults = check_indexed_with(&m, Some(&input), DelaunayRule::Canonical);
            assert!(faults.is_empty(), "{kind:?}: {faults:?}");
        }
    }
}
