//! Domains by every rule, by contours, and what is refused.

use super::*;
use crate::constrained::Crossings;
use crate::delaunay::AlgorithmKey;
use crate::drawing::Pslg;
use crate::geometry::Point;
use crate::half_edge::{UndoLog, VertexId};

/// Squares of side 2r around the origin, each a ring, counter-clockwise.
fn squares(radii: &[f64]) -> Pslg {
    let mut pslg = Pslg::default();
    for &r in radii {
        let first = pslg.points.len() as u32;
        pslg.points.extend([[-r, -r], [r, -r], [r, r], [-r, r]].map(Point::from));
        pslg.segments.extend((0..4).map(|i| [first + i, first + (i + 1) % 4]));
    }
    pslg
}

fn area_of(pslg: &Pslg, rule: DomainRule) -> f64 {
    let (cdt, _) = build(pslg, rule, Crossings::Refuse, AlgorithmKey::Incremental).unwrap();
    assert_eq!(cdt.check(), []);
    cdt.real_faces()
        .map(|f| {
            let [a, b, c] = cdt.face_points(f);
            (b - a).cross(c - a) / 2.0
        })
        .sum()
}

#[test]
fn rules_keep_what_they_say() {
    let mut pslg = squares(&[4.0, 3.0, 2.0]);
    assert_eq!(area_of(&pslg, DomainRule::Seeds), 64.0);
    assert_eq!(area_of(&pslg, DomainRule::Nesting), 64.0 - 36.0 + 16.0);
    pslg.holes.push(Point::new(0.0, 2.5));
    assert_eq!(area_of(&pslg, DomainRule::Seeds), 64.0 - 36.0 + 16.0);
    assert_eq!(area_of(&pslg, DomainRule::Hull), 64.0 - 36.0 + 16.0);
}

#[test]
fn a_thousand_nested_squares() {
    let radii: Vec<f64> = (1..=1000).rev().map(f64::from).collect();
    let expected: f64 = radii.chunks(2).map(|r| 4.0 * (r[0] * r[0] - r[1] * r[1])).sum();
    assert_eq!(area_of(&squares(&radii), DomainRule::Nesting), expected);
}

#[test]
fn leaks_and_empty_domains_are_errors() {
    let refused = |pslg: &Pslg, rule| build(pslg, rule, Crossings::Refuse, AlgorithmKey::Incremental).unwrap_err();
    let mut open = squares(&[4.0]);
    open.segments.remove(0);
    let nearest = Some((VertexId(1), 8.0));
    let end = Some(OpenEnd { vertex: VertexId(0), at: Point::new(-4.0, -4.0), nearest });
    assert_eq!(refused(&open, DomainRule::Seeds), DomainError::OpenOutline { end });
    let mut holed = squares(&[4.0, 3.0]);
    holed.segments.remove(0);
    holed.holes.push(Point::new(0.0, 0.5));
    assert_eq!(refused(&holed, DomainRule::Seeds), DomainError::OpenOutline { end });
    let mut leaking = squares(&[4.0]);
    leaking.holes.push(Point::new(1.0, 0.5));
    assert!(matches!(refused(&leaking, DomainRule::Seeds), DomainError::SeedTakesAll { seed: 0, .. }));
    let mut pocket = squares(&[4.0]);
    pocket.points.push(Point::new(0.0, 9.0));
    pocket.holes.push(Point::new(0.0, 5.0));
    assert!(matches!(refused(&pocket, DomainRule::Seeds), DomainError::SeedLeaks { seed: 0, .. }));
    let mut on_segment = squares(&[4.0]);
    on_segment.holes.push(Point::new(4.0, 0.5));
    assert!(matches!(refused(&on_segment, DomainRule::Seeds), DomainError::SeedOnSegment { .. }));
    let flat = Pslg { points: (0..4).map(|i| Point::new(f64::from(i), 0.0)).collect(), ..Pslg::default() };
    assert_eq!(refused(&flat, DomainRule::Seeds), DomainError::Flat { points: 4 });
    let doubled = Pslg { segments: [squares(&[4.0]).segments, squares(&[4.0]).segments].concat(), ..squares(&[4.0]) };
    assert_eq!(refused(&doubled, DomainRule::Nesting), DomainError::NothingNested);
}

