//! The five steps in combination: what must not depend on a choice, and what must.

use std::collections::BTreeSet;
use std::path::Path;

use trimalla::constrained::{ConstrainedTriangulation, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build};
use trimalla::drawing::{IndexedMesh, Pslg, Region, SegmentId};
use trimalla::geometry::{Orientation, Point, Triangle};
use trimalla::half_edge::FaceId;
use trimalla::quality::{against_input, aspect_ratio};
use trimalla::refine::{
    Initial, Insert, Name, NoObserver, PlacePoint, Prepare, PrepareWhen, Preset, Reason, Recipe, Recover,
    RefineOptions, Refinement, Report, Select, Start, StepOutcome,
};
use trimalla::size::TriangleInRegion;
use trimalla::triangulation::{check_mesh, check_mesh_delaunay};
use trimalla_testkit::generators::SplitMix64;
use trimalla_testkit::oracles::{DelaunayRule, check_indexed_with};
use trimalla_testkit::readers::read_poly;

fn shape(name: &str) -> Pslg {
    read_poly(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/shapes").join(name).with_extension("poly"))
}

fn started(drawing: &Pslg) -> Start {
    build(drawing, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()).expect("a domain").0.into()
}

fn begun(drawing: &Pslg, options: RefineOptions) -> Refinement {
    Refinement::new(started(drawing), options).expect("good options")
}

/// Flips and cavities lead to the same mesh, vertex by vertex, whatever the order and the points.
#[test]
fn flips_and_cavities_agree() {
    for name in ["guitar", "key", "plate", "star", "coast"] {
        let drawing = shape(name);
        for preset in Preset::ALL {
            let mut options = RefineOptions::of(preset).with_min_angle_deg(28.0).with_max_vertices(2000);
            if !matches!(options.recipe.insert, Insert::Flip | Insert::Cavity) {
                continue;
            }
            let meshes = [Insert::Flip, Insert::Cavity].map(|insert| {
                options.recipe.insert = insert;
                let mut refinement = begun(&drawing, options);
                refinement.run(&mut NoObserver);
                let (cdt, report) = refinement.finish();
                assert_eq!(cdt.check_delaunay(), [], "{name}, {preset}, {insert}");
                (cdt.points().to_vec(), cdt.canonical(), report.leftovers.len())
            });
            assert!(meshes[0] == meshes[1], "{name}, {preset}");
        }
    }
}

/// A square with a long segment inside, between rows of vertices: no edge of the Delaunay triangulation.
fn fenced() -> Pslg {
    let mut points: Vec<Point> =
        [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0], [1.0, 4.0], [7.0, 4.5]].map(Point::from).to_vec();
    points.extend((2..7).flat_map(|i| [Point::new(f64::from(i), 3.9), Point::new(f64::from(i) + 0.3, 4.8)]));
    Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0], [4, 5]], ..Pslg::default() }
}

fn recovered(drawing: &Pslg, recover: Recover, preset: Preset) -> (IndexedMesh, Report) {
    let mut options = RefineOptions::of(preset).with_min_angle_deg(25.0).with_max_vertices(5000);
    options.recipe.recover = recover;
    let mut refinement = begun(drawing, options);
    refinement.run(&mut NoObserver);
    let (cdt, report) = refinement.finish();
    assert_eq!(cdt.check_delaunay(), [], "{recover}");
    let mesh = cdt.to_indexed(drawing);
    assert_eq!(check_mesh(&mesh), [], "{recover}");
    (mesh, report)
}

