//! Every shared real input is triangulated with its segments, meshed, and checked by programs that know nothing of
//! ours.
//!
//! For each input of each family (Triangle's examples, CDT's and earcut's test files, poly2tri's bug reports,
//! straight-skeleton tests, maps, crossing polygons, point sets):
//!
//! 1. *Crossings*. Where segments cross (by comparison of all with all, exact), the input is refused, naming exactly
//!    the pairs that cross. It is then resolved by splitting; all others go in with crossings refused.
//! 2. *Triangulation*. The library's full check is silent; every segment is a chain of edges from end to end.
//! 3. *Domain*. Rings are read by nesting, `.poly` files by their hole seeds, everything else as its convex hull.
//!    Inputs without a domain of two dimensions are listed here, with the error that each must give.
//! 4. *Mesh* at 20 degrees with 200 000 vertices at most: clean by the library's checkers of plain meshes, by its
//!    comparison with the input, and by the testkit's checker, which shares no line with it.
//! 5. *Leftovers* are exactly the triangles below the bound, each with a reason; nothing is left because the strategy
//!    could not improve it, and the budget is never met.
//! 6. Triangle's family once more at 25 degrees: clean by the shared `tools/check_mesh.py`, or refused by name.
//!
//! With `--nocapture` a table is printed: vertices, triangles, leftovers by reason, milliseconds.

#![allow(clippy::print_stdout, reason = "tables for those who look")]

use std::time::Instant;

