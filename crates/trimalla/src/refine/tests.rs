//! Refinement of small domains: bound reached, invariants kept, reasons given.

use std::sync::Arc;

use super::steps::{InsertStep, InsertTraits, Plan, Proposal, SelectStep, Steps, View};
use super::*;
use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, Crossings};
use crate::delaunay::AlgorithmKey;
use crate::domain::{DomainRule, build};
use crate::drawing::Pslg;
use crate::geometry::Point;
use crate::half_edge::FaceId;

fn carved(pslg: &Pslg, algorithm: AlgorithmKey) -> ConstrainedDelaunay {
    build(pslg, DomainRule::Seeds, Crossings::Refuse, algorithm).unwrap().0
}

fn refined(pslg: &Pslg, options: RefineOptions) -> (ConstrainedTriangulation, Report) {
    let mut r = Refinement::new(carved(pslg, AlgorithmKey::Incremental), options).unwrap();
    r.run(&mut NoObserver);
    let (cdt, report) = r.finish();
    assert_eq!(cdt.check_delaunay(), []);
    for (i, p) in pslg.points.iter().enumerate() {
        assert_eq!(cdt.points()[i], *p, "input vertex {i} stays");
    }
    (cdt, report)
}

const L_SHAPE: [[f64; 2]; 6] = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.1, 1.3], [1.0, 4.0], [0.0, 4.0]];

#[test]
fn the_bound_is_reached_at_every_usual_angle() {
    for preset in Preset::ALL.into_iter().filter(|&p| p != Preset::LeppBisection) {
        for degrees in [0, 10, 20, 25, 30, 33] {
            let options = RefineOptions::of(preset).with_min_angle_deg(f64::from(degrees));
            let (_, report) = refined(&Pslg::of_ring(L_SHAPE), options);
            assert_eq!(report.leftovers, [], "{preset} at {degrees}");
            assert!(report.min_angle_deg >= f64::from(degrees) - 1e-9);
        }
    }
}

#[test]
fn every_step_keeps_the_invariants() {
    let cdt = carved(&Pslg::of_ring(L_SHAPE), AlgorithmKey::Incremental);
    let options = RefineOptions::default().with_min_angle_deg(33.0).with_max_area(0.05);
    let mut r = Refinement::new(cdt, options).unwrap();
    for _ in 0..2000 {
        if r.step().outcome == StepOutcome::Finished {
            return;
        }
        assert_eq!(r.triangulation().check_delaunay(), []);
    }
    panic!("2000 steps are more than enough here");
}

#[test]
fn the_outcome_says_whether_a_subsegment_was_split() {
    let options = RefineOptions::of(Preset::LeppCircumcenter).with_min_angle_deg(33.0).with_max_area(0.05);
    let mut r = Refinement::new(carved(&Pslg::of_ring(L_SHAPE), AlgorithmKey::Incremental), options).unwrap();
    let (mut split, mut is_finished) = (0, false);
    for _ in 0..5000 {
        let event = r.step();
        let is_split = event.outcome == StepOutcome::SubsegmentSplit;
        assert_eq!(event.subsegment.is_some() && event.inserted.is_some(), is_split, "{event:?}");
        split += u64::from(is_split);
        is_finished = event.outcome == StepOutcome::Finished;
        if is_finished {
            break;
        }
    }
    assert!(is_finished && split > 10, "{split}");
    assert_eq!(r.finish().1.segments_split, split);
}

#[test]
fn the_area_bound_is_reached() {
    let options = RefineOptions::default().with_min_angle_deg(0.0).with_max_area(0.01);
    let (cdt, report) = refined(&Pslg::of_ring(L_SHAPE), options);
    assert_eq!(report.leftovers, []);
    assert!(cdt.real_faces().all(|f| {
        let [a, b, c] = cdt.face_points(f);
        (b - a).cross(c - a) <= 0.02
    }));
}

