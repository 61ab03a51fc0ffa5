//! Edge insertion.

use crate::Cancelled;
use dashu_ratio::RBig;
use trimalla::IndexedMesh;
use trimalla::geometry::Point;
use trimalla::optimal::{Optimal, OptimalError, OptimalInput, OptimalMethod};
use trimalla::trace::{Act, NoTrace, Shape, Step, Trace};
use trimalla_testkit::generators::{PointSetKind, SplitMix64, point_set};

use super::all::{all, is_triangulation_like, largest_angle, smallest_height, some_triangulation, worst};

type Cost = fn([Point; 3]) -> RBig;

/// The method and its exact cost.
const METHODS: [(OptimalMethod, Cost); 2] =
    [(OptimalMethod::MinMaxAngle, largest_angle), (OptimalMethod::MaxMinHeight, smallest_height)];

pub(super) fn small_sets() -> Vec<Vec<Point>> {
    let mut sets = Vec::new();
    for kind in PointSetKind::ALL {
        for n in 3..=8 {
            sets.push(point_set(kind, n, n as u64));
        }
    }
    let mut rng = SplitMix64::new(1);
    for round in 0..150 {
        let n = 4 + rng.below(5);
        let side = [3, 4, 6, 20, 1_000_000][round % 5];
        let mut number = || rng.below(side) as f64 * if round % 7 == 0 { 0.1 } else { 1.0 };
        sets.push((0..n).map(|_| Point::new(number(), number())).collect());
    }
    sets
}

/// Domains with holes and constrained edges: some triangles of a set are left out, some edges must stay.
pub(super) fn small_domains() -> Vec<IndexedMesh> {
    let mut rng = SplitMix64::new(5);
    let mut domains = Vec::new();
    for round in 0..150 {
        let side = [5, 30, 1000][round % 3];
        let points: Vec<Point> = (0..9).map(|_| Point::new(rng.below(side) as f64, rng.below(side) as f64)).collect();
        let mut triangles = some_triangulation(&points);
        let mut segments = Vec::new();
        for _ in 0..rng.below(4).min(triangles.len().saturating_sub(2)) {
            let gone = triangles.swap_remove(rng.below(triangles.len()));
            if round % 4 == 0 {
                segments.push([gone[0], gone[1]]);
            }
        }
        if round % 2 == 0 && !triangles.is_empty() {
            let t = triangles[rng.below(triangles.len())];
            segments.push([t[0], t[1]]);
        }
        let mesh = IndexedMesh { points, triangles, ..IndexedMesh::default() };
        let edges = mesh.edges();
        segments.retain(|&[a, b]| edges.contains(&[a.min(b), a.max(b)]));
        domains.push(IndexedMesh { segments, ..mesh });
    }
    domains
}

fn check(input: &OptimalInput<'_>, start: &[[u32; 3]], fixed: &[[u32; 2]]) {
    let Some(every) = all(input.points, start, fixed, 3000) else { return };
    for (method, cost) in METHODS {
        let cost_of = |t: [u32; 3]| cost(t.map(|v| input.points[v as usize]));
        let made = method.triangulate(input, &mut NoTrace).expect("a sound input");
        let best = every.iter().map(|t| worst(t, cost_of)).min().expect("one triangulation at least");
        assert!(is_triangulation_like(input.points, &made.triangles, start, fixed), "{method} {:?}", input.points);
        assert_eq!(worst(&made.triangles, cost_of), best, "{method} {:?} {fixed:?}", input.points);
        assert!(made.is_proved, "{method}");
    }
}

#[test]
fn no_triangulation_of_a_small_set_is_better() {
    for points in small_sets() {
        check(&OptimalInput::of_points(&points), &some_triangulation(&points), &[]);
    }
}

#[test]
fn no_triangulation_of_a_small_domain_is_better() {
    for domain in small_domains() {
        let input = OptimalInput { domain: Some(&domain), ..OptimalInput::of_points(&domain.points) };
        check(&input, &domain.triangles, &domain.segments);
    }
}

#[test]
fn where_no_two_triangles_are_equally_bad_the_others_are_good_too() {
    for seed in 0..25 {
        let points = point_set(PointSetKind::Uniform, 5 + seed % 4, seed as u64);
        let every = all(&points, &some_triangulation(&points), &[], 3000).unwrap();
        for (method, cost) in METHODS {
            let descending = |triangles: &Vec<[u32; 3]>| {
                let mut costs: Vec<RBig> = triangles.iter().map(|t| cost(t.map(|v| points[v as usize]))).collect();
                costs.sort_by(|a, b| b.cmp(a));
                costs
            };
            let made = method.triangulate(&OptimalInput::of_points(&points), &mut NoTrace).unwrap();
            let best = every.iter().map(descending).min().unwrap();
            assert_eq!(descending(&made.triangles), best, "{method} {seed}");
        }
    }
}

