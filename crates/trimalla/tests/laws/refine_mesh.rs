//! Refining a mesh that exists.
//!
//! *Inputs*: every kind of drawing that the testkit knows (crossings split), at several sizes and seeds, meshed at 20
//! to 28 degrees: a thousand meshes. Meshes with hand-made faults; meshes that are not Delaunay; attributes and area
//! bounds.
//!
//! *Claims*
//! 1. Refined again at the same bounds, with its drawing, a mesh comes back as it is: no vertex more, the same
//!    triangles in the same order. Without its drawing too, unless rounding matters: where triangles were given up at
//!    the precision floor or in a gap of the input, and where crossings bend the segments of float soups, the result of
//!    one refinement comes back from the next.
//! 2. At a tighter bound, all old vertices are there, in order, bit for bit; all checkers find the result sound.
//! 3. What is no mesh is refused with triangles, vertices and coordinates; nothing panics.
//! 4. A start that is not Delaunay is flipped first, unless the recipe flips nothing: then its edges stay.
//! 5. Attributes come from the triangle that holds the new one; area bounds hold by place.

use crate::common::failures::{Failures, Verdict, equal, none};
use trimalla::constrained::{ConstrainedDelaunay, Crossings, Provenance};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainError, DomainRule, MeshError, Warning, build, from_mesh};
use trimalla::drawing::{IndexedMesh, Pslg, Region};
use trimalla::geometry::Point;
use trimalla::quality::against_input;
use trimalla::refine::{NoObserver, Preset, Reason, RefineOptions, Refinement, Report, StopReason};
use trimalla::triangulation::{MeshFault, check_mesh};
use trimalla::{Error, MeshOptions, Meshed, refine_mesh, refine_mesh_with};
use trimalla_testkit::generators::{PslgKind, pslg, rotated};
use trimalla_testkit::oracles::{DelaunayRule, check_indexed_with};

/// The vertex budget: what meets it is not judged, as it did not end by itself.
const BUDGET: usize = 3000;

/// The domain of a drawing by its seeds, or where it has none its hull; nothing where it is flat.
fn domain_of(drawing: &Pslg) -> Option<(ConstrainedDelaunay, Pslg)> {
    let by = |drawing: &Pslg, rule| build(drawing, rule, Crossings::Split, AlgorithmKey::default());
    match by(drawing, DomainRule::Seeds) {
        Ok((cdt, _)) => return Some((cdt, drawing.clone())),
        Err(DomainError::Flat { .. } | DomainError::Constraint(_)) => return None,
        Err(_) => {}
    }
    let whole = Pslg { holes: Vec::new(), ..drawing.clone() };
    by(&whole, DomainRule::Hull).ok().map(|(cdt, _)| (cdt, whole))
}

/// The mesh of a drawing, with the drawing as it was read; nothing where it is flat or too much for the budget.
fn meshed(drawing: &Pslg, options: RefineOptions) -> Result<Option<(IndexedMesh, Report, Pslg)>, String> {
    let Some((cdt, drawing)) = domain_of(drawing) else { return Ok(None) };
    let mut refinement = Refinement::new(cdt, options).map_err(|e| e.to_string())?;
    refinement.run(&mut NoObserver);
    let (cdt, report) = refinement.finish();
    let ended = report.stop == StopReason::Finished;
    Ok(ended.then(|| (cdt.to_indexed(&drawing), report, drawing)))
}

fn options(degrees: f64) -> RefineOptions {
    RefineOptions::default().with_min_angle_deg(degrees).with_max_vertices(BUDGET)
}

/// Claim 1. Without the drawing, segments that bend by less than rounding may be joined that were apart, and others
/// that rounding bent may stay apart: where that matters, what comes of the first refinement comes back.
fn comes_back(drawing: &Pslg, options: RefineOptions, with_drawing: bool, bent: bool) -> Verdict {
    let Some((mesh, report, drawing)) = meshed(drawing, options)? else { return Ok(()) };
    let input = with_drawing.then_some(&drawing);
    let taken = from_mesh(&mesh, &[], input).map_err(|e| e.to_string())?;
    none("taken up: library checker", &taken.cdt.check_delaunay())?;
    let again = refine_mesh(&mesh, input, &options).map_err(|e| e.to_string())?;
    let no_room = report.leftovers.iter().any(|l| matches!(l.reason, Reason::PrecisionFloor | Reason::InputGap));
    if !with_drawing && (bent || no_room) {
        let once_more = refine_mesh(&again.mesh, input, &options).map_err(|e| e.to_string())?;
        return same_mesh((&again.mesh, &again.report), (&once_more.mesh, &once_more.report));
    }
    same_mesh((&mesh, &report), (&again.mesh, &again.report))
}

