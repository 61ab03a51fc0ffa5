//! Points of `MeshSuite` that the presets do not use: the off-center of figure 15, and the incenter of figure 1.

use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build};
use trimalla::drawing::Pslg;
use trimalla::geometry::{Angle, Containment, Point, Segment, Triangle, angle_at_least};
use trimalla::refine::{
    ConstrainedSecond, Insert, LeppRule, NoObserver, PlacePoint, Prepare, Preset, Recipe, RefineOptions, Refinement,
    Select, StopReason,
};
use trimalla_testkit::generators::{PointSetKind, SplitMix64, point_set};

fn domain(points: &[Point]) -> ConstrainedDelaunay {
    let pslg = Pslg { points: points.to_vec(), ..Pslg::default() };
    build(&pslg, DomainRule::Hull, Crossings::Refuse, AlgorithmKey::default()).expect("a domain").0
}

fn options(point: PlacePoint, insert: Insert) -> RefineOptions {
    let recipe = Recipe { point, insert, prepare: Prepare::None, select: Select::Manual, ..Preset::OffCenter.recipe() };
    RefineOptions { recipe, ..RefineOptions::default() }
}

/// A long thin triangle in the middle of a large square, far from every edge.
fn needle(width: f64) -> (ConstrainedDelaunay, [Point; 3]) {
    let corners = [[0.0, 0.0], [width, 0.1 * width], [0.4 * width, 10.0]].map(Point::from);
    let square = [[-400.0, -400.0], [400.0, -400.0], [400.0, 400.0], [-400.0, 400.0]].map(Point::from);
    (domain(&[&corners[..], &square].concat()), corners)
}

#[test]
fn the_angle_at_the_exact_off_center_is_the_bound() {
    let mut treated = 0;
    for degrees in [5.0, 12.0, 20.0, 27.3, 30.0, 33.0] {
        for width in [0.25, 0.3, 0.611_111, 1.0] {
            let (t, [p, q, r]) = needle(width);
            if 2.0 * Triangle::new(p, q, r).min_angle().degrees() >= degrees {
                continue; // The circumcenter sees p–q at the bound or more: it is nearer.
            }
            treated += 1;
            let face =
                t.real_faces().find(|&f| t.face_points(f).iter().all(|c| [p, q, r].contains(c))).expect("the needle");
            let asked = options(PlacePoint::OffCenterExact, Insert::Flip).with_min_angle_deg(degrees);
            let mut refinement = Refinement::new(t, asked).expect("triangles");
            let before = refinement.triangulation().points().len();
            assert!(refinement.pick(face));
            refinement.run(&mut NoObserver);
            let points = refinement.triangulation().points();
            assert_eq!(points.len(), before + 1, "{degrees}, {width}");
            let o = points[before];
            let angle = Triangle::new(o, p, q).angles()[0].degrees();
            assert!((angle - degrees).abs() < 1e-12 * degrees, "{angle} for {degrees}, {width}");
            assert!(angle_at_least(o, p, q, Angle::from_degrees(degrees).cos_sq()), "{degrees}, {width}: just good");
        }
    }
    assert_eq!(treated, 22);
}

#[test]
fn exact_off_centers_refine() {
    for seed in 0..20 {
        let t = domain(&point_set(PointSetKind::Uniform, 40, seed));
        let recipe = Recipe { point: PlacePoint::OffCenterExact, ..Preset::OffCenter.recipe() };
        let asked = RefineOptions { recipe, ..RefineOptions::default() }.with_min_angle_deg(28.0);
        let mut refinement = Refinement::new(t, asked).expect("triangles");
        assert_eq!(refinement.run(&mut NoObserver), StopReason::Finished, "seed {seed}");
        let (t, report) = refinement.finish();
        assert_eq!(t.check_delaunay(), []);
        assert!(report.complete(), "seed {seed}");
    }
}

