//! Holes of one point: every method makes them corners, wherever they lie.

use std::collections::BTreeSet;

use crate::polygon_cases::Case;
use trimalla::geometry::Point;
use trimalla::polygon::{Polygon, PolygonError, PolygonMethod, Triangulator};
use trimalla::trace::{NoTrace, Step};
use trimalla_testkit::generators::SplitMix64;

const OUTLINE: [[f64; 2]; 6] = [[0.0, 0.0], [12.0, 0.0], [12.0, 8.0], [7.0, 8.0], [7.0, 3.0], [0.0, 8.0]];

fn case(points: &[[f64; 2]]) -> Case {
    let outline = OUTLINE.map(Point::from).to_vec();
    let rings: Vec<Vec<Point>> = std::iter::once(outline).chain(points.iter().map(|&p| vec![p.into()])).collect();
    Case::of(&rings)
}

/// The triangles of every method, each checked; the methods agree about how many there are.
///
/// The outline alone is the ring of the oracle: a point on one of its sides is a corner of two sides.
fn all(case: &Case) -> Result<Vec<[u32; 3]>, PolygonError> {
    let oracle = Case { points: case.points.clone(), ring_ends: vec![case.ring_ends[0]] };
    let polygon = Polygon::new(&case.points, &case.ring_ends)?;
    let mut triangulator = Triangulator::new();
    let first = triangulator.triangulate(polygon)?.to_vec();
    let used: BTreeSet<u32> = first.as_flattened().iter().copied().collect();
    for method in PolygonMethod::ALL {
        let triangles = method.triangulate(polygon, &mut NoTrace)?;
        assert_eq!(oracle.fault(&triangles), None, "{method}: {case:?}");
        assert_eq!(triangles.len(), first.len(), "{method}: {case:?}");
        assert_eq!(triangles.as_flattened().iter().copied().collect::<BTreeSet<_>>(), used, "{method}: {case:?}");
    }
    assert_eq!(oracle.fault(&first), None, "{case:?}");
    let sorted = |triangles: &[[u32; 3]]| {
        let turned = triangles.iter().map(|&[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]].into_iter().min());
        turned.collect::<BTreeSet<_>>()
    };
    let delaunay = PolygonMethod::ConstrainedDelaunay.triangulate(polygon, &mut NoTrace)?;
    assert_eq!(sorted(triangulator.triangulate_delaunay(polygon)?), sorted(&delaunay), "{case:?}");
    Ok(first)
}

#[test]
fn points_inside_on_sides_and_on_each_other() {
    assert_eq!(all(&case(&[])).map(|t| t.len()), Ok(4));
    assert_eq!(all(&case(&[[3.0, 1.0]])).map(|t| t.len()), Ok(6));
    assert_eq!(all(&case(&[[3.0, 0.0]])).map(|t| t.len()), Ok(5), "on a side");
    assert_eq!(all(&case(&[[7.0, 3.0]])).map(|t| t.len()), Ok(4), "a corner of the outline");
    assert_eq!(all(&case(&[[3.0, 1.0], [3.0, 1.0]])).map(|t| t.len()), Ok(6), "the same point twice");
    // On a line, and on the edges between triangles.
    assert_eq!(all(&case(&[[3.0, 1.0], [5.0, 1.0], [4.0, 1.0], [6.0, 1.0]])).map(|t| t.len()), Ok(12));
    let repeated = [OUTLINE.map(Point::from).to_vec(), vec![Point::new(3.0, 1.0); 3]];
    assert_eq!(all(&Case::of(&repeated)).map(|t| t.len()), Ok(6), "one point, three times in its ring");
}

#[test]
fn random_points_make_two_triangles_each() {
    let mut random = SplitMix64::new(71);
    for _ in 0..60 {
        let count = random.below(9);
        let points: Vec<[f64; 2]> =
            (0..count).map(|_| [random.below(13) as f64, random.below(9) as f64 / 3.0]).collect();
        let distinct: BTreeSet<[u64; 2]> = points.iter().map(|p| p.map(f64::to_bits)).collect();
        let is_corner = |p: &&[u64; 2]| OUTLINE.iter().any(|corner| corner.map(f64::to_bits) == **p);
        let is_on_side = |p: &&[u64; 2]| {
            let [x, y] = p.map(f64::from_bits);
            x == 0.0 || x == 12.0 || y == 0.0
        };
        let corners = distinct.iter().filter(is_corner).count();
        let sides = distinct.iter().filter(is_on_side).filter(|p| !is_corner(p)).count();
        let expected = 4 + 2 * (distinct.len() - corners - sides) + sides;
        assert_eq!(all(&case(&points)).map(|t| t.len()), Ok(expected), "{points:?}");
    }
}

#[test]
fn a_point_outside_is_refused_with_its_number() {
    let outside = case(&[[3.0, 1.0], [7.0, 9.0]]);
    let polygon = Polygon::new(&outside.points, &outside.ring_ends).expect("it is well formed");
    let fault = PolygonError::Nesting { ring: 2, vertex: 7, at: Point::new(7.0, 9.0) };
    for method in PolygonMethod::ALL {
        assert_eq!(method.triangulate(polygon, &mut NoTrace), Err(fault.clone()), "{method}");
    }
    assert_eq!(Triangulator::new().triangulate(polygon), Err(fault));
}

#[test]
fn faults_and_steps_name_the_points_of_the_polygon() {
    // The point comes before the hole, whose points have other numbers where it is left out.
    let hole = |corners: &[[f64; 2]]| corners.iter().map(|&p| Point::from(p)).collect::<Vec<_>>();
    let outline = OUTLINE.map(Point::from).to_vec();
    let rings = [outline.clone(), hole(&[[3.0, 1.0]]), hole(&[[9.0, 1.0], [9.0, 4.0], [14.0, 4.0]])];
    let crossing = Case::of(&rings);
    let polygon = Polygon::new(&crossing.points, &crossing.ring_ends).expect("it is well formed");
    for &method in PolygonMethod::ALL.iter().filter(|method| method.key() != "diagonals") {
        match method.triangulate(polygon, &mut NoTrace) {
            Err(PolygonError::Crossing { sides, .. }) => assert!(
                sides.as_flattened().iter().all(|v| *v != 6) && sides.as_flattened().iter().any(|v| *v > 6),
                "{method}: {sides:?}"
            ),
            other => panic!("{method}: {other:?}"),
        }
    }
    let inside = Case::of(&[outline, hole(&[[3.0, 1.0]]), hole(&[[9.0, 1.0], [9.0, 4.0], [11.0, 4.0]])]);
    let polygon = Polygon::new(&inside.points, &inside.ring_ends).expect("it is well formed");
    let mut steps: Vec<Step> = Vec::new();
    let triangles = PolygonMethod::Ears.triangulate(polygon, &mut steps).expect("it is valid");
    assert_eq!(inside.fault(&triangles), None);
    let told = |t: &[u32; 3]| steps.iter().any(|step| step.shape == trimalla::trace::Shape::Triangle(*t));
    let of_point = triangles.iter().filter(|t| t.contains(&6));
    assert!(of_point.clone().count() > 2 && of_point.into_iter().all(told), "{triangles:?}");
}
