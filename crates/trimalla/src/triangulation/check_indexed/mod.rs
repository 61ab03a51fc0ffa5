//! The checker of meshes from any source: names every fault with its place.
//!
//! An [`IndexedMesh`] read from a file may be broken in any way. Nothing here panics on it; each part
//! looks only at what the parts before it have found sound.
//!
//! 1. Columns as long as they must be, indices in range, coordinates finite.
//! 2. Every triangle strictly counter-clockwise, by the exact test.
//! 3. Every directed edge used once; every vertex star one closed fan, or open ones (where the domain
//!    touches itself).
//! 4. No two used vertices on one place; every subsegment an edge.
//! 5. No overlap: `overlap.rs`. Only where parts 1 to 4 found nothing wrong with triangles.
//! 6. On request, the circle test on every edge that is not constrained.

mod fault;
mod overlap;

pub use fault::{MeshFault, MeshVertex};

use crate::drawing::{IndexedMesh, Side, Sides};
use crate::geometry::{CircleSide, Orientation, Point, in_circle, lexicographic, orient2d};
use crate::half_edge::EdgeKey;

/// Every fault of a mesh except the circle test; empty for a sound mesh.
///
/// # Guarantees
/// Never panics, whatever the mesh holds. Faults come in the order of the parts above, within a part in
/// the order of indices. Overlap is looked for only where nothing else is wrong with the triangles, and
/// only the first place is named. A mesh without faults covers the region inside its boundary once.
///
/// # Complexity
/// O(n log n).
///
/// # Examples
/// ```
/// use trimalla::geometry::Point;
/// use trimalla::drawing::IndexedMesh;
/// use trimalla::triangulation::check_mesh;
///
/// let points = vec![Point::new(0.0, 0.0), Point::new(1.0, 0.0), Point::new(0.0, 1.0)];
/// let mesh = IndexedMesh { points, triangles: vec![[0, 2, 1]], ..IndexedMesh::default() };
/// let faults = check_mesh(&mesh);
/// let message = "triangle 0 with vertices 0 at (0, 0), 2 at (0, 1) and 1 at (1, 0) is clockwise";
/// assert_eq!(faults[0].to_string(), message);
/// ```
#[must_use]
pub fn check_mesh(mesh: &IndexedMesh) -> Vec<MeshFault> {
    let sides = Sides::of(mesh);
    let mut faults = column_faults(mesh);
    let of_columns = faults.len();
    faults.extend(vertex_faults(mesh));
    faults.extend((0..mesh.triangles.len()).filter_map(|t| triangle_fault(mesh, t)));
    faults.extend(edge_faults(mesh, &sides));
    faults.extend(duplicate_faults(mesh, &sides));
    let of_triangles = faults.len() - of_columns;
    faults.extend((0..mesh.segments.len()).filter_map(|s| segment_fault(mesh, &sides, s)));
    if of_triangles == 0 {
        faults.extend(overlap::overlap_fault(mesh, &sides));
    }
    faults
}

/// Every edge that fails the circle test and is not constrained; cocircular corners pass.
///
/// # Shape
/// Constrained are the subsegments of the mesh and the edges in `constrained`, in either direction.
/// Edges of triangles with faults that [`check_mesh`] names are passed over.
///
/// # Guarantees
/// Never panics, whatever the mesh holds.
///
/// # Source
/// The constrained circle test of `[Valenzuela09]`, definition 5.
#[must_use]
pub fn check_mesh_delaunay(mesh: &IndexedMesh, constrained: &[[u32; 2]]) -> Vec<MeshFault> {
    let sides = Sides::of(mesh);
    let mut locked: Vec<EdgeKey<u32>> = mesh.segments.iter().chain(constrained).copied().map(EdgeKey::of).collect();
    locked.sort_unstable();
    let free = |s: &&Side| locked.binary_search(&EdgeKey::of([s.origin, s.dest])).is_err();
    sides.edges().filter(free).filter_map(|s| circle_fault(mesh, &sides, s)).collect()
}

/// A vertex in range, with its place.
pub(crate) fn vertex(mesh: &IndexedMesh, index: u32) -> MeshVertex {
    MeshVertex { index, point: mesh.points[index as usize] }
}

fn ends(mesh: &IndexedMesh, side: &Side) -> [MeshVertex; 2] {
    [vertex(mesh, side.origin), vertex(mesh, side.dest)]
}

fn column_faults(mesh: &IndexedMesh) -> Vec<MeshFault> {
    let (points, triangles) = (mesh.points.len(), mesh.triangles.len());
    let columns = [
        ("point_markers", mesh.point_markers.len(), points),
        ("point_attributes", mesh.point_attributes.len(), points.saturating_mul(mesh.attributes_per_point)),
        ("triangle_attributes", mesh.triangle_attributes.len(), triangles.saturating_mul(mesh.attributes_per_triangle)),
        ("segment_markers", mesh.segment_markers.len(), mesh.segments.len()),
    ];
    let wrong = columns.into_iter().filter(|&(_, found, expected)| found != 0 && found != expected);
    let mut faults: Vec<MeshFault> =
        wrong.map(|(column, found, expected)| MeshFault::ColumnLength { column, found, expected }).collect();
    if mesh.input_points > points {
        faults.push(MeshFault::InputCount { claimed: mesh.input_points, vertices: points });
    }
    faults
}

