//! Trapezoids, diagonals and visible pairs: counts, areas in rationals, and triangulations checked edge by edge.

use std::collections::BTreeSet;

use crate::Cancelled;
use crate::random_rings::{
    GENERATORS, Generator, Rings, check, comb, flat_comb, holes, orthogonal, spiral, star, touching,
};
use dashu_ratio::RBig;
use trimalla::Point;
use trimalla::geometry::{Containment, Orientation, Ring, SegmentContact, orient2d, segment_contact};
use trimalla::polygon::{PolygonError, TrapezoidMap, diagonals, seidel, visible_pairs, visible_pairs_of_graph};
use trimalla::trace::{Act, NoTrace, Shape, Step};
use trimalla_testkit::generators::SplitMix64;

#[test]
fn random_polygons_are_tiled() {
    let mut rng = SplitMix64::new(18);
    for round in 0..60 {
        for (name, generator) in GENERATORS {
            let rings = generator(3 + rng.below(if round == 0 { 400 } else { 40 }), &mut rng);
            let triangles = seidel(rings.polygon(), &mut NoTrace).unwrap_or_else(|e| panic!("{name}: {e}: {rings:?}"));
            check(&rings, &triangles);
            assert_eq!(triangles.len(), rings.points.len() - 2 + 2 * (rings.ends.len() - 1), "{name}: {rings:?}");
        }
    }
}

#[test]
fn touching_rings_are_tiled_under_every_seed() {
    let mut rng = SplitMix64::new(7);
    for seed in 0..600 {
        let rings = touching(&mut rng);
        let map = TrapezoidMap::new(rings.polygon(), seed, &mut NoTrace).unwrap_or_else(|e| panic!("{e}: {rings:?}"));
        let triangles = map.triangles(&mut NoTrace).expect("nobody cancels");
        check(&rings, &triangles);
        let walks = map.boundary();
        let edges_of =
            |ring: &[u32]| (0..ring.len()).map(|k| [ring[k], ring[(k + 1) % ring.len()]]).collect::<Vec<_>>();
        let mut walked: Vec<_> = walks.iter().flat_map(|walk| edges_of(walk)).collect();
        walked.sort_unstable();
        let edges: BTreeSet<_> = triangles.iter().flat_map(|t| edges_of(t)).collect();
        let boundary: Vec<_> = edges.iter().copied().filter(|&[a, b]| !edges.contains(&[b, a])).collect();
        assert_eq!(walked, boundary, "{rings:?}");
    }
}

#[test]
fn trapezoids_add_up_to_the_polygon() {
    let mut rng = SplitMix64::new(3);
    for round in 0..120 {
        let rings = match round % 10 {
            9 => touching(&mut rng),
            k => GENERATORS[k].1(3 + rng.below(30), &mut rng),
        };
        let map = TrapezoidMap::new(rings.polygon(), round as u64, &mut NoTrace).expect("a valid polygon");
        let exact = |v: f64| RBig::try_from(v).expect("finite");
        let doubled = |t: trimalla::polygon::Trapezoid| {
            let [top, bottom] = [t.top, t.bottom].map(|v| exact(rings.points[v as usize].y));
            // Where a side of the trapezoid is at a height; a horizontal side has no height.
            let at = |[lower, upper]: [u32; 2], y: &RBig| {
                let [p, q] = [lower, upper].map(|v| rings.points[v as usize]);
                let [px, py, qx, qy] = [p.x, p.y, q.x, q.y].map(exact);
                if py == qy { px } else { &px + (&qx - &px) * (y - &py) / (&qy - &py) }
            };
            if top == bottom {
                return RBig::ZERO;
            }
            let width = |y: &RBig| at(t.right, y) - at(t.left, y);
            (width(&top) + width(&bottom)) * (&top - &bottom)
        };
        let sum = map.trapezoids().map(doubled).fold(RBig::ZERO, |sum, area| sum + area);
        assert_eq!(sum, rings.doubled_area(), "{rings:?}");
    }
}

