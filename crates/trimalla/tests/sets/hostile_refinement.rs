//! Refinement of drawings that have broken refiners: it ends, the mesh is sound, and what stays bad is explained.
//!
//! *Inputs*: every kind of drawing that the testkit knows (those that cross are split), at angle bounds of 0, 20, 30,
//! 36, 45 and 60 degrees, by every preset, with a budget of 3000 vertices; the same scaled by powers of two and moved
//! to UTM coordinates; segments that may not be split; and a list of named cases: small input angles, arms of
//! irrational ratio, parallel segments a millionth apart, hubs, needles, edges an ulp long.
//!
//! *Claims*
//! 1. The run ends within its budget, and the triangulation passes the library's full check; the mesh passes both
//!    checkers of plain meshes.
//! 2. Input vertices are the caller's, bit for bit; every segment is a chain of edges.
//! 3. The leftovers are exactly the triangles below the bound, each listed once, in order, with a reason; the counts
//!    by reason add up. Where neither the budget nor precision was met, at bounds up to 26.45 degrees, only the
//!    input's own angles are reasons.
//! 4. Protected segments are parted by nothing.
//! 5. A drawing times a power of two gives the same mesh times that power, triangle by triangle.
//! 6. Refining the result again adds nothing.

#![allow(clippy::print_stdout, reason = "tables for those who look")]

use std::cell::RefCell;

use crate::common::failures::{Failures, Verdict, equal, none};
use trimalla::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainError, DomainRule, build};
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::{Angle, Point};
use trimalla::quality::{against_input, below_bound};
use trimalla::refine::{Insert, NoObserver, Preset, Protect, Reason, RefineOptions, Refinement, Report, StopReason};
use trimalla::triangulation::check_mesh;
use trimalla_testkit::generators::{PslgKind, moved_to_utm, pslg, scaled};
use trimalla_testkit::oracles::{DelaunayRule, canonical, check_indexed, check_indexed_with};

/// The angle bounds.
const ANGLES_DEG: [f64; 6] = [0.0, 20.0, 30.0, 36.0, 45.0, 60.0];
/// The vertex budget.
const BUDGET: usize = 3000;
/// The budget of what is not promised to end by itself.
const SMALL_BUDGET: usize = 4000;
/// Up to this bound only the input's angles keep triangles bad.
const PROMISED_DEG: f64 = 26.45;

/// What came of a run.
struct Outcome {
    cdt: ConstrainedTriangulation,
    mesh: IndexedMesh,
    report: Report,
}

/// The domain of a drawing by its seeds, or where it has none its hull; nothing where it is flat.
fn domain_of(drawing: &Pslg) -> Result<Option<(ConstrainedDelaunay, Pslg)>, String> {
    let seeds = |drawing: &Pslg, rule| build(drawing, rule, Crossings::Split, AlgorithmKey::default());
    match seeds(drawing, DomainRule::Seeds) {
        Ok((cdt, _)) => return Ok(Some((cdt, drawing.clone()))),
        Err(DomainError::Flat { .. }) => return Ok(None),
        Err(DomainError::Constraint(e)) => return Err(e.to_string()),
        Err(_) => {}
    }
    let whole = Pslg { holes: Vec::new(), ..drawing.clone() };
    let (cdt, _) = seeds(&whole, DomainRule::Hull).map_err(|e| e.to_string())?;
    Ok(Some((cdt, whole)))
}

fn refined(drawing: &Pslg, options: RefineOptions) -> Result<Option<Outcome>, String> {
    let Some((cdt, drawing)) = domain_of(drawing)? else { return Ok(None) };
    let mut refinement = Refinement::new(cdt, options).map_err(|e| e.to_string())?;
    refinement.run(&mut NoObserver);
    let (cdt, report) = refinement.finish();
    let mesh = cdt.to_indexed(&drawing);
    Ok(Some(Outcome { cdt, mesh, report }))
}

/// Claims 1 to 3, and 6 for those that ended by themselves.
fn judge(drawing: &Pslg, options: RefineOptions) -> Verdict {
    judged(drawing, options).map(drop)
}

