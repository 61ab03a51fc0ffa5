//! The documents' own flow: triangulate points, which the hull closes, and refine without carving anything.

use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::{Delaunay, DivideAndConquer};
use trimalla::geometry::Point;
use trimalla::half_edge::{HalfEdgeId, NoJournal, UndoLog};
use trimalla::refine::{
    Centroid, LeppRule, NoObserver, Observer, OptionError, Preset, Progress, RefineOptions, Refinement, StopReason,
};
use trimalla::triangulation::Closure;
use trimalla_testkit::generators::{PointSetKind, SplitMix64, point_set};

use super::bad_triangle;

/// The bound of the source's sample program.
const BOUND_DEG: f64 = 32.0;
/// How many sets run.
const SETS: usize = 400;
/// No set comes near so many insertions.
const MOST: usize = 4000;

/// Kinds without points within rounding of each other, where no triangle between them could be mended.
const KINDS: [PointSetKind; 10] = [
    PointSetKind::Uniform,
    PointSetKind::IntegerGrid,
    PointSetKind::TenthGrid,
    PointSetKind::RotatedGrid,
    PointSetKind::UtmGrid,
    PointSetKind::RoundedCircle,
    PointSetKind::Duplicates,
    PointSetKind::CoarseUniform,
    PointSetKind::F32Rounded,
    PointSetKind::NearCollinearHull,
];

/// A square turned by some angle, with vertices along its sides that rounding has moved off them, and some inside.
fn turned_square(n: usize, rng: &mut SplitMix64) -> Vec<Point> {
    let (x, y) = (rng.range(-1.0, 1.0), rng.range(-1.0, 1.0));
    let length = (x * x + y * y).sqrt();
    let (cos, sin) = (x / length, y / length);
    let at = |u: f64, v: f64| Point::new(cos * u - sin * v, sin * u + cos * v);
    let mut points = vec![at(0.0, 0.0), at(3.0, 0.0), at(3.0, 3.0), at(0.0, 3.0)];
    for _ in 0..n / 2 {
        let u = 3.0 * (1 + rng.below(15)) as f64 / 16.0;
        points.push([at(u, 0.0), at(3.0, u), at(u, 3.0), at(0.0, u)][rng.below(4)]);
    }
    points.extend((0..n / 2).map(|_| at(rng.range(0.1, 2.9), rng.range(0.1, 2.9))));
    points
}

/// The smallest angle inside a boundary of a triangulation, in degrees: no refinement takes it away.
fn smallest_boundary_angle(t: &ConstrainedDelaunay) -> f64 {
    let angle = |h: HalfEdgeId| {
        let next = t.next_on_boundary(h);
        let [[a, b], [_, c]] = [t.edge_points(h), t.edge_points(next)];
        let (u, v) = (a - b, c - b);
        trimalla::geometry::math::atan2(u.cross(v).abs(), u.dot(v)).to_degrees()
    };
    t.boundary_loops().into_iter().flat_map(|first| t.boundary_loop(first)).map(angle).fold(360.0, f64::min)
}

/// Set number `i`, if its hull has no angle near the bound or below it.
fn set(i: u64) -> Option<Vec<Point>> {
    let mut rng = SplitMix64::new(i);
    let size = 5 + rng.below(40);
    let kind = i as usize % (KINDS.len() + 2);
    let points = KINDS
        .get(kind)
        .map_or_else(|| turned_square(size, &mut SplitMix64::new(i)), |&kind| point_set(kind, size, rng.next_u64()));
    let mut t = hull_of(&points);
    (t.carve_hull(&mut NoJournal) && smallest_boundary_angle(&t) > 40.0).then_some(points)
}

fn hull_of(points: &[Point]) -> ConstrainedDelaunay {
    ConstrainedDelaunay::from_delaunay(Delaunay::with::<DivideAndConquer>(points).expect("finite points"))
}