#[test]
fn contours_agree_with_nesting_whatever_the_algorithm() {
    let pslg = squares(&[4.0, 2.0]);
    let mut points = pslg.points.clone();
    points.extend((0..60).map(|i| Point::new(f64::from(i % 8) - 3.5, f64::from(i / 8) - 3.25)));
    points.push(points[2]);
    let contours = Contours {
        outer: Some((0..4).map(VertexId).collect()),
        holes: vec![(4..8).rev().map(VertexId).collect()],
        ..Contours::default()
    };
    let a = contours.triangulate(&points, AlgorithmKey::Incremental).unwrap();
    let b = contours.triangulate(&points, AlgorithmKey::DivideAndConquer).unwrap();
    let (c, _) = build(
        &Pslg { points: points.clone(), ..pslg },
        DomainRule::Nesting,
        Crossings::Refuse,
        AlgorithmKey::Incremental,
    )
    .unwrap();
    assert_eq!(a.check(), []);
    assert_eq!(a.canonical(), b.canonical());
    assert_eq!(a.canonical(), c.canonical());
    assert_eq!(a.duplicates(), b.duplicates());
    let holes_only = Contours { outer: None, ..contours.clone() };
    assert_eq!(holes_only.triangulate(&points, AlgorithmKey::Incremental).unwrap().canonical(), a.canonical());
    let wrong = Contours { outer: Some((0..4).rev().map(VertexId).collect()), ..Contours::default() };
    assert!(matches!(
        wrong.triangulate(&points, AlgorithmKey::Incremental),
        Err(DomainError::ContourOrientation { contour: 0, .. })
    ));
}

#[test]
fn carving_rolls_back_exactly() {
    let (mut cdt, _) = triangulate(&squares(&[4.0, 3.0, 1.0]), Crossings::Refuse, AlgorithmKey::Incremental).unwrap();
    let before = cdt.clone();
    let keep: Vec<bool> = (0..cdt.face_slots()).map(|f| f % 3 != 0).collect();
    let mut log = UndoLog::new();
    let start = log.checkpoint();
    assert!(cdt.carve(&keep, &mut log));
    assert_eq!(cdt.check(), []);
    cdt.rollback(&mut log, start);
    assert!(cdt == before, "the carving was taken back");
}

#[test]
fn holes_that_touch_leave_pinched_vertices() {
    let mut pslg = squares(&[4.0]);
    let at = |x: f64, y: f64| Point::new(x, y);
    pslg.points.extend([
        at(-2.0, 0.0),
        at(-1.0, -1.0),
        at(0.0, 0.0),
        at(-1.0, 1.0),
        at(1.0, -1.0),
        at(2.0, 0.0),
        at(1.0, 1.0),
    ]);
    pslg.segments.extend([[4, 5], [5, 6], [6, 7], [7, 4], [6, 8], [8, 9], [9, 10], [10, 6]]);
    pslg.holes.extend([at(-1.0, 0.0), at(1.0, 0.0)]);
    assert_eq!(area_of(&pslg, DomainRule::Seeds), 60.0);
}

#[test]
fn attributes_of_a_linear_function_stay_linear() {
    let mut pslg = squares(&[4.0, 1.5]);
    pslg.holes.push(Point::new(0.0, 0.0));
    let height = |p: Point| [2.0 * p.x - p.y + 3.0, 7.0];
    pslg.attributes_per_point = 2;
    pslg.point_attributes = pslg.points.iter().flat_map(|&p| height(p)).collect();
    let options = crate::MeshOptions {
        refine: crate::refine::RefineOptions::default().with_max_area(0.2),
        ..crate::MeshOptions::default()
    };
    let mesh = crate::mesh(&pslg, &options).expect("a mesh").mesh;
    assert!(mesh.points.len() > 100);
    for (p, row) in mesh.points.iter().zip(mesh.point_attributes.chunks(2)) {
        assert!((row[0] - height(*p)[0]).abs() < 1e-12 && row[1] == 7.0, "{p}: {row:?}");
    }
    // Given rows keep their bits.
    assert_eq!(mesh.point_attributes[..16], pslg.point_attributes[..]);
}
