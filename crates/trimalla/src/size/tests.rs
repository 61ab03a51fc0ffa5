//! Each field keeps the order that the trait promises, and says what it should.

use std::sync::Arc;

use super::{AreaBound, ByFunction, ByRegion, ByTriangle, Graded, SizeBounds, SizeError, SizeField, SizeSource};
use super::{TriangleInRegion, Uniform};
use crate::constrained::{ConstrainedTriangulation, Crossings};
use crate::delaunay::AlgorithmKey;
use crate::domain::{DomainRule, build, from_mesh};
use crate::drawing::{IndexedMesh, Pslg, Region};
use crate::geometry::{Point, Segment, Triangle};
use crate::half_edge::FaceId;

/// Two squares side by side, the left one with a bound of its own.
fn two_squares() -> ConstrainedTriangulation {
    let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from).to_vec();
    let segments = vec![[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0], [1, 4]];
    let left = Region { seed: Point::new(0.5, 0.4), attribute: 3.0, max_area: Some(0.1) };
    let right = Region { seed: Point::new(1.5, 0.4), attribute: 4.0, max_area: None };
    let pslg = Pslg { points, segments, regions: vec![left, right], ..Pslg::default() };
    let (cdt, _) = build(&pslg, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()).unwrap();
    cdt.into_parts().0
}

/// The promises of the trait, for every face of a triangulation.
fn assert_ordered(field: &dyn SizeField, cdt: &ConstrainedTriangulation) {
    for f in cdt.real_faces() {
        let at = TriangleInRegion::of(cdt, f);
        let bounds = [field.sure_bound(), field.bound(&at), field.in_region(at.region()), field.everywhere()];
        assert!(bounds.is_sorted(), "{bounds:?} at {at:?}");
        assert_eq!(field.bound(&at), field.bound(&at));
    }
}

fn unit_triangle() -> TriangleInRegion {
    let [a, b, c] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(Point::from);
    TriangleInRegion::in_none(Triangle::new(a, b, c))
}

#[test]
fn every_field_keeps_the_order_of_its_bounds() {
    let cdt = two_squares();
    let graded = Graded::new(&[SizeSource::at(Point::new(2.0, 1.0), 0.1)], 0.3).unwrap();
    let by_function = ByFunction(|at: &TriangleInRegion| AreaBound::of_area(at.triangle.centroid().x));
    assert_ordered(&Uniform(AreaBound::of_area(0.2)), &cdt);
    assert_ordered(&ByRegion::of(&cdt), &cdt);
    assert_ordered(&graded, &cdt);
    assert_ordered(&by_function, &cdt);
    let fields: Vec<Arc<dyn SizeField>> = vec![Arc::new(graded), Arc::new(by_function)];
    for max_area in [None, Some(0.15)] {
        assert_ordered(&SizeBounds::new(max_area, &cdt, Vec::new()), &cdt);
        assert_ordered(&SizeBounds::new(max_area, &cdt, fields.clone()), &cdt);
    }
}

#[test]
fn the_least_of_several_bounds_holds() {
    let cdt = two_squares();
    for (max_area, on_the_left, on_the_right) in [(None, 0.1, f64::INFINITY), (Some(0.2), 0.1, 0.2)] {
        let bounds = SizeBounds::new(max_area, &cdt, Vec::new());
        assert!(!bounds.are_uniform() && !bounds.are_none());
        for f in cdt.real_faces() {
            let at = TriangleInRegion::of(&cdt, f);
            let expected = if at.region_attribute == 3.0 { on_the_left } else { on_the_right };
            assert_eq!(bounds.bound(&at).area(), expected);
            // Between the two numbers that hold everywhere, the region decides.
            let refused = [0.09, 0.11, 0.19, 0.21].map(|area| bounds.refuse(2.0 * area, &cdt, f, cdt.corners(f)));
            assert_eq!(refused, [0.09, 0.11, 0.19, 0.21].map(|area| area > expected));
        }
    }
    assert!(SizeBounds::new(Some(0.05), &cdt, Vec::new()).are_uniform(), "no region has a stricter bound");
}