/// The report of a run, judged; nothing where the drawing is flat.
fn judged(drawing: &Pslg, options: RefineOptions) -> Result<Option<Report>, String> {
    let Some(Outcome { cdt, mesh, report }) = refined(drawing, options)? else { return Ok(None) };
    if matches!(options.recipe.insert, Insert::Partition | Insert::FlipOrCentroid) {
        none("library checker", &cdt.check())?;
        none("testkit checker", &check_indexed_with(&mesh, Some(drawing), DelaunayRule::Ignore))?;
    } else {
        none("library checker", &cdt.check_delaunay())?;
        none("testkit checker", &check_indexed(&mesh, Some(drawing)))?;
    }
    none("mesh checker", &check_mesh(&mesh))?;
    none("against input", &against_input(&mesh, drawing).faults)?;
    let begun_with = domain_of(drawing)?.map_or(0, |(cdt, _)| cdt.input_points() + cdt.steiner_vertices());
    let most = options.limits.max_vertices.max(begun_with);
    if mesh.points.len() > most {
        return Err(format!("{} vertices, {most} are allowed", mesh.points.len()));
    }
    reasons(&mesh, &report, options)?;
    Ok(Some(report))
}

/// Claim 3.
fn reasons(mesh: &IndexedMesh, report: &Report, options: RefineOptions) -> Verdict {
    let bound = options.criteria.min_angle;
    let listed: Vec<usize> = report.leftovers.iter().map(|l| l.triangle).collect();
    let below = if bound.degrees() > 0.0 { below_bound(mesh, bound) } else { Vec::new() };
    equal("triangles left over", &listed, &below)?;
    let sum: usize = report.reasons().iter().map(|r| r.1).sum();
    equal("sum of reasons", &sum, &listed.len())?;
    equal("vertices", &report.vertices, &mesh.points.len())?;
    equal("triangles", &report.triangles, &mesh.triangles.len())?;
    let has = |r: Reason| report.leftovers.iter().any(|l| l.reason == r);
    if has(Reason::Budget) && report.stop != StopReason::Budget {
        return Err("budget is a reason though it was not met".to_owned());
    }
    let protected = options.protect == Protect::None && has(Reason::ProtectedSegment);
    if protected || has(Reason::Cancelled) || has(Reason::SizeFloor) {
        return Err(format!("reasons that cannot be: {:?}", report.reasons()));
    }
    let met_limit = report.stop == StopReason::Budget || has(Reason::PrecisionFloor);
    if is_promised(options) && !met_limit && !report.complete() {
        return Err(format!("reasons that should not be: {:?}", report.reasons()));
    }
    Ok(())
}

fn options(preset: Preset, degrees: f64) -> RefineOptions {
    RefineOptions::of(preset).with_min_angle_deg(degrees).with_max_vertices(BUDGET)
}

/// Drawings whose crossings are split without end are the concern of `constrained_sets`.
fn drawings(n: usize) -> impl Iterator<Item = (PslgKind, Pslg)> {
    PslgKind::ALL.into_iter().map(move |kind| (kind, pslg(kind, n, 3)))
}

/// Up to 26.45 degrees these leave only what the input's angles force: the first two as promised, the third as seen.
const PROMISED: [Preset; 3] = [Preset::OffCenter, Preset::Circumcenter, Preset::LeppCentroid];

fn is_promised(options: RefineOptions) -> bool {
    let by = PROMISED.iter().any(|p| p.recipe() == options.recipe);
    by && options.protect == Protect::None && options.criteria.min_angle.degrees() <= PROMISED_DEG
}

#[test]
fn every_kind_at_every_angle_by_every_preset() {
    let mut failures = Failures::default();
    for (kind, drawing) in drawings(24) {
        for preset in Preset::ALL {
            for degrees in ANGLES_DEG {
                failures
                    .check(&format!("{kind:?} {preset} {degrees}"), &drawing, |d| judge(d, options(preset, degrees)));
            }
        }
    }
    failures.expect_none();
}

