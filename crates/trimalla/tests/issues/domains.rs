//! What belongs to a domain, and what is said of the rest.

use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{Contours, DomainError, DomainRule, Warning, build};
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::{CircleSide, Point, in_circle};
use trimalla::half_edge::VertexId;
use trimalla::triangulation::check_mesh;
use trimalla::{DomainOptions, triangulate, triangulate_conforming};

use crate::issue;

fn options(rule: DomainRule) -> DomainOptions {
    DomainOptions { rule, crossings: Crossings::Split, algorithm: AlgorithmKey::default() }
}

/// Triangles with a vertex of the mesh inside their circle, however far away and on whatever side of a boundary.
fn circles_not_empty(mesh: &IndexedMesh) -> usize {
    let mut used: Vec<u32> = mesh.triangles.iter().flatten().copied().collect();
    used.sort_unstable();
    used.dedup();
    let at = |v: u32| mesh.points[v as usize];
    let holds = |&[a, b, c]: &[u32; 3], v: u32| in_circle(at(a), at(b), at(c), at(v)) == CircleSide::Inside;
    mesh.triangles.iter().filter(|t| used.iter().any(|&v| !t.contains(&v) && holds(t, v))).count()
}

/// Boundaries were not split, so that circles reached over them.
#[test]
fn a_conforming_triangulation_conforms_at_the_boundary() {
    let drawing = issue("conforming-boundary");
    let constrained = triangulate(&drawing, &options(DomainRule::Seeds)).expect("a domain").mesh;
    assert!(circles_not_empty(&constrained) > 0, "the drawing asks for a split");
    let mut last = 0;
    for rule in DomainRule::ALL {
        let trimalla::Triangulated { mesh, warnings } =
            triangulate_conforming(&drawing, &options(rule)).expect("a domain");
        assert_eq!((check_mesh(&mesh), warnings), (vec![], vec![]));
        assert_eq!(circles_not_empty(&mesh), 0, "{rule:?}");
        assert!(mesh.points.len() > drawing.points.len() && mesh.points.len() < 20, "{}", mesh.points.len());
        last = mesh.points.len();
    }
    // Rotated and moved, where boundaries bend by rounding.
    let turned = Pslg {
        points: drawing
            .points
            .iter()
            .map(|p| Point::new(0.6 * p.x - 0.8 * p.y + 5e5, 0.8 * p.x + 0.6 * p.y + 4.6e6))
            .collect(),
        ..drawing
    };
    let mesh = triangulate_conforming(&turned, &options(DomainRule::Seeds)).expect("a domain").mesh;
    assert_eq!((check_mesh(&mesh), circles_not_empty(&mesh)), (vec![], 0));
    assert!(mesh.points.len() <= last + 4, "{}", mesh.points.len());
}

/// `nesting` refused the seed of a hole that it had removed already.
#[test]
fn nesting_takes_the_seeds_of_its_own_holes() {
    let drawing = issue("nesting-seeded-hole");
    let area = |holes: &[[f64; 2]]| {
        let seeded = Pslg { holes: holes.iter().map(|&h| h.into()).collect(), ..drawing.clone() };
        let trimalla::Triangulated { mesh, warnings } = triangulate(&seeded, &options(DomainRule::Nesting))?;
        let corners = |t: &[u32; 3]| t.map(|v| mesh.points[v as usize]);
        let doubled: f64 = mesh.triangles.iter().map(corners).map(|[a, b, c]| (b - a).cross(c - a)).sum();
        Ok::<_, DomainError>((doubled / 2.0, warnings))
    };
    let whole = 64.0 - 36.0 + 16.0;
    assert_eq!(area(&[]), Ok((whole, vec![])));
    assert_eq!(area(&[[1.5, 1.5]]), Ok((whole, vec![])), "the hole is one without its seed");
    assert_eq!(area(&[[1.5, 1.5], [6.5, 6.5]]), Ok((whole, vec![])), "two seeds in one hole");
    let (left, warnings) = area(&[[1.5, 1.5], [4.0, 4.0]]).expect("a domain");
    assert_eq!(left, whole - 16.0, "a seed in a part that is kept removes it");
    assert!(matches!(
        &warnings[..],
        [Warning::VerticesOutside { count: 4, .. }, Warning::SegmentsOutside { count: 4, .. }]
    ));
    let outside = area(&[[9.0, 4.0]]).expect("a domain").1;
    assert!(matches!(&outside[..], [Warning::IdleHole { seed: 0, .. }]), "outside of the hull");
    let mut bay = drawing.clone();
    bay.points[1] = Point::new(4.0, 0.5);
    bay.points.push(Point::new(8.0, 0.0));
    bay.holes = vec![Point::new(7.5, 0.5)];
    let leaks = triangulate(&bay, &options(DomainRule::Nesting));
    assert!(
        matches!(leaks, Err(DomainError::SeedLeaks { seed: 0, .. })),
        "inside the hull, outside of all segments: {leaks:?}"
    );
}

