//! Features of the input within rounding of each other, or nearly so, and coordinates over hundreds of decades.

use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainError, DomainRule, NearFeature, Warning, build};
use trimalla::drawing::Pslg;
use trimalla::geometry::{Angle, Point};
use trimalla::half_edge::VertexId;
use trimalla::quality::{against_input, below_bound};
use trimalla::refine::{Preset, Reason, RefineOptions};
use trimalla::{MeshOptions, refine_mesh};

use super::{issue, refined};

/// A square, and places in it with segments between them.
fn in_a_square(corner: [f64; 2], inside: &[[f64; 2]], segments: &[[u32; 2]]) -> Pslg {
    let [x, y] = corner;
    let corners = [[x, y], [x + 4.0, y], [x + 4.0, y + 4.0], [x, y + 4.0]];
    Pslg {
        points: corners.iter().chain(inside).copied().map(Point::from).collect(),
        segments: [[0, 1], [1, 2], [2, 3], [3, 0]].iter().chain(segments).copied().collect(),
        ..Pslg::default()
    }
}

/// So many doubles above a number.
fn above(x: f64, count: u64) -> f64 {
    f64::from_bits(x.to_bits() + count)
}

/// Drawings with features so many doubles apart: ends of a fan, parallel segments, lone vertices, a vertex beside a
/// segment.
fn gaps(corner: [f64; 2], count: u64) -> Vec<(&'static str, Pslg)> {
    let [x, y] = corner;
    let (apex, end) = ([x + 0.7, y + 1.1], [x + 3.3, y + 1.7]);
    let up = |p: [f64; 2], times: u64| [p[0], above(p[1], times * count)];
    let beside = up([0.5 * (apex[0] + end[0]), 0.5 * (apex[1] + end[1])], 1);
    let drawing = |inside: &[[f64; 2]], segments: &[[u32; 2]]| in_a_square(corner, inside, segments);
    vec![
        ("a fan of two", drawing(&[apex, end, up(end, 1)], &[[4, 5], [4, 6]])),
        ("a fan of three", drawing(&[apex, end, up(end, 1), up(end, 2)], &[[4, 5], [4, 6], [4, 7]])),
        ("a triangle", drawing(&[apex, end, up(end, 1)], &[[4, 5], [5, 6], [6, 4]])),
        ("unequal lengths", drawing(&[apex, end, beside], &[[4, 5], [4, 6]])),
        ("parallel", drawing(&[apex, end, up(apex, 1), up(end, 1)], &[[4, 5], [6, 7]])),
        ("lone vertices", drawing(&[end, up(end, 1)], &[])),
        ("beside a segment", drawing(&[apex, end, beside], &[[4, 5]])),
        ("two fans", drawing(&[apex, end, up(end, 1), [x + 0.5, y + 3.5]], &[[4, 5], [6, 7]])),
    ]
}

/// Triangles beside gaps within rounding had reasons of limits, though no mesh has better ones there.
#[test]
fn what_is_left_beside_gaps_within_rounding_is_forced() {
    let presets = [Preset::OffCenter, Preset::Circumcenter, Preset::LeppCentroid, Preset::LeppCircumcenter];
    for corner in [[0.0, 0.0], [500_000.0, 4_500_000.0], [-3e-5, 7e3]] {
        for count in [1, 2, 8, 64] {
            for (name, drawing) in gaps(corner, count) {
                for preset in presets {
                    for rule in [DomainRule::Seeds, DomainRule::Nesting] {
                        let options = RefineOptions::of(preset).with_max_vertices(2000);
                        let (mesh, report) = refined(&drawing, rule, options);
                        let reasons = report.reasons();
                        assert!(
                            report.complete(),
                            "{name}, {corner:?}, {count} apart, {preset:?}, {rule:?}: {reasons:?}"
                        );
                        assert!(
                            report.vertices < 200,
                            "{name}, {corner:?}, {count} apart, {preset:?}: {}",
                            report.vertices
                        );
                        assert_eq!(against_input(&mesh, &drawing).faults, [], "{name}, {corner:?}, {count} apart");
                    }
                }
            }
        }
    }
}

