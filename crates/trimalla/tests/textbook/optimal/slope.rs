//! The flattest surface.

use dashu_ratio::RBig;
use trimalla::geometry::Point;
use trimalla::optimal::{OptimalError, OptimalInput, OptimalMethod};
use trimalla::trace::NoTrace;
use trimalla_testkit::generators::{PointSetKind, SplitMix64, point_set};

use super::all::{all, is_triangulation_like, slope_sq, some_triangulation, worst};
use super::insertion::{Looks, small_domains, small_sets};

const METHOD: OptimalMethod = OptimalMethod::MinMaxSlope;

/// Heights of which many or few are equal.
fn heights(points: &[Point], round: usize, rng: &mut SplitMix64) -> Vec<f64> {
    let one = |p: &Point, rng: &mut SplitMix64| match round % 6 {
        0 => rng.unit(),
        1 => rng.below(2) as f64,
        2 => rng.below(4) as f64 * 0.1,
        3 => 7.0,
        4 => 2.0 * p.x - 3.0 * p.y + rng.below(2) as f64,
        _ => rng.range(-1e3, 1e3),
    };
    let finite = |h: f64| if h.is_finite() { h } else { 1.0 };
    points.iter().map(|p| finite(one(p, rng))).collect()
}

fn check(input: &OptimalInput<'_>, start: &[[u32; 3]], fixed: &[[u32; 2]]) {
    let Some(every) = all(input.points, start, fixed, 3000) else { return };
    let heights = input.heights.expect("heights");
    let cost = |t: [u32; 3]| slope_sq(t.map(|v| input.points[v as usize]), t.map(|v| heights[v as usize]));
    let made = METHOD.triangulate(input, &mut NoTrace).expect("a sound input");
    let best = every.iter().map(|t| worst(t, cost)).min().expect("one triangulation at least");
    assert!(is_triangulation_like(input.points, &made.triangles, start, fixed), "{:?}", input.points);
    assert_eq!(worst(&made.triangles, cost), best, "{:?} {heights:?} {fixed:?}", input.points);
    if let Some(best) = best.filter(|best| *best < RBig::from(1_u64 << 60)) {
        assert!((made.value * made.value - best.to_f64().value()).abs() <= 1e-9 * (1.0 + made.value * made.value));
    }
}

#[test]
fn no_surface_over_a_small_set_is_flatter() {
    let mut rng = SplitMix64::new(11);
    for (round, points) in small_sets().into_iter().enumerate() {
        for k in [0, 1] {
            let heights = heights(&points, round + k, &mut rng);
            let input = OptimalInput { heights: Some(&heights), ..OptimalInput::of_points(&points) };
            check(&input, &some_triangulation(&points), &[]);
        }
    }
}

#[test]
fn no_surface_over_a_small_domain_is_flatter() {
    let mut rng = SplitMix64::new(12);
    for (round, domain) in small_domains().into_iter().enumerate() {
        let heights = heights(&domain.points, round, &mut rng);
        let of_points = OptimalInput::of_points(&domain.points);
        let input = OptimalInput { heights: Some(&heights), domain: Some(&domain), ..of_points };
        check(&input, &domain.triangles, &domain.segments);
    }
}

#[test]
fn where_no_two_triangles_are_equally_steep_the_others_are_flat_too() {
    let mut rng = SplitMix64::new(13);
    for seed in 0..30 {
        let points = point_set(PointSetKind::Uniform, 5 + seed % 4, seed as u64);
        let heights = heights(&points, 0, &mut rng);
        let descending = |triangles: &Vec<[u32; 3]>| {
            let cost = |t: &[u32; 3]| slope_sq(t.map(|v| points[v as usize]), t.map(|v| heights[v as usize]));
            let mut costs: Vec<RBig> = triangles.iter().map(cost).collect();
            costs.sort_by(|a, b| b.cmp(a));
            costs
        };
        let input = OptimalInput { heights: Some(&heights), ..OptimalInput::of_points(&points) };
        let made = METHOD.triangulate(&input, &mut NoTrace).unwrap();
        let every = all(&points, &some_triangulation(&points), &[], 3000).unwrap();
        assert_eq!(descending(&made.triangles), every.iter().map(descending).min().unwrap(), "{seed}");
    }
}

#[test]
fn trials_are_no_more_than_promised() {
    let mut rng = SplitMix64::new(14);
    for kind in [PointSetKind::Uniform, PointSetKind::RoundedCircle, PointSetKind::IntegerGrid] {
        for n in [100, 200, 400] {
            let points = point_set(kind, n, 3);
            let heights = heights(&points, 0, &mut rng);
            let input = OptimalInput { heights: Some(&heights), ..OptimalInput::of_points(&points) };
            let mut looks = Looks::default();
            METHOD.triangulate(&input, &mut looks).unwrap();
            assert!(looks.0 < n * n, "{} {n}: {}", kind.key(), looks.0);
        }
    }
}

#[test]
fn heights_are_asked_for() {
    let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(Point::from);
    let run = |heights| {
        METHOD
            .triangulate(&OptimalInput { heights, ..OptimalInput::of_points(&points) }, &mut NoTrace)
            .map(|made| made.value)
    };
    assert_eq!(run(None), Err(OptimalError::NoHeights { method: "min-max-slope" }));
    assert_eq!(run(Some(&[0.0])), Err(OptimalError::HeightCount { heights: 1, points: 3 }));
    assert!(matches!(run(Some(&[0.0, f64::NAN, 0.0])), Err(OptimalError::NotFinite { index: 1, .. })));
    assert_eq!(run(Some(&[0.0, 3.0, 4.0])), Ok(5.0));
}
