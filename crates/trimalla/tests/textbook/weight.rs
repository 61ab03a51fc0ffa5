//! `min-weight` against all triangulations of small sets, weighed with 2400 binary places.

use std::collections::BTreeSet;

use crate::Cancelled;
use crate::enumerate::{triangulations, triangulations_within};
use dashu_int::UBig;
use dashu_int::ops::{SquareRoot, UnsignedAbs};
use trimalla::delaunay::Delaunay;
use trimalla::drawing::IndexedMesh;
use trimalla::geometry::Point;
use trimalla::optimal::{MinimumWeight, OptimalError, OptimalInput, OptimalMethod, WeightBudget, minimum_weight};
use trimalla::trace::{Act, NoTrace, Step};
use trimalla_testkit::generators::{PointSetKind, SplitMix64, permuted, point_set};
use trimalla_testkit::oracles::{RBig, canonical, covers_hull, on_open_segment, orient, representatives};

/// Binary places of weights.
const PLACES: usize = 2400;

/// The lengths between points, rounded down to a multiple of 2^-2400.
struct Rulers {
    lengths: Vec<Vec<UBig>>,
}

impl Rulers {
    fn new(points: &[Point]) -> Self {
        let exact: Vec<[RBig; 2]> =
            points.iter().map(|p| [p.x, p.y].map(|x| RBig::try_from(x).expect("a finite number"))).collect();
        let length = |a: &[RBig; 2], b: &[RBig; 2]| {
            let [x, y] = [&a[0] - &b[0], &a[1] - &b[1]];
            let (above, below) = (&x * &x + &y * &y).into_parts();
            ((above.unsigned_abs() << (2 * PLACES)) / below).sqrt()
        };
        Self { lengths: exact.iter().map(|a| exact.iter().map(|b| length(a, b)).collect()).collect() }
    }

    fn weight(&self, triangles: &[[u32; 3]]) -> UBig {
        edges(triangles).into_iter().map(|[a, b]| &self.lengths[a as usize][b as usize]).sum()
    }
}

/// Whether weights are equal, but for roots rounded down.
fn is_same(a: &UBig, b: &UBig) -> bool {
    let apart = if a > b { a - b } else { b - a };
    apart <= UBig::from(100_u8)
}

fn edges(triangles: &[[u32; 3]]) -> BTreeSet<[u32; 2]> {
    let sides = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    sides.map(|[a, b]| [a.min(b), a.max(b)]).collect()
}

fn solve(points: &[Point]) -> MinimumWeight {
    minimum_weight(&OptimalInput::of_points(points), WeightBudget::default(), &mut NoTrace).expect("finite points")
}

/// Compares a result with all triangulations: the best weight, and one of that weight has the whole skeleton.
fn is_best_of(points: &[Point], found: &MinimumWeight, all: &[Vec<[u32; 3]>], note: &str) {
    let rulers = Rulers::new(points);
    let weights: Vec<UBig> = all.iter().map(|triangles| rulers.weight(triangles)).collect();
    let Some(least) = weights.iter().min() else { panic!("{note}: nothing is enumerated") };
    let optimal = &found.optimal;
    assert!(optimal.is_proved, "{note}: not proved");
    assert!(all.iter().any(|other| canonical(other) == optimal.triangles), "{note}: no triangulation of the set");
    assert!(is_same(&rulers.weight(&optimal.triangles), least), "{note}: {points:?} {optimal:?}");
    let has_skeleton = |triangles: &Vec<[u32; 3]>| {
        let edges = edges(triangles);
        found.skeleton.iter().all(|edge| edges.contains(edge))
    };
    let best = all.iter().zip(&weights).filter(|(_, weight)| is_same(weight, least));
    assert!(best.map(|(triangles, _)| triangles).any(has_skeleton), "{note}: {points:?} {:?}", found.skeleton);
    assert!(found.skeleton.iter().all(|edge| edges(&optimal.triangles).contains(edge)), "{note}");
}