/// Vertices and segments outside, and markers under others, were left out in silence.
#[test]
fn what_is_left_out_is_told() {
    let drawing = issue("left-out-in-silence");
    let of = |rule| build(&drawing, rule, Crossings::Refuse, AlgorithmKey::default()).expect("a domain").1;
    let hidden = Warning::MarkersHidden { count: 1, first: [6, 0] };
    let vertices = Warning::VerticesOutside { count: 2, first: vec![4, 5] };
    let segments = Warning::SegmentsOutside { count: 2, first: vec![4, 5] };
    assert_eq!(of(DomainRule::Seeds), [vertices, segments, hidden.clone()]);
    assert_eq!(of(DomainRule::Hull), [hidden]);
    let mut many = drawing.clone();
    many.points.extend((0..20).map(|i| Point::new(20.0 + f64::from(i), 0.5 * f64::from(i % 3))));
    many.points.push(Point::new(9.0, 0.0));
    let (_, warnings) = build(&many, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()).expect("a domain");
    let told: Vec<_> = warnings.iter().filter(|w| matches!(w, Warning::VerticesOutside { .. })).collect();
    assert_eq!(
        told,
        [&Warning::VerticesOutside { count: 22, first: vec![4, 5, 6, 7, 8] }],
        "a duplicate is told as such"
    );
    assert!(warnings.contains(&Warning::Duplicates { count: 1, first: [26, 4] }), "{warnings:?}");
}

/// A hole outside the outer contour, or in another hole, was taken and ignored.
#[test]
fn a_hole_that_removes_nothing_is_refused() {
    let square =
        |x: f64, y: f64, size: f64| [[x, y], [x + size, y], [x + size, y + size], [x, y + size]].map(Point::from);
    let points = [square(0.0, 0.0, 8.0), square(1.0, 1.0, 4.0), square(9.0, 1.0, 4.0), square(2.0, 2.0, 1.0)].concat();
    let ring = |i: u32| (4 * i..4 * i + 4).map(VertexId).collect::<Vec<_>>();
    let hole = |i: u32| ring(i).into_iter().rev().collect::<Vec<_>>();
    let made = |holes: Vec<Vec<VertexId>>, algorithm| {
        Contours { outer: Some(ring(0)), holes, ..Contours::default() }.triangulate(&points, algorithm)
    };
    for algorithm in AlgorithmKey::ALL {
        assert!(made(vec![hole(1)], algorithm).is_ok());
        for (holes, contour) in [(vec![hole(2)], 1), (vec![hole(1), hole(2)], 2), (vec![hole(3), hole(1)], 1)] {
            let refused = made(holes, algorithm).map(drop);
            assert_eq!(refused, Err(DomainError::IdleContour { contour }));
        }
    }
}

/// Whether it is in the flat triangle, which is left out, or inside, depended on the algorithm.
#[test]
fn a_hole_seed_on_the_edge_of_a_flat_triangle_is_inside() {
    let drawing = issue("hole-seed-on-the-edge-of-a-flat-triangle");
    for y in [drawing.holes[0].y, 2.7e-12, 3e-12, 3.5e-12] {
        let seeded = Pslg { holes: vec![Point::new(0.03125, y)], ..drawing.clone() };
        let made =
            AlgorithmKey::ALL.map(|a| build(&seeded, DomainRule::Hull, Crossings::Refuse, a).expect("a domain").0);
        assert_eq!(made[0].face_count(), 1, "{y}: the triangle above the segment is left");
        assert_eq!(made[0].canonical(), made[1].canonical(), "{y}");
    }
}