#[test]
fn the_sample_program_ends_on_four_hundred_random_sets() {
    let sets: Vec<Vec<Point>> = (0..4 * SETS as u64).filter_map(set).take(SETS).collect();
    assert_eq!(sets.len(), SETS);
    for (i, points) in sets.into_iter().enumerate() {
        let mut t = hull_of(&points);
        assert_eq!(t.closure(), Closure::Hull);
        let centroid = [Centroid::Area, Centroid::Average][i % 2];
        let mut inserted = 0;
        while let Some(bad) = bad_triangle(&t, BOUND_DEG) {
            let path = t.lepp(bad, LeppRule::StopAtBoundary);
            assert!(t.lepp_insert(path.terminal_edge, Some(centroid)).is_some(), "set {i} is stuck: {points:?}");
            inserted += 1;
            assert!(inserted < MOST, "set {i} does not end: {points:?}");
        }
        assert_eq!(t.check(), [], "set {i}: {points:?}");
        assert_eq!(&t.points()[..points.len()], &points[..], "set {i}: input vertices stay");
    }
}

#[test]
fn one_rollback_takes_back_a_point_and_the_carving_of_the_hull() {
    for points in (0..60).filter_map(set) {
        let mut t = hull_of(&points);
        let before = t.clone();
        let Some(bad) = bad_triangle(&t, BOUND_DEG) else { continue };
        let mut log = UndoLog::new();
        let start = log.checkpoint();
        let path = t.lepp(bad, LeppRule::StopAtBoundary);
        t.lepp_insert_with(path.terminal_edge, None, &mut log).expect("room");
        assert_eq!(t.closure(), Closure::Domain);
        t.rollback(&mut log, start);
        assert!(t == before, "{points:?}");
        assert_eq!(t.check(), []);
    }
}

#[test]
fn a_terminal_edge_of_a_flat_triangle_gives_way_to_the_one_behind_it() {
    // Two vertices an ulp or so inside the side from (0, 0.1) to (0.3, 0): flat triangles at the hull.
    let at = |u: f64| Point::new(0.3 * u, 0.1 - 0.1 * u + 1e-17);
    let points = [at(0.0), at(0.25), at(0.5), at(0.75), at(1.0), Point::new(0.3, 0.3), Point::new(0.0, 0.3)];
    let start = hull_of(&points);
    let is_flat = |f| smallest_angle(&start, f) < 1e-9;
    let flat: Vec<_> = start.real_faces().filter(|&f| is_flat(f)).collect();
    assert!(!flat.is_empty(), "the side is not straight");
    for h in flat.into_iter().flat_map(|f| f.half_edges()) {
        let mut t = start.clone();
        assert!(t.lepp_insert(h, Some(Centroid::Area)).is_some(), "{h:?}");
        assert_eq!(t.check(), []);
        assert!(t.real_faces().all(|f| smallest_angle(&t, f) > 1e-3), "no flat triangle is left");
    }
}

fn smallest_angle(t: &ConstrainedDelaunay, f: trimalla::half_edge::FaceId) -> f64 {
    super::smallest_angle_deg(t.face_points(f))
}

#[test]
fn edges_that_are_none_are_refused() {
    let mut t = hull_of(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(Point::from));
    let ghosts: Vec<HalfEdgeId> = t.ghost_faces().flat_map(|f| f.half_edges()).collect();
    let infinite = ghosts.into_iter().filter(|&h| !(t.origin(h).is_finite() && t.dest(h).is_finite()));
    for h in infinite.chain([HalfEdgeId(1000), HalfEdgeId(u32::MAX)]).collect::<Vec<_>>() {
        assert_eq!(t.lepp_insert(h, None), None, "{h:?}");
        assert_eq!(t.closure(), Closure::Hull, "{h:?}");
    }
}

/// Counts how often it is asked, and cancels at that number.
struct CancelAt {
    asked: u64,
    most: u64,
}

impl Observer for CancelAt {
    fn progress(&mut self, _: Progress) -> bool {
        self.asked += 1;
        self.asked < self.most
    }
}

