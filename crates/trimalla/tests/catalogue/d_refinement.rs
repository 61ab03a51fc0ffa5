//! Family D: traps of refinement.

use trimalla::domain::DomainRule;
use trimalla::drawing::{Pslg, Region};
use trimalla::geometry::Point;
use trimalla::refine::{Observer, OptionError, Preset, Progress, Protect, RefineOptions, StopReason};
use trimalla::triangulation::check_mesh;
use trimalla::{Error, MeshOptions, mesh, refine_mesh};
use trimalla_testkit::generators::{PointSetKind, PslgKind, next_up, point_set, pslg};

use crate::{at, drawing, refined, ring};

/// A wedge of a small angle with arms of lengths 1 and `long`.
fn wedge(degrees: f64, long: f64) -> Pslg {
    let angle = degrees.to_radians();
    let points = vec![Point::new(0.0, 0.0), Point::new(long, 0.0), Point::new(libm::cos(angle), libm::sin(angle))];
    drawing(points, &ring(0, 3))
}

/// A box of side 1000 with a segment parallel to its bottom.
fn gap(width: f64) -> Pslg {
    let points = at(&[[0.0, 0.0], [1000.0, 0.0], [1000.0, 1000.0], [0.0, 1000.0], [250.0, width], [750.0, width]]);
    let mut segments = ring(0, 4);
    segments.push([4, 5]);
    drawing(points, &segments)
}

fn asked(degrees: f64) -> RefineOptions {
    RefineOptions::default().with_min_angle_deg(degrees).with_max_vertices(5000)
}

fn square() -> Pslg {
    drawing(at(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]), &ring(0, 4))
}

#[test]
fn d01_one_small_angle() {
    for degrees in [0.001, 0.01, 0.1, 1.0, 5.0, 20.0, 59.9, 60.0] {
        let mut input = wedge(degrees, 10.0);
        input.segments = vec![[0, 1], [0, 2], [3, 4], [4, 5], [5, 6], [6, 3]];
        input.points.extend(at(&[[-5.0, -5.0], [15.0, -5.0], [15.0, 5.0], [-5.0, 5.0]]));
        for bound in [20.0, 30.0] {
            let (mesh, report) = refined(&input, DomainRule::Seeds, asked(bound));
            assert!(report.complete(), "{degrees} at {bound}: {:?}", report.reasons());
            assert!(mesh.points.len() < 1000, "{degrees} at {bound}: {} vertices", mesh.points.len());
            // The needle that a third segment closes has two small angles; it needs many triangles, but it ends.
            refined(&wedge(degrees, 10.0), DomainRule::Seeds, asked(bound));
        }
    }
}

#[test]
fn d02_fans_of_small_angles() {
    for n in [360, 3600] {
        let (mesh, report) =
            refined(&pslg(PslgKind::SegmentStar, n, 0), DomainRule::Hull, asked(20.0).with_max_vertices(200_000));
        assert!(report.stop == StopReason::Finished, "{n}: {:?}, {} vertices", report.reasons(), mesh.points.len());
    }
}

#[test]
fn d03_gaps_of_every_width() {
    for exponent in -6..=1 {
        for bound in [0.0, 20.0, 34.0] {
            let width = libm::pow(10.0, f64::from(exponent));
            let options = asked(bound).with_max_vertices(20_000);
            let (mesh, report) = refined(&gap(width), DomainRule::Seeds, options);
            assert!(mesh.points.len() <= 20_000, "10^{exponent} at {bound}");
            // Those of a metre and more need few triangles.
            assert!(exponent < 0 || report.complete(), "10^{exponent} at {bound}: {:?}", report.reasons());
        }
    }
}

#[test]
fn d04_angle_bounds_of_every_kind() {
    for good in [0.0, 33.0, 34.0, 35.0, 40.0, 59.0, 60.0] {
        refined(&square(), DomainRule::Seeds, asked(good).with_max_vertices(2000));
    }
    for bad in [-1.0, 60.5, 89.9, 90.0, f64::NAN, f64::INFINITY] {
        let refused = mesh(&square(), &MeshOptions { refine: asked(bad), ..MeshOptions::default() });
        assert!(matches!(refused, Err(Error::Option(OptionError::MinAngle(_)))), "{bad}");
    }
}