#[test]
fn points_are_found_in_trapezoids() {
    let mut rng = SplitMix64::new(5);
    for round in 0..60 {
        let rings = if round % 2 == 0 { flat_comb(40, &mut rng) } else { holes(40, &mut rng) };
        let polygon = rings.polygon();
        let map = TrapezoidMap::new(polygon, round, &mut NoTrace).expect("a valid polygon");
        for k in 0..60 {
            let p = match k % 3 {
                0 => rings.points[rng.below(rings.points.len())],
                1 => Point::new(rng.below(40) as f64 / 2.0, rng.below(12) as f64 / 4.0 - 1.0),
                _ => Point::new(rng.range(-1.0, 20.0), rng.range(-1.0, 4.0)),
            };
            let mut expected = polygon.rings().map(|ring| polygon.ring(ring).locate(p)).collect::<Vec<_>>();
            let outline = expected.remove(0);
            let expected = if expected.contains(&Containment::Inside) || outline == Containment::Outside {
                Containment::Outside
            } else if expected.contains(&Containment::On) {
                Containment::On
            } else {
                outline
            };
            assert_eq!(map.contains(p), expected, "{p} in {rings:?}");
            assert_eq!(map.trapezoid_at(p).is_some(), expected == Containment::Inside);
        }
        assert_eq!(map.contains(Point::new(f64::NAN, 0.0)), Containment::Outside);
    }
}

#[test]
fn chords_and_corners_of_a_square_with_a_notch() {
    let rings = Rings::of([(0.0, 0.0), (8.0, 1.0), (8.0, 9.0), (4.0, 5.0), (0.0, 8.0)]);
    let map = TrapezoidMap::new(rings.polygon(), 1, &mut NoTrace).expect("a valid polygon");
    let chords: Vec<_> = map.chords().iter().map(|chord| (chord.from, chord.onto, chord.at)).collect();
    let expected =
        [(1, [0, 4], Point::new(0.0, 1.0)), (3, [0, 4], Point::new(0.0, 5.0)), (3, [1, 2], Point::new(8.0, 5.0))];
    assert_eq!(chords, expected);
    assert_eq!(map.trapezoids().len(), 4);
    assert_eq!(map.diagonals().collect::<Vec<_>>(), [[3, 1]]);
    let lowest = map.trapezoids().find(|t| t.bottom == 0).expect("a lowest trapezoid");
    let corners = map.corners(&lowest);
    assert_eq!(corners, [(0.0, 0.0), (0.0, 0.0), (8.0, 1.0), (0.0, 1.0)].map(|(x, y)| Point::new(x, y)));
}

/// Polygons that must be refused.
pub(crate) fn faulty() -> Vec<Rings> {
    let square = [(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0)];
    let with_hole = |hole: &[(f64, f64)]| {
        let mut rings = Rings::of(square);
        rings.add(hole.iter().copied());
        rings
    };
    let mut nested = with_hole(&[(1.0, 1.0), (7.0, 1.0), (7.0, 7.0), (1.0, 7.0)]);
    nested.add([(2.0, 2.0), (3.0, 2.0), (2.0, 3.0)]);
    let mut twice = with_hole(&[(1.0, 1.0), (7.0, 1.0), (7.0, 7.0)]);
    twice.add([(1.0, 1.0), (7.0, 1.0), (7.0, 7.0)]);
    vec![
        Rings::of([(0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 5.0)]),
        Rings::of([(0.0, 0.0), (4.0, 0.0), (2.0, 0.0), (2.0, 3.0)]),
        Rings::of([(0.0, 0.0), (4.0, 0.0), (8.0, 0.0)]),
        Rings::of([(0.0, 0.0), (4.0, 0.0)]),
        Rings::of([]),
        // Two sides that cross at a vertex of a third and a fourth.
        Rings::of([(1., 2.), (2., 2.), (0., 0.), (0., 2.), (1., 1.), (2., 0.), (2., 0.), (1., 0.)]),
        // Two triangles that meet in a vertex, run round in opposite directions.
        Rings::of([(0.0, 0.0), (2.0, 2.0), (4.0, 5.0), (4.0, 0.0), (2.0, 2.0), (0.0, 3.0)]),
        with_hole(&[(6.0, 3.0), (6.0, 5.0), (11.0, 5.0), (11.0, 3.0)]),
        with_hole(&[(10.0, 3.0), (10.0, 5.0), (11.0, 3.0)]),
        with_hole(&[(-1.0, -1.0), (9.0, -1.0), (9.0, 9.0), (-1.0, 9.0)]),
        with_hole(&[(0.0, 0.0), (0.0, 8.0), (2.0, 6.0)]),
        with_hole(&square),
        nested,
        twice,
    ]
}

