//! Takes a mesh up again: keeps its triangles as they are and finds its segments again.
//!
//! 1. The mesh is checked by [`check_mesh`](crate::triangulation::check_mesh), and against the vertices of its drawing
//!    where there is one. Its triangles become the faces; nothing is triangulated anew.
//! 2. *Locked* edges are the subsegments that the mesh lists, the boundary, and edges between triangles with different
//!    attributes: those bound a region, though no segment says so.
//! 3. Segments are found again as chains of edges: see `chains.rs`. Locked edges that belong to none become segments of
//!    their own, named after those of the drawing, so that splits are computed from ends as far apart as can be.
//! 4. Provenances are found again: see `shells.rs`. With the drawing, vertices after its own are Steiner vertices;
//!    without it, every vertex counts as input.
//! 5. Attributes make regions, area bounds too: see `given.rs`.

use super::chains::{Chain, Locked, edge_of, follow, rejoin};
use super::error::{DomainError, Warning};
use super::given::{Given, GivenAreas, TakeOver};
use super::mesh_error::MeshError;
use super::shells;
use crate::constrained::{ConstrainedTriangulation, ConstraintError, Provenance};
use crate::drawing::{IndexedMesh, Pslg};
use crate::geometry::Point;
use crate::half_edge::{HalfEdgeId, NoJournal, VertexId};
use crate::triangulation::Triangulation;

/// A mesh taken up again.
#[derive(Clone, Debug)]
pub struct FromMesh {
    /// Its triangles, closed by their boundary. Constrained Delaunay only if the mesh is:
    /// [`ConstrainedDelaunay`](crate::constrained::ConstrainedDelaunay), made from it, is.
    pub cdt: ConstrainedTriangulation,
    /// Data of the mesh that the triangulation does not hold, for the result.
    pub given: Given,
    /// The area bounds of its triangles, where some were given: a [`Start`](crate::refine::Start) that is made from
    /// all of this keeps them.
    pub areas: Option<GivenAreas>,
    /// Warnings about the mesh, and what was assumed.
    pub warnings: Vec<Warning>,
}

/// Takes a mesh up again, with the drawing it was made from where that is known.
///
/// # Shape
/// `areas` is empty or has an entry a triangle: the largest area that triangles within it may have, in squared
/// coordinate units.
///
/// # Guarantees
/// Face `t` is triangle `t` and vertices keep their indices. Boundary edges and listed segments are constrained. With a
/// drawing, its segments are named as far as edges run along them;
/// [`against_input`](crate::quality::against_input()) tells where one is not covered. No vertex of the mesh is ever
/// deleted by a refinement.
///
/// # Errors
/// [`MeshError`]; nothing panics, whatever the mesh holds.
///
/// # Complexity
/// O(n log n).
///
/// # Examples
/// ```
/// use trimalla::domain::from_mesh;
/// use trimalla::geometry::Point;
/// use trimalla::drawing::IndexedMesh;
///
/// let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from).to_vec();
/// let mesh = IndexedMesh { points, triangles: vec![[0, 1, 3], [1, 2, 3]], ..IndexedMesh::default() };
/// let taken = from_mesh(&mesh, &[], None)?;
/// assert_eq!((taken.cdt.face_count(), taken.cdt.segments().len()), (2, 4));
/// # Ok::<(), trimalla::domain::MeshError>(())
/// ```
pub fn from_mesh(mesh: &IndexedMesh, areas: &[Option<f64>], input: Option<&Pslg>) -> Result<FromMesh, MeshError> {
    check_size(mesh, areas)?;
    if let Some(pslg) = input {
        check_drawing(mesh, pslg)?;
    }
    let t = Triangulation::from_indexed(mesh).map_err(MeshError::Faults)?;
    let bare = (!areas.is_empty()).then(|| t.clone());
    let mut cdt = ConstrainedTriangulation::of_mesh(t, input.map(|pslg| pslg.points.len()));
    let mut warnings = Vec::new();
    let locked = locked_edges(&cdt, mesh, &mut warnings);
    let markers = name_segments(&mut cdt, &locked, input, &mut warnings);
    let unknown = if input.is_some() { Provenance::Free } else { Provenance::Input };
    shells::recover(&mut cdt, unknown);
    cdt.triangulate_outside();
    let taken = TakeOver::new(mesh, input, markers);
    taken.assign_seeds(&mut cdt, &mut warnings)?;
    let (given, areas) = taken.finish(&mut cdt, areas, bare);
    if input.is_none() {
        warnings.extend(pieces(&cdt));
    }
    Ok(FromMesh { cdt, given, areas, warnings })
}

