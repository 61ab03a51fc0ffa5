//! Heights at points: the example of the notes, planes, weights in rationals, contours by brute force.

use crate::Cancelled;
use crate::rationals::{Place, exact, nearer};
use dashu_ratio::RBig;
use trimalla::constrained::Crossings;
use trimalla::delaunay::{AlgorithmKey, Delaunay};
use trimalla::domain::{DomainRule, build_exactly};
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::{Point, Segment};
use trimalla::half_edge::VertexId;
use trimalla::interpolate::{
    Contour, InterpolateError, InterpolationMethod, Levels, NaturalNeighbours, Surface, WeightsBy, interpolate,
};
use trimalla::trace::Step;
use trimalla::triangulation::Triangulation;
use trimalla_testkit::generators::{PointSetKind, SplitMix64, point_set};
use trimalla_testkit::oracles::orient;

/// A, B, C, D, E of the notes, whose heights they give; the coordinates are ours.
const TERRAIN: [([f64; 2], f64); 5] =
    [([-6.0, 9.5], 110.0), ([6.0, 10.5], 110.0), ([0.0, 0.0], 100.0), ([-86.0, 2.0], 70.0), ([84.0, 12.0], 20.0)];
const P: Point = Point::new(0.0, 6.0);

fn terrain() -> (Vec<Point>, Vec<f64>) {
    TERRAIN.iter().map(|&(at, height)| (Point::from(at), height)).unzip()
}

#[test]
fn the_example_of_the_notes_gives_53_and_106_metres() {
    let (points, heights) = terrain();
    let bad = IndexedMesh {
        points: points.clone(),
        triangles: vec![[2, 4, 3], [3, 4, 1], [3, 1, 0]],
        ..IndexedMesh::default()
    };
    let bad = Triangulation::from_indexed(&bad).unwrap();
    let found = Surface::new(&bad, &heights).unwrap().height_at(P).unwrap();
    assert!((found - 53.0).abs() < 1e-12, "{found}");
    let good = Delaunay::new(&points).unwrap();
    let found = Surface::new(&good, &heights).unwrap().height_at(P).unwrap();
    assert!((found - 106.0).abs() < 1e-12, "{found}");
    let smooth = interpolate(&good, &heights, &[P], InterpolationMethod::NaturalNeighbour).unwrap()[0].unwrap();
    assert!((100.0..110.0).contains(&smooth), "{smooth}");
}

/// Points around and in a set: random ones, vertices, middles of pairs.
fn questions(points: &[Point], rng: &mut SplitMix64) -> Vec<Point> {
    let mut asked = Vec::new();
    if points.is_empty() {
        return asked;
    }
    for _ in 0..40 {
        let mut some = || points[rng.below(points.len())];
        let (p, q, r) = (some(), some(), some());
        asked.extend([p, Point::midpoint(p, q), Point::midpoint(Point::midpoint(p, q), r)]);
    }
    asked
}

const METHODS: &[InterpolationMethod] = &InterpolationMethod::ALL;

#[test]
fn planes_are_reproduced_and_outside_is_exact() {
    let rng = &mut SplitMix64::new(1);
    for kind in PointSetKind::ALL {
        let points = point_set(kind, 40, 2);
        let size = points.iter().fold(0.0, |m: f64, p| m.max(p.x.abs()).max(p.y.abs()));
        if !(1e-9..1e9).contains(&size) {
            continue;
        }
        let plane = |p: Point| 3.0 + 2.0 * p.x - 5.0 * p.y;
        let delaunay = Delaunay::new(&points).unwrap();
        let heights: Vec<f64> = points.iter().map(|&p| plane(p)).collect();
        let asked = questions(&points, rng);
        let inside = |p: Point| {
            delaunay.real_faces().any(|f| {
                let [a, b, c] = delaunay.face_points(f);
                orient(a, b, p) >= 0 && orient(b, c, p) >= 0 && orient(c, a, p) >= 0
            })
        };
        for &method in METHODS {
            let found = interpolate(&delaunay, &heights, &asked, method).unwrap();
            for (&p, height) in asked.iter().zip(&found) {
                if delaunay.dimension() == 2 {
                    assert_eq!(height.is_some(), inside(p), "{} {method}: {p}", kind.key());
                }
                let Some(height) = height else { continue };
                let off = (height - plane(p)).abs();
                // Centers of triangles between clusters are less exact than their corners.
                let allowed = if method == InterpolationMethod::Linear { 1e-10 } else { 1e-6 };
                assert!(off <= allowed * (3.0 + size), "{} {method}: {p} is off by {off:e}", kind.key());
                if let Some(at) = points.iter().position(|&q| q == p) {
                    let at = delaunay.representative(VertexId::from_index(at));
                    assert_eq!(*height, heights[at.index()], "{} {method}: on a vertex", kind.key());
                }
            }
        }
    }
}