/// What the three ways to recover say they do, they do, and they differ.
#[test]
fn each_way_to_recover_does_what_it_says() {
    let drawing = fenced();
    let [whole, split, none] = [Recover::WholeEdge, Recover::BySplitting, Recover::None]
        .map(|recover| recovered(&drawing, recover, Preset::OffCenter));
    for (mesh, report) in [&whole, &split] {
        assert_eq!(report.lost_segments, []);
        assert_eq!(against_input(mesh, &drawing).faults, []);
        assert!(report.complete(), "{:?}", report.reasons());
    }
    assert_eq!(none.1.lost_segments, [SegmentId(4)], "the long segment is in the way of better edges");
    assert!(!none.1.complete());
    assert!(!against_input(&none.0, &drawing).faults.is_empty());
    assert!(whole.0.triangles != split.0.triangles && split.0.triangles != none.0.triangles);
    // Without walls the triangulation is Delaunay throughout.
    let unlocked = IndexedMesh { segments: vec![], segment_markers: vec![], ..none.0 };
    assert_eq!(check_mesh_delaunay(&unlocked, &[]), []);
}

/// By splitting alone, the mesh is conforming: Delaunay although its segments are no walls.
#[test]
fn splitting_makes_a_conforming_triangulation() {
    let drawing = fenced();
    let in_the_end = Recipe { recover: Recover::BySplitting, prepare: Prepare::None, ..Recipe::default() };
    let at_first = Recipe { initial: Initial::Conforming, prepare: Prepare::None, ..Recipe::default() };
    let meshes = [in_the_end, at_first].map(|recipe| {
        let options = RefineOptions { recipe, ..RefineOptions::default() }.with_min_angle_deg(0.0);
        let mut refinement = begun(&drawing, options);
        refinement.run(&mut NoObserver);
        let (cdt, report) = refinement.finish();
        let mesh = cdt.to_indexed(&drawing);
        assert!(report.segments_split > 0 && report.points_inserted == 0);
        assert_eq!(against_input(&mesh, &drawing).faults, []);
        let unlocked = IndexedMesh { segments: vec![], segment_markers: vec![], ..mesh.clone() };
        assert_eq!(check_indexed_with(&unlocked, None, DelaunayRule::Delaunay), Vec::<String>::new());
        (mesh.points, cdt.canonical())
    });
    assert!(meshes[0] == meshes[1], "without angles to improve both are the same");
}

/// Segments that part regions stay, or attributes would run over.
#[test]
fn regions_keep_their_segments() {
    let mut drawing = fenced();
    drawing.points.extend([[0.0, 6.0], [8.0, 6.0]].map(Point::from));
    let n = drawing.points.len() as u32;
    drawing.segments = vec![[0, 1], [1, n - 1], [n - 1, 2], [2, 3], [3, n - 2], [n - 2, 0], [4, 5], [n - 2, n - 1]];
    drawing.regions = vec![Region { seed: Point::new(4.0, 7.0), attribute: 7.0, max_area: Some(0.25) }];
    for recover in [Recover::None, Recover::BySplitting] {
        let (mesh, report) = recovered(&drawing, recover, Preset::LeppCentroid);
        assert!(!report.lost_segments.contains(&SegmentId(7)), "{recover}");
        for (t, attribute) in mesh.triangles.iter().zip(&mesh.triangle_attributes) {
            let above = t.iter().all(|&v| mesh.points[v as usize].y >= 6.0);
            assert_eq!(*attribute, if above { 7.0 } else { 0.0 }, "{recover}");
        }
    }
}

/// The aspect ratio is a criterion of its own, and one that the caller makes too.
#[test]
fn aspect_ratios_and_tests_of_the_caller_are_met() {
    let drawing = shape("key");
    for ratio in [1.5, 2.0, 4.0] {
        let options =
            RefineOptions::default().with_min_angle_deg(0.0).with_max_aspect_ratio(ratio).with_max_vertices(50_000);
        let mut refinement = begun(&drawing, options);
        refinement.run(&mut NoObserver);
        let (cdt, report) = refinement.finish();
        assert!(report.complete(), "{ratio}: {:?}", report.reasons());
        let worst = cdt.real_faces().map(|f| aspect_ratio(&triangle(&cdt, f))).fold(0.0, f64::max);
        assert!(worst <= ratio && worst > 0.6 * ratio, "{worst} where {ratio} is allowed");
    }
    let fine = |t: &Triangle| t.centroid().y > 0.0 && t.area() > 1.0;
    let test = move |at: TriangleInRegion| fine(&at.triangle);
    let start = started(&drawing).with_test(test);
    let mut refinement = Refinement::new(start, RefineOptions::default().with_min_angle_deg(20.0)).expect("options");
    refinement.run(&mut NoObserver);
    let (cdt, report) = refinement.finish();
    assert_eq!((report.leftovers.len(), cdt.check_delaunay()), (0, vec![]));
    assert!(cdt.real_faces().all(|f| !fine(&triangle(&cdt, f))));
    let coarse = cdt.real_faces().map(|f| triangle(&cdt, f).area()).fold(0.0, f64::max);
    assert!(coarse > 1.0, "below the axis triangles stay large");
}

