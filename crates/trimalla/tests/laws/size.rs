//! What bounds sizes is kept by the mesh, whichever way it is said.

use trimalla::constrained::{ConstrainedTriangulation, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build, from_mesh};
use trimalla::drawing::Pslg;
use trimalla::geometry::{Point, Segment, Triangle};
use trimalla::refine::{NoObserver, RefineOptions, Refinement, Start, StopReason};
use trimalla::size::{AreaBound, ByFunction, Graded, SizeField, SizeSource, TriangleInRegion, Uniform};

fn square() -> Pslg {
    Pslg::of_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])
}

fn start(drawing: &Pslg) -> Start {
    let (cdt, _) = build(drawing, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()).expect("a domain");
    cdt.into()
}

/// Refines to the end, with nothing left.
fn refined(start: Start, options: RefineOptions) -> ConstrainedTriangulation {
    let mut refinement = Refinement::new(start, options).expect("good options");
    assert_eq!(refinement.run(&mut NoObserver), StopReason::Finished);
    let (cdt, report) = refinement.finish();
    assert_eq!((report.leftovers.len(), cdt.check_delaunay()), (0, vec![]));
    cdt
}

fn triangles(cdt: &ConstrainedTriangulation) -> Vec<Triangle> {
    cdt.real_faces().map(|f| TriangleInRegion::of(cdt, f).triangle).collect()
}

/// The longest edge of the triangles that have all corners within a box.
fn longest_edge_within(cdt: &ConstrainedTriangulation, low: Point, high: Point) -> f64 {
    let within = |p: &Point| low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y;
    let inside = triangles(cdt).into_iter().filter(|t| t.corners.iter().all(within));
    inside.map(|t| t.edge(t.longest_edge()).length()).fold(0.0, f64::max)
}

#[test]
fn a_graded_field_is_kept_and_no_finer_than_it_asks() {
    let drawing = square();
    let left = Segment::new(drawing.points[0], drawing.points[3]);
    let field = Graded::new(&[SizeSource::along(left, 0.1), SizeSource::at(drawing.points[2], 0.02)], 0.3).unwrap();
    let cdt = refined(start(&drawing).with_size(field.clone()), RefineOptions::default());
    for t in triangles(&cdt) {
        assert!(t.area() <= field.bound(&TriangleInRegion::in_none(t)).area() * (1.0 + 1e-12), "{t:?}");
    }
    let near_corner = longest_edge_within(&cdt, Point::new(3.9, 3.9), Point::new(4.0, 4.0));
    let near_segment = longest_edge_within(&cdt, Point::new(0.0, 1.0), Point::new(0.3, 3.0));
    let far = longest_edge_within(&cdt, Point::new(2.0, 0.0), Point::new(4.0, 2.0));
    assert!(near_corner < 0.1 && near_corner < near_segment && near_segment < 0.4, "{near_corner} {near_segment}");
    assert!(far > 0.4, "edges grow away from the sources: {far}");
    // The integral of one over the bound is what the field asks for; a mesh has a small multiple of it.
    let asked = (0..400).flat_map(|i| (0..400).map(move |k| [i, k].map(|n| 0.005 + 0.01 * f64::from(n))));
    let asked: f64 = asked.map(|p| 1e-4 / AreaBound::of_edge(field.length_at(p.into())).area()).sum();
    let made = cdt.face_count() as f64;
    assert!(asked < made && made < 4.0 * asked, "{made} triangles where {asked} would do");
}

#[test]
fn one_bound_may_be_said_in_several_ways() {
    let (drawing, options) = (square(), RefineOptions::default());
    let by_options = refined(start(&drawing), options.with_max_area(0.03));
    let uniform = refined(start(&drawing).with_size(Uniform(AreaBound::of_area(0.03))), options);
    assert_eq!(triangles(&by_options), triangles(&uniform));
    // The lattice is for bounds that are known for whole triangles; a function is asked one by one.
    let without_lattice = RefineOptions::of(trimalla::refine::Preset::OffCenter).with_max_area(0.03);
    let by_options = refined(start(&drawing), without_lattice);
    let mut unbounded = without_lattice;
    unbounded.criteria.max_area = None;
    let function = ByFunction(|_: &TriangleInRegion| AreaBound::of_area(0.03));
    assert!(triangles(&by_options).len() > 200);
    let by_function = refined(start(&drawing).with_size(function), unbounded);
    assert!(triangles(&by_function).into_iter().all(|t| t.area() <= 0.03));
}

#[test]
fn fields_stay_when_options_change() {
    let field = Graded::new(&[SizeSource::at(Point::new(0.0, 0.0), 0.05)], 0.25).unwrap();
    let mut refinement =
        Refinement::new(start(&square()).with_size(field.clone()), RefineOptions::default().with_min_angle_deg(20.0))
            .unwrap();
    refinement.change_options(RefineOptions::default().with_min_angle_deg(25.0)).unwrap();
    refinement.run(&mut NoObserver);
    let (cdt, report) = refinement.finish();
    assert!(report.complete() && cdt.face_count() > 100, "{}", cdt.face_count());
    let keeps = |t: Triangle| t.area() <= field.bound(&TriangleInRegion::in_none(t)).area() * (1.0 + 1e-12);
    assert!(triangles(&cdt).into_iter().all(keeps));
}

#[test]
fn areas_of_given_triangles_come_with_the_mesh() {
    let mesh = trimalla::triangulate(&square(), &trimalla::DomainOptions::default()).unwrap().mesh;
    let areas = vec![Some(0.01); mesh.triangles.len()];
    let taken = from_mesh(&mesh, &areas, None).unwrap();
    let cdt = refined(taken.clone().into(), RefineOptions::default());
    assert!(triangles(&cdt).into_iter().all(|t| t.area() <= 0.01));
    assert!(cdt.face_count() > 1600);
    let without = refined(taken.cdt.into(), RefineOptions::default());
    assert_eq!(without.face_count(), 2, "a triangulation alone knows no bound");
}

/// The outlook of a start counts its bounds on whole triangles.
#[test]
fn an_outlook_knows_the_fields() {
    let options = RefineOptions::default();
    let free = start(&square()).outlook(&options).forecast.triangles;
    let bounded = start(&square()).with_size(Uniform(AreaBound::of_area(0.001))).outlook(&options).forecast.triangles;
    let by_options = start(&square()).outlook(&options.with_max_area(0.001)).forecast.triangles;
    assert!(free < 100.0 && bounded > 10_000.0 && bounded == by_options, "{free} {bounded} {by_options}");
}
