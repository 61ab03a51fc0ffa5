//! Is this the mesh of that drawing?
//!
//! 1. Input vertices come first, bit for bit. Unused ones may be duplicates or lie outside the domain.
//! 2. Every input segment is a chain of mesh edges from end to end. A vertex that was put on a segment is
//!    rounded, so it may be off by a billionth of the segment's length and a few ulps of its coordinates.
//! 3. A segment may be absent where it is outside the mesh: if an end of it is unused, or if it leaves the mesh
//!    at both places where its chains from either end stop. Whether it leaves is decided by exact signs.
//!
//! # Source
//! Rules and tolerances are those of the independent checker `check_mesh.py` that the project shares.

use std::collections::BTreeSet;

use crate::domain::Pslg;
use crate::geometry::math::power_of_two_scale;
use crate::geometry::{Orientation, Point, Vector, lexicographic, orient2d};
use crate::triangulation::{IndexedMesh, MeshVertex, Side, Sides, mesh_vertex};

/// How far a chain may be off its segment, in lengths of the segment.
const OFF_BY_LENGTH: f64 = 1e-9;
/// How far a chain may be off its segment, in the largest coordinate of its ends: 8 epsilons.
const OFF_BY_COORDINATE: f64 = 8.0 * f64::EPSILON;

/// What a mesh and its input disagree on.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InputFault {
    /// Input vertices are missing at the end.
    #[error("{found} vertices are fewer than the {expected} of the input")]
    FewerVertices {
        /// Vertices of the mesh.
        found: usize,
        /// Vertices of the input.
        expected: usize,
    },
    /// An input vertex has other bits.
    #[error("input vertex {vertex} at {was} has become {is}")]
    VertexChanged {
        /// Its index.
        vertex: usize,
        /// Where the input has it.
        was: Point,
        /// Where the mesh has it.
        is: Point,
    },
    /// An input segment names a vertex that is not there.
    #[error("input segment {segment} names vertex {vertex}, but there are {vertices} vertices")]
    SegmentOutOfRange {
        /// The segment.
        segment: usize,
        /// The index.
        vertex: u32,
        /// How many vertices the input has.
        vertices: usize,
    },
    /// An input segment runs through triangles.
    #[error("input segment {segment} from vertex {} to vertex {} is not covered by edges of the mesh: it enters a triangle at vertex {stop}", .ends[0], .ends[1])]
    SegmentNotCovered {
        /// The segment.
        segment: usize,
        /// Its ends.
        ends: [MeshVertex; 2],
        /// Where the chain of edges stops.
        stop: MeshVertex,
    },
}

/// What a comparison found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Comparison {
    /// Every disagreement, vertices first; empty where the mesh is a mesh of the input.
    pub faults: Vec<InputFault>,
    /// The mesh edges that cover input segments, smaller end first, sorted: what is constrained for
    /// [`check_mesh_delaunay`](crate::triangulation::check_mesh_delaunay) where a file does not say.
    pub covered: Vec<[u32; 2]>,
}

/// Compares a mesh with the drawing that it was made from.
///
/// # Guarantees
/// Never panics, whatever mesh and input hold. Segments are compared only if no vertex is missing or changed.
///
/// # Complexity
/// Linear in the mesh, and in the vertices along each segment with their degrees.
#[must_use]
pub fn against_input(mesh: &IndexedMesh, input: &Pslg) -> Comparison {
    let mut found = Comparison { faults: vertex_faults(mesh, input), covered: Vec::new() };
    if !found.faults.is_empty() {
        return found;
    }
    let sides = Sides::of(mesh);
    let stand_ins = stand_ins(input, &sides);
    let mut covered = BTreeSet::new();
    for (segment, &named) in input.segments.iter().enumerate() {
        let vertices = input.points.len();
        if let Some(vertex) = named.into_iter().find(|&v| v as usize >= vertices) {
            found.faults.push(InputFault::SegmentOutOfRange { segment, vertex, vertices });
            continue;
        }
        let [a, b] = named.map(|v| stand_ins[v as usize]);
        let ends = [mesh_vertex(mesh, a), mesh_vertex(mesh, b)];
        if let Some(stop) = cover(mesh, &sides, a, b, &mut covered) {
            found.faults.push(InputFault::SegmentNotCovered { segment, ends, stop: mesh_vertex(mesh, stop) });
        }
    }
    found.covered = covered.into_iter().collect();
    found
}

