//! Above 33 degrees: several runs, the best of which counts.
//!
//! *Inputs*: the drawings of `data/shapes`, at 36 and 44 degrees.
//!
//! *Claims*
//! 1. The smallest angle is that of the mesh for 30 degrees or larger, and the mesh is no larger than twenty forecasts.
//! 2. Each triangle below the bound that is asked is a leftover; without a lower bound none is.
//! 3. The options of the best run alone give the same mesh.
//! 4. A named recipe, and a bound of 33 degrees or less, have one run.
//! 5. Whoever watches sees one refinement from its beginning to its end, and may cancel.

use std::path::Path;

use trimalla::constrained::{ConstrainedTriangulation, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build};
use trimalla::geometry::{Angle, Triangle};
use trimalla::refine::{Attempts, Beginning, Event, Observer, Preset, Progress, RefineOptions, StopReason, forecast};
use trimalla::{Attempted, MeshOptions, Meshed, Pslg, mesh, mesh_with};
use trimalla_testkit::readers::read_poly;

const SHAPES: [&str; 8] = ["coast", "gear", "guitar", "key", "mesh-b", "mesh-b-points", "plate", "star"];

fn shape(name: &str) -> Pslg {
    let shapes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/shapes");
    read_poly(&shapes.join(format!("{name}.poly")))
}

fn made(drawing: &Pslg, refine: RefineOptions) -> Meshed {
    mesh(drawing, &MeshOptions { refine, ..MeshOptions::default() }).expect("a sound drawing")
}

fn at(degrees: f64) -> RefineOptions {
    RefineOptions::default().with_min_angle_deg(degrees)
}

/// The vertices of the forecast.
fn expected(drawing: &Pslg, degrees: f64) -> f64 {
    let (cdt, _) = build(drawing, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()).expect("a drawing");
    forecast(&cdt, &at(degrees)).vertices
}

/// How many triangles have an angle below a bound.
fn below(made: &Meshed, degrees: f64) -> usize {
    let cos_sq = Angle::from_degrees(degrees).cos_sq();
    let is_below = |t: &&[u32; 3]| {
        let [a, b, c] = t.map(|v| made.mesh.points[v as usize]);
        !trimalla::geometry::triangle_angles_at_least(a, b, c, cos_sq)
    };
    made.mesh.triangles.iter().filter(is_below).count()
}

#[test]
fn no_mesh_is_worse_than_that_of_30_degrees() {
    for name in SHAPES {
        let drawing = shape(name);
        let safe = made(&drawing, at(30.0));
        for degrees in [36.0, 44.0] {
            let best = made(&drawing, at(degrees));
            let Attempted { bound_deg, is_lowered, .. } = best.attempted.expect("several runs");
            assert!(best.report.min_angle_deg >= safe.report.min_angle_deg - 1e-9, "{name} {degrees}");
            let forecast = expected(&drawing, degrees).max(safe.report.vertices as f64);
            assert!((best.report.vertices as f64) < 20.0 * forecast, "{name} {degrees}");
            assert_eq!(best.report.leftovers.len(), below(&best, degrees), "{name} {degrees}");
            assert_eq!(is_lowered, bound_deg < degrees, "{name} {degrees}");
            assert!(is_lowered || best.report.complete(), "{name} {degrees}: {:?}", best.report.reasons());
            assert!(bound_deg >= 36.0 || !is_lowered, "{name} {degrees}: only {bound_deg} is met");
        }
    }
}

#[test]
fn the_best_run_alone_gives_the_same_mesh() {
    let guitar = shape("guitar");
    for degrees in [34.0, 35.0, 37.0] {
        let best = made(&guitar, at(degrees));
        let Attempted { preset, bound_deg, .. } = best.attempted.expect("several runs");
        let alone = made(&guitar, RefineOptions::of(preset).with_min_angle_deg(bound_deg));
        assert_eq!(best.mesh, alone.mesh, "{degrees}");
        assert!(best.mesh.points.len() < 5_000, "{degrees}: {}", best.mesh.points.len());
    }
}

#[test]
fn one_run_is_made_where_it_is_asked_for_or_enough() {
    let key = shape("key");
    let one = RefineOptions::of(Preset::OffCenter).with_min_angle_deg(36.0);
    assert_eq!(made(&key, one).attempted, None);
    assert_eq!(made(&key, at(36.0).with_attempts(Attempts::One)).attempted, None);
    assert_eq!(made(&key, at(33.0)).attempted, None);
    assert!(made(&key, at(33.5)).attempted.is_some());
}

#[test]
fn a_bound_above_the_ceiling_is_lowered_to_it() {
    // An L-shape of squares: half-squares have 45 degrees, and no mesh has more.
    let drawing = Pslg::of_ring([[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]]);
    let best = made(&drawing, at(50.0));
    let attempted = best.attempted.expect("several runs");
    let ceiling = attempted.ceiling.expect("a corner of 90 degrees");
    assert!((ceiling.bound.degrees() - 45.0).abs() < 1e-9);
    assert!(attempted.bound_deg <= 45.0 && best.report.min_angle_deg >= attempted.bound_deg - 1e-9, "{attempted:?}");
    assert!(!best.report.complete() && best.report.stop == StopReason::NoLongerImproves);
}

/// Counts what it is told, and cancels after so many calls.
#[derive(Default)]
struct Counting {
    wants_events: bool,
    left: Option<usize>,
    begun: usize,
    events: usize,
    last: usize,
}

impl Observer for Counting {
    fn progress(&mut self, _: Progress) -> bool {
        let goes_on = self.left != Some(0);
        self.left = self.left.map(|left| left.saturating_sub(1));
        goes_on
    }

    fn begins(&mut self, begun: &mut dyn Beginning) {
        assert_eq!(begun.triangulation().steiner_vertices(), 0);
        self.begun += 1;
    }

    fn wants_events(&self) -> bool {
        self.wants_events
    }

    fn event(&mut self, _: &Event, cdt: &ConstrainedTriangulation) {
        self.events += 1;
        self.last = cdt.face_count();
    }
}

#[test]
fn a_watcher_sees_one_refinement_and_may_cancel() {
    let drawing = shape("mesh-b");
    let options = MeshOptions { refine: at(37.0), ..MeshOptions::default() };
    for wants_events in [false, true] {
        let mut watch = Counting { wants_events, ..Counting::default() };
        let best = mesh_with(&drawing, &options, &mut watch).expect("a sound drawing");
        assert_eq!(watch.begun, 1);
        assert_eq!(watch.last, if wants_events { best.mesh.triangles.len() } else { 0 });
        assert_eq!(watch.events > 0, wants_events);
    }
    for calls in [0, 1, 3, 8] {
        let mut watch = Counting { left: Some(calls), ..Counting::default() };
        let so_far = mesh_with(&drawing, &options, &mut watch).expect("a sound drawing");
        let corners = |t: &[u32; 3]| t.map(|v| so_far.mesh.points[v as usize]);
        let area = |[a, b, c]: [trimalla::Point; 3]| Triangle::new(a, b, c).area();
        assert!(so_far.mesh.triangles.iter().map(corners).all(|t| area(t) > 0.0), "{calls}");
    }
}