fn twice_area(ring: &[Place]) -> RBig {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).fold(RBig::ZERO, |sum, (p, q)| sum + &p[0] * &q[1] - &p[1] * &q[0])
}

/// Sibson's weights by their definition: which part of each cell the cell of `p` takes.
fn stolen(points: &[Point], p: Point) -> Vec<f64> {
    let sites: Vec<Place> = points.iter().map(|&q| exact(q)).collect();
    let far = |x: i32, y: i32| [RBig::from(x), RBig::from(y)];
    let plane = vec![far(-1_000_000, -1_000_000), far(1_000_000, -1_000_000), far(0, 2_000_000)];
    let cell = sites.iter().fold(plane, |part, site| nearer(&part, &exact(p), site));
    let whole = twice_area(&cell);
    let of_site = |i: usize| {
        let others = sites.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, site)| site);
        twice_area(&others.fold(cell.clone(), |part, other| nearer(&part, &sites[i], other)))
    };
    (0..sites.len()).map(|i| (of_site(i) / &whole).to_f64().value()).collect()
}

#[test]
fn natural_neighbours_have_the_weights_of_their_definition() {
    let rng = &mut SplitMix64::new(4);
    for kind in [PointSetKind::Uniform, PointSetKind::IntegerGrid, PointSetKind::CocircularWithCentre] {
        let points = point_set(kind, 14, 6);
        let delaunay = Delaunay::new(&points).unwrap();
        let mut neighbours = NaturalNeighbours::new(&delaunay);
        let mut inside = 0;
        for _ in 0..25 {
            let [a, b, c] = delaunay.face_points(delaunay.real_faces().nth(rng.below(delaunay.face_count())).unwrap());
            let (s, t) = (rng.range(0.05, 0.45), rng.range(0.05, 0.45));
            let p = a + (b - a).scaled(s) + (c - a).scaled(t);
            let expected = stolen(&points, p);
            let Some(weights) = neighbours.weights(p, WeightsBy::Area) else { continue };
            inside += 1;
            let mut found = vec![0.0; points.len()];
            weights.iter().for_each(|&(v, weight)| found[v.index()] += weight);
            for (found, expected) in found.iter().zip(&expected) {
                assert!((found - expected).abs() < 1e-9, "{}: {found} instead of {expected} at {p}", kind.key());
            }
        }
        assert!(inside > 20);
    }
}

#[test]
fn weights_sum_to_one_and_give_the_point_back() {
    let points = point_set(PointSetKind::Uniform, 300, 9);
    let delaunay = Delaunay::new(&points).unwrap();
    let mut neighbours = NaturalNeighbours::new(&delaunay);
    let rng = &mut SplitMix64::new(3);
    for by in [WeightsBy::Area, WeightsBy::Length] {
        for i in 0..500 {
            let mut p = Point::new(rng.unit(), rng.unit());
            if i % 5 == 0 {
                // Within rounding of a vertex or an edge of the hull.
                let h = delaunay.edges().filter(|&h| delaunay.is_boundary_edge(h)).nth(rng.below(5)).unwrap();
                p = Segment::new(delaunay.edge_points(h)[0], delaunay.edge_points(h)[1]).at(rng.unit());
            }
            let Some(weights) = neighbours.weights(p, by) else { continue };
            let sum: f64 = weights.iter().map(|w| w.1).sum();
            assert!((sum - 1.0).abs() < 1e-12 && weights.iter().all(|w| w.1 >= 0.0));
            let x: f64 = weights.iter().map(|w| w.1 * points[w.0.index()].x).sum();
            let y: f64 = weights.iter().map(|w| w.1 * points[w.0.index()].y).sum();
            assert!((x - p.x).abs() + (y - p.y).abs() < 1e-9, "{by:?}: ({x}, {y}) instead of {p}");
        }
    }
}

