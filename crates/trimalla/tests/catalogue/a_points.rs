//! Family A: point sets.

use std::cmp::Ordering;

use trimalla::delaunay::{AlgorithmKey, BuildError};
use trimalla::geometry::{Orientation, Point, lexicographic, orient2d};
use trimalla::half_edge::VertexId;
use trimalla_testkit::generators::{PointSetKind, next_down, next_up, point_set};
use trimalla_testkit::oracles::{brute_force_delaunay, delaunay_triangle_count, orient, representatives};

use crate::{agreed, at};

/// The set of a kind is triangulated alike by all algorithms, with as many triangles as the exact hull says.
fn holds(kind: PointSetKind, n: usize) {
    for seed in 0..2 {
        let points = point_set(kind, n, seed);
        let built = agreed(&points);
        if built.dimension() == 2 && points.len() <= 3000 {
            assert_eq!(built.canonical().len(), delaunay_triangle_count(&points), "{kind:?}");
        }
    }
}

#[test]
fn a01_no_point_one_and_two() {
    for (n, dimension) in [(0, -1), (1, 0), (2, 1)] {
        let points = &at(&[[0.5, 0.25], [2.0, 1.0]])[..n];
        let built = agreed(points);
        assert_eq!((i32::from(built.dimension()), built.canonical().len()), (dimension, 0));
    }
}

#[test]
fn a02_points_on_one_line() {
    for kind in [PointSetKind::HorizontalLine, PointSetKind::VerticalLine, PointSetKind::DiagonalLine] {
        let built = agreed(&point_set(kind, 1000, 1));
        assert_eq!((built.dimension(), built.canonical_edges().len()), (1, 999), "{kind:?}");
    }
    holds(PointSetKind::CollinearRounded, 1000);
}

#[test]
fn a03_copies_of_one_point() {
    let built = agreed(&point_set(PointSetKind::AllEqual, 10_000, 0));
    assert_eq!((built.dimension(), built.duplicates().len()), (0, 9999));
}

#[test]
fn a04_all_equal_but_one_or_two() {
    assert_eq!(agreed(&point_set(PointSetKind::AllEqualButOne, 100, 0)).dimension(), 1);
    let mut points = vec![Point::new(0.3, 0.7); 50];
    points.extend(at(&[[0.6, 1.4], [0.9, 2.1]]));
    agreed(&points);
}

#[test]
fn a05_duplicates_stand_for_the_first_of_them() {
    let points = point_set(PointSetKind::Duplicates, 10_000, 3);
    let built = agreed(&points);
    let ours: Vec<u32> = (0..points.len()).map(|i| built.representative(VertexId::from_index(i)).0).collect();
    assert_eq!(ours, representatives(&points));
}

#[test]
fn a06_signs_of_zero_keep_their_bits() {
    let points = at(&[[-0.0, 0.0], [0.0, 0.0], [0.0, -0.0], [1.0, 0.0], [0.0, 1.0]]);
    let built = agreed(&points);
    assert_eq!((built.duplicates().len(), built.canonical().len()), (2, 1));
    assert!(built.point(VertexId(0)).x.is_sign_negative(), "the first of equal points keeps its bits");
    holds(PointSetKind::SignedZeros, 200);
}

#[test]
fn a07_neighbours_one_ulp_apart() {
    let points = point_set(PointSetKind::UlpBlock, 13, 0);
    let built = agreed(&points);
    let ours: Vec<[u32; 3]> = built.canonical().iter().map(|t| t.map(|v| v.0)).collect();
    assert_eq!(ours, brute_force_delaunay(&points));
}

#[test]
fn a08_a_block_of_neighbours_against_a_line() {
    let [q, r] = [Point::new(12.0, 12.0), Point::new(24.0, 24.0)];
    let (mut naive_is_wrong, ulp) = (0, 1.0 / 9_007_199_254_740_992.0);
    for (i, j) in (0..64).flat_map(|i| (0..64).map(move |j| (f64::from(i), f64::from(j)))) {
        let p = Point::new(0.5 + i * ulp, 0.5 + j * ulp);
        let exact = match orient2d(p, q, r) {
            Orientation::Clockwise => -1,
            Orientation::Collinear => 0,
            Orientation::CounterClockwise => 1,
        };
        assert_eq!(exact, orient(p, q, r), "{p}");
        let naive = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
        naive_is_wrong += u32::from((naive > 0.0, naive < 0.0) != (exact > 0, exact < 0));
    }
    assert!(naive_is_wrong > 0, "the block is there to fool rounded arithmetic");
    holds(PointSetKind::UlpBlockOnLine, 4098);
}

#[test]
fn a09_the_integer_grid() {
    holds(PointSetKind::IntegerGrid, 2500);
    agreed(&point_set(PointSetKind::IntegerGrid, 40_000, 1));
}

#[test]
fn a10_rotated_grids() {
    for seed in (0..360).step_by(15) {
        agreed(&point_set(PointSetKind::RotatedGrid, 900, seed));
    }
}

#[test]
fn a11_a_grid_of_quarters() {
    agreed(&point_set(PointSetKind::QuarterGrid, 39_800, 0));
}

#[test]
fn a12_cocircular_integer_points() {
    for kind in [PointSetKind::Cocircular65, PointSetKind::CocircularWithCentre, PointSetKind::Cocircular1105] {
        holds(kind, 200);
    }
}

