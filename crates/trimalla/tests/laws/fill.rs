//! Wide parts filled with a lattice under an area bound.
//!
//! *Inputs*: every kind of drawing that the testkit knows (crossings split), at several sizes and seeds; squares,
//! combs, two regions, all under area bounds that ask for some hundred triangles.
//!
//! *Claims*
//! 1. Triangles above the bound are explained; all checkers find the mesh sound; every builder gives the same one.
//! 2. Refined again with its drawing it comes back as it is.
//! 3. Where there is room the mesh is hardly larger than the area asks for, also where the domain is no convex one; on
//!    all drawings together it is smaller by a tenth, on none twice as large (where a gap is 1e-16 wide, where its
//!    sides are cut matters). Above 30 degrees nothing is filled.
//! 4. Each region has the lattice of its own bound.
//! 5. Protected segments stay whole, the length floor holds, and a lattice beyond the vertex budget is not begun.
//! 6. Every step can be taken back.

#![allow(clippy::print_stdout, reason = "sizes with and without, for whoever asks with --nocapture")]

use std::cell::Cell;

use crate::common::failures::{Failures, Verdict, equal, none};
use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build};
use trimalla::drawing::{IndexedMesh, Pslg, Region};
use trimalla::geometry::Point;
use trimalla::half_edge::FaceId;
use trimalla::quality::against_input;
use trimalla::refine::{Fill, NoObserver, Protect, RefineOptions, Refinement, Report, StepOutcome, StopReason};
use trimalla::triangulation::check_mesh;
use trimalla::{MeshOptions, mesh, refine_mesh};
use trimalla_testkit::generators::{PslgKind, pslg};

const BUDGET: usize = 20_000;

fn bounded(degrees: f64, area: f64) -> RefineOptions {
    RefineOptions::default().with_min_angle_deg(degrees).with_max_area(area).with_max_vertices(BUDGET)
}

fn unfilled(options: RefineOptions) -> RefineOptions {
    let mut options = options;
    options.recipe.fill = Fill::None;
    options
}

fn square(side: f64) -> Pslg {
    Pslg::of_ring([[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]])
}

/// A back with `teeth` teeth of width 1 and length 9, as far apart as they are wide.
fn comb(teeth: u8) -> Pslg {
    let mut corners = vec![[0.0, 0.0], [2.0 * f64::from(teeth) - 1.0, 0.0]];
    for tooth in (0..teeth).rev() {
        let left = 2.0 * f64::from(tooth);
        corners.extend([[left + 1.0, 10.0], [left, 10.0]]);
        if tooth > 0 {
            corners.extend([[left, 1.0], [left - 1.0, 1.0]]);
        }
    }
    Pslg::of_ring(corners)
}

fn meshed(drawing: &Pslg, refine: RefineOptions) -> (IndexedMesh, Report) {
    let trimalla::Meshed { mesh, report, .. } =
        mesh(drawing, &MeshOptions { refine, ..MeshOptions::default() }).expect("a sound drawing");
    assert_eq!(report.stop, StopReason::Finished);
    (mesh, report)
}

fn area_of(mesh: &IndexedMesh, t: [u32; 3]) -> f64 {
    let [a, b, c] = t.map(|v| mesh.points[v as usize]);
    0.5 * (b - a).cross(c - a)
}

/// The domain by seeds, or else the hull; by one builder or the other.
fn carved(drawing: &Pslg, algorithm: AlgorithmKey) -> Option<(ConstrainedDelaunay, Pslg)> {
    let whole = Pslg { holes: Vec::new(), ..drawing.clone() };
    let by = |drawing: &Pslg, rule| build(drawing, rule, Crossings::Split, algorithm).ok().map(|(cdt, _)| cdt);
    let seeds = by(drawing, DomainRule::Seeds).map(|cdt| (cdt, drawing.clone()));
    seeds.or_else(|| by(&whole, DomainRule::Hull).map(|cdt| (cdt, whole.clone())))
}

