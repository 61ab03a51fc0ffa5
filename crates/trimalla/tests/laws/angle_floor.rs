//! The angle floors of `[MillerPavWalkington03]` hold for circumcenters at 26 degrees, wedge after wedge.

use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build};
use trimalla::drawing::Pslg;
use trimalla::geometry::{Angle, Point};
use trimalla::quality::{angle_ceiling, angle_floor, shell_floor, smallest_input_angle};
use trimalla::refine::{NoObserver, Preset, RefineOptions, Refinement, Report};

/// A triangle with this angle between sides of these lengths.
fn wedge(degrees: f64, [one, two]: [f64; 2]) -> Pslg {
    let angle = Angle::from_degrees(degrees);
    let points = [[0.0, 0.0], [one, 0.0], [two * angle.cos(), two * angle.sin()]].map(Point::from).to_vec();
    Pslg { points, segments: vec![[0, 1], [1, 2], [2, 0]], ..Pslg::default() }
}

/// A box with such an angle between two segments inside it, so that it is refined on both its sides.
fn wedge_in_a_box(degrees: f64, arms: [f64; 2]) -> Pslg {
    let corners = [[-30.0, -30.0], [30.0, -30.0], [30.0, 30.0], [-30.0, 30.0]].map(Point::from);
    let points = wedge(degrees, arms).points.into_iter().chain(corners).collect();
    let segments = vec![[0, 1], [0, 2], [3, 4], [4, 5], [5, 6], [6, 3]];
    Pslg { points, segments, ..Pslg::default() }
}

/// The report, the smallest input angle and the ceiling, in degrees.
fn refined(pslg: &Pslg) -> (Report, f64, f64) {
    let (cdt, _) = build(pslg, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()).expect("a clean drawing");
    let input = smallest_input_angle(&cdt).expect("segments meet").angle.degrees();
    let ceiling = angle_ceiling(&cdt).expect("there are triangles").bound.degrees();
    let options = RefineOptions::of(Preset::Circumcenter).with_min_angle_deg(26.0).with_max_vertices(100_000);
    let mut refinement = Refinement::new(cdt, options).expect("fine options");
    refinement.run(&mut NoObserver);
    (refinement.finish().1, input, ceiling)
}

/// Refines; says what is wrong.
#[track_caller]
fn hold(degrees: f64, arms: [f64; 2], pslg: &Pslg, floor_of: fn(Angle) -> Angle) {
    let (report, input, ceiling) = refined(pslg);
    let floor = floor_of(Angle::from_degrees(input)).degrees();
    let case = format!("{degrees}, {arms:?}, {} points", pslg.points.len());
    assert!(report.complete(), "{case}: {:?}", report.reasons());
    let found = report.min_angle_deg;
    assert!(found >= floor - 1e-9, "{case}: {found} is below {floor}");
    assert!(found <= ceiling + 1e-9, "{case}: {found} is above {ceiling}");
}

const ROOT: f64 = core::f64::consts::SQRT_2;

#[test]
fn no_angle_of_a_refined_wedge_is_below_the_floor_or_above_the_ceiling() {
    for degrees in [5.0, 10.0, 20.0, 30.0] {
        for arms in [[1.0, 1.0], [10.0, 10.0], [1.0, 10.0], [10.0, 1.0], [1.0, ROOT], [ROOT, 10.0]] {
            hold(degrees, arms, &wedge(degrees, arms), angle_floor);
        }
    }
}

#[test]
fn segments_of_any_length_keep_the_floor_of_our_shells() {
    for degrees in [2.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0] {
        for k in 0..12 {
            let first = 10.0 + 0.9 * f64::from(k);
            for arms in [[first, first], [first, 0.3 * first], [0.7 * first, first], [ROOT, first]] {
                hold(degrees, arms, &wedge_in_a_box(degrees, arms), shell_floor);
                hold(degrees, arms, &wedge(degrees, arms), shell_floor);
            }
        }
    }
}

#[test]
fn the_ceiling_of_triangles_a_is_that_of_its_right_angles() {
    let a = trimalla_testkit::readers::read_poly(&trimalla_testkit::shared_data_or_skip!().join("triangle/A.poly"));
    let (_, _, ceiling) = refined(&a);
    assert!((ceiling - 45.0).abs() < 1e-9, "{ceiling}");
}