#[test]
fn small_input_angles_are_named() {
    for degrees in [1.0f64, 5.0, 20.0] {
        let (s, c) = (degrees.to_radians() / 2.0, 10.0);
        let wedge = Pslg::of_ring([[0.0, 0.0], [c, -c * s], [c, c * s]]);
        let (_, report) = refined(&wedge, RefineOptions::default().with_min_angle_deg(25.0).with_max_vertices(20_000));
        assert!(report.complete(), "{degrees}: {:?}", report.reasons());
        assert!(!report.leftovers.is_empty(), "the wedge itself is too sharp");
    }
}

#[test]
fn the_budget_and_the_observer_stop_it() {
    let options = RefineOptions::default().with_max_area(1e-5).with_max_vertices(500);
    let (_, report) = refined(&Pslg::of_ring(L_SHAPE), options);
    assert_eq!(report.stop, StopReason::Budget);
    assert!(report.vertices <= 500 && report.reasons().iter().any(|r| r.0 == Reason::Budget));
    let mut r = Refinement::new(
        carved(&Pslg::of_ring(L_SHAPE), AlgorithmKey::Incremental),
        RefineOptions::default().with_max_area(1e-4),
    )
    .unwrap();
    let mut calls = 0;
    let stop = r.run(&mut |_: Progress| {
        calls += 1;
        calls < 3
    });
    assert_eq!(stop, StopReason::Cancelled);
    assert_eq!(r.finish().0.check_delaunay(), []);
}

#[test]
fn protected_segments_are_not_split() {
    let options = RefineOptions::default().with_protect(Protect::All);
    let (cdt, report) = refined(&Pslg::of_ring(L_SHAPE), options);
    assert_eq!(report.segments_split, 0);
    assert!(cdt.segment_ids().all(|s| cdt.chain(s).len() == 1), "every segment is one edge");
    assert!(report.leftovers.iter().all(|l| l.reason == Reason::ProtectedSegment), "{:?}", report.reasons());
}

#[test]
fn the_result_does_not_depend_on_the_builder() {
    let pslg = Pslg::of_ring(L_SHAPE);
    for preset in Preset::ALL {
        let options = RefineOptions::of(preset).with_max_area(0.01);
        let meshes = AlgorithmKey::ALL.map(|a| {
            let mut r = Refinement::new(carved(&pslg, a), options).unwrap();
            r.run(&mut NoObserver);
            let (cdt, _) = r.finish();
            (cdt.points().to_vec(), cdt.canonical())
        });
        assert!(meshes[0] == meshes[1], "{preset}: both builders lead to one mesh");
    }
}

#[test]
fn wrong_options_are_refused() {
    let cdt = carved(&Pslg::of_ring(L_SHAPE), AlgorithmKey::Incremental);
    for options in [
        RefineOptions::default().with_min_angle_deg(61.0),
        RefineOptions::default().with_min_angle_deg(f64::NAN),
        RefineOptions::default().with_max_area(0.0),
        RefineOptions::default().with_max_area(f64::INFINITY),
    ] {
        assert!(Refinement::new(cdt.clone(), options).is_err(), "{options:?}");
    }
}

#[test]
fn regions_keep_their_attributes_and_bounds() {
    let at = |x: f64, y: f64| Point::new(x, y);
    let pslg = Pslg {
        points: [[0.0, 0.0], [4.0, 0.0], [8.0, 0.0], [8.0, 4.0], [4.0, 4.0], [0.0, 4.0]].map(Point::from).to_vec(),
        segments: vec![[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0], [1, 4]],
        regions: vec![
            crate::drawing::Region { seed: at(1.0, 1.0), attribute: 7.5, max_area: Some(0.05) },
            crate::drawing::Region { seed: at(7.0, 1.0), attribute: -2.0, max_area: None },
        ],
        ..Pslg::default()
    };
    let (cdt, report) = refined(&pslg, RefineOptions::default());
    assert_eq!(report.leftovers, []);
    let mesh = cdt.to_indexed(&pslg);
    for (t, attribute) in mesh.triangles.iter().zip(&mesh.triangle_attributes) {
        let [a, b, c] = t.map(|v| mesh.points[v as usize]);
        let left = (a.x + b.x + c.x) / 3.0 < 4.0;
        assert!(*attribute == if left { 7.5 } else { -2.0 }, "{a} {b} {c}");
        assert!(!left || (b - a).cross(c - a) <= 0.1, "the bound of the left region");
    }
    let of = |a: f64| mesh.triangle_attributes.iter().filter(|&&b| b == a).count();
    assert!(of(7.5) > 5 * of(-2.0), "the right region is free of the bound: {} and {}", of(7.5), of(-2.0));
}