fn same_mesh((mesh, report): (&IndexedMesh, &Report), (again, and_then): (&IndexedMesh, &Report)) -> Verdict {
    let added = again.points.len() - mesh.points.len();
    if added > 0 {
        let (was, is) = (report.reasons(), and_then.reasons());
        return Err(format!("{added} vertices added to {}; reasons {was:?}, then {is:?}", mesh.points.len()));
    }
    equal("triangles", &again.triangles, &mesh.triangles)?;
    equal("segments", &again.segments, &mesh.segments)?;
    equal("markers", &again.segment_markers, &mesh.segment_markers)?;
    equal("point markers", &again.point_markers, &mesh.point_markers)?;
    equal("leftovers", &and_then.leftovers.len(), &report.leftovers.len())
}

/// Claim 2.
fn only_adds(drawing: &Pslg, degrees: f64, with_drawing: bool) -> Verdict {
    let Some((mesh, _, drawing)) = meshed(drawing, options(degrees))? else { return Ok(()) };
    let input = with_drawing.then_some(&drawing);
    let finer = options(degrees + 4.0);
    let taken = from_mesh(&mesh, &[], input).map_err(|e| e.to_string())?;
    let mut refinement = Refinement::new(taken.cdt, finer).map_err(|e| e.to_string())?;
    refinement.run(&mut NoObserver);
    let (cdt, report) = refinement.finish();
    none("library checker", &cdt.check_delaunay())?;
    let fine = taken.given.to_indexed(&cdt);
    let old = mesh.points.len();
    let bits = |points: &[Point]| points.iter().map(|p| [p.x.to_bits(), p.y.to_bits()]).collect::<Vec<_>>();
    equal("old vertices", &bits(&fine.points[..old.min(fine.points.len())]), &bits(&mesh.points))?;
    equal("vertices reported", &report.vertices, &fine.points.len())?;
    none("mesh checker", &check_mesh(&fine))?;
    none("against input", &against_input(&fine, &drawing).faults)?;
    // Without the drawing every old vertex counts as input.
    let fine = IndexedMesh { input_points: drawing.points.len(), ..fine };
    if !check_indexed_with(&mesh, Some(&drawing), DelaunayRule::Canonical).is_empty() {
        return Ok(()); // Bent by crossings farther than that checker follows a segment: so it was before.
    }
    none("testkit checker", &check_indexed_with(&fine, Some(&drawing), DelaunayRule::Canonical))
}

/// Every kind, twenty-six of each: a thousand, judged with the drawing and without.
fn drawings() -> impl Iterator<Item = (String, f64, Pslg)> {
    PslgKind::ALL.into_iter().flat_map(|kind| {
        (0..26).map(move |seed| {
            let n = [6, 12, 24, 40][seed as usize % 4];
            let degrees = 20.0 + 8.0 * (seed % 9) as f64 / 8.0;
            let drawing = pslg(kind, n, seed + 1);
            let drawing = if seed % 3 == 2 { rotated(&drawing, 0.3) } else { drawing };
            (format!("{kind:?} n {n} seed {seed} at {degrees}"), degrees, drawing)
        })
    })
}

#[test]
fn with_its_drawing_a_mesh_comes_back() {
    let mut failures = Failures::default();
    for (name, degrees, drawing) in drawings() {
        failures.check(&name, &drawing, |d| comes_back(d, options(degrees), true, false));
    }
    failures.expect_none();
}

#[test]
fn without_its_drawing_a_mesh_comes_back() {
    let mut failures = Failures::default();
    for (name, degrees, drawing) in drawings() {
        // In float soups 1 and 1 + ulp are coordinates: crossings bend segments by more than joints may.
        let bent = name.starts_with("FloatSoup");
        failures.check(&name, &drawing, |d| comes_back(d, options(degrees), false, bent));
    }
    failures.expect_none();
}

#[test]
fn tighter_bounds_only_add() {
    let mut failures = Failures::default();
    for (i, (name, degrees, drawing)) in drawings().enumerate() {
        failures.check(&name, &drawing, |d| only_adds(d, degrees, i % 2 == 0));
    }
    failures.expect_none();
}

/// A unit square of two triangles.
fn square() -> IndexedMesh {
    let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from).to_vec();
    IndexedMesh { points, triangles: vec![[0, 1, 2], [0, 2, 3]], ..IndexedMesh::default() }
}

/// Whether taking a mesh up fails with a fault of that kind.
fn has_fault(mesh: &IndexedMesh, kind: impl Fn(&MeshFault) -> bool) -> bool {
    match refine_mesh(mesh, None, &RefineOptions::default()) {
        Err(Error::Mesh(MeshError::Faults(faults))) => faults.iter().any(kind),
        _ => false,
    }
}

