//! The least total length of a polygon.

use trimalla::geometry::Point;
use trimalla::optimal::{OptimalError, OptimalInput, OptimalMethod};
use trimalla::trace::NoTrace;
use trimalla::{DomainOptions, IndexedMesh, Pslg, triangulate};
use trimalla_testkit::generators::{PslgKind, pslg};

use super::all::{all, is_triangulation_like};
use super::insertion::small_domains;

const METHOD: OptimalMethod = OptimalMethod::MinWeightPolygon;

fn total(points: &[Point], triangles: &[[u32; 3]]) -> f64 {
    let mesh = IndexedMesh { points: points.to_vec(), triangles: triangles.to_vec(), ..IndexedMesh::default() };
    let length = |[a, b]: [u32; 2]| Point::distance_sq(points[a as usize], points[b as usize]).sqrt();
    mesh.edges().into_iter().map(length).sum()
}

/// Whether the domain was triangulated; otherwise it has a hole or a vertex inside.
fn check(domain: &IndexedMesh) -> bool {
    let points = &domain.points;
    let input = OptimalInput { domain: Some(domain), ..OptimalInput::of_points(points) };
    let made = match METHOD.triangulate(&input, &mut NoTrace) {
        Ok(made) => made,
        Err(OptimalError::NotOneWalk { .. }) => return false,
        Err(other) => panic!("{other}"),
    };
    assert!(is_triangulation_like(points, &made.triangles, &domain.triangles, &domain.segments), "{domain:?}");
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * a.max(b);
    assert!(near(made.value, total(points, &made.triangles)));
    if let Some(every) = all(points, &domain.triangles, &domain.segments, 3000) {
        let best = every.iter().map(|t| total(points, t)).fold(f64::INFINITY, f64::min);
        assert!(near(made.value, best) || every.is_empty() || domain.triangles.is_empty(), "{domain:?}");
    }
    true
}

/// The domain of a drawing.
fn domain(drawing: &Pslg) -> IndexedMesh {
    triangulate(drawing, &DomainOptions::default()).expect("a clean drawing").mesh
}

#[test]
fn no_triangulation_of_a_small_polygon_is_shorter() {
    for kind in [PslgKind::StarPolygon, PslgKind::Comb, PslgKind::Zigzag, PslgKind::Needles] {
        for seed in 0..20 {
            assert!(check(&domain(&pslg(kind, 5 + seed % 6, seed as u64))), "{kind:?} {seed}");
        }
    }
    let checked = small_domains().iter().filter(|domain| check(domain)).count();
    assert!(checked > 20, "{checked}");
}

#[test]
fn edges_that_hang_into_a_polygon_are_kept() {
    let mut drawing = Pslg::of_ring([[0.0, 0.0], [8.0, 0.0], [8.0, 6.0], [0.0, 6.0]]);
    drawing.points.extend([[3.0, 2.0], [5.0, 3.0], [4.0, 4.0]].map(Point::from));
    drawing.segments.extend([[0, 4], [4, 5], [4, 6]]);
    assert!(check(&domain(&drawing)));
}

#[test]
fn convex_polygons_are_cut_by_the_table_of_their_diagonals() {
    for n in [50, 100] {
        let ring = (0..n).map(|i| {
            let x = f64::from(i);
            [x, x * x]
        });
        assert!(check(&domain(&Pslg::of_ring(ring))), "{n}");
    }
}

#[test]
fn what_is_no_polygon_is_refused() {
    let square = Pslg::of_ring([[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]]);
    let mut dotted = square.clone();
    dotted.points.push(Point::new(4.0, 5.0));
    assert!(!check(&domain(&dotted)));
    let mut holed = square.clone();
    holed.add_ring([[3.0, 3.0], [6.0, 3.0], [6.0, 6.0], [3.0, 6.0]].map(Point::from));
    holed.holes.push(Point::new(4.0, 4.0));
    assert!(!check(&domain(&holed)));
    holed.segments.push([0, 4]);
    assert!(check(&domain(&holed)), "a bridge makes one walk");
    let made = METHOD.triangulate(&OptimalInput::of_points(&square.points), &mut NoTrace);
    assert_eq!(made, Err(OptimalError::DomainOnly { method: "min-weight-polygon" }));
}
