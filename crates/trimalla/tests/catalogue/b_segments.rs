//! Family B: segments.

use trimalla::constrained::{ConstrainedDelaunay, ConstraintError, Crossings, Filling};
use trimalla::domain::{DomainRule, Warning};
use trimalla::geometry::Point;
use trimalla::half_edge::VertexId;
use trimalla_testkit::generators::{PslgKind, SplitMix64, next_up, pslg};
use trimalla_testkit::oracles::{brute_force_cdt, canonical};

use crate::{at, constrained, domain, drawing, refused_pairs};

/// The drawing of a kind, crossings split, is sound.
fn holds(kind: PslgKind, n: usize) -> ConstrainedDelaunay {
    constrained(&pslg(kind, n, 1))
}

/// Triangles in canonical form.
fn triangles(cdt: &ConstrainedDelaunay) -> Vec<[u32; 3]> {
    cdt.canonical().iter().map(|t| t.map(|v| v.0)).collect()
}

#[test]
fn b01_segments_without_length() {
    let points = at(&[[0.0, 0.0], [2.0, 0.0], [1.0, 2.0], [0.0, 0.0]]);
    let (_, warnings) = domain(&drawing(points, &[[0, 0], [0, 3], [1, 1]]), DomainRule::Hull).expect("a hull");
    let dropped = warnings.iter().find_map(|w| match w {
        Warning::ZeroLength { count, first } => Some((*count, *first)),
        _ => None,
    });
    assert_eq!(dropped, Some((3, 0)));
}

#[test]
fn b02_one_segment_a_thousand_times() {
    let points = at(&[[0.0, 0.0], [4.0, 1.0], [1.0, 3.0], [2.0, -3.0]]);
    let copies: Vec<[u32; 2]> = (0..1000).map(|i| if i % 2 == 0 { [0, 1] } else { [1, 0] }).collect();
    let cdt = constrained(&drawing(points, &copies));
    let h = cdt.half_edge_between(VertexId(0), VertexId(1)).expect("one edge");
    assert_eq!(cdt.segments_of(h).len(), 1000, "each copy can be traced");
    holds(PslgKind::RepeatedSegments, 20);
}

#[test]
fn b03_collinear_overlaps() {
    let points = at(&[[0.0, 0.0], [3.0, 0.0], [1.0, 0.0], [4.0, 0.0], [2.0, 2.0], [2.0, -2.0]]);
    let cdt = constrained(&drawing(points, &[[0, 1], [2, 3], [0, 3], [2, 1]]));
    let middle = cdt.half_edge_between(VertexId(2), VertexId(1)).expect("a shared edge");
    assert_eq!(cdt.segments_of(middle).len(), 4);
    let n = 1000;
    let mut points: Vec<Point> = (0..n).map(|i| Point::new(f64::from(i), 0.0)).collect();
    points.push(Point::new(500.0, 300.0));
    let chain: Vec<[u32; 2]> = (0..n as u32 - 2).map(|i| [i, i + 2]).collect();
    constrained(&drawing(points, &chain));
    holds(PslgKind::CollinearOverlaps, 30);
}

#[test]
fn b04_vertices_exactly_on_a_segment() {
    let cdt = constrained(&drawing(at(&[[0.0, 0.0], [4.0, 2.0], [2.0, 1.0], [1.0, 3.0]]), &[[0, 1]]));
    assert!(cdt.half_edge_between(VertexId(0), VertexId(2)).is_some());
    let n = 10_000;
    let mut points: Vec<Point> = (0..=n).map(|i| Point::new(4.0 * f64::from(i), 2.0 * f64::from(i))).collect();
    points.extend(at(&[[0.0, 100.0], [100.0, 0.0]]));
    SplitMix64::new(4).shuffle(&mut points);
    let end = |x: f64| points.iter().position(|p| p.x == x && p.y == x / 2.0).expect("an end") as u32;
    let segment = [end(4.0 * f64::from(n)), end(0.0)];
    constrained(&drawing(points, &[segment]));
    holds(PslgKind::PointsOnSegment, 100);
}

#[test]
fn b05_a_vertex_one_ulp_beside_a_segment_is_not_snapped() {
    let cdt = holds(PslgKind::NearMiss, 0);
    assert!(cdt.half_edge_between(VertexId(0), VertexId(1)).is_some(), "the segment stays one edge");
}

