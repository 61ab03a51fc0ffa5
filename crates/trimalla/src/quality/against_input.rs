//! Compares a mesh with the drawing that it was made from.
//!
//! 1. Input vertices come first, bit for bit. Unused ones may be duplicates or lie outside the domain.
//! 2. Every input segment is a chain of mesh edges from end to end, by the rule of [`Strip`](crate::geometry::Strip),
//!    which says how many last places a vertex on a segment may be off it and why those that this library puts there
//!    never are off by more. The decision is exact. [`from_mesh`](crate::domain::from_mesh()) looks for the same
//!    chains.
//! 3. A segment may be absent where it is outside the mesh: see `cover.rs`.

use super::cover::Cover;
use crate::drawing::{IndexedMesh, Pslg, Sides};
use crate::geometry::{Point, lexicographic};
use crate::triangulation::MeshVertex;

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
    /// The chain of an input segment passes by an input vertex that lies exactly on the segment.
    #[error("input segment {segment} from vertex {} to vertex {} passes by vertex {vertex}, which lies exactly on it", .ends[0], .ends[1])]
    VertexPassedBy {
        /// The segment.
        segment: usize,
        /// Its ends.
        ends: [MeshVertex; 2],
        /// The vertex.
        vertex: MeshVertex,
    },
    /// The chain of an input segment passes through an input vertex that does not lie on the segment.
    #[error("input segment {segment} from vertex {} to vertex {} passes through vertex {vertex}, which lies beside it", .ends[0], .ends[1])]
    VertexBeside {
        /// The segment.
        segment: usize,
        /// Its ends.
        ends: [MeshVertex; 2],
        /// The vertex.
        vertex: MeshVertex,
    },
    /// The chain of an input segment has an input vertex on another side than the segment, within rounding.
    #[error("input segment {segment} from vertex {} to vertex {} passes vertex {vertex} on the wrong side", .ends[0], .ends[1])]
    VertexOnWrongSide {
        /// The segment.
        segment: usize,
        /// Its ends.
        ends: [MeshVertex; 2],
        /// The vertex.
        vertex: MeshVertex,
    },
    /// An input segment crosses the boundary of the mesh where no vertex is.
    #[error("input segment {segment} from vertex {} to vertex {} crosses the boundary edge from vertex {} to vertex {}", .ends[0], .ends[1], .edge[0], .edge[1])]
    SegmentCrossesBoundary {
        /// The segment.
        segment: usize,
        /// Its ends.
        ends: [MeshVertex; 2],
        /// The ends of the edge.
        edge: [MeshVertex; 2],
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
/// Linear in the mesh, n log n in the vertices of the drawing, and the degrees of the vertices along each segment.
#[must_use]
pub fn against_input(mesh: &IndexedMesh, input: &Pslg) -> Comparison {
    let mut found = Comparison { faults: vertex_faults(mesh, input), covered: Vec::new() };
    if !found.faults.is_empty() {
        return found;
    }
    let sides = Sides::of(mesh);
    let stand_ins = stand_ins(input, &sides);
    let mut cover = Cover::new(mesh, input, &sides);
    for (segment, &named) in input.segments.iter().enumerate() {
        let vertices = input.points.len();
        match named.into_iter().find(|&v| v as usize >= vertices) {
            Some(vertex) => found.faults.push(InputFault::SegmentOutOfRange { segment, vertex, vertices }),
            None => found.faults.extend(cover.fault(segment, named.map(|v| stand_ins[v as usize]))),
        }
    }
    found.covered = cover.into_edges();
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

/// For each input vertex the first used vertex at its place, or else the first vertex there.
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
