//! Polygons: every method, against what is obviously true and by comparison of all with all.

use crate::Cancelled;
use crate::polygon_cases::{Case, KINDS, scribble};
use trimalla::domain::DomainRule;
use trimalla::geometry::{Point, Vector, lexicographically_less};
use trimalla::polygon::{
    Cause, MonotonePieces, Monotonicity, Polygon, PolygonError, PolygonMethod, Triangulator, VertexKind,
    chain_monotonicity, monotone_pieces, ring_monotonicity, triangulate_monotone,
};
use trimalla::trace::NoTrace;
use trimalla::{DomainOptions, Pslg, triangulate};
use trimalla_testkit::generators::SplitMix64;
use trimalla_testkit::oracles::{canonical, doubled_ring_area, orient};

fn by(method: Option<PolygonMethod>, case: &Case) -> Result<Vec<[u32; 3]>, PolygonError> {
    let polygon = Polygon::new(&case.points, &case.ring_ends)?;
    match method {
        Some(method) => method.triangulate(polygon, &mut NoTrace),
        None => Triangulator::new().triangulate(polygon).map(<[_]>::to_vec),
    }
}

/// The methods that take polygons with holes, and the triangulator.
fn methods() -> impl Iterator<Item = Option<PolygonMethod>> {
    let several = [PolygonMethod::Monotone, PolygonMethod::Ears, PolygonMethod::ConstrainedDelaunay];
    [None].into_iter().chain(several.map(Some))
}

#[test]
fn ten_thousand_polygons_are_triangulated() {
    let mut rng = SplitMix64::new(1807);
    let mut reused = Triangulator::new();
    for round in 0..10_000 {
        let (kind, make) = KINDS[round % KINDS.len()];
        let size = 3 + rng.below(if round % 50 == 0 { 200 } else { 30 });
        let case = make(size, &mut rng);
        for method in methods() {
            let triangles = by(method, &case).unwrap_or_else(|e| panic!("{method:?} {kind} {round} {e}: {case:?}"));
            let fault = case.fault(&triangles);
            assert!(fault.is_none(), "{method:?} {kind} {round} {fault:?}: {case:?} {triangles:?}");
        }
        let polygon = Polygon::new(&case.points, &case.ring_ends).unwrap();
        assert_eq!(reused.triangulate(polygon).unwrap(), by(None, &case).unwrap(), "memory changes nothing");
    }
}

#[test]
fn flips_lead_to_the_constrained_delaunay_triangulation() {
    let mut rng = SplitMix64::new(1811);
    let mut reused = Triangulator::new();
    let nested = DomainOptions { rule: DomainRule::Nesting, ..DomainOptions::default() };
    let mut compared = 0;
    for round in 0..700 {
        let (kind, make) = KINDS[round % KINDS.len()];
        let case = make(3 + rng.below(60), &mut rng);
        // Points given twice have two indices in a polygon, and one vertex in a drawing.
        if !case.is_plain() {
            continue;
        }
        let drawing = Pslg::of_rings(case.rings().into_iter().map(<[Point]>::to_vec));
        let mesh = triangulate(&drawing, &nested).unwrap_or_else(|e| panic!("{kind} {round}: {e}")).mesh;
        let polygon = Polygon::new(&case.points, &case.ring_ends).unwrap();
        let made = reused.triangulate_delaunay(polygon).unwrap().to_vec();
        assert_eq!(canonical(&made), canonical(&mesh.triangles), "{kind} {round}: {case:?}");
        let by_key = by(Some(PolygonMethod::ConstrainedDelaunay), &case).unwrap();
        assert_eq!(canonical(&by_key), canonical(reused.triangulate_delaunay(polygon).unwrap()));
        compared += 1;
    }
    assert!(compared > 300, "{compared}");
}

#[test]
fn scribbles_are_refused_exactly_when_they_are_invalid() {
    let mut rng = SplitMix64::new(1808);
    let mut counts = [0; 3];
    for round in 0..60_000 {
        let case = scribble(&mut rng);
        let valid = case.is_valid();
        counts[valid.map_or(2, usize::from)] += 1;
        for method in methods() {
            match by(method, &case) {
                Ok(triangles) => {
                    assert_ne!(valid, Some(false), "{method:?} {round} should refuse {case:?}");
                    let fault = case.fault(&triangles);
                    assert!(fault.is_none(), "{method:?} {round} {fault:?}: {case:?} {triangles:?}");
                }
                Err(e) => assert_ne!(valid, Some(true), "{method:?} {round} should not say {e}: {case:?}"),
            }
        }
    }
    assert!(counts.iter().take(2).all(|&n| n > 1000), "{counts:?}");
}

#[test]
fn huge_and_tiny_polygons_are_triangulated() {
    let mut rng = SplitMix64::new(1809);
    for scale in [f64::MAX / 100.0, 1e300, 1e-300, 5e-324] {
        for (kind, make) in KINDS {
            let mut case = make(12, &mut rng);
            case.points
                .iter_mut()
                .for_each(|p| *p = Point::new((p.x * 4.0).round() * scale, (p.y * 4.0).round() * scale));
            for method in methods() {
                match by(method, &case) {
                    Ok(triangles) => assert_eq!(case.fault(&triangles), None, "{method:?} {kind}"),
                    Err(e) => assert_ne!(case.is_valid(), Some(true), "{method:?} {kind} {e}: {case:?}"),
                }
            }
        }
    }
}