#[test]
fn faulty_polygons_are_refused_with_a_place() {
    for rings in faulty() {
        for seed in 0..40 {
            let error = TrapezoidMap::new(rings.polygon(), seed, &mut NoTrace).err();
            assert!(error.is_some(), "{rings:?} under seed {seed}");
        }
    }
    let bow = Rings::of([(0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 5.0)]);
    match seidel(bow.polygon(), &mut NoTrace) {
        Err(PolygonError::Crossing { mut sides, at }) => {
            sides.sort_unstable();
            assert_eq!(sides, [[0, 1], [2, 3]]);
            assert!((at.x - at.y).abs() < 1e-9 && at.x > 0.0, "{at}");
        }
        other => panic!("{other:?}"),
    }
    let none = Rings::default();
    assert_eq!(seidel(none.polygon(), &mut NoTrace), Ok(Vec::new()));
}

#[test]
fn random_rings_are_tiled_or_refused_as_the_oracle_says() {
    let mut rng = SplitMix64::new(11);
    let mut tiled = 0;
    for seed in 0..20_000 {
        let size = 3 + rng.below(6);
        let grid = 3 + rng.below(3);
        let rings = Rings::of((0..size).map(|_| (rng.below(grid) as f64, rng.below(grid) as f64)));
        let crosses = {
            let sides: Vec<_> = Ring::new(&rings.points).sides().filter(|(p, q)| p != q).collect();
            let faults = |(i, &(a, b)): (usize, &(Point, Point))| {
                sides[..i].iter().any(|&(c, d)| {
                    let contact = segment_contact(a, b, c, d);
                    matches!(contact, SegmentContact::Crossing | SegmentContact::Overlapping)
                })
            };
            sides.iter().enumerate().any(faults)
        };
        match TrapezoidMap::new(rings.polygon(), seed, &mut NoTrace) {
            Ok(map) => {
                assert!(!crosses, "{rings:?}");
                check(&rings, &map.triangles(&mut NoTrace).expect("nobody cancels"));
                tiled += 1;
            }
            Err(PolygonError::Crossing { .. }) => assert!(crosses, "{rings:?}"),
            Err(PolygonError::Flat { .. }) => assert_eq!(rings.doubled_area(), RBig::ZERO),
            // It passes through itself at a vertex or on a side.
            Err(PolygonError::Misplaced { .. }) => {}
            Err(other) => panic!("{other}"),
        }
    }
    assert!(tiled > 2000, "{tiled}");
}

#[test]
fn coordinates_of_any_size_are_exact() {
    let mut rng = SplitMix64::new(13);
    for scale in [1e-300, 5e-324, 1e300, f64::MAX / 64.0] {
        for _ in 0..20 {
            let rings = orthogonal(40, &mut rng).mapped(|p| Point::new(p.x * scale, p.y * scale));
            check(&rings, &seidel(rings.polygon(), &mut NoTrace).expect("a valid polygon"));
        }
    }
}