fn vertex_faults(mesh: &IndexedMesh) -> impl Iterator<Item = MeshFault> + '_ {
    let wild = mesh.points.iter().zip(0..).filter(|(p, _)| !p.is_finite());
    wild.map(|(&point, index)| MeshFault::NotFinite(MeshVertex { index, point }))
}

/// The first thing wrong with a triangle by itself.
fn triangle_fault(mesh: &IndexedMesh, triangle: usize) -> Option<MeshFault> {
    let t = mesh.triangles[triangle];
    let vertices = mesh.points.len();
    if let Some(&vertex) = t.iter().find(|&&v| v as usize >= vertices) {
        return Some(MeshFault::IndexOutOfRange { triangle, vertex, vertices });
    }
    if let Some(k) = (0..3).find(|&k| t[k] == t[(k + 1) % 3]) {
        return Some(MeshFault::RepeatedVertex { triangle, vertex: vertex(mesh, t[k]) });
    }
    let corners = t.map(|v| vertex(mesh, v));
    let [a, b, c] = corners.map(|v| v.point);
    if ![a, b, c].into_iter().all(Point::is_finite) {
        return None; // Named already.
    }
    match orient2d(a, b, c) {
        Orientation::CounterClockwise => None,
        orientation => Some(MeshFault::NotCounterClockwise { triangle, corners, orientation }),
    }
}

/// Directed edges used twice; where there are none, stars that are not made of fans.
fn edge_faults(mesh: &IndexedMesh, sides: &Sides) -> Vec<MeshFault> {
    let twice = sides.iter().zip(sides.iter().skip(1)).filter(|(s, t)| (s.origin, s.dest) == (t.origin, t.dest));
    let faults: Vec<MeshFault> = twice
        .map(|(s, t)| MeshFault::EdgeUsedTwice { edge: ends(mesh, s), triangles: [s.triangle, t.triangle] })
        .collect();
    if !faults.is_empty() {
        return faults; // Turning about a vertex needs one way to turn.
    }
    (0..).take(mesh.points.len()).filter_map(|v| star_fault(mesh, sides, v)).collect()
}

/// A closed fan about `v` beside other triangles.
///
/// With every directed edge used once, the triangles about a vertex fall into fans, each open or closed.
fn star_fault(mesh: &IndexedMesh, sides: &Sides, v: u32) -> Option<MeshFault> {
    let star = sides.from(v);
    let mut seen = vec![false; star.len()];
    let mut first = None;
    // Open fans begin at a side that no other triangle precedes.
    for start in 0..star.len() {
        if sides.find(star[start].dest, v).is_none() {
            first = first.or(Some(star[start].triangle));
            mark_fan(star, start, &mut seen);
        }
    }
    // What is left are closed ones, each of which must be alone.
    while let Some(start) = seen.iter().position(|seen| !seen) {
        if let Some(other) = first {
            let triangles = [star[start].triangle, other];
            return Some(MeshFault::Star { vertex: vertex(mesh, v), triangles });
        }
        first = Some(star[start].triangle);
        mark_fan(star, start, &mut seen);
    }
    None
}

/// Marks the sides that follow one another counter-clockwise about their origin.
fn mark_fan(star: &[Side], start: usize, seen: &mut [bool]) {
    let mut at = Some(start);
    while let Some(i) = at.filter(|&i| !seen[i]) {
        seen[i] = true;
        at = star.binary_search_by_key(&star[i].apex, |s| s.dest).ok();
    }
}

/// Used vertices on one place, each with the one before it in order of place and index.
fn duplicate_faults(mesh: &IndexedMesh, sides: &Sides) -> Vec<MeshFault> {
    let used = |v: &u32| sides.is_used(*v) && mesh.points[*v as usize].is_finite();
    let mut order: Vec<u32> = (0..).take(mesh.points.len()).filter(used).collect();
    let place = |v: &u32| mesh.points[*v as usize];
    order.sort_unstable_by(|a, b| lexicographic(place(a), place(b)).then(a.cmp(b)));
    let pairs = order.windows(2).filter(|w| place(&w[0]) == place(&w[1]));
    pairs.map(|w| MeshFault::DuplicateVertices([vertex(mesh, w[0]), vertex(mesh, w[1])])).collect()
}

fn segment_fault(mesh: &IndexedMesh, sides: &Sides, segment: usize) -> Option<MeshFault> {
    let [a, b] = mesh.segments[segment];
    let vertices = mesh.points.len();
    if let Some(vertex) = [a, b].into_iter().find(|&v| v as usize >= vertices) {
        return Some(MeshFault::SegmentOutOfRange { segment, vertex, vertices });
    }
    let ends = [vertex(mesh, a), vertex(mesh, b)];
    (!sides.joins(a, b)).then_some(MeshFault::SegmentNotAnEdge { segment, ends })
}

/// The circle test across the edge of a side: the fault, if the test fails.
fn circle_fault(mesh: &IndexedMesh, sides: &Sides, side: &Side) -> Option<MeshFault> {
    let other = sides.find(side.dest, side.origin)?;
    let [a, b, c, d] = [side.origin, side.dest, side.apex, other.apex].map(|v| mesh.points[v as usize]);
    let sound = [a, b, c, d].into_iter().all(Point::is_finite)
        && orient2d(a, b, c) == Orientation::CounterClockwise
        && orient2d(b, a, d) == Orientation::CounterClockwise;
    (sound && in_circle(a, b, c, d) == CircleSide::Inside).then(|| MeshFault::NotDelaunay {
        edge: ends(mesh, side),
        triangles: [side.triangle, other.triangle],
        inside: vertex(mesh, other.apex),
    })
}