#[test]
fn small_sets_of_every_kind_attain_the_best_of_all_triangulations() {
    for &kind in &PointSetKind::ALL {
        for (n, seed) in [(3, 1), (4, 2), (5, 3), (6, 4), (6, 5), (7, 6), (7, 7), (8, 8)] {
            let points = point_set(kind, n, seed);
            let found = solve(&points);
            let all = triangulations(&points);
            if found.optimal.triangles.is_empty() {
                assert!(all.is_empty(), "{}", kind.key());
                continue;
            }
            is_best_of(&points, &found, &all, &format!("{} {n} {seed}", kind.key()));
        }
    }
}

#[test]
fn nine_points_attain_the_best_of_all_triangulations() {
    for seed in 0..6 {
        for kind in [PointSetKind::Uniform, PointSetKind::IntegerGrid, PointSetKind::CoarseUniform] {
            let points = point_set(kind, 9, seed);
            is_best_of(&points, &solve(&points), &triangulations(&points), &format!("{} {seed}", kind.key()));
        }
    }
}

#[test]
fn points_of_a_small_lattice_attain_the_best_of_all_triangulations() {
    let mut rng = SplitMix64::new(11);
    for round in 0..150 {
        let n = 4 + round % 5;
        let side = 3 + round % 4;
        let points: Vec<Point> = (0..n).map(|_| Point::new(rng.below(side) as f64, rng.below(side) as f64)).collect();
        let (found, all) = (solve(&points), triangulations(&points));
        if !found.optimal.triangles.is_empty() {
            is_best_of(&points, &found, &all, &format!("lattice {round}"));
        }
    }
}

#[test]
fn components_inside_a_face_are_connected_in_the_best_way() {
    // Chords of the octagon cross all spokes; without triangles the skeleton does not tell that they are longer.
    let no_triangles = WeightBudget { triangles: 0, ..WeightBudget::default() };
    let octagon = [(2, 1), (1, 2), (-1, 2), (-2, 1), (-2, -1), (-1, -2), (1, -2), (2, -1)];
    let mut rng = SplitMix64::new(5);
    let mut connected = 0;
    for round in 0..16 {
        let mut near = |x: f64, y: f64, by: f64| Point::new(x + rng.range(-by, by), y + rng.range(-by, by));
        let noise = if round < 2 { 0.0 } else { 0.1 };
        let mut points: Vec<Point> = octagon.iter().map(|&(x, y)| near(f64::from(x), f64::from(y), noise)).collect();
        points.push(near(0.0, 0.0, noise));
        if round % 4 == 1 {
            points.push(near(0.25, 0.125, noise));
        }
        let all = triangulations(&points);
        for budget in [WeightBudget::default(), no_triangles] {
            let found = minimum_weight(&OptimalInput::of_points(&points), budget, &mut NoTrace).unwrap();
            connected += found.faces_with_components;
            is_best_of(&points, &found, &all, &format!("octagon {round}"));
        }
    }
    assert!(connected >= 8, "{connected} faces have components inside");
}

#[test]
fn a_domain_with_a_hole_keeps_its_boundary_and_attains_the_best() {
    let mut rng = SplitMix64::new(3);
    for round in 0..40 {
        let mut near = |x: f64, y: f64| Point::new(x + rng.range(-1.0, 1.0), y + rng.range(-1.0, 1.0));
        let mut points = vec![near(0.0, 0.0), near(12.0, 0.0), near(7.0, 5.0), near(12.0, 12.0), near(0.0, 12.0)];
        points.extend([near(3.0, 4.5), near(5.5, 7.0), near(3.0, 8.5)]);
        let boundary = [[0, 1], [1, 2], [2, 3], [3, 4], [4, 0], [6, 5], [7, 6], [5, 7]];
        let all = triangulations_within(&points, &boundary);
        let Some(first) = all.get(round % all.len().max(1)) else { panic!("{points:?} has no triangulation") };
        let domain = IndexedMesh { points: points.clone(), triangles: first.clone(), ..IndexedMesh::default() };
        let input = OptimalInput { points: &points, heights: None, domain: Some(&domain) };
        let found = minimum_weight(&input, WeightBudget::default(), &mut NoTrace).unwrap();
        is_best_of(&points, &found, &all, &format!("domain {round}"));
    }
}

