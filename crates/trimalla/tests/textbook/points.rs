//! Triangulations of point sets.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use trimalla::IndexedMesh;
use trimalla::delaunay::{AlgorithmKey, BuildError};
use trimalla::geometry::Point;
use trimalla::optimal::{FlipCriterion, OptimalError, OptimalInput, OptimalMethod, locally_optimal};
use trimalla::quality::{DelaunayMeasures, compare_equiangularity, max_detour};
use trimalla::trace::{Act, NoTrace, Shape, Step};
use trimalla_testkit::generators::{PointSetKind, SplitMix64, point_set};
use trimalla_testkit::oracles::{RBig, covers_hull, delaunay_triangle_count, in_circle, orient};

use super::{Cancelled, enumerate};

/// Point sets of every kind, of at most `n` points.
fn sets(n: usize, seeds: u64) -> impl Iterator<Item = (String, Vec<Point>)> {
    let kinds = PointSetKind::ALL.into_iter();
    kinds.flat_map(move |kind| (0..seeds).map(move |seed| (format!("{kind:?} {n} {seed}"), point_set(kind, n, seed))))
}

#[test]
fn pairs_give_one_of_the_triangulations() {
    for n in [0, 3, 6, 8] {
        for (name, points) in sets(n, 2) {
            let made = OptimalMethod::Pairs.triangulate(&OptimalInput::of_points(&points), &mut NoTrace).unwrap();
            let all = enumerate::triangulations(&points);
            assert!(all.contains(&made.triangles) || all.is_empty() && made.triangles.is_empty(), "{name}: {made:?}");
        }
    }
}

#[test]
fn five_algorithms_share_one_canonical_list() {
    let mut sets_seen = 0;
    for n in [4, 12, 40] {
        for (name, points) in sets(n, 9) {
            sets_seen += 1;
            let [first, others @ ..] = AlgorithmKey::ALL;
            let expected = first.triangulate(&points, None).unwrap();
            for other in others {
                let made = other.triangulate(&points, None).unwrap();
                assert_eq!(made.check_delaunay(), [], "{other} {name}");
                assert_eq!(made.dimension(), expected.dimension(), "{other} {name}");
                assert_eq!(made.canonical(), expected.canonical(), "{other} {name}");
                assert_eq!(made.canonical_edges(), expected.canonical_edges(), "{other} {name}");
                assert_eq!(made.duplicates(), expected.duplicates(), "{other} {name}");
            }
        }
    }
    assert!(sets_seen > 1000, "only {sets_seen} sets");
}

#[test]
fn five_algorithms_agree_on_larger_sets() {
    for (name, points) in sets(400, 1) {
        let [first, others @ ..] = AlgorithmKey::ALL;
        let expected = first.triangulate(&points, None).unwrap().canonical();
        for other in others {
            assert_eq!(other.triangulate(&points, None).unwrap().canonical(), expected, "{other} {name}");
        }
    }
}

/// Rounding leads the sweep of `voronoi` astray only where distances are below the last place of the size of the set.
#[test]
fn the_sweep_is_led_astray_by_sets_of_many_magnitudes_alone() {
    use PointSetKind as Kind;
    for kind in Kind::ALL {
        let many_magnitudes = [
            Kind::UlpBlock,
            Kind::UlpBlockOnLine,
            Kind::MixedExponents,
            Kind::ModerateExponents,
            Kind::MixedMagnitudes,
            Kind::Exponential,
            Kind::SubnormalTriangle,
            Kind::FarTriangle,
        ];
        for (n, seed) in [(12, 0), (40, 1), (400, 2), (400, 3)] {
            let mut steps: Vec<Step> = Vec::new();
            AlgorithmKey::Voronoi.triangulate_traced(&point_set(kind, n, seed), None, &mut steps).unwrap();
            let is_astray = steps.iter().any(|s| s.note.contains("astray"));
            assert!(!is_astray || many_magnitudes.contains(&kind), "{kind:?} {n} {seed}");
        }
    }
}