/// Claims 1 and 2; adds the triangles with and without a lattice to `sizes`.
fn judge(drawing: &Pslg, degrees: f64, parts: f64, sizes: [&Cell<usize>; 2]) -> Verdict {
    let Some((cdt, _)) = carved(drawing, AlgorithmKey::default()) else { return Ok(()) };
    let area = cdt.real_faces().map(|f| 0.5 * area_doubled(&cdt, f)).sum::<f64>() / parts;
    if !(area > 0.0 && area.is_finite()) {
        return Ok(());
    }
    let options = bounded(degrees, area);
    let mut results = Vec::new();
    for algorithm in [AlgorithmKey::Incremental, AlgorithmKey::DivideAndConquer] {
        let Some((cdt, drawing)) = carved(drawing, algorithm) else { return Err("built by one only".into()) };
        let mut refinement = Refinement::new(cdt, options).map_err(|e| e.to_string())?;
        let stop = refinement.run(&mut NoObserver);
        let (cdt, report) = refinement.finish();
        none("library checker", &cdt.check())?;
        results.push((cdt.canonical(), cdt.to_indexed(&drawing), report, stop, drawing));
    }
    let (canonical, mesh, report, stop, drawing) = &results[0];
    for other in &results[1..] {
        equal("builders", &other.0, canonical)?;
        equal("points of builders", &other.1.points, &mesh.points)?;
    }
    none("mesh checker", &check_mesh(mesh))?;
    none("against input", &against_input(mesh, drawing).faults)?;
    let explained: Vec<usize> = report.leftovers.iter().map(|l| l.triangle).collect();
    // The area from another corner rounds differently, that of a needle altogether.
    let is_large = |t: &usize| {
        let [a, b, c] = mesh.triangles[*t];
        [[a, b, c], [b, c, a], [c, a, b]].into_iter().all(|t| area_of(mesh, t) > area * (1.0 + 1e-12))
    };
    let large: Vec<usize> = (0..mesh.triangles.len()).filter(is_large).collect();
    let unexplained: Vec<&usize> = large.iter().filter(|t| !explained.contains(t)).collect();
    none("large triangles unexplained", &unexplained)?;
    let (cdt, _) = carved(drawing, AlgorithmKey::default()).ok_or("built once only")?;
    let mut plain = Refinement::new(cdt, unfilled(options)).map_err(|e| e.to_string())?;
    let is_comparable = plain.run(&mut NoObserver) == StopReason::Finished && *stop == StopReason::Finished;
    let plain = plain.finish().1.triangles;
    if is_comparable {
        let [with, without] = sizes;
        with.set(with.get() + report.triangles);
        without.set(without.get() + plain);
        if report.triangles > 2 * plain + 10 {
            return Err(format!("{} triangles where {plain} do without a lattice", report.triangles));
        }
    }
    if *stop != StopReason::Finished || !report.leftovers.is_empty() {
        return Ok(());
    }
    let again = refine_mesh(mesh, Some(drawing), &options).map_err(|e| e.to_string())?;
    equal("vertices when refined again", &again.mesh.points.len(), &mesh.points.len())
}

fn area_doubled(cdt: &ConstrainedDelaunay, f: FaceId) -> f64 {
    let [a, b, c] = cdt.face_points(f);
    (b - a).cross(c - a)
}

#[test]
fn every_kind_of_drawing() {
    let mut failures = Failures::default();
    let (with, without) = (Cell::new(0), Cell::new(0));
    for kind in PslgKind::ALL {
        for seed in 0..4u64 {
            let drawing = pslg(kind, [5, 12, 30][seed as usize % 3], seed + 1);
            for (degrees, parts) in [(0.0, 150.0), (25.0, 40.0), (30.0, 600.0)] {
                failures.check(&format!("{kind:?} seed {seed} at {degrees}, {parts}"), &drawing, |d| {
                    judge(d, degrees, parts, [&with, &without])
                });
            }
        }
    }
    failures.expect_none();
}

/// Claim 3: the triangles over those that the area asks for.
fn excess(drawing: &Pslg, options: RefineOptions) -> f64 {
    let (mesh, report) = meshed(drawing, options);
    assert_eq!(report.leftovers, []);
    let area = mesh.triangles.iter().map(|&t| area_of(&mesh, t)).sum::<f64>();
    mesh.triangles.len() as f64 / (area / options.criteria.max_area.unwrap_or(f64::NAN))
}

#[test]
fn where_there_is_room_a_mesh_is_as_small_as_its_area_allows() {
    for degrees in [0.0, 20.0, 30.0] {
        for (drawing, area) in [(square(1.0), 2e-4), (comb(6), 0.004), (square(1e6), 2e8), (square(1e-9), 2e-22)] {
            let options = bounded(degrees, area);
            let (with, without) = (excess(&drawing, options), excess(&drawing, unfilled(options)));
            println!("{area} at {degrees}: {with:.3} of the least, {without:.3} without");
            assert!(with < 1.3 && with < 0.85 * without, "{area} at {degrees}: {with} {without}");
        }
    }
}

