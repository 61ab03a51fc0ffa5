//! Meshes that were not valid, runs that did not end, numbers that were none.

use std::path::Path;
use std::sync::Arc;

use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::{AlgorithmKey, Delaunay};
use trimalla::domain::{DomainRule, build};
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::{Orientation, Point, orient2d};
use trimalla::half_edge::{FaceId, HalfEdgeId, UndoLog, VertexId};
use trimalla::locate::Locus;
use trimalla::refine::steps::{Places, PointStep, Proposal, Steps, View};
use trimalla::refine::{
    Initial, Insert, NoObserver, Preset, Progress, Recover, RefineOptions, Refinement, Report, Select, Start,
    StopReason,
};
use trimalla::triangulation::check_mesh;
use trimalla::{mesh, refine_mesh};
use trimalla_testkit::readers::read_poly;

use super::{issue, refined};

fn square() -> Pslg {
    let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [1.0, 1.0]].map(Point::from).to_vec();
    Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]], ..Pslg::default() }
}

fn begun(drawing: &Pslg, options: RefineOptions) -> Refinement {
    let (cdt, _) = build(drawing, DomainRule::Hull, Crossings::Split, AlgorithmKey::default()).expect("a domain");
    Refinement::new(cdt, options).expect("good options")
}

/// Refines the domain of a drawing, crossings split, by any recipe; the mesh is valid, and Delaunay where the recipe
/// keeps that.
fn refined_by_any(drawing: &Pslg, rule: DomainRule, options: RefineOptions) -> (IndexedMesh, Report) {
    let (cdt, _) = build(drawing, rule, Crossings::Split, AlgorithmKey::default()).expect("a domain");
    let mut refinement = Refinement::new(cdt, options).expect("good options");
    refinement.run(&mut NoObserver);
    let (cdt, report) = refinement.finish();
    let keeps_delaunay = matches!(options.recipe.insert, Insert::Flip | Insert::Cavity);
    assert_eq!(if keeps_delaunay { cdt.check_delaunay() } else { cdt.check() }, []);
    let mesh = cdt.to_indexed(drawing);
    assert_eq!(check_mesh(&mesh), []);
    (mesh, report)
}

/// Only vertices within 64 last places of a boundary edge were looked for, not edges that leave a vertex at a tiny
/// angle.
#[test]
fn boundaries_that_leave_a_corner_at_a_tiny_angle_do_not_cross() {
    let drawing = issue("boundary-crosses-near-a-corner");
    for preset in Preset::ALL {
        for angle in [20.0, 30.0] {
            let options = RefineOptions::of(preset).with_min_angle_deg(angle).with_max_vertices(300);
            refined_by_any(&drawing, DomainRule::Nesting, options);
        }
    }
}

/// Splits of long edges were thought to be far from the ends, where no angle outside is thinner than rounding.
#[test]
fn a_split_near_the_end_of_a_long_edge_does_not_cross_beside_a_thin_angle() {
    let drawing = issue("split-near-the-end-beside-a-thin-angle");
    for preset in Preset::ALL {
        for most in [27, 60, 300] {
            let options = RefineOptions::of(preset).with_max_vertices(most);
            let (mesh, _) = refined_by_any(&drawing, DomainRule::Nesting, options);
            let again = refine_mesh(&mesh, None, &options.with_max_vertices(most + 60)).expect("a mesh of our own");
            assert_eq!(check_mesh(&again.mesh), []);
        }
    }
}

/// The same boundary read from a mesh, without its outside.
#[test]
fn boundaries_of_a_mesh_read_again_do_not_cross() {
    let drawing = issue("boundary-crosses-near-a-corner");
    let mesh = IndexedMesh {
        points: drawing.points,
        triangles: vec![[0, 2, 1], [2, 3, 4], [6, 0, 5]],
        ..IndexedMesh::default()
    };
    let is_left = |t: [u32; 3]| {
        let [a, b, c] = t.map(|v| mesh.points[v as usize]);
        orient2d(a, b, c) == Orientation::CounterClockwise
    };
    let triangles = mesh.triangles.iter().map(|&t| if is_left(t) { t } else { [t[0], t[2], t[1]] }).collect();
    let mesh = IndexedMesh { triangles, ..mesh.clone() };
    assert_eq!(check_mesh(&mesh), []);
    for preset in Preset::ALL {
        let finer = refine_mesh(&mesh, None, &RefineOptions::of(preset).with_max_vertices(150)).expect("a sound mesh");
        assert_eq!(check_mesh(&finer.mesh), [], "{preset}");
    }
}