#[test]
fn a_cancelled_trace_ends_the_algorithms() {
    let points = point_set(PointSetKind::Uniform, 50, 1);
    let heights: Vec<f64> = points.iter().map(|p| p.x * p.y).collect();
    for key in [AlgorithmKey::Lift, AlgorithmKey::Flip, AlgorithmKey::Voronoi] {
        let made = key.triangulate_traced(&points, None, &mut Cancelled);
        assert_eq!(made.map(|_| ()), Err(BuildError::Cancelled), "{key}");
    }
    for method in OptimalMethod::ALL {
        if method == OptimalMethod::MinWeightPolygon {
            continue; // It takes domains only.
        }
        let input = OptimalInput { heights: Some(&heights), ..OptimalInput::of_points(&points) };
        assert_eq!(method.triangulate(&input, &mut Cancelled), Err(OptimalError::Cancelled), "{method}");
    }
}

/// Replaying the triangles that `lift` and `voronoi`, and the edges that `flip`, add and remove, gives the
/// triangulation.
#[test]
fn the_steps_make_the_triangulation() {
    for (name, points) in sets(40, 1) {
        let expected = AlgorithmKey::Incremental.triangulate(&points, None).unwrap();
        for key in [AlgorithmKey::Lift, AlgorithmKey::Flip] {
            let mut steps: Vec<Step> = Vec::new();
            key.triangulate_traced(&points, None, &mut steps).unwrap();
            let mut there = BTreeSet::new();
            for step in steps {
                let mut shape = match step.shape {
                    Shape::Edge(e) => e.to_vec(),
                    Shape::Triangle(t) => t.to_vec(),
                    _ => continue,
                };
                shape.sort_unstable();
                match step.act {
                    Act::Add => assert!(there.insert(shape), "{key} {name}"),
                    Act::Remove => assert!(there.remove(&shape), "{key} {name}"),
                    _ => {}
                }
            }
            let made: Vec<Vec<u32>> = there.into_iter().collect();
            let mut list: Vec<Vec<u32>> = match key {
                AlgorithmKey::Lift => expected.canonical().iter().map(|t| t.map(|v| v.0).to_vec()).collect(),
                _ => expected.canonical_edges().iter().map(|e| e.map(|v| v.0).to_vec()).collect(),
            };
            list.iter_mut().for_each(|shape| shape.sort_unstable());
            list.sort_unstable();
            assert_eq!(made, list, "{key} {name}");
        }
    }
}

#[test]
fn greedy_fast_is_greedy_naive() {
    let greedy = |method: OptimalMethod, points: &[Point]| {
        method.triangulate(&OptimalInput::of_points(points), &mut NoTrace).unwrap()
    };
    for n in [5, 8, 30] {
        for (name, points) in sets(n, 3) {
            let fast = greedy(OptimalMethod::Greedy, &points);
            assert_eq!(fast, greedy(OptimalMethod::GreedyNaive, &points), "{name}");
            let all = if n <= 8 { enumerate::triangulations(&points) } else { Vec::new() };
            assert!(all.is_empty() || all.contains(&fast.triangles), "{name}");
        }
    }
    for kind in
        [PointSetKind::Uniform, PointSetKind::CoarseUniform, PointSetKind::IntegerGrid, PointSetKind::RandomWalk]
    {
        for seed in 0..2 {
            let points = point_set(kind, 150, seed);
            let fast = greedy(OptimalMethod::Greedy, &points);
            assert_eq!(fast, greedy(OptimalMethod::GreedyNaive, &points), "{kind:?} {seed}");
        }
    }
}

/// The shortest pairs are there, exactly, and ties go to the lower vertices.
#[test]
fn greedy_takes_the_shortest_pair_first() {
    for n in [5, 9, 16] {
        for (name, points) in sets(n, 1) {
            let mut steps: Vec<Step> = Vec::new();
            OptimalMethod::Greedy.triangulate(&OptimalInput::of_points(&points), &mut steps).unwrap();
            let edges = steps.iter().filter(|s| s.act == Act::Add).filter_map(|s| match s.shape {
                Shape::Edge(e) => Some((squared_length(&points, e), e)),
                _ => None,
            });
            assert!(edges.collect::<Vec<_>>().is_sorted(), "{name}");
        }
    }
}