#[test]
fn area_bounds_are_met_or_explained() {
    let mut failures = Failures::default();
    for (kind, drawing) in drawings(16) {
        failures.check(&format!("{kind:?}"), &drawing, |d| {
            let Some((cdt, _)) = domain_of(d)? else { return Ok(()) };
            let Some(b) = cdt.bounding_box() else { return Ok(()) };
            let area = (b.max.x - b.min.x) * (b.max.y - b.min.y) / 300.0;
            if !(area > 0.0 && area.is_finite()) {
                return Ok(());
            }
            let Some(out) = refined(d, options(Preset::OffCenter, 20.0).with_max_area(area))? else { return Ok(()) };
            none("library checker", &out.cdt.check_delaunay())?;
            let large = |t: &[u32; 3]| {
                let [a, b, c] = t.map(|v| out.mesh.points[v as usize]);
                (b - a).cross(c - a) > 2.0 * area
            };
            let below = below_bound(&out.mesh, Angle::from_degrees(20.0));
            let bad: Vec<usize> = (0..out.mesh.triangles.len())
                .filter(|t| large(&out.mesh.triangles[*t]) || below.binary_search(t).is_ok())
                .collect();
            equal("triangles left over", &out.report.leftovers.iter().map(|l| l.triangle).collect(), &bad)
        });
    }
    failures.expect_none();
}

#[test]
fn protected_segments_stay_one_edge() {
    let mut failures = Failures::default();
    for (kind, drawing) in drawings(24) {
        for protect in [Protect::Boundary, Protect::All] {
            for degrees in [20.0, 33.0] {
                failures.check(&format!("{kind:?} {protect:?} {degrees}"), &drawing, |d| {
                    let options = options(Preset::OffCenter, degrees).with_protect(protect);
                    let (Some((before, _)), Some(after)) = (domain_of(d)?, refined(d, options)?) else { return Ok(()) };
                    kept_whole(&before, &after.cdt, protect)?;
                    judge(d, options)
                });
            }
        }
    }
    failures.expect_none();
}

/// Every constrained edge that is protected is still there.
fn kept_whole(before: &ConstrainedTriangulation, after: &ConstrainedTriangulation, protect: Protect) -> Verdict {
    let boundary = |h| before.is_inner_side_of_boundary(h) || before.is_inner_side_of_boundary(before.twin(h));
    for h in before.edges().filter(|&h| before.is_marked(h) && (protect == Protect::All || boundary(h))) {
        let (a, b) = (before.origin(h), before.dest(h));
        if !after.half_edge_between(a, b).is_some_and(|h| after.is_marked(h)) {
            return Err(format!("the protected edge from {a} to {b} was parted"));
        }
    }
    Ok(())
}

/// Named: a length floor is kept, and named where it is the reason.
#[test]
fn length_floors_are_kept() {
    let mut failures = Failures::default();
    for (kind, drawing) in drawings(24) {
        failures.check(&format!("{kind:?}"), &drawing, |d| {
            let mut options = options(Preset::OffCenter, 30.0);
            options.limits.length_floor = Some(0.05);
            let (Some((before, _)), Some(after)) = (domain_of(d)?, refined(d, options)?) else { return Ok(()) };
            none("library checker", &after.cdt.check_delaunay())?;
            let old = before.points().len();
            for h in after.cdt.edges() {
                let [a, b] = after.cdt.edge_points(h);
                let new = after.cdt.origin(h).index() >= old || after.cdt.dest(h).index() >= old;
                let length = (b - a).length_sq().sqrt();
                if new && length < 0.05 * (1.0 - 1e-9) {
                    return Err(format!("a new edge from {a} to {b} is {length} long"));
                }
            }
            Ok(())
        });
    }
    failures.expect_none();
}

#[test]
fn scales_by_powers_of_two_change_nothing() {
    let mut failures = Failures::default();
    for (kind, drawing) in drawings(24) {
        for preset in PROMISED {
            failures.check(&format!("{kind:?} {preset}"), &drawing, |d| {
                let Some(plain) = refined(d, options(preset, 30.0))? else { return Ok(()) };
                for k in [-400, -100, 100, 400] {
                    let factor = libm::ldexp(1.0, k);
                    let Some(other) = refined(&scaled(d, factor), options(preset, 30.0))? else {
                        return Err(format!("flat at 2^{k}"));
                    };
                    equal(&format!("vertices at 2^{k}"), &other.mesh.points.len(), &plain.mesh.points.len())?;
                    equal(
                        &format!("triangles at 2^{k}"),
                        &canonical(&other.mesh.triangles),
                        &canonical(&plain.mesh.triangles),
                    )?;
                    let back: Vec<Point> =
                        other.mesh.points.iter().map(|p| Point::new(p.x / factor, p.y / factor)).collect();
                    equal(&format!("places at 2^{k}"), &back, &plain.mesh.points)?;
                    equal(&format!("reasons at 2^{k}"), &other.report.reasons(), &plain.report.reasons())?;
                }
                Ok(())
            });
        }
    }
    failures.expect_none();
}

