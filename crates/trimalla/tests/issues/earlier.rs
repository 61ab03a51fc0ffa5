//! Faults found while the kernel and the refinement were written.

use trimalla::constrained::{ConstrainedDelaunay, Crossings, Filling};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainError, DomainRule, build};
use trimalla::drawing::{DrawingError, Pslg};
use trimalla::geometry::Point;
use trimalla::quality::against_input;
use trimalla::refine::{Reason, RefineOptions};
use trimalla::{DomainOptions, Error, MeshOptions, mesh, refine_mesh};
use trimalla_testkit::oracles::{brute_force_cdt, canonical};
use trimalla_testkit::readers::read_input;
use trimalla_testkit::shared_data_or_skip;

use crate::{issue, refined};

/// `constrained::apply::doubled_rims` looked for an edge that dangles by a vertex with one neighbour on both sides.
#[test]
fn an_edge_that_dangles_with_a_loop_at_its_end_is_joined() {
    for name in ["dangling-edge-with-loop", "dangling-edge-with-loop-huge"] {
        let drawing = issue(name);
        for filling in [Filling::Randomised, Filling::Recursive] {
            let mut cdt = ConstrainedDelaunay::new(&drawing.points, &[], Crossings::Refuse).expect("finite points");
            cdt.set_filling(filling);
            cdt.insert_segments(&drawing.segments, Crossings::Refuse).expect("nothing crosses");
            assert_eq!(cdt.check(), [], "{name}, {filling:?}");
            let ours: Vec<[u32; 3]> = cdt.canonical().iter().map(|t| t.map(|v| v.0)).collect();
            assert_eq!(canonical(&ours), brute_force_cdt(&drawing.points, &drawing.segments), "{name}, {filling:?}");
        }
    }
}

/// `constrained::insert_segment::split_crossing` computed crossings from split pieces, which are bent.
#[test]
fn crossings_do_not_creep() {
    let drawing = issue("crossings-creep");
    let cdt =
        ConstrainedDelaunay::new(&drawing.points, &drawing.segments, Crossings::Split).expect("crossings are split");
    assert_eq!(cdt.check(), []);
    assert!(cdt.steiner_vertices() < 12, "{} vertices for three crossings", cdt.steiner_vertices());
}

/// Boundary edges that no segment runs along had neither shells nor small input angles.
#[test]
fn hull_edges_have_small_input_angles_too() {
    let (mesh, report) = refined(
        &issue("hull-edge-at-small-angle"),
        DomainRule::Hull,
        RefineOptions::default().with_min_angle_deg(20.0).with_max_vertices(5000),
    );
    assert!(report.complete(), "{:?}", report.reasons());
    assert!(mesh.points.len() < 60, "{} vertices", mesh.points.len());
}

/// The same on a real outline, which has two hundred vertices with its hull given as segments.
#[test]
fn the_hull_of_a_guitar_is_meshed() {
    let (guitar, _) = read_input(&shared_data_or_skip!().join("cdt/guitar_no_box.txt"));
    let (mesh, report) =
        refined(&guitar, DomainRule::Hull, RefineOptions::default().with_min_angle_deg(20.0).with_max_vertices(20_000));
    assert!(mesh.points.len() < 1000, "{} vertices, {:?}", mesh.points.len(), report.reasons());
}

/// `constrained::split_subsegment` did not look at the edges from a rounded split point to the two apexes.
#[test]
fn edges_from_a_split_point_pass_the_circle_test() {
    let (_, report) = refined(
        &issue("spokes-of-a-split"),
        DomainRule::Hull,
        RefineOptions::default().with_min_angle_deg(33.0).with_max_vertices(111),
    );
    assert!(report.vertices <= 111);
}

/// `refine::split_segments::place_of_cut` divided by a length of zero.
#[test]
fn a_subsegment_too_short_to_measure_is_left() {
    let (mesh, report) = refined(
        &issue("subnormal-subsegment"),
        DomainRule::Hull,
        RefineOptions::default().with_min_angle_deg(40.0).with_max_vertices(500),
    );
    assert!(mesh.points.iter().all(|p| p.is_finite()));
    assert!(report.reasons().iter().all(|r| r.0 != Reason::StrategyCannotImprove), "{:?}", report.reasons());
}