fn squared_length(points: &[Point], [a, b]: [u32; 2]) -> RBig {
    let number = |x: f64| RBig::try_from(x).expect("a finite number");
    let [a, b] = [a, b].map(|v| points[v as usize]);
    let [x, y] = [number(a.x) - number(b.x), number(a.y) - number(b.y)];
    &x * &x + &y * &y
}

/// Any triangulation of a frame with a hole, given as a domain, leads to the same greedy triangulation.
#[test]
fn domains_keep_their_boundary() {
    let frame = [[0.0, 0.0], [9.0, 0.0], [9.0, 8.0], [0.0, 8.0], [2.0, 2.0], [3.0, 6.0], [6.0, 4.0]].map(Point::from);
    let boundary = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 4]];
    let all = enumerate::triangulations_within(&frame, &boundary);
    let heights = frame.map(|p| p.x * p.y);
    use OptimalMethod::{FlipMinMaxAngle, FlipShortestDiagonal, MinMaxLength, MinMaxLengthByTree, MinWeightPolygon};
    for method in OptimalMethod::ALL {
        if matches!(method, MinMaxLength | MinMaxLengthByTree | MinWeightPolygon) {
            continue; // They take points only, or no holes.
        }
        let mut made = BTreeSet::new();
        for triangles in &all {
            let mesh = IndexedMesh { points: frame.to_vec(), triangles: triangles.clone(), ..IndexedMesh::default() };
            let input =
                OptimalInput { domain: Some(&mesh), heights: Some(&heights), ..OptimalInput::of_points(&frame) };
            made.insert(method.triangulate(&input, &mut NoTrace).unwrap().triangles);
        }
        assert!(made.iter().all(|triangles| all.contains(triangles)), "{method}");
        // These end in a local optimum, which depends on where they begin.
        let is_local = matches!(method, FlipMinMaxAngle | FlipShortestDiagonal);
        assert!(made.len() == 1 || is_local, "{method}");
    }
    let both = [OptimalMethod::Greedy, OptimalMethod::GreedyNaive].map(|method| {
        let mesh = IndexedMesh { points: frame.to_vec(), triangles: all[0].clone(), ..IndexedMesh::default() };
        let input = OptimalInput { domain: Some(&mesh), ..OptimalInput::of_points(&frame) };
        method.triangulate(&input, &mut NoTrace).unwrap()
    });
    assert_eq!(both[0], both[1]);
}

/// The properties that the notes list: the Delaunay triangulation against all triangulations of small sets.
#[test]
fn delaunay_is_best_as_the_notes_say() {
    let mut rng = SplitMix64::new(5);
    for round in 0..220 {
        let n = 4 + round % 6;
        let flat = [1.0, 0.3, 0.05][round % 3];
        let points: Vec<Point> = (0..n).map(|_| Point::new(rng.unit(), flat * rng.unit())).collect();
        let mesh =
            |triangles: Vec<[u32; 3]>| IndexedMesh { points: points.clone(), triangles, ..IndexedMesh::default() };
        let t = AlgorithmKey::Incremental.triangulate(&points, None).unwrap();
        let best = mesh(t.canonical().iter().map(|t| t.map(|v| v.0)).collect());
        let measures = DelaunayMeasures::of(&best);
        assert!(max_detour(&best) < 2.42, "{points:?}");
        for triangles in enumerate::triangulations(&points) {
            let other = mesh(triangles);
            assert_ne!(compare_equiangularity(&best, &other), Ordering::Less, "{points:?}");
            let there = DelaunayMeasures::of(&other);
            let (more, less) = (1.0 + 1e-9, 1.0 - 1e-9);
            assert!(measures.min_angle >= there.min_angle * less, "{points:?}");
            assert!(measures.max_enclosing_radius <= there.max_enclosing_radius * more, "{points:?}");
            assert!(measures.inradius_sum >= there.inradius_sum * less, "{points:?}");
            assert!(measures.max_circumradius <= there.max_circumradius * more, "{points:?}");
        }
    }
}

