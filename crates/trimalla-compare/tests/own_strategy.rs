//! A strategy from outside beside the library's: bounded, the same for any number of jobs, resumable.
#![allow(clippy::unwrap_used, reason = "a helper of a test may fail the test")]

use std::fs;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use trimalla::drawing::Pslg;
use trimalla::geometry::{Point, Triangle};
use trimalla::half_edge::FaceId;
use trimalla::refine::Preset;
use trimalla::refine::steps::{Places, PointStep, Proposal, View};
use trimalla_compare::{
    Cell, CompareError, Contender, End, Experiment, Journal, NoWatch, Outcome, Task, Times, Watch, figures, markdown,
    records,
};

/// The middle of the triangle: a poor choice, which is what budgets are for.
struct Barycenter;

impl PointStep for Barycenter {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places) {
        let [a, b, c] = view.cdt.corners(face);
        places.extend(Proposal::towards(view, face, Triangle::new(a, b, c).centroid()));
    }
}

fn experiment(version: &str) -> Experiment {
    let mut points = [[0.0, 0.0], [10.0, 0.0], [10.0, 6.0], [0.0, 6.0]].map(Point::from).to_vec();
    points.extend((1..24).map(f64::from).map(|i| Point::new(0.4 * i, 0.01 * i * i)));
    let arc = Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]], ..Pslg::default() };
    let mut experiment = Experiment::new([25.0, 20.0, 25.0]);
    experiment.max_vertices = 400;
    experiment.add_drawing("arc", arc.clone()).unwrap();
    experiment.add_drawing("arc", arc).unwrap();
    experiment.add_contender(Contender::of(Preset::OffCenter)).unwrap();
    let own = Contender::of(Preset::OffCenter).called("barycenter");
    experiment.add_contender(own.with_steps(version, |_, steps| steps.point = Arc::new(Barycenter))).unwrap();
    experiment
}

fn outcomes(experiment: &Experiment, jobs: usize) -> Vec<Outcome> {
    let ran = experiment.run(jobs, None, &NoWatch).unwrap();
    let cells = experiment.sheets(&ran, None).into_iter().flat_map(|s| s.columns).flat_map(|c| c.cells);
    cells.map(|cell| if let Cell::Run(outcome) = cell { outcome } else { panic!("{cell:?}") }).collect()
}

#[test]
fn outside_strategies_are_run_beside_the_library_s() {
    let mut experiment = experiment("1");
    assert_eq!((experiment.angles(), &experiment.drawings()[1].title[..]), (&[20.0, 25.0][..], "arc-2"));
    let found = outcomes(&experiment, 1);
    // Drawings, contenders, angles.
    assert_eq!(found.len(), 8);
    assert!(found[..2].iter().all(|o| o.end == End::Done && o.min_angle_deg >= 20.0), "{found:?}");
    assert!(found[2..4].iter().all(|o| o.end == End::Budget && o.vertices == 400), "{found:?}");
    let untimed = |list: Vec<Outcome>| list.into_iter().map(|o| Outcome { seconds: 0.0, ..o }).collect::<Vec<_>>();
    assert_eq!(untimed(found[..4].to_vec()), untimed(found[4..].to_vec()), "both drawings are the same");
    assert_eq!(untimed(found), untimed(outcomes(&experiment, 5)));

    let ran = experiment.run(2, None, &NoWatch).unwrap();
    let sheets = experiment.sheets(&ran, None);
    assert!(markdown::text(&experiment, &sheets).contains("| vertices | off-center | barycenter |"));
    assert!(figures::all_in_one(&experiment, &sheets).contains("barycenter"));
    assert!(!records::json(&experiment, &sheets).contains("step_seconds"));
    experiment.times = Times::BySteps;
    let ran = experiment.run(2, None, &NoWatch).unwrap();
    let csv = records::csv(&experiment, &experiment.sheets(&ran, None));
    let fields = |line: &str| line.matches(',').count();
    assert!(csv.lines().all(|line| fields(line) == fields(csv.lines().next().unwrap())), "{csv}");
    assert!(csv.lines().next().unwrap().ends_with(",insert_seconds,recover_seconds,rest_seconds"));
    assert!(records::json(&experiment, &experiment.sheets(&ran, None)).contains("\"step_seconds\":{\"insert\":"));
}

/// Counts runs, and ends the experiment after some.
#[derive(Default)]
struct Counting {
    ran: AtomicUsize,
    most: Option<usize>,
}

impl Watch for Counting {
    fn ran(&self, _: &Task<'_>) {
        self.ran.fetch_add(1, Ordering::SeqCst);
    }

    fn is_cancelled(&self) -> bool {
        self.most.is_some_and(|most| self.ran.load(Ordering::SeqCst) >= most)
    }
}

#[test]
fn what_was_stopped_goes_on_and_other_steps_are_other_runs() {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("own-strategy.journal");
    let _ = fs::remove_file(&path);
    let run = |experiment: &Experiment, most: Option<usize>| {
        let (mut journal, watch) = (Journal::open(&path).unwrap(), Counting { most, ..Counting::default() });
        let ran = experiment.run(1, Some(&mut journal), &watch);
        (ran, watch.ran.into_inner())
    };
    let mut first = experiment("1");
    first.times = Times::Hidden;
    let stopped = run(&first, Some(3)).0;
    assert!(matches!(stopped, Err(CompareError::Interrupted)), "{stopped:?}");
    // Both drawings are the same, and so are their runs: four outcomes are all.
    let lines = || fs::read_to_string(&path).unwrap().lines().count();
    assert_eq!(lines(), 3);
    let (ran, runs) = run(&first, None);
    assert_eq!((runs, lines()), (8 - 6, 5));
    let text = |experiment: &Experiment, ran| records::csv(experiment, &experiment.sheets(&ran, None));
    let known = run(&first, None);
    assert_eq!((text(&first, ran.unwrap()), 0), (text(&first, known.0.unwrap()), known.1));
    assert_eq!(run(&experiment("2"), None).1, 4, "the outside strategy is another one");
    let mut timed = experiment("1");
    timed.times = Times::BySteps;
    assert_eq!(run(&timed, None).1, 8, "outcomes without the times of steps are not enough");
    assert_eq!(run(&timed, None).1, 0);
}