#[test]
fn many_points_have_the_heights_that_each_has_alone() {
    let drawing = Pslg::of_rings([
        vec![[0.0, 0.0], [9.0, 1.0], [8.0, 7.0], [5.0, 2.5], [4.0, 8.0], [1.0, 6.0]],
        vec![[2.0, 2.0], [3.0, 4.0], [4.0, 2.0]],
    ]);
    let (domain, _) = build_exactly(&drawing, DomainRule::Nesting, Crossings::Refuse, AlgorithmKey::default()).unwrap();
    let heights: Vec<f64> = (0..domain.points().len()).map(|i| (i * i) as f64).collect();
    let surface = Surface::new(&domain, &heights).unwrap();
    let rng = &mut SplitMix64::new(1);
    let mut asked: Vec<Point> = (0..400).map(|_| Point::new(rng.range(-1.0, 10.0), rng.range(-1.0, 9.0))).collect();
    asked.extend([Point::new(f64::NAN, 1.0), Point::new(1.0, f64::INFINITY), Point::new(1e300, -1e300)]);
    asked.extend_from_slice(&drawing.points);
    let found = surface.heights_at(&asked);
    let mut inside = 0;
    for (&p, height) in asked.iter().zip(&found) {
        assert_eq!(p.is_finite().then(|| surface.height_at(p)).flatten(), *height);
        let holds = domain.real_faces().any(|f| domain.face_contains(f, p));
        assert_eq!(height.is_some(), holds, "{p}");
        inside += usize::from(holds);
    }
    assert!(inside > 100);
}

#[test]
fn gradients_are_those_of_the_planes() {
    let points = point_set(PointSetKind::Uniform, 50, 4);
    let delaunay = Delaunay::new(&points).unwrap();
    let heights: Vec<f64> = points.iter().map(|p| 3.0 * p.x - 4.0 * p.y + 1.0).collect();
    let surface = Surface::new(&delaunay, &heights).unwrap();
    for g in delaunay.real_faces().map(|f| surface.gradient(f).unwrap()) {
        assert!((g.x - 3.0).abs() + (g.y + 4.0).abs() < 1e-9, "{g:?}");
    }
    for v in delaunay.used_vertices() {
        let g = surface.gradient_at(v).unwrap();
        assert!((g.x - 3.0).abs() + (g.y + 4.0).abs() < 1e-9, "{g:?}");
    }
    assert_eq!(surface.gradient(delaunay.ghost_faces().next().unwrap()), None);
    assert_eq!(surface.gradient_at(VertexId(9999)), None);
    for scale in [1e-200, 1e200] {
        let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|[x, y]| Point::new(x * scale, y * scale));
        let delaunay = Delaunay::new(&points).unwrap();
        let surface = Surface::new(&delaunay, &[0.0, 2.0, 3.0]).unwrap();
        let g = surface.gradient(delaunay.real_faces().next().unwrap()).unwrap();
        assert!((g.x * scale - 2.0).abs() + (g.y * scale - 3.0).abs() < 1e-12, "{g:?}");
    }
}

/// How often contours of a level cross the edges of a triangulation, counted edge by edge.
fn crossed_edges(t: &Triangulation, heights: &[f64], level: f64) -> usize {
    let above = |v: VertexId| heights[v.index()] >= level;
    t.edges().filter(|&h| above(t.origin(h)) != above(t.dest(h))).count()
}