#[test]
fn a_given_triangle_bounds_what_lies_in_it() {
    let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(Point::from).to_vec();
    let mesh = IndexedMesh { points, triangles: vec![[0, 1, 2], [0, 2, 3]], ..IndexedMesh::default() };
    let taken = from_mesh(&mesh, &[Some(0.5), None], None).unwrap();
    let areas = taken.areas.expect("areas were given");
    assert_eq!(areas.max_areas, [Some(0.5), None]);
    assert!(taken.cdt.real_faces().all(|f| taken.cdt.region_rule(f).unwrap().max_area.is_none()));
    let field = ByTriangle::new(areas.triangles, &areas.max_areas);
    assert_ordered(&field, &taken.cdt);
    // Whatever given triangle the region names, the place decides; on the edge between two the stricter one.
    for named in taken.cdt.real_faces() {
        let bound_around = |x: f64, y: f64| {
            let corners = [[-0.5, -0.5], [0.5, -0.5], [0.0, 1.0]].map(|[dx, dy]| Point::new(x + dx, y + dy));
            field.bound(&TriangleInRegion::of_face(&taken.cdt, named, corners))
        };
        assert_eq!(bound_around(3.0, 1.0).area(), 0.5);
        assert!(bound_around(1.0, 3.0).is_none());
        assert_eq!(bound_around(2.0, 2.0).area(), 0.5);
    }
    assert!(field.bound(&unit_triangle()).is_none(), "a triangle in no region has no bound");
    let without = ByTriangle::new(crate::triangulation::Triangulation::default(), &[]);
    assert!(without.bound(&TriangleInRegion::of(&taken.cdt, FaceId(0))).is_none());
}

#[test]
fn a_tree_of_sources_answers_as_all_of_them() {
    let along = |i: u32| f64::from(i * i % 101) / 10.0;
    let source = |i: u32| {
        let place = Segment::new(Point::new(along(i), along(7 * i + 3)), Point::new(along(3 * i), along(5 * i + 1)));
        SizeSource { place, length: 0.01 + along(11 * i) }
    };
    let sources: Vec<SizeSource> = (1..90).map(source).collect();
    for growth in [0.0, 0.2, 3.0] {
        let field = Graded::new(&sources, growth).unwrap();
        for p in (0..200).map(|i| Point::new(along(13 * i) - 1.0, along(17 * i + 5) + 0.3)) {
            let of = |s: &SizeSource| s.length + growth * s.place.distance(p);
            let slow = sources.iter().map(of).fold(f64::INFINITY, f64::min);
            assert!((field.length_at(p) - slow).abs() <= 1e-14 * slow, "{p} {growth}");
        }
    }
}

#[test]
fn a_graded_field_refuses_what_is_no_length() {
    let at = |length| [SizeSource::at(Point::new(0.0, 0.0), length)];
    for length in [0.0, -1.0, f64::INFINITY] {
        let refused = Graded::new(&at(length), 0.3).map(|_| ());
        assert_eq!(refused, Err(SizeError::Length { source_index: 0, length }));
    }
    assert!(Graded::new(&at(f64::NAN), 0.3).is_err());
    assert_eq!(Graded::new(&at(1.0), -0.5).map(|_| ()), Err(SizeError::Growth(-0.5)));
    let far = [SizeSource::at(Point::new(f64::NAN, 0.0), 1.0)];
    assert_eq!(Graded::new(&far, 0.3).map(|_| ()), Err(SizeError::Place { source_index: 0 }));
    assert!(Graded::new(&[], 0.3).unwrap().bound(&unit_triangle()).is_none(), "without sources there is no bound");
}

#[test]
fn what_is_not_a_number_bounds_nothing() {
    assert!(AreaBound::of_area(f64::NAN).is_none() && AreaBound::of_edge(f64::NAN).is_none());
    assert!(!AreaBound::of_area(-1.0).admits(0.0), "and what is negative admits nothing");
    assert_eq!(AreaBound::of_area(0.3).area(), 0.3);
}