#[test]
fn grids_and_circles_are_proved() {
    let grid: Vec<Point> = (0..900).map(|i| Point::new(f64::from(i % 30), f64::from(i / 30))).collect();
    let found = solve(&grid);
    assert!(found.optimal.is_proved);
    let expected = 2.0 * 29.0 * 30.0 + 29.0 * 29.0 * 2.0_f64.sqrt();
    assert!((found.optimal.value - expected).abs() < 1e-9);
    for (kind, n) in
        [(PointSetKind::Cocircular65, 36), (PointSetKind::CocircularWithCentre, 37), (PointSetKind::RoundedCircle, 24)]
    {
        let points = point_set(kind, n, 1);
        let found = solve(&points);
        assert!(found.optimal.is_proved && covers_hull(&points, &found.optimal.triangles), "{}", kind.key());
    }
}

#[test]
fn larger_sets_are_valid_and_no_heavier_than_delaunay_and_greedy() {
    for &kind in &PointSetKind::ALL {
        let points = point_set(kind, 60, 9);
        let small = WeightBudget { steps: 2_000_000, ..WeightBudget::default() };
        let found = minimum_weight(&OptimalInput::of_points(&points), small, &mut NoTrace).unwrap().optimal;
        let delaunay = Delaunay::new(&points).unwrap();
        let delaunay: Vec<[u32; 3]> = delaunay.real_faces().map(|f| delaunay.face_vertices(f).map(|v| v.0)).collect();
        assert!(covers_hull(&points, &found.triangles), "{}", kind.key());
        assert_eq!(found.triangles.len(), delaunay.len(), "{}", kind.key());
        let rulers = Rulers::new(&points);
        let (weight, of_delaunay) = (rulers.weight(&found.triangles), rulers.weight(&delaunay));
        assert!(!found.is_proved || weight <= of_delaunay || is_same(&weight, &of_delaunay), "{}", kind.key());
        let of_greedy = greedy_weight(&points, &rulers);
        assert!(!found.is_proved || weight <= of_greedy || is_same(&weight, &of_greedy), "{}", kind.key());
    }
}

/// The weight of the greedy triangulation: the shortest edge that crosses none and has no point on it, again and again.
fn greedy_weight(points: &[Point], rulers: &Rulers) -> UBig {
    let at = |v: u32| points[v as usize];
    let mut used = representatives(points);
    used.sort_unstable();
    used.dedup();
    let pairs = used.iter().flat_map(|&a| used.iter().map(move |&b| [a, b]));
    let is_free = |&[a, b]: &[u32; 2]| a < b && !used.iter().any(|&c| on_open_segment(at(c), at(a), at(b)));
    let mut pairs: Vec<[u32; 2]> = pairs.filter(is_free).collect();
    pairs.sort_by_key(|&[a, b]| &rulers.lengths[a as usize][b as usize]);
    let mut taken: Vec<[u32; 2]> = Vec::new();
    for [p, q] in pairs {
        let crosses = |&[r, s]: &[u32; 2]| {
            let side = |a: u32, b: u32, c: u32| orient(at(a), at(b), at(c));
            side(p, q, r) * side(p, q, s) < 0 && side(r, s, p) * side(r, s, q) < 0
        };
        if !taken.iter().any(crosses) {
            taken.push([p, q]);
        }
    }
    taken.iter().map(|&[a, b]| &rulers.lengths[a as usize][b as usize]).sum()
}

#[test]
fn the_order_of_the_points_changes_nothing() {
    let points = point_set(PointSetKind::Uniform, 400, 4);
    let found = solve(&points);
    let drawing = trimalla::drawing::Pslg { points, ..Default::default() };
    let (other, _) = permuted(&drawing, 7);
    let again = solve(&other.points);
    assert!(found.optimal.is_proved && again.optimal.is_proved);
    assert_eq!((found.candidates, found.possible, found.faces), (again.candidates, again.possible, again.faces));
    assert!((found.optimal.value - again.optimal.value).abs() < 1e-9);
}