/// A test of the caller's own is asked for triangles of the domain alone, also where boundary segments are split.
#[test]
fn a_test_of_the_caller_gets_triangles_of_the_domain() {
    // Shifted, so that what is no vertex lies far outside.
    let mut drawing = shape("key");
    drawing.points.iter_mut().for_each(|p| *p = Point::new(p.x + 1e4, p.y + 1e4));
    drawing.holes.iter_mut().for_each(|p| *p = Point::new(p.x + 1e4, p.y + 1e4));
    let asked = |TriangleInRegion { triangle: t, .. }: TriangleInRegion| {
        assert!(t.orientation() == Orientation::CounterClockwise && t.centroid().x > 5e3, "{t:?}");
        t.area() > 0.5
    };
    let start = started(&drawing).with_test(asked);
    let mut refinement = Refinement::new(start, RefineOptions::default()).expect("options");
    refinement.run(&mut NoObserver);
    assert!(refinement.finish().1.segments_split > 10);
}

fn triangle(cdt: &ConstrainedTriangulation, f: FaceId) -> Triangle {
    let [a, b, c] = cdt.face_points(f);
    Triangle::new(a, b, c)
}

/// Three small drawings: a hole and a loose segment, a small angle, a fence.
fn small_shapes() -> [(&'static str, Pslg); 3] {
    let ring = |points: &[[f64; 2]]| points.iter().copied().map(Point::from).collect::<Vec<_>>();
    let mut holed = Pslg {
        points: ring(&[
            [0.0, 0.0],
            [6.0, 0.0],
            [6.0, 4.0],
            [0.0, 4.0],
            [1.0, 1.0],
            [2.0, 1.0],
            [1.0, 2.5],
            [3.0, 1.0],
            [5.0, 3.5],
        ]),
        segments: vec![[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 4], [7, 8]],
        ..Pslg::default()
    };
    holed.holes.push(Point::new(1.2, 1.2));
    let wedge = Pslg {
        points: ring(&[[0.0, 0.0], [8.0, 0.0], [8.0, 1.5], [3.0, 0.1], [7.0, 0.4]]),
        segments: vec![[0, 1], [1, 2], [2, 0], [3, 4]],
        ..Pslg::default()
    };
    [("holed", holed), ("wedge", wedge), ("fenced", fenced())]
}

/// Every choice of every step with every other.
fn all_recipes() -> impl Iterator<Item = Recipe> {
    let mut all = vec![Recipe::default()];
    let mut each = |set: &dyn Fn(&mut Vec<Recipe>, Recipe)| {
        all = all.iter().fold(Vec::new(), |mut next, &r| {
            set(&mut next, r);
            next
        });
    };
    each(&|out, r| out.extend(Prepare::ALL.iter().map(|&prepare| Recipe { prepare, ..r })));
    each(&|out, r| out.extend(PrepareWhen::ALL.iter().map(|&prepare_when| Recipe { prepare_when, ..r })));
    each(&|out, r| out.extend(Select::ALL.iter().map(|&select| Recipe { select, ..r })));
    each(&|out, r| out.extend([false, true].map(|until_destroyed| Recipe { until_destroyed, ..r })));
    each(&|out, r| out.extend(PlacePoint::ALL.iter().map(|&point| Recipe { point, ..r })));
    each(&|out, r| out.extend(Insert::ALL.iter().map(|&insert| Recipe { insert, ..r })));
    each(&|out, r| out.extend(Recover::ALL.iter().map(|&recover| Recipe { recover, ..r })));
    all.into_iter()
}

#[test]
fn every_combination_of_the_five_steps_is_sound() {
    let mut runs = 0;
    for (name, drawing) in small_shapes() {
        for recipe in all_recipes() {
            let options =
                RefineOptions { recipe, ..RefineOptions::default() }.with_min_angle_deg(28.0).with_max_vertices(60);
            let mut refinement = begun(&drawing, options);
            if recipe.select == Select::Manual {
                let all: Vec<FaceId> = refinement.triangulation().real_faces().collect();
                assert!(all.into_iter().all(|f| refinement.pick(f)), "real faces can be picked");
            }
            refinement.run(&mut NoObserver);
            let (cdt, report) = refinement.finish();
            let delaunay = matches!(recipe.insert, Insert::Flip | Insert::Cavity);
            let faults = if delaunay { cdt.check_delaunay() } else { cdt.check() };
            assert_eq!(faults, [], "{name}: {recipe}");
            let mesh = cdt.to_indexed(&drawing);
            assert_eq!(check_mesh(&mesh), [], "{name}: {recipe}");
            if report.lost_segments.is_empty() {
                assert_eq!(against_input(&mesh, &drawing).faults, [], "{name}: {recipe}");
            } else {
                assert_eq!(recipe.recover, Recover::None, "{name}: {recipe}");
            }
            assert!(mesh.points.len() <= 60, "{name}: {recipe}: {} vertices", mesh.points.len());
            let told: usize = report.reasons().iter().map(|r| r.1).sum();
            assert_eq!(told, report.leftovers.len(), "{name}: {recipe}");
            runs += 1;
        }
    }
    assert_eq!(
        runs,
        3 * 2 * 2 * Select::ALL.len() * 2 * PlacePoint::ALL.len() * Insert::ALL.len() * Recover::ALL.len()
    );
}

/// Only triangles that were picked are treated, bad or not.
#[test]
fn manual_refinement_treats_what_is_picked() {
    let mut options = RefineOptions::of(Preset::LeppCentroid).with_min_angle_deg(25.0);
    options.recipe.select = Select::Manual;
    options.recipe.until_destroyed = false;
    let drawing = shape("key");
    let mut refinement = begun(&drawing, options);
    let before = refinement.triangulation().points().len();
    refinement.run(&mut NoObserver);
    assert_eq!(refinement.triangulation().points().len(), before, "nothing was picked");
    let first = refinement.triangulation().real_faces().next().expect("a face");
    assert!(refinement.pick(first) && !refinement.pick(FaceId(u32::MAX / 3)));
    refinement.run(&mut NoObserver);
    let (cdt, report) = refinement.finish();
    assert_eq!(cdt.points().len(), before + 1);
    assert!(
        report
            .leftovers
            .iter()
            .all(|l| matches!(l.reason, Reason::NotPicked | Reason::InputAngle | Reason::AcrossSmallInputAngle))
    );
}

/// Every step says what it did, and all of them are taken back to the arrays of the start.
#[test]
fn steps_tell_what_they_did_and_are_taken_back() {
    for (name, drawing) in small_shapes() {
        for preset in Preset::ALL {
            let options = RefineOptions::of(preset).with_min_angle_deg(30.0).with_max_vertices(200);
            let mut refinement = begun(&drawing, options);
            let start = refinement.triangulation().clone();
            let mut states = vec![(start.clone(), 0)];
            loop {
                let before = triangles_of(refinement.triangulation());
                let event = refinement.step();
                assert_eq!(event.number, refinement.steps_made());
                let mut expected: BTreeSet<Name> = before;
                assert!(event.destroyed.iter().all(|t| expected.remove(t)), "{name}, {preset}: {event:?}");
                assert!(event.made.iter().all(|t| expected.insert(*t)), "{name}, {preset}: {event:?}");
                assert!(expected == triangles_of(refinement.triangulation()), "{name}, {preset}: {event:?}");
                if let Some(inserted) = event.inserted {
                    assert_eq!(refinement.triangulation().point(inserted.vertex), inserted.point);
                }
                if let Some((triangle, _)) = event.selected {
                    assert_eq!(event.lepp.first(), Some(&triangle));
                    assert!(
                        event.terminal_edge.is_some()
                            && event.given_up.is_some() != event.candidates.iter().any(|c| c.refused.is_none())
                    );
                }
                let done = matches!(event.outcome, StepOutcome::Finished | StepOutcome::Exhausted);
                states.push((refinement.triangulation().clone(), event.number));
                if done {
                    break;
                }
            }
            for (state, steps) in states.iter().rev().skip(1) {
                assert!(refinement.back(), "{name}, {preset}: back to {steps}");
                assert_eq!(refinement.steps_made(), *steps);
                assert!(refinement.triangulation() == state, "{name}, {preset}: step {steps}");
            }
            assert!(!refinement.back() && *refinement.triangulation() == start, "{name}, {preset}");
            // Forward again it goes the same way.
            refinement.run_until(|_| false);
            assert!(refinement.triangulation() == &states[states.len() - 1].0, "{name}, {preset}");
        }
    }
}

/// What the caller does between steps is taken back with them: picks, other options, a test of his own.
#[test]
fn steps_are_taken_back_past_picks_and_other_options() {
    let mut random = SplitMix64::new(5);
    for (name, drawing) in small_shapes() {
        for select in [Select::Manual, Select::ShortestEdge, Select::First] {
            let mut options = RefineOptions::of(Preset::LeppCentroid).with_min_angle_deg(25.0).with_max_vertices(400);
            options.recipe.select = select;
            let mut refinement = begun(&drawing, options);
            let mut before = Vec::new();
            for _ in 0..120 {
                refinement = interfered(refinement, options, &mut random);
                before.push(refinement.triangulation().clone());
                refinement.step();
                // Back and forth in between, too.
                if random.below(6) == 0 {
                    let steps = 1 + random.below(before.len());
                    go_back(&mut refinement, &mut before, steps, name);
                }
            }
            let steps = before.len();
            go_back(&mut refinement, &mut before, steps, name);
            assert!(!refinement.back(), "{name}: nothing is left");
        }
    }
}

/// Picks a triangle, changes options or adds a test, or does nothing.
fn interfered(mut refinement: Refinement, options: RefineOptions, random: &mut SplitMix64) -> Refinement {
    match random.below(16) {
        0..=7 => {
            let faces: Vec<FaceId> = refinement.triangulation().real_faces().collect();
            assert!(refinement.pick(faces[random.below(faces.len())]));
            refinement
        }
        8 => {
            let angle = [20.0, 25.0, 30.0][random.below(3)];
            refinement.change_options(options.with_min_angle_deg(angle)).expect("good options");
            refinement
        }
        9 => {
            let most = 0.05 + 0.1 * random.below(4) as f64;
            refinement.change_test(move |at: TriangleInRegion| at.triangle.area() > most);
            refinement
        }
        _ => refinement,
    }
}

/// Takes steps back one by one; each state is the one before its step.
fn go_back(refinement: &mut Refinement, before: &mut Vec<ConstrainedTriangulation>, steps: usize, name: &str) {
    for _ in 0..steps {
        let was = before.pop().expect("a step");
        assert_eq!(refinement.steps_made() as usize, before.len() + 1, "{name}");
        assert!(refinement.back(), "{name}: step {}", before.len());
        assert!(*refinement.triangulation() == was, "{name}: step {} restores another mesh", before.len());
    }
}

fn triangles_of(cdt: &ConstrainedTriangulation) -> BTreeSet<Name> {
    let sorted = |mut t: Name| {
        t.sort_unstable();
        t
    };
    cdt.real_faces().map(|f| sorted(cdt.face_vertices(f))).collect()
}