/// Part 1.
fn vertex_faults(mesh: &IndexedMesh, input: &Pslg) -> Vec<InputFault> {
    let (found, expected) = (mesh.points.len(), input.points.len());
    if found < expected {
        return vec![InputFault::FewerVertices { found, expected }];
    }
    let bits = |p: Point| [p.x.to_bits(), p.y.to_bits()];
    let pairs = input.points.iter().zip(&mesh.points).enumerate();
    let changed = pairs.filter(|(_, (was, is))| bits(**was) != bits(**is));
    changed.map(|(vertex, (&was, &is))| InputFault::VertexChanged { vertex, was, is }).collect()
}

/// For each input vertex the first used one on the same place, or else the first one there.
fn stand_ins(input: &Pslg, sides: &Sides) -> Vec<u32> {
    let place = |v: u32| input.points[v as usize];
    let mut order: Vec<u32> = (0..).take(input.points.len()).collect();
    order.sort_unstable_by(|&a, &b| lexicographic(place(a), place(b)).then(a.cmp(&b)));
    let mut stand_ins = vec![0; order.len()];
    for same in order.chunk_by(|&a, &b| place(a) == place(b)) {
        let used = same.iter().find(|&&v| sides.is_used(v));
        let stand_in = *used.unwrap_or(&same[0]);
        same.iter().for_each(|&v| stand_ins[v as usize] = stand_in);
    }
    stand_ins
}

/// Parts 2 and 3: collects the edges that cover a segment; returns where it runs into a triangle.
fn cover(mesh: &IndexedMesh, sides: &Sides, a: u32, b: u32, covered: &mut BTreeSet<[u32; 2]>) -> Option<u32> {
    if a == b || !sides.is_used(a) || !sides.is_used(b) {
        return None;
    }
    let forth = Line::new(mesh, a, b).chain(sides);
    forth.collect_into(covered);
    if forth.stop() == b {
        return None;
    }
    let back = Line::new(mesh, b, a).chain(sides);
    back.collect_into(covered);
    let enters = |from: u32, to: u32| enters_a_triangle(mesh, sides, from, to);
    [(forth.stop(), b), (back.stop(), a)].into_iter().find(|&(from, to)| enters(from, to)).map(|(from, _)| from)
}

/// Whether the ray from one vertex to another begins inside a triangle of the first or along a side of it.
fn enters_a_triangle(mesh: &IndexedMesh, sides: &Sides, from: u32, to: u32) -> bool {
    let [v, target] = [from, to].map(|v| mesh.points[v as usize]);
    let left_on = |p: Point, q: Point| {
        v.is_finite() && p.is_finite() && q.is_finite() && orient2d(v, p, q) != Orientation::Clockwise
    };
    sides.from(from).iter().any(|s: &Side| {
        let [p, q] = [s.dest, s.apex].map(|w| mesh.points[w as usize]);
        left_on(p, target) && left_on(target, q) && left_on(p, q)
    })
}

/// Rounding moves no coordinate by less than the smallest number there is.
const SMALLEST: f64 = 1e-323;

/// A segment in coordinates in which it reaches from the origin to about one.
struct Line<'a> {
    mesh: &'a IndexedMesh,
    ends: [u32; 2],
    shrink: f64,
    scale: f64,
    along: Vector,
    /// Largest cross product with `along` of a point that counts as on the segment.
    tolerance: f64,
}