#[test]
fn a13_rounded_circles_and_one_point_an_ulp_off() {
    agreed(&point_set(PointSetKind::RoundedCircle, 50_000, 0));
    let mut points = point_set(PointSetKind::RoundedCircle, 300, 0);
    let i = points.iter().position(|p| p.x > 0.1 && p.y > 0.1).expect("points all around");
    for x in [next_up(points[i].x), next_down(points[i].x)] {
        points[i].x = x;
        agreed(&points);
    }
}

#[test]
fn a14_twin_rings_and_a_hub() {
    holds(PointSetKind::TwinRings, 2000);
    let points = point_set(PointSetKind::Hub, 100_000, 0);
    let built = agreed(&points);
    let hub = points.iter().position(|p| p.x == 0.0 && p.y == 0.0).expect("a hub");
    assert!(built.neighbours(VertexId::from_index(hub)).count() > 50_000);
}

#[test]
fn a15_hulls_that_are_straight_but_for_rounding() {
    holds(PointSetKind::NearCollinearHull, 1002);
}

#[test]
fn a16_long_walks() {
    for (kind, n) in
        [(PointSetKind::Parabola, 20_000), (PointSetKind::Spiral, 20_000), (PointSetKind::Exponential, 680)]
    {
        agreed(&point_set(kind, n, 0));
    }
}

#[test]
fn a17_every_order_gives_the_same_triangles() {
    let mut points = point_set(PointSetKind::CoarseUniform, 2000, 5);
    points.sort_by(|&a, &b| lexicographic(a, b));
    points.dedup();
    let places = |points: &[Point]| {
        let place = |v: VertexId| points[v.index()];
        let mut all: Vec<[Point; 3]> = agreed(points).canonical().iter().map(|t| t.map(place)).collect();
        all.iter_mut().for_each(|t| t.sort_by(|&p, &q| lexicographic(p, q)));
        all.sort_by(|s, t| (0..3).fold(Ordering::Equal, |so_far, i| so_far.then(lexicographic(s[i], t[i]))));
        all
    };
    let by_x = places(&points);
    let mut other = points.clone();
    other.reverse();
    assert_eq!(places(&other), by_x);
    other.sort_by(|a, b| a.y.total_cmp(&b.y));
    assert_eq!(places(&other), by_x);
    let zigzag: Vec<Point> =
        (0..points.len()).map(|i| points[if i % 2 == 0 { i / 2 } else { points.len() - 1 - i / 2 }]).collect();
    assert_eq!(places(&zigzag), by_x);
}

#[test]
fn a18_clusters_at_four_corners() {
    holds(PointSetKind::GaussianClusters, 2000);
    agreed(&point_set(PointSetKind::GaussianClusters, 100_000, 0));
}

#[test]
fn a19_far_pairs_and_boxes_without_width() {
    agreed(&at(&[[0.0, 1e38], [1.0, 1e38]]));
    agreed(&at(&[[0.0, 1e38], [1.0, 1e38], [0.0, 0.0]]));
    holds(PointSetKind::UlpWideBox, 500);
}

#[test]
fn a20_the_ends_of_the_range() {
    for kind in [
        PointSetKind::LargeSquare,
        PointSetKind::HugeSquare,
        PointSetKind::MinuteSquare,
        PointSetKind::SubnormalTriangle,
    ] {
        holds(kind, 100);
    }
    let least = f64::from_bits(1);
    let built = agreed(&at(&[[0.0, 0.0], [least, 0.0], [0.0, least]]));
    assert_eq!(built.canonical().len(), 1);
}

#[test]
fn a21_mixed_magnitudes() {
    holds(PointSetKind::MixedMagnitudes, 50);
    agreed(&at(&[[6e-271, 0.0], [0.0, -5e260], [1.0, 1.0], [-1.0, 2.0], [3.0, -5e260], [6e-271, 7.0]]));
}

#[test]
fn a22_numbers_that_are_none() {
    let good = point_set(PointSetKind::Uniform, 9, 0);
    for (index, bad) in [0, 4, 8].into_iter().flat_map(|i| [f64::NAN, f64::INFINITY, f64::NEG_INFINITY].map(|b| (i, b)))
    {
        for in_x in [true, false] {
            let mut points = good.clone();
            *(if in_x { &mut points[index].x } else { &mut points[index].y }) = bad;
            for key in AlgorithmKey::ALL {
                let refused = key.triangulate(&points, None);
                assert!(
                    matches!(refused, Err(BuildError::NotFinite { index: i, .. }) if i == index),
                    "{key:?} {index} {bad}"
                );
            }
        }
    }
}

#[test]
fn a23_a_far_origin() {
    agreed(&point_set(PointSetKind::UtmGrid, 20_000, 0));
    let east = point_set(PointSetKind::UtmGrid, 900, 0).into_iter().map(|p| Point::new(p.x + 3.2e7, p.y));
    agreed(&east.collect::<Vec<Point>>());
}

#[test]
fn a24_single_precision() {
    agreed(&point_set(PointSetKind::F32Rounded, 100_000, 0));
    agreed(&point_set(PointSetKind::CoarseUniform, 50_000, 0));
}

#[test]
fn a25_a_disc_and_three_far_points() {
    let points = point_set(PointSetKind::FarTriangle, 2000, 0);
    assert_eq!(agreed(&points).canonical().len(), delaunay_triangle_count(&points));
}