#[test]
fn far_away_it_ends_too() {
    let mut failures = Failures::default();
    for (kind, drawing) in drawings(24) {
        failures.check(&format!("{kind:?} at UTM"), &moved_to_utm(&drawing), |d| {
            judge(d, options(Preset::OffCenter, 30.0))
        });
    }
    failures.expect_none();
}

/// Input vertices are bound to be met at every stop: budgets from none to more than enough.
#[test]
fn any_budget_leaves_a_sound_mesh() {
    let mut failures = Failures::default();
    for kind in [PslgKind::Gear, PslgKind::StarPolygon, PslgKind::NestedSquares, PslgKind::LongSegments] {
        let drawing = pslg(kind, 24, 3);
        for budget in [0, 1, 24, 25, 26, 27, 30, 40, 55, 80, 111, 160] {
            failures.check(&format!("{kind:?}, {budget} vertices"), &drawing, |d| {
                judge(d, RefineOptions::default().with_min_angle_deg(33.0).with_max_vertices(budget))
            });
        }
    }
    failures.expect_none();
}

#[test]
fn refining_the_result_again_adds_nothing() {
    let mut failures = Failures::default();
    for (kind, drawing) in drawings(24) {
        failures.check(&format!("{kind:?}"), &drawing, |d| {
            let options = options(Preset::OffCenter, 25.0);
            let Some(first) = refined(d, options)? else { return Ok(()) };
            if !first.report.leftovers.is_empty() || first.report.stop != StopReason::Finished {
                return Ok(());
            }
            let again = Pslg {
                points: first.mesh.points.clone(),
                segments: first.mesh.segments.clone(),
                holes: first.mesh.holes.clone(),
                ..Pslg::default()
            };
            let Some(second) = refined(&again, options)? else { return Ok(()) };
            equal("points inserted again", &second.report.points_inserted, &0)?;
            equal("leftovers", &second.report.leftovers, &Vec::new())
        });
    }
    failures.expect_none();
}

/// A box of side 2 around the origin with loose segments in it.
fn boxed(points: &[[f64; 2]], segments: &[[u32; 2]]) -> Pslg {
    let mut pslg = Pslg::of_ring([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]);
    pslg.points.extend(points.iter().copied().map(Point::from));
    pslg.segments.extend(segments.iter().map(|s| s.map(|v| v + 4)));
    pslg
}

/// Runs a named case at several angles by every preset, with a larger budget; returns what it met.
fn named(name: &str, drawing: &Pslg, budget: usize) -> Vec<(RefineOptions, Report)> {
    let mut failures = Failures::default();
    let mut reports = Vec::new();
    for preset in Preset::ALL {
        for degrees in [20.0, 25.0, 30.0, 36.0, 45.0, 60.0] {
            let mut options = options(preset, degrees).with_max_vertices(budget);
            if !is_promised(options) {
                options.limits.max_vertices = budget.min(SMALL_BUDGET);
            }
            let report = RefCell::new(None);
            failures.check(&format!("{name} {preset} {degrees}"), drawing, |d| {
                report.replace(judged(d, options)?);
                Ok(())
            });
            if let Some(report) = report.into_inner() {
                println!("{name} {preset} {degrees}: {} vertices, {:?}", report.vertices, report.reasons());
                reports.push((options, report));
            }
        }
    }
    failures.expect_none();
    reports
}

/// Nothing but the input's angles, and far below the budget.
fn assert_only_input_angles(name: &str, reports: &[(RefineOptions, Report)], most: usize) {
    for (options, report) in reports.iter().filter(|r| is_promised(r.0)) {
        assert!(report.complete(), "{name}, {options:?}: {:?}", report.reasons());
        assert!(report.vertices <= most, "{name}, {options:?}: {} vertices", report.vertices);
    }
}

