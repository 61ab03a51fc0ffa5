//! Polygons: every method, against what is obviously true and by comparison of all with all.

use crate::polygon_cases::{Case, KINDS, scribble};
use trimalla::geometry::Point;
use trimalla::polygon::{Polygon, PolygonError, PolygonMethod, Triangulator};
use trimalla::trace::NoTrace;
use trimalla_testkit::generators::SplitMix64;

fn by(method: Option<PolygonMethod>, case: &Case) -> Result<Vec<[u32; 3]>, PolygonError> {
    let polygon = Polygon::new(&case.points, &case.ring_ends)?;
    match method {
        Some(method) => method.triangulate(polygon, &mut NoTrace),
        None => Triangulator::new().triangulate(polygon).map(<[_]>::to_vec),
    }
}

/// The methods that take polygons with holes, and the triangulator.
fn methods() -> impl Iterator<Item = Option<PolygonMethod>> {
    [None].into_iter()
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