/// Sizes and area bounds.
fn check_size(mesh: &IndexedMesh, areas: &[Option<f64>]) -> Result<(), MeshError> {
    let triangles = mesh.triangles.len();
    if triangles == 0 {
        return Err(MeshError::NoTriangles);
    }
    if triangles > MeshError::MAX_TRIANGLES {
        return Err(MeshError::TooManyTriangles { triangles });
    }
    if !areas.is_empty() && areas.len() != triangles {
        return Err(MeshError::AreaCount { found: areas.len(), expected: triangles });
    }
    let wrong = |bound: &f64| !(*bound > 0.0 && bound.is_finite());
    match areas.iter().enumerate().find_map(|(t, a)| a.filter(wrong).map(|bound| (t, bound))) {
        Some((triangle, bound)) => Err(MeshError::AreaBound { triangle, bound }),
        None => Ok(()),
    }
}

/// The vertices of the drawing come first, bit for bit, and its segments name them.
fn check_drawing(mesh: &IndexedMesh, pslg: &Pslg) -> Result<(), MeshError> {
    pslg.validate().map_err(DomainError::from)?;
    let (found, expected) = (mesh.points.len(), pslg.points.len());
    if found < expected {
        return Err(MeshError::FewerVertices { found, expected });
    }
    let bits = |p: Point| [p.x.to_bits(), p.y.to_bits()];
    let mut pairs = pslg.points.iter().zip(&mesh.points).enumerate();
    if let Some((vertex, (&was, &is))) = pairs.find(|(_, (was, is))| bits(**was) != bits(**is)) {
        return Err(MeshError::VertexChanged { vertex, was, is });
    }
    let outside = |ends: &[u32; 2]| ends.iter().copied().find(|&v| v as usize >= expected);
    match pslg.segments.iter().enumerate().find_map(|(s, ends)| outside(ends).map(|v| (s, v))) {
        Some((segment, v)) => {
            let missing = ConstraintError::NoSuchVertex { segment, vertex: VertexId(v), points: expected };
            Err(DomainError::from(missing).into())
        }
        None => Ok(()),
    }
}

/// Step 2.
fn locked_edges(cdt: &ConstrainedTriangulation, mesh: &IndexedMesh, warnings: &mut Vec<Warning>) -> Locked {
    let mut locked = Locked::new();
    for (i, &[a, b]) in mesh.segments.iter().enumerate() {
        let between = |a, b| cdt.half_edge_between(VertexId(a), VertexId(b));
        // On a vertex where the boundary touches itself, only one of the two stars may know the edge.
        if let Some(h) = between(a, b).or_else(|| between(b, a)) {
            let marker = mesh.segment_markers.get(i).copied().unwrap_or(0);
            let slot = locked.entry(edge_of(cdt, h)).or_insert(marker);
            *slot = if *slot == 0 { marker } else { *slot };
        }
    }
    for h in cdt.ghost_faces().filter_map(|f| cdt.ghost_edge(f)) {
        locked.entry(edge_of(cdt, h)).or_insert(0);
    }
    let n = mesh.attributes_per_triangle;
    // Where the product overflows, the table is empty: its length was checked.
    let row = |t: usize| mesh.triangle_attributes.get(t.saturating_mul(n)..(t + 1).saturating_mul(n));
    let parts_regions = |h: &HalfEdgeId| {
        let beside = cdt.twin(*h).face();
        cdt.is_real(beside) && !same_bits(row(h.face().index()), row(beside.index()))
    };
    let unlisted: Vec<HalfEdgeId> = cdt.edges().filter(parts_regions).map(|h| edge_of(cdt, h)).collect();
    let unlisted: Vec<HalfEdgeId> = unlisted.into_iter().filter(|edge| !locked.contains_key(edge)).collect();
    if !unlisted.is_empty() {
        warnings.push(Warning::RegionBoundaries { edges: unlisted.len() });
    }
    locked.extend(unlisted.into_iter().map(|edge| (edge, 0)));
    locked
}