#[test]
fn every_line_that_is_removed_was_added() {
    let mut rng = SplitMix64::new(17);
    let rings = holes(60, &mut rng);
    let mut steps: Vec<Step> = Vec::new();
    let triangles = seidel(rings.polygon(), &mut steps).expect("a valid polygon");
    let mut lines = Vec::new();
    for step in &steps {
        match (step.act, step.shape) {
            (Act::Add, Shape::Line(line)) => lines.push(line),
            (Act::Remove, Shape::Line(line)) => {
                let at = lines.iter().position(|&l| l == line).expect("a line that is there");
                lines.swap_remove(at);
            }
            _ => {}
        }
    }
    let map = TrapezoidMap::new(rings.polygon(), 1991, &mut NoTrace).expect("a valid polygon");
    assert!(map.chords().len() <= lines.len());
    let told = steps.iter().filter(|s| matches!(s.shape, Shape::Triangle(_))).count();
    assert_eq!(told, triangles.len());
    assert_eq!(seidel(rings.polygon(), &mut Cancelled), Err(PolygonError::Cancelled));
}

#[test]
fn the_work_grows_nearly_linearly() {
    let mut rng = SplitMix64::new(19);
    for (name, generator) in [("star", star as Generator), ("spiral", spiral), ("comb", comb)] {
        let mut per_corner = Vec::new();
        for n in [1000, 8000, 64_000] {
            let rings = generator(n, &mut rng);
            let runs = (0..3).map(|seed| {
                let map = TrapezoidMap::new(rings.polygon(), seed, &mut NoTrace).expect("a valid polygon");
                map.steps() as f64 / rings.points.len() as f64
            });
            per_corner.push(runs.sum::<f64>() / 3.0);
        }
        assert!(per_corner[2] < 1.35 * per_corner[0] && per_corner[2] < 30.0, "{name}: {per_corner:?} steps a corner");
    }
}

#[test]
fn diagonals_and_visible_pairs_tile_polygons() {
    let mut rng = SplitMix64::new(23);
    for round in 0..300 {
        let rings = match round % 12 {
            9.. => touching(&mut rng),
            k => GENERATORS[k].1(3 + rng.below(25), &mut rng),
        };
        let expected = seidel(rings.polygon(), &mut NoTrace).expect("a valid polygon").len();
        let by_pairs = visible_pairs(rings.polygon(), &mut NoTrace).unwrap_or_else(|e| panic!("{e}: {rings:?}"));
        check(&rings, &by_pairs);
        assert_eq!(by_pairs.len(), expected, "{rings:?}");
        match diagonals(rings.polygon(), &mut NoTrace) {
            Err(PolygonError::Holes { holes, .. }) => assert_eq!(holes, rings.ends.len() - 1),
            Err(other) => panic!("{other}: {rings:?}"),
            Ok(by_diagonals) => {
                check(&rings, &by_diagonals);
                assert_eq!(by_diagonals.len(), expected, "{rings:?}");
            }
        }
    }
    for rings in faulty() {
        assert!(visible_pairs(rings.polygon(), &mut NoTrace).is_err(), "{rings:?}");
        assert!(diagonals(rings.polygon(), &mut NoTrace).is_err(), "{rings:?}");
    }
}

#[test]
fn random_rings_are_tiled_by_diagonals_and_pairs() {
    let mut rng = SplitMix64::new(29);
    for _ in 0..6000 {
        let size = 4 + rng.below(6);
        let grid = 3 + rng.below(3);
        let rings = Rings::of((0..size).map(|_| (rng.below(grid) as f64, rng.below(grid) as f64)));
        let Ok(expected) = seidel(rings.polygon(), &mut NoTrace) else {
            assert!(diagonals(rings.polygon(), &mut NoTrace).is_err(), "{rings:?}");
            continue;
        };
        for found in [diagonals(rings.polygon(), &mut NoTrace), visible_pairs(rings.polygon(), &mut NoTrace)] {
            let found = found.unwrap_or_else(|e| panic!("{e}: {rings:?}"));
            check(&rings, &found);
            assert_eq!(found.len(), expected.len());
        }
    }
}

