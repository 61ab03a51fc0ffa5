//! Meshes made smaller after their refinement.
//!
//! *Inputs*: the drawings of `data/shapes`, and random drawings of every kind at random bounds.
//!
//! *Claims*
//! 1. The mesh is one of its drawing, constrained Delaunay, with all input vertices where they were.
//! 2. No angle is below the bound that the refinement met, each is proved, and no triangle is above its area bound.
//! 3. There are never more vertices than before; of shapes at 36 degrees less than half of the Steiner vertices stay.
//! 4. The same options give the same mesh.
//! 5. Whoever cancels gets a mesh for which all of that holds.

use std::path::Path;

use trimalla::improve::AngleBound;
use trimalla::refine::{NoObserver, Progress, RefineOptions};
use trimalla::{Improve, MeshOptions, Meshed, Pslg, mesh, mesh_with};
use trimalla_testkit::generators::{PslgKind, SplitMix64, pslg};
use trimalla_testkit::oracles::{DelaunayRule, check_indexed_with};
use trimalla_testkit::readers::read_poly;

fn shape(name: &str) -> Pslg {
    let shapes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/shapes");
    read_poly(&shapes.join(format!("{name}.poly")))
}

fn sifted(refine: RefineOptions, effort: u8) -> MeshOptions {
    MeshOptions { refine, improve: Improve::Sift { effort }, ..MeshOptions::default() }
}

fn assert_sound(drawing: &Pslg, made: &Meshed, options: &RefineOptions, what: &str) {
    let Meshed { mesh, report, .. } = made;
    let faults = check_indexed_with(mesh, Some(drawing), DelaunayRule::Delaunay);
    assert_eq!(faults, Vec::<String>::new(), "{what}");
    assert_eq!(mesh.points[..drawing.points.len()], drawing.points, "{what}: input vertices stay");
    assert_eq!((mesh.points.len(), mesh.triangles.len()), (report.vertices, report.triangles), "{what}");
    let Some(improved) = made.improved else { return };
    assert!(improved.vertices <= improved.vertices_before && improved.vertices == mesh.points.len(), "{what}");
    assert!(improved.is_proved && report.leftovers.is_empty(), "{what}: {improved:?}");
    let bound = options.criteria.min_angle.degrees();
    assert!(report.min_angle_deg >= bound * (1.0 - 1e-12), "{what}: {}", report.min_angle_deg);
    for t in &mesh.triangles {
        let corners @ [a, b, c] = t.map(|v| mesh.points[v as usize]);
        let bound = AngleBound::new(bound).expect("a bound");
        assert!(bound.is_met_by(corners), "{what}");
        assert!(options.criteria.max_area.is_none_or(|area| 0.5 * (b - a).cross(c - a) <= area), "{what}: an area");
    }
}

#[test]
fn shapes_get_much_smaller() {
    for name in ["key", "mesh-b", "mesh-b-points"] {
        let drawing = shape(name);
        for (degrees, part) in [(30.0, 0.8), (36.0, 0.5)] {
            let refine = RefineOptions::default().with_min_angle_deg(degrees);
            let made = mesh(&drawing, &sifted(refine, 1)).expect("a sound drawing");
            assert_sound(&drawing, &made, &refine, name);
            let given = drawing.points.len();
            let [now, before] =
                made.improved.map(|i| [i.vertices, i.vertices_before].map(|n| (n - given) as f64)).expect("a sift");
            assert!(now <= part * before, "{name} at {degrees}: {before} to {now}");
            assert_eq!(mesh(&drawing, &sifted(refine, 1)).expect("a sound drawing"), made, "{name}: the same again");
        }
    }
}

/// Above 38 degrees no refinement ends: meshes are led there.
#[test]
fn meshes_climb_where_no_refinement_ends() {
    for (name, degrees) in [("mesh-b", 41.0), ("key", 40.0)] {
        let drawing = shape(name);
        let refine = RefineOptions::default().with_min_angle_deg(degrees);
        let refined = mesh(&drawing, &MeshOptions { refine, ..MeshOptions::default() }).expect("a sound drawing");
        let met = refined.attempted.expect("several runs").bound_deg;
        assert!(met < degrees, "{name}: a refinement meets {met}");
        let made = mesh(&drawing, &sifted(refine, 1)).expect("a sound drawing");
        assert_sound(&drawing, &made, &refine, name);
        assert_eq!(made.improved.and_then(|improved| improved.climbed_from_deg), Some(met), "{name}");
        assert!(made.report.complete() && made.attempted.is_some_and(|a| !a.is_lowered), "{name}: {:?}", made.report);
        assert_eq!(mesh(&drawing, &sifted(refine, 1)).expect("a sound drawing"), made, "{name}: the same again");
    }
}

/// A square corner forbids more than 45 degrees, and 45 itself by rounding: the mesh gets near it, and says how near.
#[test]
fn a_climb_ends_below_the_ceiling() {
    let drawing = Pslg::of_ring([[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.2]]);
    let refine = RefineOptions::default().with_min_angle_deg(50.0);
    let made = mesh(&drawing, &sifted(refine, 1)).expect("a sound drawing");
    let attempted = made.attempted.expect("several runs");
    assert!(attempted.is_lowered && attempted.bound_deg < 45.0, "{attempted:?}");
    let from = made.improved.and_then(|improved| improved.climbed_from_deg).expect("a climb");
    assert!(from < attempted.bound_deg && !made.report.complete(), "{attempted:?} from {from}");
    assert!(made.report.min_angle_deg >= attempted.bound_deg * (1.0 - 1e-12), "{:?}", made.report);
    let faults = check_indexed_with(&made.mesh, Some(&drawing), DelaunayRule::Delaunay);
    assert_eq!(faults, Vec::<String>::new());
}

#[test]
fn random_drawings_stay_sound() {
    let mut random = SplitMix64::new(2112);
    let mut smaller = 0;
    for (round, kind) in (0..160).zip(PslgKind::ALL.into_iter().cycle()) {
        let drawing = pslg(kind, 6 + random.below(30), round);
        let degrees = random.range(10.0, 30.0);
        let mut refine = RefineOptions::default().with_min_angle_deg(degrees).with_max_vertices(400);
        if round % 3 == 0 {
            refine = refine.with_max_area(0.05);
        }
        let what = format!("{kind:?} {round} at {degrees}");
        let Ok(made) = mesh(&drawing, &sifted(refine, 1)) else { continue };
        assert_sound(&drawing, &made, &refine, &what);
        smaller += usize::from(made.improved.is_some_and(|improved| improved.vertices < improved.vertices_before));
    }
    assert!(smaller > 4, "only {smaller} meshes got smaller");
}

#[test]
fn whoever_cancels_gets_a_sound_mesh() {
    let drawing = shape("key");
    let refine = RefineOptions::default().with_min_angle_deg(33.0);
    let whole = mesh_with(&drawing, &sifted(refine, 2), &mut NoObserver).expect("a sound drawing");
    let refined = mesh(&drawing, &MeshOptions { refine, ..MeshOptions::default() }).expect("a sound drawing");
    for after in [5, 30, 200] {
        let mut calls = 0;
        let mut watch = |_: Progress| {
            calls += 1;
            calls < after
        };
        let made = mesh_with(&drawing, &sifted(refine, 2), &mut watch).expect("a sound drawing");
        assert_sound(&drawing, &made, &refine, "cancelled");
        let sizes = whole.mesh.points.len()..=refined.mesh.points.len();
        assert!(made.improved.is_none() || sizes.contains(&made.mesh.points.len()));
    }
}