fn same_bits(a: Option<&[f64]>, b: Option<&[f64]>) -> bool {
    let bits = |row: Option<&[f64]>| row.map(|r| r.iter().map(|x| x.to_bits()).collect::<Vec<u64>>());
    bits(a) == bits(b)
}

/// Step 3; returns the markers of all segments.
fn name_segments(
    cdt: &mut ConstrainedTriangulation,
    locked: &Locked,
    input: Option<&Pslg>,
    warnings: &mut Vec<Warning>,
) -> Vec<i32> {
    let of_drawing = input.map_or(&[][..], |pslg| &pslg.segments);
    let ends: Vec<[VertexId; 2]> = of_drawing.iter().map(|s| s.map(|v| cdt.representative(VertexId(v)))).collect();
    let names = input.map(|pslg| follow(cdt, pslg, &ends, locked)).unwrap_or_default();
    let known = if input.is_some() { cdt.input_points() } else { 0 };
    let chains = rejoin(cdt, locked, &names, |v| v.index() >= known);
    note_chains(cdt, &chains, input.is_some(), warnings);
    let mut markers: Vec<i32> =
        input.map_or_else(Vec::new, |p| (0..of_drawing.len()).map(|s| marker_of(p, s)).collect());
    for &ends in &ends {
        cdt.begin_segment(ends, &mut NoJournal);
    }
    for (&edge, list) in &names.0 {
        cdt.mark_as_part_of(edge, list, &mut NoJournal);
    }
    for Chain { vertices, marker } in chains {
        let ends = [vertices[0], vertices[vertices.len() - 1]];
        let mark = cdt.begin_segment(ends, &mut NoJournal);
        markers.push(marker);
        for pair in vertices.windows(2) {
            if let Some(h) = cdt.half_edge_between(pair[0], pair[1]) {
                cdt.set_mark(h, mark, &mut NoJournal);
            }
        }
    }
    markers
}

fn marker_of(pslg: &Pslg, segment: usize) -> i32 {
    pslg.segment_markers.get(segment).copied().unwrap_or(0)
}

/// Adds warnings about joined subsegments, and about those on no segment of the drawing.
fn note_chains(cdt: &ConstrainedTriangulation, chains: &[Chain], has_drawing: bool, warnings: &mut Vec<Warning>) {
    if has_drawing {
        let boundaries = |v: &[VertexId]| {
            let h = cdt.half_edge_between(v[0], v[1]);
            h.is_some_and(|h| cdt.is_boundary_edge(h))
        };
        let inner = chains.iter().flat_map(|c| c.vertices.windows(2)).filter(|pair| !boundaries(pair)).count();
        if inner > 0 {
            warnings.push(Warning::NotInDrawing { subsegments: inner });
        }
        return;
    }
    let joined = || chains.iter().filter(|c| c.vertices.len() > 2);
    let subsegments = joined().map(|c| c.vertices.len() - 1).sum();
    if joined().next().is_some() {
        warnings.push(Warning::Rejoined { chains: joined().count(), subsegments });
    }
}

/// A warning if the mesh falls into several pieces.
fn pieces(cdt: &ConstrainedTriangulation) -> Option<Warning> {
    let mut seen = vec![false; cdt.face_slots()];
    let mut pieces = 0;
    for first in cdt.real_faces() {
        let mut stack = vec![first];
        pieces += usize::from(!seen[first.index()]);
        while let Some(f) = stack.pop() {
            if !std::mem::replace(&mut seen[f.index()], true) {
                stack.extend(f.half_edges().map(|h| cdt.twin(h).face()).into_iter().filter(|&g| cdt.is_real(g)));
            }
        }
    }
    (pieces > 1).then_some(Warning::Pieces { pieces })
}