#[test]
fn what_the_budget_does_not_cover_is_said() {
    let points = point_set(PointSetKind::Uniform, 300, 2);
    let input = OptimalInput::of_points(&points);
    let best = solve(&points).optimal;
    let all = WeightBudget::default();
    for budget in
        [WeightBudget { steps: 0, ..all }, WeightBudget { steps: 500, ..all }, WeightBudget { edges: 100, ..all }]
    {
        let found = minimum_weight(&input, budget, &mut NoTrace).unwrap().optimal;
        assert!(!found.is_proved);
        assert!(covers_hull(&points, &found.triangles) && found.triangles.len() == best.triangles.len());
        assert!(best.value <= found.value && found.value < 1.05 * best.value);
    }
    // Without triangles the skeleton is smaller, and the result is the same if the faces are.
    let few = point_set(PointSetKind::Uniform, 12, 2);
    let found = minimum_weight(&OptimalInput::of_points(&few), WeightBudget { triangles: 0, ..all }, &mut NoTrace);
    assert_eq!(found.unwrap().optimal, solve(&few).optimal);
}

#[test]
fn the_budget_covers_a_part_of_a_domain() {
    let points = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0), (3.0, 3.0), (6.0, 3.0), (5.0, 6.0), (4.0, 7.5)]
        .map(|(x, y)| Point::new(x, y));
    let boundary = [[0, 1], [1, 2], [2, 3], [3, 0], [5, 4], [6, 5], [4, 6]];
    let all = triangulations_within(&points, &boundary);
    let domain = IndexedMesh { points: points.to_vec(), triangles: all[0].clone(), ..IndexedMesh::default() };
    let input = OptimalInput { points: &points, heights: None, domain: Some(&domain) };
    for budget in [
        WeightBudget { steps: 0, triangles: 0, ..WeightBudget::default() },
        WeightBudget { edges: 1, ..WeightBudget::default() },
    ] {
        let found = minimum_weight(&input, budget, &mut NoTrace).unwrap();
        assert!(!found.optimal.is_proved);
        assert!(all.iter().any(|triangles| canonical(triangles) == found.optimal.triangles));
    }
}

#[test]
fn the_method_refuses_what_is_no_input_and_can_be_cancelled() {
    let method: OptimalMethod = "min-weight".parse().unwrap();
    let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| Point::new(x, y));
    let mut bad = square;
    bad[2].y = f64::NAN;
    let refused = method.triangulate(&OptimalInput::of_points(&bad), &mut NoTrace);
    assert!(matches!(refused, Err(OptimalError::NotFinite { index: 2, .. })));
    let other = IndexedMesh { points: square[..3].to_vec(), triangles: vec![[0, 1, 2]], ..IndexedMesh::default() };
    let input = OptimalInput { points: &square, heights: None, domain: Some(&other) };
    assert!(matches!(method.triangulate(&input, &mut NoTrace), Err(OptimalError::OtherPoints { .. })));
    let mut steps: Vec<Step> = Vec::new();
    let made = method.triangulate(&OptimalInput::of_points(&square), &mut steps).unwrap();
    assert_eq!((made.triangles.len(), made.is_proved), (2, true));
    assert_eq!(steps.iter().filter(|step| step.act == Act::Add).count(), 5);
    let cancelled = method.triangulate(&OptimalInput::of_points(&square), &mut Cancelled);
    assert_eq!(cancelled, Err(OptimalError::Cancelled));
    for few in [&square[..0], &square[..1], &square[..2]] {
        let made = method.triangulate(&OptimalInput::of_points(few), &mut NoTrace).unwrap();
        assert!(made.triangles.is_empty() && made.is_proved && made.value == 0.0);
    }
}
