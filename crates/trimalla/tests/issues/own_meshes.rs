//! Meshes that the library makes of segments within rounding of each other, and takes up again with their drawing.
//!
//! Two kinds of faults are here: the comparison took edges in the strip of a segment that is outside for its chain, and
//! splitting brought a segment back on the other side of an input vertex.

use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build};
use trimalla::drawing::{IndexedMesh, Pslg, SegmentId};
use trimalla::geometry::{Orientation, Point, on_segment, orient2d};
use trimalla::quality::{InputFault, against_input};
use trimalla::refine::{Initial, Insert, Limits, NoObserver, PlacePoint, Recipe, Recover, RefineOptions, Refinement};
use trimalla::refine_mesh;
use trimalla::triangulation::check_mesh;
use trimalla_testkit::generators::SplitMix64;
use trimalla_testkit::oracles::first_flaw;

use super::issue;

/// Options with a budget.
fn options(recipe: Recipe, max_vertices: usize) -> RefineOptions {
    RefineOptions { recipe, limits: Limits { max_vertices, ..Limits::default() }, ..RefineOptions::default() }
}

/// What the comparison, an independent oracle and a refinement that asks for nothing say of the mesh of a drawing.
fn verdicts(drawing: &Pslg, (rule, crossings): (DomainRule, Crossings), options: RefineOptions) -> Vec<String> {
    let (cdt, _) = build(drawing, rule, crossings, AlgorithmKey::default()).expect("a domain");
    let mut refinement = Refinement::new(cdt, options).expect("good options");
    refinement.run(&mut NoObserver);
    let (cdt, report) = refinement.finish();
    assert_eq!(report.lost_segments, []);
    let mesh = cdt.to_indexed(drawing);
    let mut said: Vec<String> = check_mesh(&mesh).iter().map(|fault| format!("{fault:?}")).collect();
    said.extend(against_input(&mesh, drawing).faults.iter().map(ToString::to_string));
    said.extend(first_flaw(&mesh, Some(drawing), false).map(|flaw| flaw.to_string()));
    let nothing = RefineOptions::default().with_min_angle_deg(0.0).with_max_vertices(mesh.points.len());
    said.extend(refine_mesh(&mesh, Some(drawing), &nothing).err().map(|error| error.to_string()));
    said
}

#[test]
fn edges_beside_a_segment_that_is_outside_are_not_its_chain() {
    let (refuse, split) = (Crossings::Refuse, Crossings::Split);
    let cases = [
        ("segment-outside-beside-one-inside", DomainRule::Seeds, refuse),
        ("boundary-within-rounding-of-a-segment", DomainRule::Nesting, split),
        ("hole-between-two-segments-an-ulp-apart", DomainRule::Hull, refuse),
        ("bundle-carved-to-slivers", DomainRule::Seeds, split),
        ("end-an-ulp-from-another-end", DomainRule::Hull, refuse),
        ("segment-along-a-side-in-the-boundary", DomainRule::Seeds, split),
        ("hole-along-a-bundle", DomainRule::Hull, split),
        ("ring-within-rounding-of-a-line", DomainRule::Nesting, refuse),
        ("hole-as-thin-as-rounding", DomainRule::Hull, refuse),
    ];
    for (name, rule, crossings) in cases {
        let drawing = issue(name);
        let halving = Recipe { point: PlacePoint::LeppMidpoint, insert: Insert::Partition, ..Recipe::default() };
        for recipe in [Recipe::default(), halving] {
            for more in 0..45 {
                let options = options(recipe, drawing.points.len() + more);
                assert_eq!(verdicts(&drawing, (rule, crossings), options), [""; 0], "{name}, {more} more");
                let options = options.with_max_area(1e-5);
                assert_eq!(verdicts(&drawing, (rule, crossings), options), [""; 0], "{name}, small, {more} more");
            }
        }
    }
}

#[test]
fn splitting_brings_no_segment_back_through_a_vertex_beside_it() {
    let names = ["split-over-a-vertex-behind-the-rim", "split-over-an-end-on-a-segment", "led-through-an-end-beside"];
    for name in names {
        let drawing = issue(name);
        for (initial, recover) in
            [(Initial::Conforming, Recover::WholeEdge), (Initial::Constrained, Recover::BySplitting)]
        {
            for more in 0..70 {
                let recipe = Recipe { initial, recover, ..Recipe::default() };
                let options = options(recipe, drawing.points.len() + more);
                let said = verdicts(&drawing, (DomainRule::Hull, Crossings::Refuse), options);
                assert_eq!(said, [""; 0], "{name}, {initial:?}, {more} more");
            }
        }
    }
}

#[test]
fn a_segment_partly_outside_is_accepted_over_decades() {
    let drawing = issue("segment-partly-outside-over-decades");
    let (cdt, _) = build(&drawing, DomainRule::Nesting, Crossings::Split, AlgorithmKey::default()).expect("a domain");
    let mesh = cdt.to_indexed(&drawing);
    assert_eq!(against_input(&mesh, &drawing).faults, []);
    assert_eq!(first_flaw(&mesh, Some(&drawing), true), None);
}

#[test]
fn a_segment_whose_square_vanishes_is_covered() {
    let drawing = issue("segment-whose-square-vanishes");
    for more in 0..30 {
        let options = options(Recipe::default(), drawing.points.len() + more);
        assert_eq!(verdicts(&drawing, (DomainRule::Hull, Crossings::Split), options), [""; 0], "{more} more");
    }
}

