//! The longest edge as short as possible.

use trimalla::geometry::Point;
use trimalla::optimal::{OptimalError, OptimalInput, OptimalMethod};
use trimalla::trace::{Act, NoTrace, Shape, Step};
use trimalla_testkit::generators::{PointSetKind, SplitMix64, point_set};

use super::all::{all, is_triangulation_like, length_sq, some_triangulation, worst};
use super::insertion::{Looks, small_sets};

const METHODS: [OptimalMethod; 2] = [OptimalMethod::MinMaxLength, OptimalMethod::MinMaxLengthByTree];

fn check(points: &[Point]) {
    let start = some_triangulation(points);
    let Some(every) = all(points, &start, &[], 3000) else { return };
    let at = |v: u32| points[v as usize];
    let cost = |t: [u32; 3]| {
        let sides = [0, 1, 2].map(|k| length_sq(at(t[k]), at(t[(k + 1) % 3])));
        sides.into_iter().max().expect("three sides")
    };
    let best = every.iter().map(|t| worst(t, cost)).min().expect("one triangulation at least");
    for method in METHODS {
        let made = method.triangulate(&OptimalInput::of_points(points), &mut NoTrace).expect("a sound input");
        assert!(
            is_triangulation_like(points, &made.triangles, &start, &[]),
            "{method} {points:?} {:?}",
            made.triangles
        );
        assert_eq!(worst(&made.triangles, cost), best, "{method} {points:?}");
        assert!(made.is_proved, "{method}");
    }
}

#[test]
fn no_longest_edge_is_shorter() {
    for points in small_sets() {
        check(&points);
    }
    // Six points around a seventh at equal distances, sheared copies of it, and their halves.
    for shear in 0..5 {
        let hexagon = [[0, 0], [7, 0], [3, 6], [-4, 6], [-7, 0], [-3, -6], [4, -6]];
        let points = hexagon.map(|[x, y]| Point::new(f64::from(x + shear * y), f64::from(y)));
        for n in 3..=7 {
            check(&points[..n]);
        }
    }
}

#[test]
fn both_ways_give_the_same_longest_edge() {
    let mut rng = SplitMix64::new(3);
    for kind in PointSetKind::ALL {
        let n = 20 + rng.below(60);
        let points = point_set(kind, n, 9);
        let run = |method: OptimalMethod| method.triangulate(&OptimalInput::of_points(&points), &mut NoTrace).unwrap();
        let [one, two] = METHODS.map(run);
        assert_eq!(one.value.to_bits(), two.value.to_bits(), "{} {n}", kind.key());
        let delaunay = trimalla::Delaunay::new(&points).unwrap().canonical();
        let start: Vec<[u32; 3]> = delaunay.iter().map(|t| t.map(|v| v.0)).collect();
        for made in [one, two] {
            assert!(is_triangulation_like(&points, &made.triangles, &start, &[]), "{}", kind.key());
        }
    }
}

#[test]
fn the_graph_is_that_of_its_definition() {
    for kind in [PointSetKind::Uniform, PointSetKind::IntegerGrid, PointSetKind::Cocircular65] {
        let points = point_set(kind, 40, 2);
        let mut steps: Vec<Step> = Vec::new();
        OptimalMethod::MinMaxLength.triangulate(&OptimalInput::of_points(&points), &mut steps).unwrap();
        let mut told: Vec<[u32; 2]> = steps
            .iter()
            .filter_map(|step| match (step.act, step.shape) {
                (Act::Add, Shape::Edge(edge)) => Some(edge),
                _ => None,
            })
            .collect();
        told.sort_unstable();
        let mut graph = Vec::new();
        for p in 0..points.len() as u32 {
            for q in p + 1..points.len() as u32 {
                let length = |a: u32, b: u32| length_sq(points[a as usize], points[b as usize]);
                let nearer = |x: u32| length(p, x) < length(p, q) && length(q, x) < length(p, q);
                if !(0..points.len() as u32).any(|x| x != p && x != q && nearer(x)) {
                    graph.push([p, q]);
                }
            }
        }
        assert_eq!(told, graph, "{}", kind.key());
    }
}

#[test]
fn few_diagonals_are_looked_at() {
    for n in [1000, 2000, 4000] {
        let points = point_set(PointSetKind::Uniform, n, 3);
        let mut looks = Looks::default();
        OptimalMethod::MinMaxLength.triangulate(&OptimalInput::of_points(&points), &mut looks).unwrap();
        assert!(looks.0 < 10 * n, "{n}: {}", looks.0);
    }
}

#[test]
fn domains_are_refused() {
    let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(Point::from);
    let domain = trimalla::IndexedMesh { points: points.to_vec(), triangles: vec![[0, 1, 2]], ..Default::default() };
    let input = OptimalInput { domain: Some(&domain), ..OptimalInput::of_points(&points) };
    let made = OptimalMethod::MinMaxLength.triangulate(&input, &mut NoTrace);
    assert_eq!(made, Err(OptimalError::PointsOnly { method: "min-max-length" }));
}