#[test]
fn the_steps_lead_from_the_start_to_the_result() {
    for seed in 0..5 {
        let points = point_set(PointSetKind::Uniform, 60, seed);
        let mut steps: Vec<Step> = Vec::new();
        let made = OptimalMethod::MinMaxAngle.triangulate(&OptimalInput::of_points(&points), &mut steps).unwrap();
        let mut there = Vec::new();
        for step in steps {
            match (step.act, step.shape) {
                (Act::Add, Shape::Triangle(t)) => there.push(t),
                (Act::Remove, Shape::Triangle(t)) => there.retain(|u| *u != t),
                _ => {}
            }
        }
        assert_eq!(trimalla_testkit::oracles::canonical(&there), made.triangles, "{seed}");
    }
}

#[test]
fn faults_of_the_input_are_named() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from);
    let run = |input: &OptimalInput<'_>| OptimalMethod::MinMaxAngle.triangulate(input, &mut NoTrace);
    let mut bad = square;
    bad[2].y = f64::NAN;
    assert!(matches!(run(&OptimalInput::of_points(&bad)), Err(OptimalError::NotFinite { index: 2, .. })));
    let domain =
        IndexedMesh { points: square.to_vec(), triangles: vec![[0, 1, 2], [0, 1, 3]], ..IndexedMesh::default() };
    let of_domain = OptimalInput { domain: Some(&domain), ..OptimalInput::of_points(&square) };
    assert!(matches!(run(&of_domain), Err(OptimalError::Domain(_))));
    let other = OptimalInput { points: &square[..3], ..of_domain };
    assert!(matches!(run(&other), Err(OptimalError::OtherPoints { count: 4, expected: 3 })));
    assert_eq!(run(&OptimalInput::of_points(&[])), Ok(Optimal { is_proved: true, ..Optimal::default() }));
}

/// A hexagon and a triangulation of it with an angle of 152.1 degrees, which no flip makes better: each leaves, or
/// makes, a triangle at least as bad beside the edge.
const STUCK: ([[f64; 2]; 6], [[u32; 3]; 4]) = (
    [[1.0, 3.0], [10.0, 4.0], [10.0, 8.0], [9.0, 9.0], [6.0, 10.0], [0.0, 9.0]],
    [[3, 4, 5], [2, 3, 5], [1, 2, 5], [0, 1, 5]],
);

#[test]
fn an_edge_is_inserted_where_no_flip_helps() {
    let points = STUCK.0.map(Point::from);
    let cost = |t: &[u32; 3]| largest_angle(t.map(|v| points[v as usize]));
    for flipped in super::all::flips(&points, &STUCK.1, &[]) {
        let gone = STUCK.1.iter().filter(|t| !flipped.contains(*t) && !flipped.contains(&rotated(t)));
        let before = gone.map(cost).max().unwrap();
        let came = flipped.iter().filter(|t| !STUCK.1.contains(t));
        assert!(came.map(cost).max().unwrap() >= before, "{flipped:?}");
    }
    let domain = IndexedMesh { points: points.to_vec(), triangles: STUCK.1.to_vec(), ..IndexedMesh::default() };
    let input = OptimalInput { domain: Some(&domain), ..OptimalInput::of_points(&points) };
    let made = OptimalMethod::MinMaxAngle.triangulate(&input, &mut NoTrace).unwrap();
    assert!((made.value.to_degrees() - 107.102).abs() < 1e-3, "{}", made.value.to_degrees());
}

fn rotated(t: &[u32; 3]) -> [u32; 3] {
    trimalla_testkit::oracles::canonical(&[*t])[0]
}

/// Counts how often something is looked at.
#[derive(Default)]
pub(super) struct Looks(pub(super) usize);

impl Trace for Looks {
    fn step(&mut self, step: Step) {
        self.0 += usize::from(step.act == Act::Look);
    }
}

#[test]
fn walks_cross_no_more_edges_than_promised() {
    for kind in [PointSetKind::Uniform, PointSetKind::RoundedCircle, PointSetKind::IntegerGrid] {
        for n in [500, 1000, 2000] {
            let points = point_set(kind, n, 3);
            for (method, _) in METHODS {
                let mut looks = Looks::default();
                method.triangulate(&OptimalInput::of_points(&points), &mut looks).unwrap();
                assert!(looks.0 < n * n, "{method} {} {n}: {}", kind.key(), looks.0);
            }
        }
    }
}

#[test]
fn a_cancelled_run_ends() {
    let points = point_set(PointSetKind::Uniform, 50, 1);
    let heights: Vec<f64> = points.iter().map(|p| p.x * p.y).collect();
    let free = OptimalInput { heights: Some(&heights), ..OptimalInput::of_points(&points) };
    let triangles = some_triangulation(&points[..3]);
    let domain = IndexedMesh { points: points.clone(), triangles, ..IndexedMesh::default() };
    for method in OptimalMethod::ALL {
        let only_domains = method == OptimalMethod::MinWeightPolygon;
        let made =
            method.triangulate(&OptimalInput { domain: only_domains.then_some(&domain), ..free }, &mut Cancelled);
        assert_eq!(made, Err(OptimalError::Cancelled), "{method}");
    }
}