/// Points with no segments, with an open chain, and with an outline inside the hull.
fn uncarved() -> Vec<ConstrainedDelaunay> {
    let fifty = point_set(PointSetKind::Uniform, 50, 7);
    let square = turned_square(12, &mut SplitMix64::new(3));
    let crack = [[0, 2], [5, 6]];
    let outline = [[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0], [2.0, 2.0], [4.0, 2.0], [3.0, 4.0]].map(Point::from);
    let with = |points: &[Point], segments: &[[u32; 2]]| {
        ConstrainedDelaunay::new(points, segments, Crossings::Split).expect("segments")
    };
    let grid = point_set(PointSetKind::RotatedGrid, 30, 1);
    vec![
        hull_of(&fifty),
        hull_of(&square),
        hull_of(&grid),
        with(&fifty, &crack),
        with(&square, &crack),
        with(&outline, &[[4, 5], [5, 6], [6, 4]]),
    ]
}

#[test]
fn what_was_triangulated_is_refined_without_carving_by_every_preset() {
    for (i, start) in uncarved().into_iter().enumerate() {
        for preset in Preset::ALL {
            // Bisection keeps small angles: it is asked for small triangles.
            let is_bisection = preset == Preset::LeppBisection;
            let options = RefineOptions::of(preset).with_max_vertices(3000);
            let options = options.with_min_angle_deg(if is_bisection { 0.0 } else { 25.0 });
            let options = if is_bisection { options.with_max_area(0.2) } else { options };
            let mut refinement = Refinement::new(start.clone(), options).expect("triangles");
            let stop = refinement.run(&mut NoObserver);
            let (t, report) = refinement.finish();
            assert!(matches!(stop, StopReason::Finished | StopReason::NoLongerImproves), "set {i}, {preset}: {stop:?}");
            // Neither of the two keeps the circle test.
            let is_plain = is_bisection || preset == Preset::Sanhueza;
            let faults = if is_plain { t.check() } else { t.check_delaunay() };
            assert_eq!(faults, [], "set {i}, {preset}");
            assert!(report.complete(), "set {i}, {preset}: {:?}", report.leftovers);
        }
    }
}

#[test]
fn refinement_of_what_was_not_carved_can_be_cancelled() {
    for start in uncarved() {
        let mut refinement = Refinement::new(start, RefineOptions::default().with_max_area(1e-6)).expect("triangles");
        assert_eq!(refinement.run(&mut CancelAt { asked: 0, most: 3 }), StopReason::Cancelled);
        assert_eq!(refinement.finish().0.check_delaunay(), []);
    }
}

#[test]
fn a_triangulation_without_triangles_is_refused() {
    let line = [[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]].map(Point::from);
    for count in 0..=3 {
        let flat = ConstrainedDelaunay::from_delaunay(Delaunay::new(&line[..count]).expect("finite points"));
        let refused = Refinement::new(flat, RefineOptions::default()).map(|_| ());
        assert_eq!(refused, Err(OptionError::NoTriangles), "{count} points");
    }
}

/// Hostile points: the loop may find no room, but what it leaves is sound, and refinement ends.
#[test]
fn no_points_are_too_hostile() {
    for (i, kind) in PointSetKind::ALL.into_iter().enumerate() {
        for size in [3, 6, 17, 40] {
            let points = point_set(kind, size, i as u64);
            let start = hull_of(&points);
            let mut t = start.clone();
            for _ in 0..150 {
                let Some(bad) = bad_triangle(&t, BOUND_DEG) else { break };
                let path = t.lepp(bad, LeppRule::StopAtBoundary);
                if t.lepp_insert(path.terminal_edge, Some(Centroid::Area)).is_none() {
                    break;
                }
            }
            assert_eq!(t.check(), [], "{} {size}", kind.key());
            for preset in [Preset::OffCenter, Preset::LeppCentroid] {
                let options = RefineOptions::of(preset).with_max_vertices(400);
                let Ok(mut refinement) = Refinement::new(start.clone(), options) else {
                    assert!(start.dimension() < 2, "{} {size}", kind.key());
                    continue;
                };
                let stop = refinement.run(&mut CancelAt { asked: 0, most: 100_000 });
                assert_ne!(stop, StopReason::Cancelled, "{} {size} {preset}", kind.key());
                assert_eq!(refinement.finish().0.check_delaunay(), [], "{} {size} {preset}", kind.key());
            }
        }
    }
}
