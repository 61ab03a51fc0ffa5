//! Going back: every state is what it was, also behind a run, and what comes after it is what came the first time.

use std::path::Path;

use trimalla::constrained::{ConstrainedTriangulation, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build};
use trimalla::drawing::Pslg;
use trimalla::refine::{NoObserver, Preset, Recover, RefineOptions, Refinement, Select};
use trimalla_testkit::generators::SplitMix64;
use trimalla_testkit::readers::read_poly;

fn begun(name: &str, options: RefineOptions) -> Refinement {
    let shapes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/shapes");
    let drawing: Pslg = read_poly(&shapes.join(name).with_extension("poly"));
    let (cdt, _) = build(&drawing, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()).expect("a domain");
    Refinement::new(cdt, options).expect("good options")
}

/// Recipes whose steps change all that a step can change: queues of both orders, lattices, segments let go.
fn recipes() -> Vec<RefineOptions> {
    let mut all: Vec<RefineOptions> = Preset::ALL.iter().map(|&preset| RefineOptions::of(preset)).collect();
    all.push(RefineOptions::default().with_max_area(0.2));
    for recover in [Recover::BySplitting, Recover::Complete, Recover::None] {
        let mut options = RefineOptions::default();
        options.recipe.recover = recover;
        all.push(options);
    }
    let mut oldest_first = RefineOptions::default();
    oldest_first.recipe.select = Select::First;
    all.push(oldest_first);
    all.into_iter().map(|options| options.with_min_angle_deg(28.0).with_max_vertices(700)).collect()
}

/// What is seen of a refinement from outside.
fn state(refinement: &Refinement) -> (ConstrainedTriangulation, String) {
    (refinement.triangulation().clone(), format!("{:?}", refinement.overview()))
}

#[test]
fn runs_are_taken_back_step_by_step() {
    for name in ["key", "plate"] {
        for (number, options) in recipes().into_iter().enumerate() {
            let mut stepwise = begun(name, options);
            let mut states = vec![state(&stepwise)];
            while !stepwise.step().outcome.is_last() {
                states.push(state(&stepwise));
            }
            let end = state(&stepwise);

            let mut refinement = begun(name, options);
            refinement.keep_history(usize::MAX);
            refinement.run(&mut NoObserver);
            assert!(state(&refinement).0 == end.0, "{name}, recipe {number}: the record changes the run");
            assert_eq!(refinement.steps_made() as usize, states.len(), "{name}, recipe {number}");
            let mut random = SplitMix64::new(number as u64);
            let mut at = states.len();
            // Back and forth: whatever was taken back comes again as it came the first time.
            while at > 0 {
                for _ in 0..1 + random.below(40).min(at - 1) {
                    assert!(refinement.back());
                    at -= 1;
                    assert!(state(&refinement) == states[at], "{name}, recipe {number}: back to {at}");
                }
                let forward = random.below(8).min(states.len() - 1 - at);
                for _ in 0..forward.min(at) {
                    refinement.step();
                    at += 1;
                    assert!(state(&refinement) == states[at], "{name}, recipe {number}: on to {at}");
                }
            }
            assert!(!refinement.back(), "{name}, recipe {number}: nothing is left");
            refinement.run(&mut NoObserver);
            assert!(state(&refinement).0 == end.0, "{name}, recipe {number}: the second run ends elsewhere");
        }
    }
}

/// Old steps are forgotten when records take too much; those left can be taken back.
#[test]
fn a_history_keeps_to_its_memory() {
    let options = RefineOptions::default().with_max_vertices(3000).with_max_area(0.02);
    let mut whole = begun("key", options);
    whole.keep_history(usize::MAX);
    whole.run(&mut NoObserver);
    let most = whole.history_bytes() / 4;
    let mut refinement = begun("key", options);
    refinement.keep_history(most);
    refinement.run(&mut NoObserver);
    assert!(refinement.history_bytes() <= most && refinement.history_bytes() > most / 2);
    let steps = refinement.steps_made();
    assert!(steps > 100 && steps < whole.steps_made() / 2, "{steps} of {}", whole.steps_made());
    let end = refinement.triangulation().clone();
    assert!((0..steps).all(|_| refinement.back()) && !refinement.back());
    refinement.run(&mut NoObserver);
    assert!(*refinement.triangulation() == end);
}

#[test]
fn steps_that_are_forgotten_are_not_taken_back() {
    let mut refinement = begun("key", RefineOptions::default().with_min_angle_deg(28.0));
    refinement.keep_history(usize::MAX);
    let mut states = vec![state(&refinement)];
    for number in 1..=30 {
        refinement.step();
        let changes = refinement.last_changes().expect("a step");
        let before = &states[number - 1].0;
        let is_used = |t: &ConstrainedTriangulation, v: usize| {
            v < t.points().len() && t.is_used(trimalla::half_edge::VertexId::from_index(v))
        };
        let t = refinement.triangulation();
        let changed = t.vertices_changed(changes);
        let differ = (0..t.points().len().max(before.points().len())).filter(|&v| is_used(t, v) != is_used(before, v));
        for v in differ {
            assert!(changed.iter().any(|changed| changed.index() == v), "vertex {v} in step {number}");
        }
        states.push(state(&refinement));
    }
    let (bytes, copy) = (refinement.history_bytes(), refinement.without_history());
    assert!(state(&copy) == states[30] && copy.steps_made() == 0 && copy.history_bytes() == 0);
    refinement.forget_oldest(20);
    assert!(refinement.history_bytes() < bytes && refinement.steps_made() == 10 && refinement.step_number() == 30);
    for at in (20..30).rev() {
        assert!(refinement.back());
        assert!(state(&refinement) == states[at], "back to {at}");
    }
    assert!(!refinement.back(), "the others are forgotten");
}