fn check_contours(t: &Triangulation, heights: &[f64], contours: &[Contour], what: &str) {
    let surface = Surface::new(t, heights).expect("a height for each vertex");
    for contour in contours {
        let Contour { level, points, is_closed } = contour;
        assert!(points.len() > 1, "{what}: a contour of one point");
        let span = surface.range().map_or(0.0, |[low, high]| high - low);
        for &p in points {
            let on_edge = |[a, b]: [Point; 2]| Segment::new(a, b).distance(p) <= 1e-12 * (a - b).length_sq().sqrt();
            let at_level = t.edges().filter(|&h| on_edge(t.edge_points(h))).any(|h| {
                let [a, b] = t.edge_points(h);
                let by = Segment::new(a, b).nearest_parameter(p);
                let height = (1.0 - by) * heights[t.origin(h).index()] + by * heights[t.dest(h).index()];
                (height - level).abs() <= 1e-9 * span
            });
            assert!(at_level, "{what}: {p} is not at {level}");
        }
        if !is_closed {
            for &end in [&points[0], &points[points.len() - 1]] {
                let mut boundary = t.edges().filter(|&h| t.is_boundary_edge(h)).map(|h| t.edge_points(h));
                assert!(boundary.any(|[a, b]| Segment::new(a, b).distance(end) < 1e-12), "{what}: {end} is inside");
            }
        }
    }
}

#[test]
fn contours_cross_every_edge_between_higher_and_lower_ground() {
    let rng = &mut SplitMix64::new(6);
    for kind in [PointSetKind::Uniform, PointSetKind::IntegerGrid, PointSetKind::Cocircular65] {
        for whole in [false, true] {
            let points = point_set(kind, 70, 5);
            let delaunay = Delaunay::new(&points).unwrap();
            // Whole heights from a few: many vertices lie exactly at a level, and many triangles are level.
            let heights: Vec<f64> =
                points.iter().map(|_| if whole { rng.below(4) as f64 } else { rng.range(0.0, 3.0) }).collect();
            let surface = Surface::new(&delaunay, &heights).unwrap();
            for level in [-1.0, 0.0, 0.5, 1.0, 2.0, 2.75, 3.0, 4.0] {
                let contours = surface.contours(&Levels::At(vec![level])).unwrap();
                check_contours(&delaunay, &heights, &contours, kind.key());
                if !whole {
                    // All points differ: each crossed edge has one, a closed contour as many as edges.
                    let points: usize = contours.iter().map(|c| c.points.len()).sum();
                    assert_eq!(points, crossed_edges(&delaunay, &heights, level), "{}", kind.key());
                }
            }
            let all = surface.contours(&Levels::Every(0.5)).unwrap();
            let some = |level: f64| surface.contours(&Levels::At(vec![level])).unwrap();
            let one_by_one: Vec<Contour> = (0..=6).flat_map(|i| some(f64::from(i) * 0.5)).collect();
            assert_eq!(all, one_by_one);
        }
    }
}

#[test]
fn higher_ground_is_on_the_left() {
    let pyramid = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [2.0, 2.0]].map(Point::from);
    let delaunay = Delaunay::new(&pyramid).unwrap();
    let contours = |heights: &[f64], level: f64| {
        Surface::new(&delaunay, heights).unwrap().contours(&Levels::At(vec![level])).unwrap()
    };
    let [up] = &contours(&[0.0, 0.0, 0.0, 0.0, 8.0], 4.0)[..] else { panic!("one contour") };
    let [down] = &contours(&[8.0, 8.0, 8.0, 8.0, 0.0], 4.0)[..] else { panic!("one contour") };
    let area = |c: &Contour| trimalla::geometry::Ring::new(&c.points).signed_area();
    assert!(up.is_closed && down.is_closed);
    assert_eq!((area(up), area(down)), (4.0, -4.0));
    // A ridge from corner to corner.
    let [open] = &contours(&[0.0, 0.0, 8.0, 8.0, 4.0], 6.0)[..] else { panic!("one contour") };
    assert!(!open.is_closed && open.points[0].x < open.points[open.points.len() - 1].x);
}