#[test]
fn b06_t_junctions() {
    holds(PslgKind::TJunctions, 0);
    let exact = drawing(at(&[[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [1.0, 1.0]]), &[[0, 1], [2, 3]]);
    assert_eq!(refused_pairs(&exact), 0, "a vertex on a segment is no crossing");
}

#[test]
fn b07_a_proper_crossing() {
    let cross = drawing(at(&[[-1.0, 0.0], [1.0, 0.0], [0.0, -1.0], [0.0, 1.0]]), &[[0, 1], [2, 3]]);
    assert_eq!(refused_pairs(&cross), 1);
    assert_eq!(constrained(&cross).steiner_vertices(), 1);
}

#[test]
fn b08_crossings_that_are_no_doubles() {
    let cross = drawing(at(&[[0.0, 0.0], [3.0, 1.0], [0.0, 1.0], [1.0, 0.0]]), &[[0, 1], [2, 3]]);
    assert_eq!((refused_pairs(&cross), constrained(&cross).steiner_vertices()), (1, 1));
    holds(PslgKind::LongSegments, 200);
}

#[test]
fn b09_nearly_parallel_segments() {
    holds(PslgKind::NearParallel, 0);
    let points =
        at(&[[300.0, 300.0], [302.0, 301.0], [300.0, 300.0], [302.0, next_up(301.0)], [299.0, 299.5], [303.0, 301.5]]);
    constrained(&drawing(points, &[[0, 1], [2, 3], [4, 5], [0, 5]]));
}

#[test]
fn b10_crossings_within_an_ulp_of_a_vertex() {
    let up = next_up(1.0);
    for foot in [1.0, up, 2.0 - up] {
        let points = at(&[[0.0, 0.0], [2.0, 2.0], [foot, 1.0], [3.0, 0.0], [1.0, 5.0]]);
        constrained(&drawing(points, &[[0, 1], [2, 3], [2, 4]]));
    }
    // The rounded crossing falls on a vertex that is there already.
    let points = at(&[[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0], [0.5, 0.5], [0.5, next_up(0.5)]]);
    constrained(&drawing(points, &[[0, 1], [2, 3]]));
}

#[test]
fn b11_bundles_of_lines() {
    holds(PslgKind::Bundle, 50);
    holds(PslgKind::ExactBundle, 50);
}

#[test]
fn b12_stars_of_segments() {
    holds(PslgKind::SegmentStar, 10_000);
    holds(PslgKind::NarrowStar, 1000);
}

#[test]
fn b13_combs_and_a_long_channel() {
    holds(PslgKind::Comb, 10_000);
    holds(PslgKind::Zigzag, 10_000);
    channel(100_000, Filling::Randomised);
    channel(2000, Filling::Recursive);
}

/// One segment through a channel of twice `n` vertices.
fn channel(n: i32, filling: Filling) {
    let side = |y: f64| (0..n).map(move |i| Point::new(f64::from(i), y));
    let points: Vec<Point> = side(-1.0).chain(side(1.0)).chain(at(&[[-1.0, 0.0], [f64::from(n), 0.0]])).collect();
    let ends = [points.len() as u32 - 2, points.len() as u32 - 1];
    let mut cdt = ConstrainedDelaunay::new(&points, &[], Crossings::Refuse).expect("finite points");
    cdt.set_filling(filling);
    cdt.insert_segments(&[ends], Crossings::Refuse).expect("nothing crosses");
    assert_eq!(cdt.check(), []);
}

#[test]
fn b14_edges_that_dangle_in_a_channel() {
    for seed in 0..4 {
        let input = pslg(PslgKind::Hanging, 12, seed);
        let ours = triangles(&constrained(&input));
        if input.points.len() <= 24 {
            assert_eq!(canonical(&ours), brute_force_cdt(&input.points, &input.segments));
        }
    }
}

#[test]
fn b15_segments_along_the_hull() {
    let points = at(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [4.0, 0.0], [2.0, 3.0]]);
    for segments in [&[[0, 3]][..], &[[0, 2]], &[[1, 2], [3, 4], [4, 0]], &[[3, 0], [0, 4]]] {
        constrained(&drawing(points.clone(), segments));
    }
}

#[test]
fn b16_ends_that_do_not_exist() {
    let points = at(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    for bad in [3, 4, u32::MAX] {
        let refused = ConstrainedDelaunay::new(&points, &[[0, 1], [1, bad]], Crossings::Split);
        assert!(matches!(refused, Err(ConstraintError::NoSuchVertex { segment: 1, vertex, .. }) if vertex.0 == bad));
    }
}

#[test]
fn b17_a_segment_after_a_split_crossing() {
    let points = at(&[[0.0, 0.0], [7.0, 3.0], [1.0, 4.0], [6.0, -2.0], [9.0, 9.0], [-3.0, 5.0]]);
    let mut cdt = ConstrainedDelaunay::new(&points, &[[0, 1], [2, 3]], Crossings::Split).expect("good input");
    cdt.insert_segments(&[[1, 4], [1, 5], [2, 1]], Crossings::Split).expect("crossings are split");
    assert_eq!(cdt.check(), []);
}

#[test]
fn b18_random_soups_on_a_small_grid() {
    for seed in 0..40 {
        constrained(&pslg(PslgKind::GridSoup, 3 + seed as usize % 30, seed));
    }
}

#[test]
fn b19_random_soups_of_awkward_numbers() {
    for seed in 0..40 {
        constrained(&pslg(PslgKind::FloatSoup, 3 + seed as usize % 25, seed));
    }
}

#[test]
fn b20_a_polyline_of_steps_of_one_ulp() {
    let mut x = 1.0;
    let n = 100_000;
    let mut points: Vec<Point> = Vec::with_capacity(n + 1);
    for i in 0..n {
        points.push(Point::new(x, if i % 2 == 0 { 1.0 } else { next_up(1.0) }));
        x = next_up(x);
    }
    points.push(Point::new(1.0, 5.0));
    let segments: Vec<[u32; 2]> = (0..n as u32 - 1).map(|i| [i, i + 1]).collect();
    let cdt = ConstrainedDelaunay::new(&points, &segments, Crossings::Refuse).expect("nothing crosses");
    assert_eq!(cdt.check(), []);
}