/// Two segments that leave a vertex an ulp apart: a triangle beside them had 26 degrees, since neither could be split
/// where the other one had its vertex.
#[test]
fn a_needle_within_rounding_spoils_no_triangle_beside_it() {
    let (_, report) = refined(&issue("needle-an-ulp-wide"), DomainRule::Seeds, RefineOptions::default());
    let sharp = |reason| matches!(reason, Reason::InputAngle | Reason::AcrossSmallInputAngle);
    assert!(report.leftovers.iter().all(|l| sharp(l.reason) && l.min_angle_deg < 1e-6), "{:?}", report.leftovers);
    assert!(report.vertices < 40, "{}", report.vertices);
}

/// Gaps wider than rounding are meshed: nothing is left beside them.
#[test]
fn vertices_farther_apart_than_rounding_are_meshed() {
    let end = [3.3, 1.7];
    let drawing = in_a_square([0.0, 0.0], &[end, [end[0], end[1] + 1e-11]], &[]);
    let (_, report) = refined(&drawing, DomainRule::Seeds, RefineOptions::default());
    assert_eq!(report.leftovers, []);
}

/// Small triangles of a large drawing passed for good ones.
#[test]
fn angles_over_decades_are_measured_in_units_of_their_triangle() {
    let drawing = issue("angles-over-decades");
    let options = RefineOptions::default().with_max_vertices(8);
    let (mesh, report) = refined(&drawing, DomainRule::Hull, options);
    let listed: Vec<usize> = report.leftovers.iter().map(|l| l.triangle).collect();
    assert_eq!(listed, below_bound(&mesh, Angle::from_degrees(30.0)));
}

/// A subsegment without room for its split was not tried again once there was some.
#[test]
fn splits_without_room_are_tried_again() {
    let drawing = issue("split-without-room-at-first");
    let mut options = RefineOptions::default().with_min_angle_deg(0.0).with_max_vertices(100);
    options.limits.length_floor = Some(6.973_146_294_229_324e-9);
    let (mesh, report) = refined(&drawing, DomainRule::Hull, options);
    assert_eq!(report.leftovers, []);
    let again = refine_mesh(&mesh, Some(&drawing), &options).expect("its own mesh");
    assert_eq!((again.mesh.points, again.mesh.triangles), (mesh.points, mesh.triangles));
}

/// Of a gap outside the domain nothing was said.
#[test]
fn parts_that_nearly_touch_are_named() {
    let drawing = issue("parts-that-nearly-touch");
    let told = |drawing: &Pslg, rule| {
        let options =
            MeshOptions { domain: trimalla::DomainOptions { rule, ..Default::default() }, ..Default::default() };
        let meshed = trimalla::mesh_with(drawing, &options, &mut trimalla::refine::NoObserver).expect("a domain");
        meshed.warnings
    };
    for rule in [DomainRule::Seeds, DomainRule::Nesting] {
        let warnings = told(&drawing, rule);
        let [Warning::NearlyTouching { vertex: 1, other: NearFeature::Vertex(4), distance, .. }] = warnings[..] else {
            panic!("{warnings:?}")
        };
        assert!((distance / 1e-10 - 1.0).abs() < 1e-5, "{distance}");
        let mut shifted = drawing.clone();
        shifted.points[4..].iter_mut().for_each(|p| p.y += 0.37);
        let warnings = told(&shifted, rule);
        assert!(
            matches!(warnings[..], [Warning::NearlyTouching { other: NearFeature::Segment(_), .. }]),
            "{warnings:?}"
        );
        shifted.points[4..].iter_mut().for_each(|p| p.x += 1e-3);
        assert_eq!(told(&shifted, rule), []);
    }
}

/// The error named one end of a gap in an outline only.
#[test]
fn both_ends_of_an_open_outline_are_named() {
    let mut open = in_a_square([0.0, 0.0], &[[0.0, 2.4e-16]], &[]);
    open.segments[3] = [3, 4];
    let refused =
        build(&open, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()).expect_err("an open outline");
    let DomainError::OpenOutline { end: Some(end) } = refused else { panic!("{refused}") };
    assert_eq!((end.vertex, end.nearest), (VertexId(0), Some((VertexId(4), 2.4e-16))));
}
