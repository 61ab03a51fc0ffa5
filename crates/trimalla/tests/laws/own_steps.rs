//! Strategies from outside the library, one for each step: the example's, put through the suites that ours pass.

#[path = "../../examples/own_steps.rs"]
#[allow(dead_code, reason = "an example has a main function")]
mod example;

use std::sync::Arc;

use example::{BothCenters, CompleteRecovery, FirstRing, LargestFirst, NoneLonger, fenced, own_steps};
use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build};
use trimalla::drawing::Pslg;
use trimalla::geometry::Point;
use trimalla::quality::against_input;
use trimalla::refine::conformance::{self, Subject};
use trimalla::refine::steps::Steps;
use trimalla::refine::{NoObserver, Recover, RefineOptions, Refinement, Start, StepOutcome, StopReason};
use trimalla::triangulation::{check_mesh, check_mesh_delaunay};

fn with(change: impl Fn(&mut Steps) + Send + Sync + 'static) -> Subject {
    Subject::default().with_steps(move |_, steps| change(steps))
}

#[test]
fn each_step_of_our_own_passes_its_suite() {
    conformance::prepare(&with(|steps| steps.prepare = Arc::new(NoneLonger(2.0)))).expect("step 1");
    conformance::select(&with(|steps| steps.select = Arc::new(LargestFirst))).expect("step 2");
    conformance::point(&with(|steps| steps.point = Arc::new(BothCenters))).expect("step 3");
    conformance::insert(&with(|steps| steps.insert = Arc::new(FirstRing))).expect("step 4");
    conformance::recover(&with(|steps| steps.recover = Arc::new(CompleteRecovery))).expect("step 5");
    conformance::laws(&Subject::default().with_steps(|_, steps| *steps = own_steps())).expect("all five");
}

fn begun(options: RefineOptions, steps: Steps) -> Refinement {
    begun_on(&fenced(), options, steps)
}

fn begun_on(drawing: &Pslg, options: RefineOptions, steps: Steps) -> Refinement {
    let (cdt, _) = build(drawing, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()).expect("a domain");
    Refinement::new(Start::from(cdt).with_steps(steps), options).expect("good options")
}

/// The segment is gone while points go in, and there in the end; the library's own step does the same.
#[test]
fn complete_recovery_brings_back_what_insertions_lost() {
    let options = RefineOptions::default().with_min_angle_deg(25.0).with_max_vertices(5000);
    let mut of_recipe = options;
    of_recipe.recipe.recover = Recover::Complete;
    let outside = Steps { recover: Arc::new(CompleteRecovery), ..Steps::of(&options) };
    let meshes = [(options, outside), (of_recipe, Steps::of(&of_recipe))].map(|(options, steps)| {
        let mut refinement = begun(options, steps);
        let mut was_missing = false;
        loop {
            let event = refinement.step();
            let mesh = refinement.triangulation().to_indexed(&fenced());
            was_missing |= !against_input(&mesh, &fenced()).faults.is_empty();
            if event.outcome.is_last() {
                break;
            }
        }
        assert!(was_missing, "the segment is never lost");
        let (cdt, report) = refinement.finish();
        let mesh = cdt.to_indexed(&fenced());
        assert_eq!((check_mesh(&mesh), against_input(&mesh, &fenced()).faults), (vec![], vec![]));
        assert_eq!(check_mesh_delaunay(&mesh, &[]), [], "constrained Delaunay, the segment a wall");
        assert!(report.complete() && report.lost_segments.is_empty(), "{:?}", report.reasons());
        cdt.canonical()
    });
    assert_eq!(meshes[0], meshes[1]);
}

/// Where one point is proposed for a triangle, one goes in; where two are, often two.
#[test]
fn two_points_go_in_together() {
    let options = RefineOptions::default().with_min_angle_deg(28.0).with_max_vertices(2000);
    let mut drawing = fenced();
    let spread = |i: u32, step: f64| 0.1 + 7.8 * (f64::from(i) * step).fract();
    drawing.points.extend((1..300).map(|i| Point::new(spread(i, 0.754_877_666), 0.5 * spread(i, 0.618_033_989))));
    let steps = Steps { point: Arc::new(BothCenters), ..Steps::of(&options) };
    let mut refinement = begun_on(&drawing, options, steps);
    let mut pairs = 0;
    loop {
        let before = refinement.triangulation().steiner_vertices();
        let event = refinement.step();
        pairs += usize::from(refinement.triangulation().steiner_vertices() == before + 2);
        if event.outcome.is_last() {
            break;
        }
    }
    assert!(pairs > 0, "no step put two points in");
    assert!(refinement.finish().1.complete());
}

/// Step 1 has the triangulation in hand: all splits wait before the first point goes in.
#[test]
fn a_step_1_of_our_own_splits_before_points_go_in() {
    let options = RefineOptions::default().with_min_angle_deg(25.0);
    let mut refinement = begun(options, Steps { prepare: Arc::new(NoneLonger(1.0)), ..Steps::of(&options) });
    let mut points_before = None;
    for _ in 0..1000 {
        let event = refinement.step();
        let is_before = [StepOutcome::Prepared, StepOutcome::SubsegmentSplit, StepOutcome::SubsegmentKept];
        if !is_before.contains(&event.outcome) {
            points_before = Some(refinement.triangulation().steiner_vertices());
            break;
        }
    }
    assert!(points_before.is_some_and(|n| n >= 4 * 7), "{points_before:?} vertices on sides of length 8");
    assert_eq!(refinement.run(&mut NoObserver), StopReason::Finished);
}