#[test]
fn above_30_degrees_nothing_is_filled() {
    let options = bounded(31.0, 1e-3);
    assert_eq!(meshed(&square(1.0), options).0, meshed(&square(1.0), unfilled(options)).0);
    let by_ratio = bounded(0.0, 1e-3).with_max_aspect_ratio(1.29);
    let made = |refine| mesh(&square(1.0), &MeshOptions { refine, ..MeshOptions::default() }).expect("meshed").mesh;
    assert_eq!(made(by_ratio), made(unfilled(by_ratio)));
}

#[test]
fn each_region_has_a_lattice_of_its_own() {
    let mut drawing = square(8.0);
    drawing.points.extend([[4.0, 0.0], [4.0, 8.0]].map(Point::from));
    drawing.segments = vec![[0, 4], [4, 1], [1, 2], [2, 5], [5, 3], [3, 0], [4, 5]];
    let region =
        |x: f64, attribute: f64, area: f64| Region { seed: Point::new(x, 1.0), attribute, max_area: Some(area) };
    drawing.regions = vec![region(1.0, 1.0, 0.01), region(7.0, 2.0, 0.08)];
    let (mesh, report) = meshed(&drawing, RefineOptions::default());
    assert_eq!(report.leftovers, []);
    for (attribute, bound) in [(1.0, 0.01), (2.0, 0.08)] {
        let of_region = |t: &&[u32; 3]| area_of(&mesh, **t) <= bound;
        let triangles = mesh.triangles.iter().zip(&mesh.triangle_attributes).filter(|(_, a)| **a == attribute);
        let triangles: Vec<[u32; 3]> = triangles.map(|(t, _)| *t).collect();
        assert!(triangles.iter().all(|t| of_region(&t)));
        let least = 32.0 / bound;
        assert!((triangles.len() as f64) < 2.0 * least, "{} in {attribute}, {least}", triangles.len());
    }
}

#[test]
fn protected_segments_stay_whole() {
    let drawing = square(1.0);
    let options = bounded(20.0, 1e-3).with_protect(Protect::All);
    let (mesh, report) = meshed(&drawing, options);
    assert_eq!(mesh.segments.len(), 4);
    assert_eq!(report.segments_split, 0);
    assert_eq!(check_mesh(&mesh), []);
}

#[test]
fn a_lattice_beyond_the_budget_is_not_begun() {
    let drawing = square(1.0);
    for area in [1e-9, 1e-80, 1e-300, f64::MIN_POSITIVE, 5e-324] {
        let options = RefineOptions::default().with_max_area(area).with_max_vertices(300);
        let report = mesh(&drawing, &MeshOptions { refine: options, ..MeshOptions::default() }).expect("meshed").report;
        assert_eq!(report.stop, StopReason::Budget, "{area}");
        assert!(report.vertices <= 300 && report.leftovers.len() > 10, "{area}: {}", report.vertices);
    }
}

#[test]
fn the_length_floor_holds() {
    for floor in [0.03, 0.06, 0.1, 0.5] {
        let mut options = bounded(0.0, 1e-3);
        options.limits.length_floor = Some(floor);
        let (mesh, _) = meshed(&square(1.0), options);
        let length = |p: u32, q: u32| (mesh.points[p as usize] - mesh.points[q as usize]).length_sq().sqrt();
        let edges = mesh.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let shortest = edges.map(|[p, q]| length(p, q)).fold(f64::INFINITY, f64::min);
        assert!(shortest >= floor, "{shortest} where the floor is {floor}");
    }
}

#[test]
fn every_step_can_be_taken_back() {
    let (cdt, _) = carved(&comb(2), AlgorithmKey::default()).expect("a domain");
    let mut refinement = Refinement::new(cdt, bounded(25.0, 0.06)).expect("options");
    let mut states = vec![refinement.triangulation().clone()];
    let mut nodes = 0;
    loop {
        let event = refinement.step();
        assert_eq!(refinement.triangulation().check(), []);
        states.push(refinement.triangulation().clone());
        if event.outcome == StepOutcome::Filled {
            let node = event.inserted.map(|i| refinement.triangulation().point(i.vertex) == i.point);
            assert_ne!(node, Some(false));
            nodes += usize::from(node.is_some());
        }
        if event.outcome == StepOutcome::Finished {
            break;
        }
    }
    assert!(nodes > 20, "{nodes} nodes");
    for state in states.iter().rev().skip(1) {
        assert!(refinement.back() && refinement.triangulation() == state);
    }
    refinement.run_until(|_| false);
    assert!(Some(refinement.triangulation()) == states.last(), "forward again it goes the same way");
}