/// The report counted vertices that were carved away, and the budget did not count crossings beside duplicates.
#[test]
fn vertices_of_the_report_are_those_of_the_mesh() {
    let drawing = issue("carved-crossings");
    let (mesh, report) = refined(&drawing, DomainRule::Seeds, RefineOptions::default().with_min_angle_deg(0.0));
    assert_eq!((report.vertices, report.steiner_points), (mesh.points.len(), mesh.points.len() - mesh.input_points));
    let mut doubled = drawing.clone();
    doubled.points.extend(vec![drawing.points[0]; 20]);
    let (mesh, _) =
        refined(&doubled, DomainRule::Hull, RefineOptions::default().with_max_area(1e-4).with_max_vertices(100));
    assert!(mesh.points.len() <= 100, "{} vertices", mesh.points.len());
}

/// Two sides of a crack too thin to keep its inside apart were split at one place.
#[test]
fn the_two_sides_of_a_carved_crack_stay_apart() {
    let (sketch, _) = read_input(&shared_data_or_skip!().join("poly2tri/sketchup.dat"));
    refined(&sketch, DomainRule::Nesting, RefineOptions::default().with_min_angle_deg(20.0).with_max_vertices(20_000));
}

/// `quality::against_input` followed a chain by rounded parameters, which are equal for vertices an ulp apart.
#[test]
fn vertices_an_ulp_apart_are_a_chain() {
    let (slopes, _) = read_input(&shared_data_or_skip!().join("crossing/vertical_ulp_slopes1.geojson"));
    let (cdt, _) = build(&slopes, DomainRule::Nesting, Crossings::Split, AlgorithmKey::default()).expect("a domain");
    assert_eq!(against_input(&cdt.to_indexed(&slopes), &slopes).faults, []);
    let tiny = Pslg {
        points: [[0.0, 0.0], [-5e-324, 0.0], [-1.854726177237903e-33, 0.0], [0.0, -9.106087148441447e-65]]
            .map(Point::from)
            .to_vec(),
        segments: vec![[2, 0]],
        ..Pslg::default()
    };
    let (cdt, _) = build(&tiny, DomainRule::Hull, Crossings::Refuse, AlgorithmKey::default()).expect("a domain");
    assert_eq!(against_input(&cdt.to_indexed(&tiny), &tiny).faults, []);
}

/// The number of attributes was multiplied without a bound.
#[test]
fn an_absurd_number_of_attributes_is_an_error() {
    let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(Point::from).to_vec();
    let pslg = Pslg { points, attributes_per_point: usize::MAX, point_attributes: vec![1.0], ..Pslg::default() };
    let options = MeshOptions {
        domain: DomainOptions { rule: DomainRule::Hull, ..DomainOptions::default() },
        ..MeshOptions::default()
    };
    assert!(matches!(mesh(&pslg, &options), Err(Error::Domain(DomainError::Drawing(DrawingError::Column { .. })))));
}

/// `constrained::split_subsegment::point_on_subsegment` trusted the far ends of a bent segment, and the parameter of a
/// vertex on a long segment overflowed.
#[test]
fn a_bent_segment_is_split_between_the_ends_of_its_pieces() {
    refined(&issue("bent-segment-huge"), DomainRule::Nesting, RefineOptions::default().with_max_vertices(500));
}

/// Nothing proved on the outside of a carved boundary that a rounded split crosses no other boundary.
#[test]
fn boundaries_with_something_within_rounding_outside_are_not_split() {
    let fine = RefineOptions::default().with_max_area(1e-4).with_max_vertices(20_000);
    refined(&issue("crack-within-rounding"), DomainRule::Nesting, fine);
}

/// Splits were computed from what a file does not keep, vertices deleted that left no room behind, and segments not
/// found again where they leave the domain or end at a point given twice outside it.
#[test]
fn a_mesh_from_a_file_is_refined_as_it_would_have_been() {
    let options = RefineOptions::default().with_min_angle_deg(22.0).with_max_vertices(5000);
    for (name, rule) in [
        ("split-from-a-file", DomainRule::Hull),
        ("no-room-without-vertices", DomainRule::Hull),
        ("no-room-without-vertices", DomainRule::Seeds),
        ("segment-out-of-the-domain", DomainRule::Seeds),
        ("duplicates-outside", DomainRule::Seeds),
    ] {
        let drawing = issue(name);
        let (mesh, _) = refined(&drawing, rule, options);
        let again = refine_mesh(&mesh, Some(&drawing), &options).expect("its own mesh");
        assert_eq!((&again.mesh.points, &again.mesh.segments), (&mesh.points, &mesh.segments), "{name}");
        assert_eq!(again.mesh.triangles, mesh.triangles, "{name}");
    }
}