#[test]
fn d05_area_bounds_of_every_kind() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused =
            mesh(&square(), &MeshOptions { refine: asked(20.0).with_max_area(bad), ..MeshOptions::default() });
        assert!(matches!(refused, Err(Error::Option(OptionError::MaxArea(_)))), "{bad}");
    }
    for tiny in [1e-300, 5e-324, 1e-33] {
        let (mesh, report) = refined(&square(), DomainRule::Seeds, asked(20.0).with_max_area(tiny));
        assert!(mesh.points.len() <= 5000 && !report.complete(), "{tiny}");
    }
}

#[test]
fn d06_segments_one_ulp_long() {
    let up = next_up(1.0);
    let points = at(&[[0.0, 0.0], [1.0, 0.0], [up, 0.0], [up, 1.0], [0.0, 1.0]]);
    refined(&drawing(points, &ring(0, 5)), DomainRule::Seeds, asked(20.0));
    let points = at(&[[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [0.0, 3.0], [1.0, 1.0], [up, 1.0]]);
    let mut segments = ring(0, 4);
    segments.push([4, 5]);
    refined(&drawing(points, &segments), DomainRule::Seeds, asked(20.0));
}

#[test]
fn d07_needles_and_circumcenters_far_away() {
    let needle = drawing(at(&[[0.0, 0.0], [1.0, 0.0], [0.5, 1e-200]]), &ring(0, 3));
    for preset in Preset::ALL {
        let options = RefineOptions { recipe: preset.recipe(), ..asked(20.0) }.with_max_vertices(300);
        refined(&needle, DomainRule::Seeds, options);
    }
    refined(&pslg(PslgKind::Needles, 20, 1), DomainRule::Seeds, asked(20.0));
}

#[test]
fn d08_boundaries_that_stay_whole() {
    for protect in [Protect::Boundary, Protect::All] {
        let input = pslg(PslgKind::Gear, 60, 1);
        let (mesh, _) = refined(&input, DomainRule::Seeds, asked(30.0).with_protect(protect));
        let outline = |ends: &[u32; 2]| ends.iter().all(|&v| (v as usize) < input.points.len());
        assert!(mesh.segments.iter().all(outline), "{protect:?}: a segment was split");
    }
}

#[test]
fn d09_meshes_that_are_none() {
    let (good, _) = refined(&square(), DomainRule::Seeds, asked(20.0).with_max_area(0.05));
    let mut turned = good.clone();
    turned.triangles[0].swap(0, 1);
    let mut twice = good.clone();
    twice.triangles.push(twice.triangles[0]);
    let mut wild = good.clone();
    wild.triangles[0][0] = u32::MAX;
    let mut bent = good.clone();
    bent.points[6] = Point::new(f64::NAN, 0.5);
    for (what, broken) in [("turned", turned), ("twice", twice), ("out of range", wild), ("not finite", bent)] {
        assert!(matches!(refine_mesh(&broken, None, &asked(20.0)), Err(Error::Mesh(_))), "{what}");
    }
}

#[test]
fn d10_regions_far_apart_in_size() {
    let mut input = drawing(
        at(&[
            [0.0, 0.0],
            [2000.0, 0.0],
            [2000.0, 1000.0],
            [0.0, 1000.0],
            [1.0, 1.0],
            [1.01, 1.0],
            [1.01, 1.01],
            [1.0, 1.01],
        ]),
        &[ring(0, 4), ring(4, 4)].concat(),
    );
    let region =
        |x: f64, y: f64, max_area| Region { seed: Point::new(x, y), attribute: max_area, max_area: Some(max_area) };
    input.regions = vec![region(1.005, 1.005, 1e-6), region(500.0, 500.0, 1e6)];
    let (_, report) = refined(&input, DomainRule::Seeds, asked(25.0).with_max_vertices(20_000));
    assert!(report.complete(), "{:?}", report.reasons());
}

#[test]
fn d11_every_small_budget() {
    let input = wedge(20.0, 10.0);
    let (free, _) = refined(&input, DomainRule::Seeds, asked(25.0));
    let needed = free.points.len();
    for budget in 0..=needed + 20 {
        let (mesh, report) = refined(&input, DomainRule::Seeds, asked(25.0).with_max_vertices(budget));
        let most = budget.max(input.points.len());
        assert!(mesh.points.len() <= most, "{} vertices, {budget} allowed", mesh.points.len());
        // Vertices come and go: on its way a run may have some more than at its end.
        let has_finished = report.stop == StopReason::Finished;
        assert!(has_finished || budget < needed + 20, "{budget} of {needed}");
        assert!(!has_finished || budget >= needed, "{budget} of {needed}");
    }
}

/// Cancels at the n-th question.
struct CancelsAt(u64);

impl Observer for CancelsAt {
    fn progress(&mut self, _: Progress) -> bool {
        self.0 = self.0.saturating_sub(1);
        self.0 > 0
    }
}

#[test]
fn d12_cancelled_at_any_time() {
    let input = pslg(PslgKind::Gear, 100, 1);
    for preset in Preset::ALL {
        for n in 1..8 {
            let options = MeshOptions {
                refine: RefineOptions { recipe: preset.recipe(), ..asked(30.0) }.with_max_area(0.001),
                ..MeshOptions::default()
            };
            let meshed = trimalla::mesh_with(&input, &options, &mut CancelsAt(n)).expect("a mesh");
            assert_eq!(check_mesh(&meshed.mesh), [], "{preset:?}, question {n}");
        }
    }
}

#[test]
fn d13_hulls_that_are_straight_but_for_rounding() {
    let points = point_set(PointSetKind::NearCollinearHull, 200, 0);
    let (mesh, _) = refined(&drawing(points, &[]), DomainRule::Hull, asked(30.0).with_max_vertices(20_000));
    assert!(mesh.points.len() < 20_000, "{} vertices", mesh.points.len());
}

#[test]
fn d14_a_refined_mesh_stays_as_it_is() {
    for kind in [PslgKind::Gear, PslgKind::StarPolygon, PslgKind::Wedge, PslgKind::Slits] {
        let input = pslg(kind, 40, 2);
        let (first, report) = refined(&input, DomainRule::Seeds, asked(25.0));
        assert!(report.complete(), "{kind:?}");
        for bound in [25.0, 20.0] {
            let again = refine_mesh(&first, Some(&input), &asked(bound)).expect("its own mesh");
            assert_eq!(again.mesh.points.len(), first.points.len(), "{kind:?} at {bound}");
        }
    }
}

/// Shapes on which other programs have failed, described in their public reports.
#[test]
fn d15_known_offenders() {
    let tiny_edge = at(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [1e-7, 1.0], [0.0, 1.0]]);
    refined(&drawing(tiny_edge, &ring(0, 5)), DomainRule::Seeds, asked(30.0));
    let mut comb: Vec<Point> = (0..40).map(|i| Point::new(f64::from(i), 0.0)).collect();
    comb.extend(at(&[[39.0, 10.0], [0.0, 10.0]]));
    let mut segments = ring(0, 42);
    segments.extend((0..40).step_by(4).map(|i| [i, 40 + i % 2]));
    refined(&drawing(comb, &segments), DomainRule::Seeds, asked(25.0).with_max_vertices(50_000));
    let mut closed = at(&[[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0], [0.0, 0.0]]);
    closed[4] = closed[0];
    refined(&drawing(closed, &ring(0, 5)), DomainRule::Seeds, asked(30.0));
    let near_t = at(&[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0], [5.0, 1e-12], [5.0, 5.0]]);
    let mut segments = ring(0, 4);
    segments.push([4, 5]);
    let (mesh, _) = refined(&drawing(near_t, &segments), DomainRule::Seeds, asked(20.0).with_max_vertices(100_000));
    assert!(mesh.points.len() < 100_000, "{} vertices", mesh.points.len());
}