use crate::common::failures::{Verdict, equal, guarded, none};
use trimalla::constrained::{ConstrainedDelaunay, ConstraintError, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{self, DomainError, DomainRule};
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::quality::{against_input, below_bound};
use trimalla::refine::{NoObserver, Reason, RefineOptions, Refinement, Report, StopReason};
use trimalla::triangulation::{check_mesh, check_mesh_delaunay};
use trimalla::{MeshOptions, mesh};
use trimalla_testkit::oracles::{check_indexed, contacts, on_open_segment};
use trimalla_testkit::peers;
use trimalla_testkit::readers::{NamedInput, all_inputs};
use trimalla_testkit::shared::say_skipped;
use trimalla_testkit::shared_data_or_skip;

/// Segments beyond which comparing all with all takes too long for a test.
const ALL_PAIRS_LIMIT: usize = 10_000;
/// Segments times vertices beyond which the testkit's checker is not told the input: it looks at all pairs.
const PRODUCT_LIMIT: usize = 400_000_000;
/// The vertex budget.
const BUDGET: usize = 200_000;
/// The angle bound of all families.
const BOUND_DEG: f64 = 20.0;
/// The angle bound of Triangle's family.
const TRIANGLE_BOUND_DEG: f64 = 25.0;

/// Inputs that have no domain, and the error that says so.
const WITHOUT_DOMAIN: [(&str, &str); 5] = [
    ("box.poly", "open"),
    // Every place is covered by an even number of their polygons.
    ("daef_cross_selfintersecting.geojson", "nested"),
    ("overlapping_segments2.geojson", "nested"),
    ("degenerate.json", "nested"),
    ("empty-square.json", "nested"),
];

#[test]
fn every_real_input_is_triangulated_and_meshed() {
    let data = shared_data_or_skip!();
    let inputs = all_inputs(&data);
    assert!(inputs.len() > 80, "only {} inputs", inputs.len());
    let mut wrong = Vec::new();
    println!("{:<44} {:>8} {:>8} {:>7}  leftovers", "input", "vertices", "triangles", "ms");
    for input in &inputs {
        let name = format!("{}/{}", input.family, input.name);
        if let Err(fault) = guarded(&input.pslg, &|_| judge(&name, input)) {
            println!("{name}: WRONG {fault}");
            wrong.push(format!("{name}: {fault}"));
        }
    }
    assert!(wrong.is_empty(), "{} of {} wrong: {wrong:#?}", wrong.len(), inputs.len());
}

/// The pairs of segments whose interiors meet in one point that is no vertex; nothing where it takes too long.
fn true_pairs(drawing: &Pslg) -> Option<Vec<[usize; 2]>> {
    if drawing.segments.len() > ALL_PAIRS_LIMIT {
        return None;
    }
    let at = |s: usize| drawing.segments[s].map(|v| drawing.points[v as usize]);
    let found = contacts(drawing).crossings.into_iter().map(|(i, j)| [i, j]);
    let apart = found.filter(|&[i, j]| {
        let ([a, b], [c, d]) = (at(i), at(j));
        !drawing.points.iter().any(|&p| on_open_segment(p, a, b) && on_open_segment(p, c, d))
    });
    Some(apart.collect())
}

fn judge(name: &str, input: &NamedInput) -> Verdict {
    let drawing = &input.pslg;
    let crossings = crossings_of(drawing)?;
    let cdt = ConstrainedDelaunay::new(&drawing.points, &drawing.segments, crossings).map_err(|e| e.to_string())?;
    none("triangulation", &cdt.check())?;
    for (s, &[_, b]) in cdt.segment_ids().zip(cdt.segments()) {
        let end = cdt.chain(s).last().map_or(cdt.segments()[s.index()][0], |&h| cdt.dest(h));
        equal(&format!("end of the chain of segment {s}"), &end, &b)?;
    }
    let rule = match (input.rings, &*input.family) {
        (true, _) => DomainRule::Nesting,
        (false, "triangle") => DomainRule::Seeds,
        _ => DomainRule::Hull,
    };
    let begun = Instant::now();
    let built = domain::build(drawing, rule, crossings, AlgorithmKey::default());
    let without = WITHOUT_DOMAIN.iter().find(|(n, _)| *n == input.name).map(|w| w.1);
    let (cdt, _) = match (built, without) {
        (Ok(built), None) => built,
        (Err(DomainError::OpenOutline { .. }), Some("open")) | (Err(DomainError::NothingNested), Some("nested")) => {
            return Ok(());
        }
        (Ok(_), Some(_)) => return Err("there should be no domain".to_owned()),
        (Err(e), _) => return Err(e.to_string()),
    };
    let options = RefineOptions::default().with_min_angle_deg(BOUND_DEG).with_max_vertices(BUDGET);
    let mut refinement = Refinement::new(cdt, options).map_err(|e| e.to_string())?;
    refinement.run(&mut NoObserver);
    let (cdt, report) = refinement.finish();
    let mesh = cdt.to_indexed(drawing);
    let reasons: Vec<String> = report.reasons().iter().map(|(r, n)| format!("{n} {r}")).collect();
    println!(
        "{name:<44} {:>8} {:>8} {:>7}  {}",
        report.vertices,
        report.triangles,
        begun.elapsed().as_millis(),
        reasons.join(", ")
    );
    none("refined triangulation", &cdt.check())?;
    clean(&mesh, drawing)?;
    explained(&mesh, &report)
}

/// Claim 1: says whether crossings are to be split.
fn crossings_of(drawing: &Pslg) -> Result<Crossings, String> {
    let refused = ConstrainedDelaunay::new(&drawing.points, &drawing.segments, Crossings::Refuse);
    let named: Vec<[usize; 2]> = match refused {
        Ok(_) => Vec::new(),
        Err(ConstraintError::Crossing(pairs)) => pairs.iter().map(|p| p.segments).collect(),
        Err(e) => return Err(e.to_string()),
    };
    if let Some(expected) = true_pairs(drawing) {
        equal("pairs that cross", &named, &expected)?;
    }
    Ok(if named.is_empty() { Crossings::Refuse } else { Crossings::Split })
}

/// Claim 4.
fn clean(mesh: &IndexedMesh, drawing: &Pslg) -> Verdict {
    none("mesh checker", &check_mesh(mesh))?;
    none("circle test", &check_mesh_delaunay(mesh, &[]))?;
    none("against input", &against_input(mesh, drawing).faults)?;
    let told = (drawing.segments.len() * mesh.points.len() < PRODUCT_LIMIT).then_some(drawing);
    none("testkit checker", &check_indexed(mesh, told))
}

/// Claim 5.
fn explained(mesh: &IndexedMesh, report: &Report) -> Verdict {
    let below = below_bound(mesh, RefineOptions::default().with_min_angle_deg(BOUND_DEG).criteria.min_angle);
    equal("leftovers", &report.leftovers.iter().map(|l| l.triangle).collect::<Vec<_>>(), &below)?;
    let lazy = report.leftovers.iter().find(|l| l.reason == Reason::StrategyCannotImprove);
    equal("a leftover without a good reason", &lazy, &None)?;
    // Real drawings at an easy bound need no more than a few vertices for each of their own.
    equal("the vertex budget", &report.stop, &StopReason::Finished)
}

#[test]
fn the_family_of_triangle_is_clean_by_the_shared_checker() {
    let data = shared_data_or_skip!();
    for input in all_inputs(&data).into_iter().filter(|i| i.family == "triangle") {
        let options = MeshOptions {
            refine: RefineOptions::default().with_min_angle_deg(TRIANGLE_BOUND_DEG),
            ..MeshOptions::default()
        };
        let trimalla::Meshed { mesh, report, .. } = match mesh(&input.pslg, &options) {
            Ok(done) => done,
            Err(e) => {
                assert_eq!(input.name, "box.poly", "{e}");
                assert!(e.to_string().contains("the domain is empty"), "{e}");
                continue;
            }
        };
        assert!(report.complete(), "{}: {:?}", input.name, report.reasons());
        let Some(verdict) = peers::check_mesh_in_memory_at(&mesh, Some(&input.pslg), Some(TRIANGLE_BOUND_DEG))
            .expect("files can be written")
        else {
            return say_skipped("python3, numpy or tools/check_mesh.py not found");
        };
        println!(
            "{}: {} vertices, {:?}, shared checker {}",
            input.name,
            report.vertices,
            report.reasons(),
            if verdict.is_ok() { "clean" } else { "not clean" }
        );
        assert_eq!(verdict, Ok(()), "{}", input.name);
    }
}