#[test]
fn what_is_no_mesh_is_refused_by_name() {
    let with = |change: &dyn Fn(&mut IndexedMesh)| {
        let mut mesh = square();
        change(&mut mesh);
        mesh
    };
    let inverted = with(&|m| m.triangles[1] = [0, 3, 2]);
    assert!(has_fault(&inverted, |f| matches!(f, MeshFault::NotCounterClockwise { triangle: 1, .. })));
    let missing = with(&|m| m.triangles[0] = [0, 1, 7]);
    assert!(has_fault(&missing, |f| matches!(f, MeshFault::IndexOutOfRange { triangle: 0, vertex: 7, .. })));
    let doubled = with(&|m| m.triangles.push([0, 1, 2]));
    assert!(has_fault(&doubled, |f| matches!(f, MeshFault::EdgeUsedTwice { .. })));
    let overlapping = with(&|m| {
        m.points.extend([[0.25, 0.25], [0.75, 0.25], [0.5, 0.75]].map(Point::from));
        m.triangles.push([4, 5, 6]);
    });
    assert!(has_fault(&overlapping, |f| matches!(f, MeshFault::Overlap { .. })));
    let joint = with(&|m| {
        m.points.extend([[1.0, 0.5], [2.0, 0.5]].map(Point::from));
        m.triangles.push([4, 5, 2]);
    });
    assert!(has_fault(&joint, |f| matches!(f, MeshFault::BoundaryContact { .. })));
    let repeated = with(&|m| {
        m.points.push(m.points[2]);
        m.triangles[1] = [0, 4, 3];
    });
    assert!(has_fault(&repeated, |f| matches!(f, MeshFault::DuplicateVertices(_))));
    let segment = with(&|m| m.segments.push([1, 3]));
    assert!(has_fault(&segment, |f| matches!(f, MeshFault::SegmentNotAnEdge { segment: 0, .. })));
    let nothing = with(&|m| m.triangles.clear());
    assert_eq!(refine_mesh(&nothing, None, &RefineOptions::default()), Err(Error::Mesh(MeshError::NoTriangles)));
}

#[test]
fn another_drawing_is_refused_by_name() {
    let mesh = square();
    let ring = vec![[0, 1], [1, 2], [2, 3], [3, 0]];
    let drawing = Pslg { points: mesh.points.clone(), segments: ring, ..Pslg::default() };
    let refine = |drawing: &Pslg| refine_mesh(&mesh, Some(drawing), &RefineOptions::default());
    assert!(refine(&drawing).is_ok());
    let mut moved = drawing.clone();
    moved.points[2].x = 1.5;
    assert!(matches!(refine(&moved), Err(Error::Mesh(MeshError::VertexChanged { vertex: 2, .. }))));
    let mut more = drawing.clone();
    more.points.push(Point::new(0.5, 0.5));
    assert!(matches!(refine(&more), Err(Error::Mesh(MeshError::FewerVertices { found: 4, expected: 5 }))));
    let mut crossed = drawing.clone();
    crossed.segments.push([1, 3]);
    assert!(matches!(refine(&crossed), Err(Error::NotOfDrawing(faults)) if faults.len() == 1));
    let mut wild = drawing;
    wild.segments.push([1, 9]);
    assert!(matches!(refine(&wild), Err(Error::Mesh(MeshError::Drawing(_)))));
}