/// Segments that do not cross, most of them from near one to near another of two points, and vertices beside them.
fn close_segments(seed: u64) -> Pslg {
    let mut rng = SplitMix64::new(seed);
    let mut points: Vec<Point> = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from).to_vec();
    let mut segments: Vec<[u32; 2]> = Vec::new();
    let [a, b] = [[rng.range(0.1, 0.3), rng.range(0.2, 0.8)], [rng.range(0.7, 0.9), rng.range(0.2, 0.8)]];
    for _ in 0..12 {
        let ends: [Point; 2] = [0.0, 1.0].map(|end| {
            let t = if rng.below(3) == 0 { rng.range(0.0, 1.0) } else { end };
            let off = 3.0 * f64::EPSILON;
            Point::new(
                a[0] + (b[0] - a[0]) * t + off * rng.range(-1.0, 1.0),
                a[1] + (b[1] - a[1]) * t + off * rng.range(-1.0, 1.0),
            )
        });
        let touches = |[c, d]: [u32; 2]| {
            let [c, d] = [c, d].map(|v| points[v as usize]);
            trimalla::geometry::segments_cross_properly(ends[0], ends[1], c, d)
        };
        if segments.iter().any(|&s| touches(s)) {
            continue;
        }
        let n = points.len() as u32;
        points.extend(ends);
        segments.push([n, n + 1]);
    }
    Pslg { points, segments, ..Pslg::default() }
}

#[test]
fn segments_brought_back_by_splitting_keep_their_sides() {
    let mut close = 0;
    for seed in 0..150 {
        let drawing = close_segments(seed);
        let Ok((cdt, _)) = build(&drawing, DomainRule::Hull, Crossings::Refuse, AlgorithmKey::default()) else {
            continue;
        };
        close += drawing.segments.len();
        for (initial, recover) in
            [(Initial::Conforming, Recover::WholeEdge), (Initial::Constrained, Recover::BySplitting)]
        {
            let recipe = Recipe { initial, recover, ..Recipe::default() };
            let mut refinement = Refinement::new(cdt.clone(), options(recipe, 80)).expect("good options");
            refinement.run(&mut NoObserver);
            let (cdt, report) = refinement.finish();
            let mesh = cdt.to_indexed(&drawing);
            let is_kept = |s: usize| !report.lost_segments.contains(&SegmentId::from_index(s));
            let segments = (0..drawing.segments.len()).filter(|&s| is_kept(s)).map(|s| drawing.segments[s]).collect();
            let kept = Pslg { segments, ..drawing.clone() };
            assert_eq!(against_input(&mesh, &kept).faults, [], "seed {seed}, {initial:?}");
        }
    }
    assert!(close > 500, "only {close} segments");
}

#[test]
fn a_vertex_farther_beside_than_edges_are_led_is_a_fault_where_segments_cross() {
    // Vertex 2 is above the segment 0–1; segments 5–6 and 7–8 cross, outside of the mesh.
    for (places, is_fault) in [(11.0, false), (14.0, true), (17.0, true)] {
        let above = 0.5 + places * f64::EPSILON / 2.0;
        let points = [[0.0, 0.5], [1.0, 0.5], [0.5, above], [0.5, 0.0], [0.5, 1.0]];
        let cross = [[3.0, 3.0], [4.0, 4.0], [3.0, 4.0], [4.0, 3.0]];
        let points: Vec<Point> = points.into_iter().chain(cross).map(Point::from).collect();
        let triangles = vec![[0, 3, 2], [3, 1, 2], [0, 2, 4], [2, 1, 4]];
        let mesh = IndexedMesh { points: points.clone(), triangles, ..IndexedMesh::default() };
        let drawing = Pslg { points, segments: vec![[0, 1], [5, 6], [7, 8]], ..Pslg::default() };
        let faults = against_input(&mesh, &drawing).faults;
        let is_found = matches!(faults[..], [InputFault::SegmentNotCovered { segment: 0, .. }]);
        assert!(if is_fault { is_found } else { faults.is_empty() }, "{places} places: {faults:?}");
    }
}

#[test]
fn every_vertex_put_on_the_wrong_side_of_a_segment_is_found() {
    // Vertex 4 beside the segment 0–1 by an ulp, on either side, in meshes that have it on the other.
    for up in [-1.0, 1.0] {
        let beside = Point::new(0.5, 0.5 + up * f64::EPSILON);
        let other = Point::new(0.5, 0.5 + up * 2.0 * f64::EPSILON);
        let ends = [[0.0, 0.5], [1.0, 0.5], [0.5, 0.0], [0.5, 1.0]].map(Point::from);
        let points: Vec<Point> = ends.into_iter().chain([beside, other]).collect();
        // The chain 0–5–1 passes vertex 4 on the wrong side.
        assert!(!on_segment(points[0], points[1], points[4]));
        assert_ne!(orient2d(points[0], points[1], points[4]), Orientation::Collinear);
        let triangles = if up > 0.0 {
            vec![[0, 5, 3], [5, 1, 3], [0, 4, 5], [4, 1, 5], [0, 2, 4], [2, 1, 4]]
        } else {
            vec![[0, 2, 5], [2, 1, 5], [0, 5, 4], [5, 1, 4], [0, 4, 3], [4, 1, 3]]
        };
        let mesh = IndexedMesh { points: points.clone(), triangles, ..IndexedMesh::default() };
        assert_eq!(check_mesh(&mesh), []);
        let drawing = Pslg { points: points[..5].to_vec(), segments: vec![[0, 1]], ..Pslg::default() };
        let faults = against_input(&mesh, &drawing).faults;
        assert!(!faults.is_empty(), "{up}");
    }
}