/// Of cocircular points, some Delaunay triangulation is equiangular; the smallest angle is the best for all.
#[test]
fn ties_leave_the_smallest_angle_the_best() {
    for n in [6, 8] {
        for (name, points) in sets(n, 2) {
            let all = enumerate::triangulations(&points);
            let mesh = |t: &[[u32; 3]]| IndexedMesh {
                points: points.clone(),
                triangles: t.to_vec(),
                ..IndexedMesh::default()
            };
            let made =
                OptimalMethod::FlipMaxMinAngle.triangulate(&OptimalInput::of_points(&points), &mut NoTrace).unwrap();
            let delaunay = AlgorithmKey::Lift.triangulate(&points, None).unwrap().canonical();
            assert_eq!(made.triangles, delaunay.iter().map(|t| t.map(|v| v.0)).collect::<Vec<_>>(), "{name}");
            let best = all.iter().map(|t| mesh(t)).max_by(compare_equiangularity);
            let Some(best) = best else { continue };
            assert!(first_flaw_of_circles(&points, &best.triangles).is_none(), "{name}: the best is Delaunay");
        }
    }
}

/// A triangle whose circle holds a vertex strictly inside.
fn first_flaw_of_circles(points: &[Point], triangles: &[[u32; 3]]) -> Option<[u32; 3]> {
    let holds_one = |t: &&[u32; 3]| {
        let [a, b, c] = t.map(|v| points[v as usize]);
        points.iter().any(|&p| in_circle(a, b, c, p) > 0)
    };
    triangles.iter().find(holds_one).copied()
}

/// No flip improves what flips have made, by rational numbers; segments stay.
#[test]
fn flips_end_where_no_flip_improves() {
    for n in [6, 20] {
        for (name, points) in sets(n, 2) {
            let pairs = OptimalMethod::Pairs.triangulate(&OptimalInput::of_points(&points), &mut NoTrace).unwrap();
            let mut mesh = IndexedMesh { points: points.clone(), triangles: pairs.triangles, ..IndexedMesh::default() };
            mesh.segments = mesh.edges().into_iter().step_by(7).collect();
            for criterion in FlipCriterion::ALL {
                let made = locally_optimal(&mesh, criterion, &mut NoTrace).unwrap();
                assert_eq!(trimalla::triangulation::check_mesh(&made), [], "{criterion} {name}");
                for [[a, b], [c, d]] in flippable(&made) {
                    let better = match criterion {
                        FlipCriterion::ShortestDiagonal => {
                            squared_length(&points, [c, d]) < squared_length(&points, [a, b])
                        }
                        FlipCriterion::MinMaxAngle => {
                            let largest = |ts: [[u32; 3]; 2]| {
                                ts.into_iter().flat_map(|t| corners_of(&points, t)).max().expect("corners")
                            };
                            largest([[c, a, d], [d, b, c]]) < largest([[a, b, c], [b, a, d]])
                        }
                        _ => {
                            in_circle(points[a as usize], points[b as usize], points[c as usize], points[d as usize])
                                > 0
                        }
                    };
                    assert!(!better, "{criterion} {name}: {a} {b} for {c} {d}");
                }
            }
        }
    }
}

/// A flip gives half-edges to other edges: one that waits may be an edge of the boundary when its turn comes.
#[test]
fn flips_leave_the_boundary() {
    for n in [100, 1000] {
        for seed in 0..60 {
            let points = point_set(PointSetKind::Uniform, n, seed);
            let input = OptimalInput::of_points(&points);
            for method in [OptimalMethod::FlipMinMaxAngle, OptimalMethod::FlipShortestDiagonal] {
                let made = method.triangulate(&input, &mut NoTrace).unwrap();
                assert_eq!(made.triangles.len(), delaunay_triangle_count(&points), "{method} {n} {seed}");
            }
        }
    }
}

/// What flips make of a thousand points tiles the hull, and no shorter diagonal is left.
#[test]
fn flips_of_larger_sets_are_sound() {
    use OptimalMethod as Method;
    for kind in [PointSetKind::Uniform, PointSetKind::CoarseUniform, PointSetKind::MixedExponents, PointSetKind::Spiral]
    {
        for seed in 0..3 {
            let points = point_set(kind, 1000, seed);
            for method in [Method::FlipMaxMinAngle, Method::FlipMinMaxAngle, Method::FlipShortestDiagonal] {
                let made = method.triangulate(&OptimalInput::of_points(&points), &mut NoTrace).unwrap();
                let mesh = IndexedMesh { points: points.clone(), triangles: made.triangles, ..IndexedMesh::default() };
                assert_eq!(trimalla::triangulation::check_mesh(&mesh), [], "{method} {kind:?} {seed}");
                assert!(covers_hull(&points, &mesh.triangles), "{method} {kind:?} {seed}");
                if method == Method::FlipShortestDiagonal {
                    for [edge, other] in flippable(&mesh) {
                        assert!(squared_length(&points, other) >= squared_length(&points, edge), "{kind:?} {seed}");
                    }
                }
            }
        }
    }
}