#[test]
fn boundaries_in_a_thin_angle_do_not_touch() {
    let options = RefineOptions::of(Preset::LeppMidpoint).with_min_angle_deg(28.0).with_max_vertices(1500);
    refined(&issue("boundaries-touch-in-a-thin-angle"), DomainRule::Nesting, options);
}

/// `refine::lepp::quadrilateral_centroid` divided zero by zero.
#[test]
fn the_centroid_of_triangles_without_area_is_a_point() {
    for name in ["centroid-of-no-area", "centroid-of-no-area-by-cavity"] {
        for insert in [Insert::Flip, Insert::Cavity] {
            let mut options = RefineOptions::of(Preset::LeppCentroid).with_max_vertices(300);
            options.recipe.insert = insert;
            let (mesh, _) = refined(&issue(name), DomainRule::Hull, options);
            assert!(mesh.points.iter().all(|p| p.is_finite()), "{name}, {insert}");
        }
    }
}

/// Proposes what it is told to, whatever the triangle.
struct Proposes(fn(View<'_>, FaceId) -> Proposal);

impl PointStep for Proposes {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places) {
        places.push((self.0)(view, face));
    }
}

/// Places from outside the library were believed.
#[test]
fn a_place_that_is_not_what_it_says_is_refused() {
    let lies: [fn(View<'_>, FaceId) -> Proposal; 9] = [
        |_, f| Proposal::Free { point: Point::new(f64::NAN, 1.0), locus: Locus::Face(f) },
        |_, f| Proposal::Free { point: Point::new(f64::INFINITY, 1.0), locus: Locus::Face(f) },
        |_, f| Proposal::Free { point: Point::new(-9.0, -9.0), locus: Locus::Face(f) },
        |_, _| Proposal::Free { point: Point::new(2.0, 2.5), locus: Locus::Face(FaceId(4_000_000)) },
        |_, f| Proposal::Free { point: Point::new(2.0, 2.5), locus: Locus::Edge(f.half_edge(0)) },
        |_, _| Proposal::Free { point: Point::new(2.0, 2.5), locus: Locus::Vertex(VertexId(0)) },
        |view, f| Proposal::OnEdge { edge: f.half_edge(0), point: view.cdt.point(VertexId(0)) },
        |_, f| Proposal::OnEdge { edge: f.half_edge(1), point: Point::new(f64::NAN, f64::NAN) },
        |_, _| Proposal::Split(HalfEdgeId(u32::MAX)),
    ];
    for (number, lie) in lies.into_iter().enumerate() {
        for insert in Insert::ALL {
            let mut options = RefineOptions::default().with_max_vertices(200);
            options.recipe.insert = insert;
            let steps = Steps { point: Arc::new(Proposes(lie)), ..Steps::of(&options) };
            let (cdt, _) =
                build(&square(), DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()).expect("a domain");
            let mut refinement = Refinement::new(Start::from(cdt).with_steps(steps), options).expect("good options");
            assert_eq!(refinement.run(&mut NoObserver), StopReason::Finished, "lie {number}, {insert}");
            let (cdt, report) = refinement.finish();
            assert_eq!(check_mesh(&cdt.to_indexed(&square())), [], "lie {number}, {insert}");
            assert!(!report.complete(), "lie {number}, {insert}: nothing was refined");
        }
    }
}

/// Vertices of crossings that rounding made were not counted.
#[test]
fn the_budget_holds_for_segments_brought_back_by_splitting() {
    let drawing = issue("budget-of-a-recovery");
    for (initial, recover) in [
        (Initial::Conforming, Recover::WholeEdge),
        (Initial::Conforming, Recover::BySplitting),
        (Initial::Constrained, Recover::BySplitting),
    ] {
        for preset in Preset::ALL {
            for budget in 5..60 {
                let mut options = RefineOptions::of(preset).with_min_angle_deg(33.0).with_max_vertices(budget);
                (options.recipe.initial, options.recipe.recover) = (initial, recover);
                let (mesh, report) = refined_by_any(&drawing, DomainRule::Hull, options);
                assert!(
                    mesh.points.len() <= budget,
                    "{preset}, {initial}, {recover}: {} for {budget}",
                    mesh.points.len()
                );
                assert_eq!(report.vertices, mesh.points.len());
            }
        }
    }
}

/// The observer was asked only after insertions, and not at all while segments were split before the first step.
#[test]
fn a_run_that_inserts_nothing_can_be_cancelled() {
    // Every triangle is bad, and none can be helped: all segments are protected, no point is proposed.
    struct Nowhere;
    impl PointStep for Nowhere {
        fn propose(&self, _: View<'_>, _: FaceId, _: &mut Places) {}
    }
    let points: Vec<Point> =
        (0..40_u8).flat_map(|i| (0..40_u8).map(move |j| Point::new(f64::from(i), f64::from(j)))).collect();
    let grid = Pslg { points, ..Pslg::default() };
    let (cdt, _) = build(&grid, DomainRule::Hull, Crossings::Split, AlgorithmKey::default()).expect("a domain");
    let options = RefineOptions::default().with_min_angle_deg(50.0);
    let steps = Steps { point: Arc::new(Nowhere), ..Steps::of(&options) };
    let mut refinement = Refinement::new(Start::from(cdt).with_steps(steps), options).expect("good options");
    let mut calls = 0;
    let stop = refinement.run(&mut |_: Progress| {
        calls += 1;
        calls < 5
    });
    assert_eq!((stop, calls), (StopReason::Cancelled, 5));
}

#[test]
fn whatever_comes_before_the_loop_can_be_cancelled() {
    // Many long segments, close to rows of vertices: none is an edge of the Delaunay triangulation.
    let mut points: Vec<Point> = Vec::new();
    let mut segments: Vec<[u32; 2]> = Vec::new();
    for row in 0..40_u8 {
        let y = f64::from(row);
        let first = u32::from(row) * 42;
        points.extend([Point::new(0.0, y), Point::new(100.0, y + 0.01)]);
        points.extend((0..40_u8).map(|i| Point::new(1.5 + 2.4 * f64::from(i), y + 0.05)));
        segments.push([first, first + 1]);
    }
    let drawing = Pslg { points, segments, ..Pslg::default() };
    let mut options = RefineOptions::default().with_max_vertices(1_000_000);
    options.recipe.initial = Initial::Conforming;
    let mut refinement = begun(&drawing, options);
    let stop = refinement.run(&mut |p: Progress| p.vertices < 1800);
    assert_eq!(stop, StopReason::Cancelled);
    let mut whole = refinement.clone();
    assert_ne!(whole.run(&mut NoObserver), StopReason::Cancelled, "it can go on");
    assert!(whole.finish().1.vertices > 3000);
    let (cdt, report) = refinement.finish();
    assert!(report.vertices < 3000, "{} vertices", report.vertices);
    assert_eq!(report.lost_segments, [], "what is left goes in whole");
    assert_eq!(check_mesh(&cdt.to_indexed(&drawing)), []);
}

#[test]
fn manual_selection_can_be_cancelled_and_ends() {
    let mut options = RefineOptions::default();
    options.recipe.select = Select::Manual;
    let mut refinement = begun(&square(), options);
    assert_eq!(refinement.run(&mut |_: Progress| false), StopReason::Cancelled);
    assert_eq!(refinement.run(&mut NoObserver), StopReason::Finished);
}

/// Duplicates went on naming a vertex that was removed, or the next one in its slot.
#[test]
fn duplicates_of_a_vertex_that_goes_are_forgotten() {
    let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [2.0, 3.0], [2.0, 3.0], [2.0, 3.0]].map(Point::from);
    for moves in [false, true] {
        let mut delaunay = Delaunay::new(&points).expect("finite");
        let before = delaunay.clone();
        let mut log = UndoLog::new();
        let here = log.checkpoint();
        assert_eq!(delaunay.representative(VertexId(5)), VertexId(3));
        if moves {
            delaunay.move_vertex_with(VertexId(3), Point::new(5.0, 5.0), &mut log).expect("a vertex");
        } else {
            delaunay.remove_with(VertexId(3), &mut log).expect("a vertex");
        }
        assert_eq!(delaunay.representative(VertexId(5)), VertexId(5));
        assert_eq!(delaunay.check(), []);
        delaunay.rollback(&mut log, here);
        assert_eq!(delaunay, before);
    }
    let mut cdt = ConstrainedDelaunay::new(&points, &[], Crossings::Refuse).expect("finite");
    cdt.remove(VertexId(3)).expect("a vertex");
    assert_eq!((cdt.duplicates(), cdt.check()), (&[][..], vec![]));
}

/// A product of counts overflowed.
#[test]
fn an_absurd_number_of_triangle_attributes_is_no_panic() {
    let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from).to_vec();
    let mut mesh = IndexedMesh { points, triangles: vec![[0, 1, 3], [1, 2, 3]], ..IndexedMesh::default() };
    mesh.attributes_per_triangle = usize::MAX;
    assert!(refine_mesh(&mesh, None, &RefineOptions::default()).is_ok());
    mesh.triangle_attributes = vec![1.0; 2];
    assert!(refine_mesh(&mesh, None, &RefineOptions::default()).is_err());
}

/// Coordinates of 1e308 were written out digit by digit.
#[test]
fn messages_stay_short_for_huge_coordinates() {
    let points = [[-1e308, 0.0], [1e308, 1e308], [-1e308, 1e308], [1e308, 1e-300]].map(Point::from).to_vec();
    let drawing = Pslg { points, segments: vec![[0, 1], [2, 3], [0, 3], [2, 1]], ..Pslg::default() };
    let error = mesh(&drawing, &trimalla::MeshOptions::default()).expect_err("segments cross");
    assert!(error.to_string().len() < 200, "{error}");
}

/// Edges of a hull that no segment runs along were queued for a split and dropped again, for ever.
#[test]
fn a_triangulation_that_was_not_carved_is_refined_to_an_end() {
    let points: Vec<Point> = (0..50_u32)
        .map(|i| {
            let hash = |k: u32| f64::from(i.wrapping_mul(k).wrapping_add(k) % 1009);
            Point::new(hash(2_654_435_761), hash(40_503))
        })
        .collect();
    for preset in Preset::ALL {
        let cdt = ConstrainedDelaunay::from_delaunay(Delaunay::new(&points).expect("finite"));
        let mut refinement =
            Refinement::new(cdt, RefineOptions::of(preset).with_max_vertices(500)).expect("good options");
        let mut calls = 0;
        let stop = refinement.run(&mut |_: Progress| {
            calls += 1;
            calls < 10_000
        });
        assert_ne!(stop, StopReason::Cancelled, "{preset}: no end");
        assert_eq!(refinement.triangulation().check(), [], "{preset}");
    }
}

/// Above about 33 degrees the default filled the mesh with bad triangles, up to the budget of five million vertices.
#[test]
fn a_refinement_that_no_longer_improves_stops() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/shapes/guitar.poly");
    let guitar = read_poly(&file);
    let (cdt, _) = build(&guitar, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()).expect("a domain");
    for (preset, angle, stop) in [
        (Preset::OffCenter, 36.0, StopReason::NoLongerImproves),
        (Preset::Circumcenter, 45.0, StopReason::NoLongerImproves),
        (Preset::LeppCentroid, 36.0, StopReason::Finished),
        (Preset::OffCenter, 33.0, StopReason::Finished),
    ] {
        let options = RefineOptions::of(preset).with_min_angle_deg(angle).with_max_vertices(200_000);
        let mut refinement = Refinement::new(cdt.clone(), options).expect("good options");
        assert_eq!(refinement.run(&mut NoObserver), stop, "{preset}, {angle}");
        let (_, report) = refinement.finish();
        assert!(report.vertices < 100_000, "{preset}, {angle}: {} vertices", report.vertices);
        assert_eq!(report.complete(), stop == StopReason::Finished, "{preset}, {angle}");
    }
}

/// A row of the lattice that runs along a flat triangle has many more nodes than the area of the triangle tells: the
/// plan took gigabytes.
#[test]
fn a_lattice_plan_keeps_to_the_budget() {
    let options = RefineOptions::default().with_min_angle_deg(0.0).with_max_area(1e-16).with_max_vertices(1000);
    let (mesh, _) = refined(&issue("lattice-along-a-sliver"), DomainRule::Seeds, options);
    assert!(mesh.points.len() <= 1000);
}