#[test]
fn bisection_nests_and_stops() {
    let pslg = Pslg::of_ring(L_SHAPE);
    let start = carved(&pslg, AlgorithmKey::Incremental);
    let options = RefineOptions::of(Preset::LeppBisection).with_max_area(0.02);
    let mut r = Refinement::new(start.clone(), options).unwrap();
    r.run(&mut NoObserver);
    let (cdt, report) = r.finish();
    assert_eq!(cdt.check(), [], "sound, though not Delaunay");
    assert!(report.leftovers.iter().all(|l| l.reason == Reason::StrategyCannotImprove), "{:?}", report.reasons());
    assert!(report.stop == StopReason::Finished && report.triangles > 200);
    // Longest-edge bisection never makes an angle smaller than half the smallest there was.
    let least = |t: &ConstrainedTriangulation| {
        let angle = |f| {
            let [a, b, c] = t.corners(f);
            crate::geometry::Triangle::new(a, b, c).min_angle().degrees()
        };
        t.real_faces().map(angle).fold(180.0, f64::min)
    };
    assert!(report.min_angle_deg >= least(&start) / 2.0 - 1e-9, "{} from {}", report.min_angle_deg, least(&start));
}

#[test]
fn paths_rise_to_their_terminal_edge() {
    let (cdt, _) = refined(&Pslg::of_ring(L_SHAPE), RefineOptions::default().with_max_area(0.05));
    let ruler = Ruler::for_box(cdt.bounding_box());
    for f in cdt.real_faces() {
        let path = cdt.lepp(f, LeppRule::StopAtConstraints);
        assert_eq!(path.faces[0], f);
        let longest = |f| lepp::longest_edge(&cdt, ruler, f);
        for pair in path.faces.windows(2) {
            let order = lepp::compare_edges(&cdt, ruler, longest(pair[0]), longest(pair[1]));
            assert!(order.is_le(), "edges rise along the path");
        }
        let end = path.terminal_edge;
        let mutual = || longest(cdt.twin(end).face()) == cdt.twin(end);
        assert!(cdt.is_marked(end) || mutual(), "the terminal edge is constrained or the longest of both");
        assert_eq!(path.terminal_edge, lepp::terminal_edge(&cdt, ruler, f, LeppRule::StopAtConstraints));
    }
}

/// Bisection, as a caller might write it.
struct Halving;

impl InsertStep for Halving {
    fn plan(&self, _: View<'_>, _: Proposal, _: &mut Vec<FaceId>) -> Plan {
        Plan::Parts
    }

    fn traits(&self) -> InsertTraits {
        InsertTraits { keeps_delaunay: false, keeps_small_angles: true }
    }
}

/// Only the recipe's step 4 decided where bisection stops, so that a bisection of the caller's own ran up to the
/// budget.
#[test]
fn bisection_from_outside_stops_where_ours_does() {
    let wedge = Pslg::of_ring([[0.0, 0.0], [9.0, 0.0], [9.0, 1.0], [0.0, 4.0]]);
    let ours = RefineOptions::of(Preset::LeppBisection).with_max_vertices(5000);
    let theirs = RefineOptions { recipe: Recipe { insert: Insert::Flip, ..ours.recipe }, ..ours };
    let begin = |options: &RefineOptions, steps| {
        let start = Start::from(carved(&wedge, AlgorithmKey::Incremental)).with_steps(steps);
        Refinement::new(start, *options).unwrap()
    };
    let halving = Steps { insert: Arc::new(Halving), ..Steps::of(&theirs) };
    let [(mesh, report), other] = [begin(&ours, Steps::of(&ours)), begin(&theirs, halving)].map(|mut r| {
        assert_eq!(r.run(&mut NoObserver), StopReason::Finished);
        let (cdt, report) = r.finish();
        (cdt.canonical(), report)
    });
    assert_eq!((&other.0, other.1.reasons()), (&mesh, report.reasons()));
    assert!(!report.leftovers.is_empty() && report.leftovers.iter().all(|l| l.reason == Reason::StrategyCannotImprove));
}