impl<'a> Line<'a> {
    fn new(mesh: &'a IndexedMesh, from: u32, to: u32) -> Self {
        let [a, b] = [from, to].map(|v| mesh.points[v as usize]);
        let largest = [a.x, a.y, b.x, b.y].into_iter().fold(0.0_f64, |m, c| m.max(c.abs()));
        // Differences of larger numbers could overflow.
        let shrink = if largest > 1e300 { 0.125 } else { 1.0 };
        let mut line = Self { mesh, ends: [from, to], shrink, scale: 1.0, along: Vector::default(), tolerance: 0.0 };
        let reach = line.local(to);
        line.scale = power_of_two_scale(reach.x.abs().max(reach.y.abs()));
        line.along = line.local(to);
        let length = line.along.length_sq().sqrt();
        line.tolerance =
            (OFF_BY_LENGTH * length + (OFF_BY_COORDINATE * largest + SMALLEST) * shrink * line.scale) * length;
        line
    }

    /// A vertex relative to the start of the segment.
    fn local(&self, v: u32) -> Vector {
        let [p, a] = [v, self.ends[0]].map(|v| self.mesh.points[v as usize]);
        let difference = |p: f64, a: f64| (p * self.shrink - a * self.shrink) * self.scale;
        Vector::new(difference(p.x, a.x), difference(p.y, a.y))
    }

    /// How far along the segment a vertex lies, 0 to 1; `None` if it is not on it.
    fn parameter(&self, v: u32) -> Option<f64> {
        if self.ends.contains(&v) {
            return Some(if v == self.ends[1] { 1.0 } else { 0.0 });
        }
        let p = self.local(v);
        let t = p.dot(self.along) / self.along.length_sq();
        let on = p.cross(self.along).abs() <= self.tolerance && (0.0..=1.0).contains(&t);
        on.then_some(t)
    }

    /// Follows edges along the segment, always forward, as far as they lead; other ways where one ends.
    fn chain(&self, sides: &Sides) -> Chain {
        let mut links: Vec<Link> = vec![Link { vertex: self.ends[0], t: 0.0, before: None }];
        let mut met = BTreeSet::from([self.ends[0]]);
        let mut open = vec![0];
        let mut best = 0;
        while let Some(at) = open.pop() {
            let Link { vertex, t, .. } = links[at];
            if t >= links[best].t {
                best = at;
            }
            if vertex == self.ends[1] {
                break;
            }
            let mut ahead: Vec<(f64, u32)> = neighbours(sides, vertex)
                .filter_map(|v| self.parameter(v).map(|s| (s, v)))
                .filter(|&(s, v)| s >= t && met.insert(v))
                .collect();
            // The nearest is looked at first: it is pushed last.
            ahead.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(b.1.cmp(&a.1)));
            for (t, vertex) in ahead {
                open.push(links.len());
                links.push(Link { vertex, t, before: Some(at) });
            }
        }
        Chain::ending_at(best, &links)
    }
}

/// A vertex met along a segment, and how.
#[derive(Clone, Copy, Debug)]
struct Link {
    vertex: u32,
    t: f64,
    before: Option<usize>,
}

/// Vertices joined by edges, backwards.
struct Chain(Vec<u32>);

impl Chain {
    fn ending_at(last: usize, links: &[Link]) -> Self {
        let chain = std::iter::successors(Some(last), |&at| links[at].before);
        Self(chain.map(|at| links[at].vertex).collect())
    }

    fn stop(&self) -> u32 {
        self.0[0]
    }

    fn collect_into(&self, edges: &mut BTreeSet<[u32; 2]>) {
        edges.extend(self.0.windows(2).map(|w| [w[0].min(w[1]), w[0].max(w[1])]));
    }
}

/// Vertices joined to `v`, some twice.
fn neighbours(sides: &Sides, v: u32) -> impl Iterator<Item = u32> + '_ {
    sides.from(v).iter().flat_map(|s| [s.dest, s.apex])
}