#[test]
fn arms_of_irrational_ratio() {
    for degrees in [60.0_f64, 45.0, 30.0, 10.0, 1.0, 1e-3, 1e-6] {
        let (sin, cos) = (libm::sin(degrees.to_radians()), libm::cos(degrees.to_radians()));
        let long = core::f64::consts::SQRT_2;
        for (what, apex) in [("in a box", true), ("a triangle", false)] {
            let arms = [[0.0, 0.0], [0.5, 0.0], [0.5 * long * cos, 0.5 * long * sin]];
            let drawing = if apex { boxed(&arms, &[[0, 1], [0, 2]]) } else { Pslg::of_ring(arms) };
            let name = format!("arms at {degrees} degrees, {what}");
            let reports = named(&name, &drawing, 20_000);
            // The shorter arm ends so near the longer one that as many triangles fit between them as the angle is
            // small: below some hundredths of a degree only the budget ends it.
            if degrees > 0.1 {
                assert_only_input_angles(&name, &reports, 5_000);
            }
        }
    }
}

#[test]
fn parallel_segments_a_millionth_apart() {
    let drawing = boxed(&[[-0.5, 0.0], [0.5, 0.0], [-0.5, 1e-6], [0.5, 1e-6]], &[[0, 1], [2, 3]]);
    for (_, report) in named("parallels", &drawing, 20_000).into_iter().filter(|r| is_promised(r.0)) {
        assert_eq!(report.stop, StopReason::Budget, "a million triangles fit between them");
        assert!(report.vertices <= 20_000);
    }
}

#[test]
fn a_hub_of_a_hundred_segments() {
    for n in [7_u32, 100, 360] {
        let mut points = vec![[0.0, 0.0]];
        points.extend((0..n).map(|i| {
            let turn = core::f64::consts::TAU * f64::from(i) / f64::from(n);
            let radius = 0.3 + 0.6 * f64::from(i * 7919 % n) / f64::from(n);
            [radius * libm::cos(turn), radius * libm::sin(turn)]
        }));
        let spokes: Vec<[u32; 2]> = (1..=n).map(|i| [0, i]).collect();
        let reports = named(&format!("hub of {n}"), &boxed(&points, &spokes), 60_000);
        assert_only_input_angles(&format!("hub of {n}"), &reports, 40_000);
    }
}

#[test]
fn edges_an_ulp_long_and_needles() {
    let ulp = f64::EPSILON;
    let cases = [
        ("vertices an ulp apart", Pslg::of_ring([[0.0, 0.0], [1.0, 0.0], [1.0, ulp], [1.0, 1.0], [0.0, 1.0]])),
        ("a notch an ulp deep", Pslg::of_ring([[0.0, 0.0], [0.5, ulp], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])),
        ("a needle", Pslg::of_ring([[0.0, 0.0], [1.0, 0.0], [0.5, 1e-200]])),
        ("a thin box", Pslg::of_ring([[0.0, 0.0], [1.0, 0.0], [1.0, 1e-12], [0.0, 1e-12]])),
        ("no area to speak of", Pslg::of_ring([[0.0, 0.0], [1.0, 0.0], [1.0, 5e-324], [0.0, 5e-324]])),
        ("subnormal", Pslg::of_ring([[0.0, 0.0], [5e-324, 0.0], [0.0, 5e-324]])),
        ("huge", Pslg::of_ring([[-1e308, -1e308], [1e308, -1e308], [1e308, 1e308], [-1e308, 1e308]])),
        ("huge and flat", Pslg::of_ring([[-1e308, 0.0], [1e308, 0.0], [0.0, 1e-300]])),
        ("a near T", boxed(&[[-0.5, 0.0], [0.5, 0.0], [0.0, 1e-12], [0.0, 0.5]], &[[0, 1], [2, 3]])),
        (
            "a crack",
            Pslg::of_ring([
                [0.0, 0.0],
                [1.0, 0.0],
                [1.0, 1.0],
                [0.5 + 1e-14, 1.0],
                [0.5, 0.5],
                [0.5 - 1e-14, 1.0],
                [0.0, 1.0],
            ]),
        ),
    ];
    for (name, drawing) in cases {
        named(name, &drawing, 5_000);
    }
}

/// CGAL#2456: a comb of collinear boundary points and a fan that crosses it.
#[test]
fn a_comb_of_boundary_points_under_a_fan() {
    let mut corners: Vec<[f64; 2]> = (0..=40).map(|i| [f64::from(i) / 40.0, 0.0]).collect();
    corners.extend([[1.0, 1.0], [0.0, 1.0]]);
    let mut drawing = Pslg::of_ring(corners);
    drawing.segments.extend((1..40).step_by(3).map(|i| [i, 41]));
    let reports = named("comb under a fan", &drawing, 20_000);
    assert_only_input_angles("comb under a fan", &reports, 10_000);
}
