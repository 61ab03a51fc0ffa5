//! Contours after Valenzuela (2009), section 5.1, and Vigo (1997), section 5: any order gives one triangulation.

use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{ContourOrder, Contours, DomainError, DomainRule, build_exactly};
use trimalla::drawing::Pslg;
use trimalla::geometry::{Point, Ring, Triangle};
use trimalla::half_edge::{NoJournal, VertexId};
use trimalla_testkit::generators::SplitMix64;

/// A drawing of an outline, some rings in it, and points everywhere; corners on a grid, so that many are collinear or
/// equal.
fn drawing(seed: u64) -> (Vec<Point>, Contours) {
    let mut rng = SplitMix64::new(seed);
    let mut points = Vec::new();
    let mut ring = |corners: Vec<Point>| -> Vec<VertexId> {
        let first = points.len();
        points.extend(corners);
        (first..points.len()).map(VertexId::from_index).collect()
    };
    let outer = ring(notched(0.0, 0.0, 64.0, &mut rng));
    let mut holes = Vec::new();
    for i in 0..rng.below(5) {
        let at = [(8.0, 8.0), (40.0, 8.0), (8.0, 40.0), (40.0, 40.0)].get(i).copied().unwrap_or((28.0, 28.0));
        let mut hole = ring(notched(at.0, at.1, 8.0, &mut rng));
        hole.reverse();
        holes.push(hole);
    }
    points.extend((0..rng.below(60)).map(|_| Point::new(rng.below(70) as f64, rng.below(70) as f64)));
    (points, Contours { outer: Some(outer), holes, ..Contours::default() })
}

/// A square, counter-clockwise, with vertices along its sides, of which some are drawn inwards.
fn notched(x: f64, y: f64, side: f64, rng: &mut SplitMix64) -> Vec<Point> {
    let mut corners = Vec::new();
    for k in 0..4 {
        for i in 0..4 {
            let (u, v) = (side * f64::from(i) / 4.0, if i > 0 && rng.below(3) == 0 { side / 8.0 } else { 0.0 });
            let (dx, dy) = [(u, v), (side - v, u), (side - u, side - v), (v, side - u)][k];
            corners.push(Point::new(x + dx, y + dy));
        }
    }
    corners
}

/// The triangles and constrained edges by coordinates.
fn canonical(t: &ConstrainedDelaunay) -> (Vec<[VertexId; 3]>, Vec<[VertexId; 2]>) {
    let mut marked: Vec<[VertexId; 2]> =
        t.marked_edges().map(|h| [t.origin(h).min(t.dest(h)), t.origin(h).max(t.dest(h))]).collect();
    marked.sort_unstable();
    (t.canonical(), marked)
}

#[test]
fn holes_first_gives_the_same_triangulation() {
    for seed in 0..200 {
        let (points, contours) = drawing(seed);
        let holes_first = Contours { order: ContourOrder::HolesFirst, ..contours.clone() };
        let usual = contours.triangulate(&points, AlgorithmKey::DivideAndConquer);
        for algorithm in AlgorithmKey::ALL {
            let other = holes_first.triangulate(&points, algorithm);
            match (&usual, &other) {
                (Ok(usual), Ok(other)) => {
                    assert_eq!(other.check(), [], "seed {seed}");
                    assert_eq!(canonical(usual), canonical(other), "seed {seed}");
                    let ends: Vec<[u32; 2]> = other.segments().iter().map(|s| s.map(|v| v.0)).collect();
                    let named =
                        holes_first.segments().into_iter().map(|s| s.map(|v| other.representative(VertexId(v)).0));
                    assert_eq!(ends[..ends.len().min(named.len())], named.collect::<Vec<_>>()[..], "seed {seed}");
                }
                _ => panic!("seed {seed}: {:?} and {:?}", usual.as_ref().err(), other.as_ref().err()),
            }
        }
    }
}

#[test]
fn collinear_and_crossing_contours_are_refused_alike() {
    let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [3.0, 1.0], [6.0, 1.0], [6.0, 2.0], [3.0, 2.0]];
    let points = points.map(Point::from);
    let outer = Some((0..4).map(VertexId).collect::<Vec<_>>());
    let across = (4..8).rev().map(VertexId).collect::<Vec<_>>();
    let usual = Contours { outer, holes: vec![across], ..Contours::default() };
    let holes_first = Contours { order: ContourOrder::HolesFirst, ..usual.clone() };
    let error = |contours: &Contours| contours.triangulate(&points, AlgorithmKey::Incremental).expect_err("they cross");
    let pairs = |error: DomainError| error.to_string().matches(" and ").count();
    assert_eq!(pairs(error(&usual)), pairs(error(&holes_first)));
}

#[test]
fn a_hole_outside_its_outline_is_named_in_every_order() {
    let square = |x: f64, y: f64, s: f64| [[x, y], [x + s, y], [x + s, y + s], [x, y + s]].map(Point::from);
    let points: Vec<Point> = [square(0.0, 0.0, 10.0), square(2.0, 2.0, 3.0), square(20.0, 20.0, 2.0)].concat();
    let ring = |first: u32| (first..first + 4).map(VertexId);
    let hole = |first: u32| ring(first).rev().collect::<Vec<_>>();
    for order in [ContourOrder::ByAlgorithm, ContourOrder::HolesFirst] {
        for algorithm in AlgorithmKey::ALL {
            let contours = Contours { outer: Some(ring(0).collect()), holes: vec![hole(4), hole(8)], order };
            let refused = contours.triangulate(&points, algorithm).map(|_| ());
            assert_eq!(refused, Err(DomainError::IdleContour { contour: 2 }), "{order:?}");
        }
    }
}

#[test]
fn what_was_triangulated_on_line_is_marked_by_parity() {
    for seed in 0..100 {
        let (points, contours) = drawing(seed);
        let segments = contours.segments();
        // Contours in a triangle that contains them all, built point by point and edge by edge.
        let mut all = [[-500.0, -400.0], [600.0, -400.0], [30.0, 700.0]].map(Point::from).to_vec();
        all.extend(&points);
        let mut t = ConstrainedDelaunay::new(&all, &[], Crossings::Refuse).expect("points");
        for &[a, b] in &segments {
            t.insert_segment(VertexId(a + 3), VertexId(b + 3), Crossings::Refuse).expect("nothing crosses");
        }
        let inside = t.inside_by_parity();
        assert!(t.carve(&inside, &mut NoJournal), "seed {seed}");
        let pslg = Pslg { points, segments, ..Pslg::default() };
        let (built, _) =
            build_exactly(&pslg, DomainRule::Nesting, Crossings::Refuse, AlgorithmKey::default()).expect("a domain");
        let moved: Vec<[u32; 3]> = built.canonical().into_iter().map(|f| f.map(|v| v.0 + 3)).collect();
        assert_eq!(t.canonical().into_iter().map(|f| f.map(|v| v.0)).collect::<Vec<_>>(), moved, "seed {seed}");
        // The outline's area less that of the holes.
        let area: f64 = t.real_faces().map(|f| t.face_points(f)).map(|[a, b, c]| Triangle::new(a, b, c).area()).sum();
        let rings = contours.outer.iter().chain(&contours.holes);
        let drawn: f64 = rings
            .map(|ring| ring.iter().map(|v| pslg.points[v.index()]).collect::<Vec<_>>())
            .map(|r| Ring::new(&r).signed_area())
            .sum();
        assert!((area - drawn).abs() < 1e-9 * drawn.abs(), "seed {seed}: {area}, {drawn}");
    }
}
