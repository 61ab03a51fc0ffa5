//! Small sets of points, one after the other, by the triangulator that keeps its memory.

use trimalla::delaunay::{BuildError, Delaunay, Triangulator};
use trimalla::geometry::Point;
use trimalla_testkit::generators::{PointSetKind, SplitMix64, point_set};
use trimalla_testkit::oracles::canonical;

#[test]
fn small_sets_have_the_triangles_of_delaunay() {
    let mut rng = SplitMix64::new(77);
    let mut triangulator = Triangulator::new();
    for round in 0..8000 {
        let kind = PointSetKind::ALL[round % PointSetKind::ALL.len()];
        let points = point_set(kind, 1 + rng.below(if round % 40 == 0 { 400 } else { 40 }), round as u64);
        compare(&mut triangulator, &points, kind.key());
    }
}

/// Integer points, most of them several times, many at one distance from the middle; some at the ends of the range.
#[test]
fn repeated_and_huge_points_have_the_triangles_of_delaunay() {
    let mut rng = SplitMix64::new(78);
    let mut triangulator = Triangulator::new();
    for round in 0..4000 {
        let side = 1 + rng.below(9);
        let scale = [1.0, 0.1, 1e300, 1e-300, 2e307, 5e-324][round % 6];
        let half = if round % 4 < 2 { 0.0 } else { (side / 2) as f64 };
        let mut coordinate = || (rng.below(side) as f64 - half) * scale;
        let points: Vec<Point> = (0..1 + round % 80).map(|_| Point::new(coordinate(), coordinate())).collect();
        compare(&mut triangulator, &points, "repeated");
    }
}

fn compare(triangulator: &mut Triangulator, points: &[Point], name: &str) {
    let made = canonical(triangulator.triangulate(points).expect("finite points"));
    let expected = Delaunay::new(points).expect("finite points").canonical();
    let expected: Vec<[u32; 3]> = expected.into_iter().map(|t| t.map(|v| v.0)).collect();
    assert_eq!(made, expected, "{name}: {points:?}");
}

#[test]
fn what_has_no_triangle_has_none() {
    let mut triangulator = Triangulator::new();
    for points in [&[][..], &[[1.0, 1.0]], &[[0.0, 0.0], [0.0, 0.0]], &[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]] {
        let points: Vec<Point> = points.iter().copied().map(Point::from).collect();
        assert_eq!(triangulator.triangulate(&points), Ok(&[][..]));
    }
    let points = [[0.0, 0.0], [1.0, f64::NAN]].map(Point::from);
    assert!(matches!(triangulator.triangulate(&points), Err(BuildError::NotFinite { index: 1, .. })));
}
