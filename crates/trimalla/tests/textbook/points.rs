//! Triangulations of point sets.

use std::collections::BTreeSet;

use trimalla::IndexedMesh;
use trimalla::delaunay::{AlgorithmKey, BuildError};
use trimalla::geometry::Point;
use trimalla::optimal::{OptimalError, OptimalInput, OptimalMethod};
use trimalla::trace::{Act, NoTrace, Shape, Step, Trace};
use trimalla_testkit::generators::{PointSetKind, point_set};
use trimalla_testkit::oracles::RBig;

use super::enumerate;

/// Point sets of every kind, of at most `n` points.
fn sets(n: usize, seeds: u64) -> impl Iterator<Item = (String, Vec<Point>)> {
    let kinds = PointSetKind::ALL.into_iter();
    kinds.flat_map(move |kind| (0..seeds).map(move |seed| (format!("{kind:?} {n} {seed}"), point_set(kind, n, seed))))
}

#[test]
fn pairs_give_one_of_the_triangulations() {
    for n in [0, 3, 6, 8] {
        for (name, points) in sets(n, 2) {
            let made = OptimalMethod::Pairs.triangulate(&OptimalInput::of_points(&points), &mut NoTrace).unwrap();
            let all = enumerate::triangulations(&points);
            assert!(all.contains(&made.triangles) || all.is_empty() && made.triangles.is_empty(), "{name}: {made:?}");
        }
    }
}

#[test]
fn five_algorithms_share_one_canonical_list() {
    let mut sets_seen = 0;
    for n in [4, 12, 40] {
        for (name, points) in sets(n, 9) {
            sets_seen += 1;
            let [first, others @ ..] = AlgorithmKey::ALL;
            let expected = first.triangulate(&points, None).unwrap();
            for other in others {
                let made = other.triangulate(&points, None).unwrap();
                assert_eq!(made.check_delaunay(), [], "{other} {name}");
                assert_eq!(made.dimension(), expected.dimension(), "{other} {name}");
                assert_eq!(made.canonical(), expected.canonical(), "{other} {name}");
                assert_eq!(made.canonical_edges(), expected.canonical_edges(), "{other} {name}");
                assert_eq!(made.duplicates(), expected.duplicates(), "{other} {name}");
            }
        }
    }
    assert!(sets_seen > 1000, "only {sets_seen} sets");
}

#[test]
fn five_algorithms_agree_on_larger_sets() {
    for (name, points) in sets(400, 1) {
        let [first, others @ ..] = AlgorithmKey::ALL;
        let expected = first.triangulate(&points, None).unwrap().canonical();
        for other in others {
            assert_eq!(other.triangulate(&points, None).unwrap().canonical(), expected, "{other} {name}");
        }
    }
}

/// Rounding leads the sweep of `voronoi` astray only where distances are below the last place of the size of the set.
#[test]
fn the_sweep_is_led_astray_by_sets_of_many_magnitudes_alone() {
    use PointSetKind as Kind;
    for kind in Kind::ALL {
        let many_magnitudes = [
            Kind::UlpBlock,
            Kind::UlpBlockOnLine,
            Kind::MixedExponents,
            Kind::ModerateExponents,
            Kind::MixedMagnitudes,
            Kind::Exponential,
            Kind::SubnormalTriangle,
            Kind::FarTriangle,
        ];
        for (n, seed) in [(12, 0), (40, 1), (400, 2), (400, 3)] {
            let mut steps: Vec<Step> = Vec::new();
            AlgorithmKey::Voronoi.triangulate_traced(&point_set(kind, n, seed), None, &mut steps).unwrap();
            let is_astray = steps.iter().any(|s| s.note.contains("astray"));
            assert!(!is_astray || many_magnitudes.contains(&kind), "{kind:?} {n} {seed}");
        }
    }
}

#[test]
fn a_cancelled_trace_ends_the_algorithms() {
    let points = point_set(PointSetKind::Uniform, 50, 1);
    for key in [AlgorithmKey::Lift, AlgorithmKey::Flip, AlgorithmKey::Voronoi] {
        let made = key.triangulate_traced(&points, None, &mut Cancelled);
        assert_eq!(made.map(|_| ()), Err(BuildError::Cancelled), "{key}");
    }
    for method in OptimalMethod::ALL {
        let made = method.triangulate(&OptimalInput::of_points(&points), &mut Cancelled);
        assert_eq!(made, Err(OptimalError::Cancelled), "{method}");
    }
}

/// Is cancelled from the start.
struct Cancelled;

impl Trace for Cancelled {
    fn step(&mut self, _: Step) {}

    fn is_cancelled(&self) -> bool {
        true
    }
}