/// The kind of a vertex by its two sides alone, the inside on the left of the way `p`, `v`, `q`.
fn kind_by_sides(p: Point, v: Point, q: Point) -> VertexKind {
    let turns_left = orient(p, v, q) == 1;
    match (lexicographically_less(v, p), lexicographically_less(v, q), turns_left) {
        (true, true, true) => VertexKind::Start,
        (true, true, false) => VertexKind::Split,
        (false, false, true) => VertexKind::End,
        (false, false, false) => VertexKind::Merge,
        (false, true, _) => VertexKind::Lower,
        (true, false, _) => VertexKind::Upper,
    }
}

#[test]
fn pieces_are_monotone_and_both_sweeps_draw_the_same_diagonals() {
    let mut rng = SplitMix64::new(1810);
    for round in 0..3000 {
        let (name, make) = KINDS[round % KINDS.len()];
        let case = make(3 + rng.below(40), &mut rng);
        let polygon = Polygon::new(&case.points, &case.ring_ends).unwrap();
        let found = monotone_pieces(polygon, &mut NoTrace).unwrap();
        let mut triangles = Vec::new();
        for piece in &found.pieces {
            let ring: Vec<Point> = piece.iter().map(|&v| case.points[v as usize]).collect();
            assert_ne!(ring_monotonicity(&ring, Vector { x: 1.0, y: 0.0 }), Monotonicity::Not, "{name} {piece:?}");
            triangles.extend(triangulate_monotone(&case.points, piece, &mut NoTrace).unwrap());
        }
        assert_eq!(case.fault(&triangles), None, "{name} {round} {case:?}");
        if !case.is_plain() {
            continue;
        }
        for &(v, kind) in &found.kinds {
            let (p, q) = neighbours(&case, v as usize);
            assert_eq!(kind, kind_by_sides(p, case.points[v as usize], q), "{name} {round} vertex {v}");
        }
        // The sweep from right to left is that from left to right of the polygon turned by a half-turn.
        let turned: Vec<Point> = case.points.iter().map(|p| Point::new(-p.x, -p.y)).collect();
        let back = monotone_pieces(Polygon::new(&turned, &case.ring_ends).unwrap(), &mut NoTrace).unwrap();
        let drawn = |found: &MonotonePieces, not: Cause| {
            let mut all: Vec<[u32; 2]> = found.diagonals.iter().filter(|d| d.cause != not).map(|d| d.ends).collect();
            all.iter_mut().for_each(|ends| ends.sort_unstable());
            all.sort_unstable();
            all
        };
        assert_eq!(drawn(&found, Cause::Split), drawn(&back, Cause::Merge), "{name} {round}");
        assert_eq!(drawn(&found, Cause::Merge), drawn(&back, Cause::Split), "{name} {round}");
    }
}

/// The neighbours of a corner on the way with the inside on its left.
fn neighbours(case: &Case, v: usize) -> (Point, Point) {
    let end = case.ring_ends.iter().position(|&e| v < e as usize).expect("a ring");
    let begin = if end == 0 { 0 } else { case.ring_ends[end - 1] as usize };
    let ring = &case.points[begin..case.ring_ends[end] as usize];
    let (i, n) = (v - begin, ring.len());
    let (p, q) = (ring[(i + n - 1) % n], ring[(i + 1) % n]);
    let ccw = doubled_ring_area(ring) > Default::default();
    if ccw == (end == 0) { (p, q) } else { (q, p) }
}

#[test]
fn monotonicity_is_told_for_any_direction() {
    let mut rng = SplitMix64::new(1811);
    let mut counts = [0; 3];
    for _ in 0..20_000 {
        let chain: Vec<Point> =
            (0..2 + rng.below(4)).map(|_| Point::new(rng.below(4) as f64, rng.below(4) as f64)).collect();
        let direction = Vector { x: rng.below(5) as f64 - 2.0, y: rng.below(5) as f64 - 2.0 };
        let mut at: Vec<f64> = chain.iter().map(|p| p.x * direction.x + p.y * direction.y).collect();
        let distinct = chain.windows(2).zip(at.windows(2)).any(|(p, a)| p[0] != p[1] && a[0] == a[1]);
        let sorted = at.is_sorted();
        at.reverse();
        let expected = match (sorted || at.is_sorted(), distinct) {
            (false, _) => Monotonicity::Not,
            (true, true) => Monotonicity::Monotone,
            (true, false) => Monotonicity::Strict,
        };
        assert_eq!(chain_monotonicity(&chain, direction), expected, "{chain:?} {direction:?}");
        counts[expected as usize] += 1;
    }
    assert!(counts.iter().all(|&n| n > 1000), "{counts:?}");
    let square = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)].map(|(x, y)| Point::new(x, y));
    assert_eq!(ring_monotonicity(&square, Vector { x: 1.0, y: 0.0 }), Monotonicity::Monotone);
    assert_eq!(ring_monotonicity(&square, Vector { x: 1.0, y: 0.5 }), Monotonicity::Strict);
    let notch = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (2.0, 1.0), (0.0, 3.0)].map(|(x, y)| Point::new(x, y));
    assert_eq!(ring_monotonicity(&notch, Vector { x: 0.0, y: 1.0 }), Monotonicity::Not);
    assert!(matches!(
        triangulate_monotone(&notch.map(|p| Point::new(p.y, p.x)), &[0, 1, 2, 3, 4], &mut NoTrace),
        Err(PolygonError::NotMonotone { .. })
    ));
}

#[test]
fn a_cancelled_triangulation_ends() {
    let case = KINDS[0].1(5000, &mut SplitMix64::new(1812));
    let polygon = Polygon::new(&case.points, &case.ring_ends).unwrap();
    for method in methods().flatten() {
        assert_eq!(method.triangulate(polygon, &mut Cancelled), Err(PolygonError::Cancelled), "{method}");
    }
}