#[test]
fn separate_pieces_and_touching_ones_are_meshes() {
    let mut mesh = square();
    mesh.points.extend([[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [5.0, 5.0], [6.0, 5.0], [5.0, 6.0]].map(Point::from));
    mesh.triangles.extend([[2, 5, 6], [7, 8, 9]]); // One touches in vertex 2, one lies apart; vertex 4 is unused.
    let taken = from_mesh(&mesh, &[], None).unwrap();
    assert_eq!(taken.cdt.check(), []);
    assert_eq!(taken.cdt.duplicates().len(), 1);
    assert!(taken.warnings.contains(&Warning::Pieces { pieces: 3 }));
    let options = RefineOptions::default().with_max_area(0.01);
    let Meshed { mesh: fine, report, .. } = refine_mesh(&mesh, None, &options).unwrap();
    assert!(report.complete());
    assert_eq!(check_mesh(&fine), []);
    assert_eq!(fine.points[..mesh.points.len()], mesh.points);
}

/// A flat quadrilateral cut along its long diagonal: not Delaunay.
fn flat() -> IndexedMesh {
    let points = [[0.0, 0.0], [4.0, -1.0], [8.0, 0.0], [4.0, 1.0]].map(Point::from).to_vec();
    IndexedMesh { points, triangles: vec![[0, 1, 2], [0, 2, 3]], ..IndexedMesh::default() }
}

#[test]
fn what_is_not_delaunay_is_flipped_only_by_recipes_that_flip() {
    let none = |preset| RefineOptions::of(preset).with_min_angle_deg(0.0);
    let flipped = refine_mesh(&flat(), None, &none(Preset::OffCenter)).unwrap();
    assert_eq!(flipped.report.edges_flipped, 1);
    assert!(flipped.warnings.contains(&Warning::Flipped { flips: 1 }));
    assert!(flipped.mesh.triangles.iter().all(|t| t.contains(&1) && t.contains(&3)));
    let kept = refine_mesh(&flat(), None, &none(Preset::LeppBisection)).unwrap();
    assert_eq!((kept.mesh.triangles, kept.report.edges_flipped), (flat().triangles, 0));
    let halved = refine_mesh(&flat(), None, &none(Preset::LeppBisection).with_max_area(1.0)).unwrap();
    assert_eq!(check_mesh(&halved.mesh), []);
    let on_diagonal = |p: &Point| p.y == 0.0;
    assert!(halved.mesh.points.iter().filter(|p| on_diagonal(p)).count() > 2, "the long diagonal was halved");
}

#[test]
fn attributes_are_handed_down_and_their_boundaries_stay() {
    let mut mesh = flat();
    (mesh.attributes_per_triangle, mesh.triangle_attributes) = (2, vec![1.0, 10.0, 2.0, 20.0]);
    let options = RefineOptions::default().with_max_area(0.1);
    let Meshed { mesh: fine, warnings, .. } = refine_mesh(&mesh, None, &options).unwrap();
    assert!(warnings.contains(&Warning::RegionBoundaries { edges: 1 }));
    assert_eq!(fine.attributes_per_triangle, 2);
    for (t, row) in fine.triangles.iter().zip(fine.triangle_attributes.chunks(2)) {
        let y: f64 = t.iter().map(|&v| fine.points[v as usize].y).sum();
        assert_eq!(row, if y < 0.0 { [1.0, 10.0] } else { [2.0, 20.0] });
    }
}

#[test]
fn area_bounds_hold_by_place() {
    let mesh = square();
    let areas = [Some(0.002), None];
    let options = RefineOptions::default().with_min_angle_deg(20.0);
    let fine = refine_mesh_with(&mesh, &areas, None, &options, &mut NoObserver).unwrap();
    assert!(fine.report.complete() && fine.report.leftovers.is_empty());
    let area = |[a, b, c]: [Point; 3]| (b - a).cross(c - a) / 2.0;
    let mut largest = [0.0_f64; 2];
    for corners in fine.mesh.triangles.iter().map(|t| t.map(|v| fine.mesh.points[v as usize])) {
        let [a, b, c] = corners;
        let above = a.y + b.y + c.y > a.x + b.x + c.x; // The first triangle lies below the diagonal.
        largest[usize::from(above)] = largest[usize::from(above)].max(area(corners));
    }
    assert!(largest[0] <= 0.002 && largest[1] > 0.002, "{largest:?}");
    let wrong = refine_mesh_with(&mesh, &areas[..1], None, &options, &mut NoObserver);
    assert_eq!(wrong, Err(Error::Mesh(MeshError::AreaCount { found: 1, expected: 2 })));
}

#[test]
fn the_drawing_tells_segments_and_free_vertices_apart() {
    let points = [[0.0, 0.0], [3.0, 1.0], [1.0, 3.0]].map(Point::from).to_vec();
    let regions = vec![Region { seed: Point::new(1.0, 1.0), attribute: 7.0, max_area: Some(0.05) }];
    let drawing = Pslg { points, segments: vec![[0, 1], [1, 2], [2, 0]], regions, ..Pslg::default() };
    let Meshed { mesh, report, .. } = trimalla::mesh(&drawing, &MeshOptions::default()).unwrap();
    assert!(report.complete() && report.segments_split > 0);
    let with = from_mesh(&mesh, &[], Some(&drawing)).unwrap().cdt;
    assert_eq!(with.segments().len(), 3);
    let kinds: Vec<Provenance> = with.used_vertices().map(|v| with.provenance(v)).collect();
    assert!(kinds[..3].iter().all(|p| *p == Provenance::Input));
    let on_segments = kinds[3..].iter().filter(|p| !p.is_free()).count();
    assert_eq!(on_segments as u64, report.segments_split);
    // Without it the corners still end the chains, and nothing is free.
    let taken = from_mesh(&mesh, &[], None).unwrap();
    assert_eq!(taken.cdt.segments().len(), 3);
    assert!(taken.cdt.used_vertices().all(|v| !taken.cdt.provenance(v).is_free()));
    assert!(taken.warnings.contains(&Warning::Rejoined { chains: 3, subsegments: mesh.segments.len() }));
    let again = refine_mesh(&mesh, Some(&drawing), &RefineOptions::default()).unwrap();
    assert_eq!(again.mesh, mesh);
}