#[test]
fn the_incenter_lies_inside_and_depends_on_no_order() {
    let mut rng = SplitMix64::new(1);
    for _ in 0..2000 {
        let scale = [1.0, 1e-150, 1e150][rng.below(3)];
        let mut corner = || Point::new(scale * rng.range(-1.0, 1.0), scale * rng.range(-1.0, 1.0));
        let [a, b, c] = [corner(), corner(), corner()];
        let triangle = Triangle::new(a, b, c);
        let center = triangle.incenter();
        assert!([Triangle::new(b, c, a), Triangle::new(c, b, a)].iter().all(|t| t.incenter() == center));
        if triangle.min_angle().degrees() > 1e-3 {
            assert_eq!(triangle.locate(center), Containment::Inside);
            let radius = triangle.inradius();
            let distances = [0, 1, 2].map(|i| triangle.edge(i).distance(center));
            assert!(distances.iter().all(|d| (d - radius).abs() < 1e-9 * scale), "{distances:?}, {radius}");
        }
    }
    let [a, b, far] = [Point::new(0.0, 0.0), Point::new(f64::MAX, 0.0), Point::new(-f64::MAX, f64::MAX)];
    assert!(Triangle::new(a, b, far).incenter().is_finite());
    assert_eq!(Triangle::new(b, b, b).incenter(), b);
}

#[test]
fn trivial_refinement_makes_three_triangles_of_the_picked_one() {
    let t = domain(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]].map(Point::from));
    let face = t.real_faces().next().expect("a triangle");
    let mut refinement = Refinement::new(t, options(PlacePoint::Incenter, Insert::Partition)).expect("triangles");
    assert!(refinement.pick(face));
    refinement.run(&mut NoObserver);
    let t = refinement.triangulation();
    assert_eq!((t.face_count(), t.points().last().copied()), (3, Some(Point::new(1.0, 1.0))));
}

#[test]
fn incenters_end_whatever_is_asked() {
    for insert in [Insert::Flip, Insert::Cavity, Insert::Partition] {
        let t = domain(&point_set(PointSetKind::Uniform, 30, 4));
        let recipe = Recipe { point: PlacePoint::Incenter, insert, ..Preset::OffCenter.recipe() };
        let start = RefineOptions { recipe, ..RefineOptions::default() };
        let mut angles = Refinement::new(t.clone(), start.with_min_angle_deg(25.0)).expect("triangles");
        angles.run(&mut NoObserver);
        assert!(angles.finish().0.points().len() < 20_000, "{insert}");
        let small = start.with_min_angle_deg(0.0).with_max_area(1e-3);
        let mut areas = Refinement::new(t, small).expect("triangles");
        assert_eq!(areas.run(&mut NoObserver), StopReason::Finished, "{insert}");
        let (t, _) = areas.finish();
        assert!(t.real_faces().all(|f| {
            let [a, b, c] = t.face_points(f);
            Triangle::new(a, b, c).area() < 1.0001e-3
        }));
    }
}

/// A square of two triangles with a constrained second-longest edge in each: t1's is halved, though t2's is longer.
#[test]
fn a_constrained_second_edge_of_the_first_terminal_triangle_comes_before_the_longer_one() {
    let points = [[0.0, 0.0], [10.0, 0.0], [4.0, 6.0], [4.0, -7.5], [4.5, 20.0], [5.5, -20.0]].map(Point::from);
    let segments = [[1, 2], [1, 3]];
    let outline = [[0, 5], [5, 1], [1, 4], [4, 0]];
    let pslg = Pslg { points: points.to_vec(), segments: [&outline[..], &segments].concat(), ..Pslg::default() };
    let (t, _) = build(&pslg, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()).expect("a domain");
    let name = |f| t.face_vertices(f);
    let of = |apex: u32| {
        t.real_faces().find(|&f| [0, 1, apex].iter().all(|&v| name(f).iter().any(|w| w.0 == v))).expect("a face")
    };
    for (first, end) in [(of(2), points[2]), (of(3), points[3])] {
        let recipe = Recipe {
            point: PlacePoint::LeppMidpoint,
            constrained_second: ConstrainedSecond::Always,
            lepp_rule: LeppRule::StopAtBoundary,
            select: Select::Manual,
            ..Preset::LeppMidpoint.recipe()
        };
        let asked = RefineOptions { recipe, ..RefineOptions::default() };
        let mut refinement = Refinement::new(t.clone(), asked).expect("triangles");
        assert!(refinement.pick(first));
        let before = refinement.triangulation().points().len();
        // The pick queues the subsegment, and the next step splits it.
        (0..2).for_each(|_| drop(refinement.step()));
        // On the segment, at a shell around its end.
        let split = refinement.triangulation().points().get(before).copied().expect("a vertex");
        assert!(Segment::new(points[1], end).distance(split) < 1e-12, "t1 is {first}: {split}");
    }
}