#[test]
fn visible_pairs_triangulate_graphs() {
    let mut rng = SplitMix64::new(31);
    let mut refused = 0;
    for round in 0..400 {
        let grid = 3 + rng.below(6);
        let n = 1 + rng.below(20);
        let points: Vec<Point> = (0..n).map(|_| Point::new(rng.below(grid) as f64, rng.below(grid) as f64)).collect();
        let segments: Vec<[u32; 2]> = (0..round % 5).map(|_| [rng.below(n) as u32, rng.below(n) as u32]).collect();
        let drawing = trimalla::Pslg { points: points.clone(), segments: segments.clone(), ..Default::default() };
        let crosses = !trimalla_testkit::oracles::crossing_pairs(&drawing).is_empty();
        match visible_pairs_of_graph(&points, &segments, &mut NoTrace) {
            Ok(triangles) => {
                assert!(!crosses || segments.is_empty(), "{points:?} {segments:?}");
                assert!(trimalla_testkit::oracles::covers_hull(&points, &triangles), "{points:?} {segments:?}");
                assert!(triangles.iter().all(|t| {
                    let [a, b, c] = t.map(|v| points[v as usize]);
                    orient2d(a, b, c) == Orientation::CounterClockwise
                }));
                let distinct = trimalla_testkit::oracles::delaunay_triangle_count(&points);
                assert_eq!(triangles.len(), distinct, "{points:?} {segments:?}");
            }
            Err(PolygonError::Crossing { .. }) => {
                assert!(crosses, "{points:?} {segments:?}");
                refused += 1;
            }
            Err(other) => panic!("{other}"),
        }
    }
    assert!(refused > 20);
    let points = [Point::new(0.0, 0.0), Point::new(1.0, 0.0)];
    let error = visible_pairs_of_graph(&points, &[[0, 2]], &mut NoTrace);
    assert_eq!(error, Err(PolygonError::SegmentEnd { segment: 0, vertex: 2 }));
    let nan = visible_pairs_of_graph(&[Point::new(f64::NAN, 0.0)], &[], &mut NoTrace);
    assert!(matches!(nan, Err(PolygonError::NotFinite { index: 0, .. })));
}

/// The rings of a drawing whose segments run round one ring after the other.
fn rings_of(drawing: &trimalla::Pslg) -> Option<Rings> {
    let mut rings = Rings::default();
    let mut first = 0;
    for (k, &[a, b]) in drawing.segments.iter().enumerate() {
        let is_last = drawing.segments.get(k + 1).is_none_or(|next| next[0] != b) || b == drawing.segments[first][0];
        let p = drawing.points[a as usize];
        rings.points.push(p);
        if is_last {
            (b == drawing.segments[first][0]).then_some(())?;
            rings.ends.push(rings.points.len() as u32);
            first = k + 1;
        }
    }
    (!rings.ends.is_empty()).then_some(rings)
}

#[test]
fn real_polygons_are_tiled_or_refused_with_the_place() {
    let Some(data) = trimalla_testkit::shared::shared_data_or_say() else { return };
    let mut tiled = 0;
    for input in trimalla_testkit::readers::all_inputs(&data) {
        let is_polygon = ["earcut", "poly2tri", "salzburg"].contains(&&*input.family) && input.rings;
        let Some(rings) = is_polygon.then(|| rings_of(&input.pslg)).flatten() else { continue };
        match TrapezoidMap::new(rings.polygon(), 1, &mut NoTrace) {
            Ok(map) => {
                let triangles = map.triangles(&mut NoTrace).expect("nobody cancels");
                if triangles.len() < 12_000 {
                    check(&rings, &triangles);
                }
                tiled += 1;
            }
            Err(PolygonError::Crossing { sides: [one, two], .. }) => {
                let [[a, b], [c, d]] = [one, two].map(|side| side.map(|v| rings.points[v as usize]));
                let contact = segment_contact(a, b, c, d);
                let is_fault = matches!(contact, SegmentContact::Crossing | SegmentContact::Overlapping);
                assert!(is_fault, "{}: {one:?} {two:?}", input.name);
            }
            Err(error) => assert!(matches!(error, PolygonError::Flat { .. }), "{}: {error}", input.name),
        }
    }
    assert!(tiled >= 22, "{tiled}");
}