#[test]
fn faults_are_named() {
    let (points, mut heights) = terrain();
    let delaunay = Delaunay::new(&points).unwrap();
    assert_eq!(Surface::new(&delaunay, &[1.0]).unwrap_err(), InterpolateError::Count { heights: 1, vertices: 5 });
    let surface = Surface::new(&delaunay, &heights).unwrap();
    assert_eq!(surface.range(), Some([20.0, 110.0]));
    for step in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(surface.contours(&Levels::Every(step)), Err(InterpolateError::Step(step)));
    }
    assert!(matches!(surface.contours(&Levels::Every(f64::NAN)), Err(InterpolateError::Step(_))));
    assert!(matches!(surface.contours(&Levels::Every(1e-300)), Err(InterpolateError::TooManyLevels { .. })));
    assert!(matches!(surface.contours(&Levels::At(vec![f64::NAN])), Err(InterpolateError::Level(_))));
    heights[3] = f64::NAN;
    let error = Surface::new(&delaunay, &heights).unwrap_err();
    assert!(error.to_string().contains("vertex 3 at (-86, 2)"), "{error}");
}

#[test]
fn few_and_collinear_vertices_have_heights() {
    let none = Delaunay::new(&[]).unwrap();
    assert_eq!(Surface::new(&none, &[]).unwrap().height_at(P), None);
    let one = Delaunay::new(&[P]).unwrap();
    assert_eq!(Surface::new(&one, &[7.0]).unwrap().height_at(Point::new(1.0, 1.0)), None);
    let line = [[0.0, 0.0], [2.0, 2.0], [6.0, 6.0]].map(Point::from);
    let line = Delaunay::new(&line).unwrap();
    for &method in METHODS {
        let asked = [[0.0, 0.0], [1.0, 1.0], [5.0, 5.0], [7.0, 7.0], [1.0, 0.0]].map(Point::from);
        let found = interpolate(&line, &[0.0, 4.0, 8.0], &asked, method).unwrap();
        assert_eq!(found, [Some(0.0), Some(2.0), Some(7.0), None, None]);
    }
    let surface = Surface::new(&line, &[0.0, 4.0, 8.0]).unwrap();
    assert_eq!(surface.contours(&Levels::Every(1.0)), Ok(Vec::new()));
}

#[test]
fn extreme_coordinates_and_heights_are_answered() {
    let max = f64::MAX;
    let points = [[-max, -max], [max, -max], [max, max], [-max, max], [0.0, 5e-324], [1e300, 1.0]].map(Point::from);
    let heights = [max, -max, max, -max, 0.0, 5e-324];
    let delaunay = Delaunay::new(&points).unwrap();
    let asked = [[0.0, 0.0], [max, 0.0], [1e300, 1e299], [5e-324, 5e-324], [-1e-300, 1e308]].map(Point::from);
    for &method in METHODS {
        for height in interpolate(&delaunay, &heights, &asked, method).unwrap() {
            assert!(height.is_some_and(f64::is_finite), "{method}");
        }
    }
    let surface = Surface::new(&delaunay, &heights).unwrap();
    for contour in surface.contours(&Levels::At(vec![-1e308, 0.0, 5e-324, 1e308])).unwrap() {
        assert!(contour.points.iter().all(|p| p.is_finite()));
    }
}

#[test]
fn steps_are_told() {
    let (points, heights) = terrain();
    let delaunay = Delaunay::new(&points).unwrap();
    let surface = Surface::new(&delaunay, &heights).unwrap();
    let mut steps: Vec<Step> = Vec::new();
    surface.contours_with_trace(&Levels::Every(10.0), &mut steps).unwrap();
    assert!(!steps.is_empty());
    let cancelled = surface.contours_with_trace(&Levels::Every(10.0), &mut Cancelled);
    assert_eq!(cancelled, Err(InterpolateError::Cancelled));
    steps.clear();
    NaturalNeighbours::new(&delaunay).weights_with_trace(P, WeightsBy::Area, &mut steps).unwrap();
    assert!(steps.len() >= 4, "{steps:?}");
}