/// The edges of a mesh that are no segments and whose quadrilaterals are strictly convex, each with its other diagonal:
/// `c` to the left of `ab`, `d` to the right.
fn flippable(mesh: &IndexedMesh) -> Vec<[[u32; 2]; 2]> {
    let at = |v: u32| mesh.points[v as usize];
    let sides = mesh.triangles.iter().flat_map(|&[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]]);
    let apex: BTreeMap<[u32; 2], u32> = sides.map(|[a, b, c]| ([a, b], c)).collect();
    let inner = apex.iter().filter_map(|(&[a, b], &c)| Some([[a, b], [c, *apex.get(&[b, a])?]]));
    let is_free = |&[[a, b], [c, d]]: &[[u32; 2]; 2]| {
        let is_segment = mesh.segments.iter().any(|s| *s == [a, b] || *s == [b, a]);
        !is_segment && orient(at(c), at(a), at(d)) > 0 && orient(at(d), at(b), at(c)) > 0
    };
    inner.filter(is_free).collect()
}

/// The negative cotangents of the angles of a triangle, which grow with the angles.
fn corners_of(points: &[Point], [a, b, c]: [u32; 3]) -> [RBig; 3] {
    let number = |v: u32| {
        let p = points[v as usize];
        [p.x, p.y].map(|x| RBig::try_from(x).expect("a finite number"))
    };
    [[a, b, c], [b, c, a], [c, a, b]].map(|t| {
        let [p, q, r] = t.map(number);
        let (u, v) = ([&q[0] - &p[0], &q[1] - &p[1]], [&r[0] - &p[0], &r[1] - &p[1]]);
        -(&u[0] * &v[0] + &u[1] * &v[1]) / (&u[0] * &v[1] - &u[1] * &v[0])
    })
}

#[test]
fn inputs_that_are_wrong_are_named() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from);
    let mut holed = square;
    holed[2].y = f64::NAN;
    let mesh = IndexedMesh { points: square.to_vec(), triangles: vec![[0, 1, 2], [0, 2, 1]], ..IndexedMesh::default() };
    for method in OptimalMethod::ALL {
        let refused = |input: &OptimalInput<'_>| method.triangulate(input, &mut NoTrace).unwrap_err();
        let of_points = OptimalInput::of_points(&holed);
        assert!(matches!(refused(&of_points), OptimalError::NotFinite { index: 2, .. }), "{method}");
        let input = OptimalInput { heights: Some(&[0.0, 1.0]), ..OptimalInput::of_points(&square) };
        assert_eq!(refused(&input), OptimalError::HeightCount { heights: 2, points: 4 }, "{method}");
        let input = OptimalInput { domain: Some(&mesh), ..OptimalInput::of_points(&square) };
        assert!(matches!(refused(&input), OptimalError::Domain(_)), "{method}");
        let input = OptimalInput { domain: Some(&mesh), ..OptimalInput::of_points(&square[..3]) };
        assert_eq!(refused(&input), OptimalError::OtherPoints { count: 4, expected: 3 }, "{method}");
    }
    let many = point_set(PointSetKind::RoundedCircle, 12_000, 1);
    let made = OptimalMethod::GreedyNaive.triangulate(&OptimalInput::of_points(&many), &mut NoTrace);
    assert!(matches!(made, Err(OptimalError::TooManyPairs { .. })));
    assert!(matches!(locally_optimal(&mesh, FlipCriterion::MinMaxAngle, &mut NoTrace), Err(OptimalError::Domain(_))));
    for key in AlgorithmKey::ALL {
        assert!(matches!(key.triangulate(&holed, None), Err(BuildError::NotFinite { index: 2, .. })), "{key}");
    }
}