/// Replaying the triangles that `lift` and `voronoi`, and the edges that `flip`, add and remove, gives the triangulation.
#[test]
fn the_steps_make_the_triangulation() {
    for (name, points) in sets(40, 1) {
        let expected = AlgorithmKey::Incremental.triangulate(&points, None).unwrap();
        for key in [AlgorithmKey::Lift, AlgorithmKey::Flip] {
            let mut steps: Vec<Step> = Vec::new();
            key.triangulate_traced(&points, None, &mut steps).unwrap();
            let mut there = BTreeSet::new();
            for step in steps {
                let mut shape = match step.shape {
                    Shape::Edge(e) => e.to_vec(),
                    Shape::Triangle(t) => t.to_vec(),
                    _ => continue,
                };
                shape.sort_unstable();
                match step.act {
                    Act::Add => assert!(there.insert(shape), "{key} {name}"),
                    Act::Remove => assert!(there.remove(&shape), "{key} {name}"),
                    _ => {}
                }
            }
            let made: Vec<Vec<u32>> = there.into_iter().collect();
            let mut list: Vec<Vec<u32>> = match key {
                AlgorithmKey::Lift => expected.canonical().iter().map(|t| t.map(|v| v.0).to_vec()).collect(),
                _ => expected.canonical_edges().iter().map(|e| e.map(|v| v.0).to_vec()).collect(),
            };
            list.iter_mut().for_each(|shape| shape.sort_unstable());
            list.sort_unstable();
            assert_eq!(made, list, "{key} {name}");
        }
    }
}

#[test]
fn greedy_fast_is_greedy_naive() {
    let greedy = |method: OptimalMethod, points: &[Point]| {
        method.triangulate(&OptimalInput::of_points(points), &mut NoTrace).unwrap()
    };
    for n in [5, 8, 30] {
        for (name, points) in sets(n, 3) {
            let fast = greedy(OptimalMethod::Greedy, &points);
            assert_eq!(fast, greedy(OptimalMethod::GreedyNaive, &points), "{name}");
            let all = if n <= 8 { enumerate::triangulations(&points) } else { Vec::new() };
            assert!(all.is_empty() || all.contains(&fast.triangles), "{name}");
        }
    }
    for kind in
        [PointSetKind::Uniform, PointSetKind::CoarseUniform, PointSetKind::IntegerGrid, PointSetKind::RandomWalk]
    {
        for seed in 0..4 {
            let points = point_set(kind, 150, seed);
            let fast = greedy(OptimalMethod::Greedy, &points);
            assert_eq!(fast, greedy(OptimalMethod::GreedyNaive, &points), "{kind:?} {seed}");
        }
    }
}

/// The shortest pairs are there, exactly, and ties go to the lower vertices.
#[test]
fn greedy_takes_the_shortest_pair_first() {
    for n in [5, 9, 16] {
        for (name, points) in sets(n, 1) {
            let mut steps: Vec<Step> = Vec::new();
            OptimalMethod::Greedy.triangulate(&OptimalInput::of_points(&points), &mut steps).unwrap();
            let edges = steps.iter().filter(|s| s.act == Act::Add).filter_map(|s| match s.shape {
                Shape::Edge(e) => Some((squared_length(&points, e), e)),
                _ => None,
            });
            assert!(edges.collect::<Vec<_>>().is_sorted(), "{name}");
        }
    }
}

fn squared_length(points: &[Point], [a, b]: [u32; 2]) -> RBig {
    let number = |x: f64| RBig::try_from(x).expect("a finite number");
    let [a, b] = [a, b].map(|v| points[v as usize]);
    let [x, y] = [number(a.x) - number(b.x), number(a.y) - number(b.y)];
    &x * &x + &y * &y
}

/// Any triangulation of a frame with a hole, given as a domain, leads to the same greedy triangulation.
#[test]
fn domains_keep_their_boundary() {
    let frame = [[0.0, 0.0], [9.0, 0.0], [9.0, 8.0], [0.0, 8.0], [2.0, 2.0], [3.0, 6.0], [6.0, 4.0]].map(Point::from);
    let boundary = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 4]];
    let all = enumerate::triangulations_within(&frame, &boundary);
    for &method in OptimalMethod::ALL {
        let mut made = BTreeSet::new();
        for triangles in &all {
            let mesh = IndexedMesh { points: frame.to_vec(), triangles: triangles.clone(), ..IndexedMesh::default() };
            let input = OptimalInput { domain: Some(&mesh), ..OptimalInput::of_points(&frame) };
            made.insert(method.triangulate(&input, &mut NoTrace).unwrap().triangles);
        }
        assert!(made.iter().all(|triangles| all.contains(triangles)), "{method}");
        assert_eq!(made.len(), 1, "{method}");
    }
    let both = [OptimalMethod::Greedy, OptimalMethod::GreedyNaive].map(|method| {
        let mesh = IndexedMesh { points: frame.to_vec(), triangles: all[0].clone(), ..IndexedMesh::default() };
        let input = OptimalInput { domain: Some(&mesh), ..OptimalInput::of_points(&frame) };
        method.triangulate(&input, &mut NoTrace).unwrap()
    });
    assert_eq!(both[0], both[1]);
}