/// A clock that advances by one at each reading: every reading ends a part, so the parts add up to all readings but the
/// first.
fn ticks() -> u64 {
    thread_local!(static READINGS: std::cell::Cell<u64> = const { std::cell::Cell::new(0) });
    READINGS.with(|readings| readings.replace(readings.get() + 1))
}

#[test]
fn every_step_is_timed_where_there_is_a_clock() {
    let options = RefineOptions {
        recipe: Recipe { recover: Recover::BySplitting, ..Recipe::default() },
        ..RefineOptions::default()
    };
    let mut fenced = Pslg::of_ring([[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0], [1.0, 4.0], [7.0, 4.5]]);
    fenced.points.extend((2..7).flat_map(|i| [Point::new(f64::from(i), 3.9), Point::new(f64::from(i) + 0.3, 4.8)]));
    fenced.segments = vec![[0, 1], [1, 2], [2, 3], [3, 0], [4, 5]];
    let timed = |clock: Option<Clock>| {
        let mut r = Refinement::new(Start::from(carved(&fenced, AlgorithmKey::Incremental)).with_clock(clock), options)
            .unwrap();
        r.run(&mut NoObserver);
        let (cdt, report) = r.finish();
        (cdt.canonical(), report)
    };
    let (mesh, report) = timed(Some(ticks));
    let times = report.step_times.expect("a clock was given");
    assert!(times.by_name().into_iter().all(|(_, seconds)| seconds > 0.0), "{times:?}");
    // The part before the first reading, and those between the calls, are the caller's.
    let inside = (times.total() * 1e9).round() as u64;
    assert!(inside < ticks() && inside > 4 * (report.points_inserted + report.segments_split), "{times:?}");
    assert_eq!(report.inserted.iter().sum::<u64>(), report.points_inserted + report.segments_split);
    let (untimed, silent) = timed(None);
    assert_eq!((silent.step_times, untimed), (None, mesh));
    assert_eq!(silent, Report { step_times: None, ..report });
}

/// The shortest edge first, in the whole drawing at once.
struct AllAtOnce;

impl SelectStep for AllAtOnce {
    fn priority(&self, view: View<'_>, face: FaceId, _: u64) -> f64 {
        let [a, b, c] = view.cdt.corners(face);
        view.ruler.length_sq(a, b).min(view.ruler.length_sq(b, c)).min(view.ruler.length_sq(c, a))
    }
}

#[test]
fn large_drawings_are_as_small_by_patches_as_all_at_once() {
    let mut domain = Pslg::of_ring([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    // Evenly spread without a pattern: the fractional parts of multiples of two irrational numbers.
    let spread = |i: u32, step: f64| 0.001 + 0.998 * (f64::from(i) * step).fract();
    domain
        .points
        .extend((1..20_000).map(|i| Point::new(spread(i, 0.754_877_666_246_692_8), spread(i, 0.618_033_988_749_895))));
    let options = RefineOptions::default();
    let all_at_once = Steps { select: Arc::new(AllAtOnce), ..Steps::of(&options) };
    let [by_patches, all_at_once] = [Steps::of(&options), all_at_once].map(|steps| {
        let start = Start::from(carved(&domain, AlgorithmKey::Incremental)).with_steps(steps);
        let mut refinement = Refinement::new(start, options).unwrap();
        refinement.run(&mut NoObserver);
        let (cdt, report) = refinement.finish();
        assert_eq!(cdt.check_delaunay(), []);
        assert_eq!(report.leftovers, []);
        report.vertices
    });
    assert!(by_patches > 22_000, "{by_patches} vertices: there is something to do in each of three patches");
    let ratio = f64::from(by_patches as u32) / f64::from(all_at_once as u32);
    assert!((0.99..1.01).contains(&ratio), "{by_patches} to {all_at_once}");
}
