//! Statistics against counts by hand and by the testkit, bounds at their limits, meshes against inputs.

use crate::common::meshes::{delaunay_mesh, mesh, points};
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::{Angle, Point, Triangle};
use trimalla::quality::{Bins, Histogram, InputFault, Spread, Statistics, against_input, aspect_ratio, below_bound};
use trimalla::triangulation::check_mesh;
use trimalla_testkit::generators::{PointSetKind, point_set};
use trimalla_testkit::oracles::euler;

/// The triangles of a grid of squares, some left out: `#` is there, a blank is not. The first row is the top.
fn grid(rows: &[&str]) -> IndexedMesh {
    let (height, width) = (rows.len() as u32, rows[0].len() as u32);
    let id = |x: u32, y: u32| y * (width + 1) + x;
    let cells =
        rows.iter().zip((0..height).rev()).flat_map(|(row, y)| row.bytes().zip(0..).map(move |(c, x)| (c, x, y)));
    let there = cells.filter(|&(c, ..)| c == b'#');
    let triangles = there.flat_map(|(_, x, y)| {
        let [a, b, c, d] = [id(x, y), id(x + 1, y), id(x + 1, y + 1), id(x, y + 1)];
        [[a, b, c], [a, c, d]]
    });
    let place = |v: u32| Point::new(f64::from(v % (width + 1)), f64::from(v / (width + 1)));
    mesh((0..(width + 1) * (height + 1)).map(place).collect(), triangles.collect())
}

#[test]
fn pieces_holes_and_loops_are_counted() {
    let cases: [(&[&str], [usize; 3]); 6] = [
        (&["##", "##"], [1, 0, 1]),
        (&["###", "# #", "###"], [1, 1, 2]),
        (&["# #"], [2, 0, 2]),
        // Two squares that touch in a corner: one piece, two loops.
        (&["# ", " #"], [1, 0, 2]),
        // A hole that touches the boundary from inside, in one vertex of the ring.
        (&["## ", "# #", "###"], [1, 1, 1]),
        (&["#####", "#   #", "# # #", "#   #", "#####"], [2, 1, 3]),
    ];
    for (rows, expected) in cases {
        let mesh = grid(rows);
        assert_eq!(check_mesh(&mesh), [], "{rows:?}");
        let s = Statistics::of(&mesh);
        assert_eq!([s.components, s.holes, s.boundary_loops], expected, "{rows:?}");
    }
}

#[test]
fn counts_agree_with_the_testkit() {
    for kind in PointSetKind::ALL {
        let mesh = delaunay_mesh(&point_set(kind, 200, 3));
        let (s, e) = (Statistics::of(&mesh), euler(&mesh.triangles));
        let ours = (s.used_vertices, s.edges, s.triangles, s.boundary_edges, s.components);
        assert_eq!(ours, (e.vertices, e.edges, e.faces, e.boundary_edges, e.components), "{kind:?}");
        assert_eq!(s.degrees.iter().sum::<usize>(), s.used_vertices, "{kind:?}");
        let ends: usize = s.degrees.iter().enumerate().map(|(d, n)| d * n).sum();
        assert_eq!(ends, 2 * s.edges, "{kind:?}");
        assert_eq!(s.smallest_angles.total(), s.triangles, "{kind:?}");
        assert_eq!(s.all_angles.total(), 3 * s.triangles, "{kind:?}");
    }
}

#[test]
fn measures_of_a_square_are_as_drawn() {
    let s = Statistics::of(&grid(&["#"]));
    let degrees = |a: Option<trimalla::quality::AngleAt>| a.map(|a| (a.angle.degrees(), a.triangle));
    assert_eq!((degrees(s.min_angle), degrees(s.max_angle)), (Some((45.0, 0)), Some((90.0, 0))));
    assert_eq!((s.total_area, s.area), (1.0, Some(Spread { min: 0.5, mean: 0.5, max: 0.5 })));
    let longest = s.edge_length.map(|e| (e.min, e.max));
    assert_eq!(longest, Some((1.0, 2.0_f64.sqrt())));
    assert_eq!(s.degrees, [0, 0, 2, 2]);
    assert_eq!((s.all_angles.counts[4], s.all_angles.counts[9]), (4, 2));
    assert_eq!(s.smallest_angles.counts[9], 2);
    let few = Statistics::with_bins(&grid(&["#"]), Bins { smallest: 0, all: 2 });
    assert_eq!((few.smallest_angles.counts, few.all_angles.counts), (vec![2], vec![4, 2]));
}

#[test]
fn aspect_ratios_do_not_depend_on_scale() {
    for s in [1e-300, 1.0, 1e300] {
        let right = Triangle::new(Point::default(), Point::new(3.0 * s, 0.0), Point::new(0.0, 4.0 * s));
        assert!((aspect_ratio(&right) - 1.25).abs() < 1e-12, "{}", aspect_ratio(&right));
    }
    let equilateral = Triangle::new(Point::default(), Point::new(1.0, 0.0), Point::new(0.5, 0.75_f64.sqrt()));
    assert!((aspect_ratio(&equilateral) - 1.0).abs() < 1e-12);
    let point = Triangle::default();
    assert_eq!(aspect_ratio(&point), f64::INFINITY);
}

#[test]
fn spreads_and_histograms_hold_every_value() {
    assert_eq!(Spread::of([]), None);
    let huge = Spread::of([f64::MAX, f64::MAX, f64::MAX]).map(|s| s.mean);
    assert!(huge.is_some_and(|mean| mean.is_finite() && mean > 1e308));
    let mut h = Histogram::new(6, 60.0);
    [0.0, 9.999, 10.0, 60.0, 61.0, -1.0, f64::NAN].into_iter().for_each(|v| h.add(v));
    assert_eq!(h.counts, [4, 1, 0, 0, 0, 2]);
    assert_eq!(h.range_deg(5), [50.0, 60.0]);
}

#[test]
fn broken_meshes_are_measured_as_far_as_they_go() {
    assert_eq!(Statistics::of(&IndexedMesh::default()).holes, 0);
    let mut broken = grid(&["##"]);
    broken.triangles.extend([[0, 0, 1], [0, 1, u32::MAX], [5, 4, 3], [0, 1, 4], [0, 1, 4]]);
    broken.points[5].x = f64::NAN;
    let s = Statistics::of(&broken);
    assert_eq!((s.triangles, s.unmeasured), (9, 5));
    assert!(s.to_string().contains("not measurable"), "{s}");
    assert!(s.total_area.is_finite());
}

#[test]
fn the_table_has_every_number_and_fits_a_terminal() {
    let s = Statistics::of(&delaunay_mesh(&point_set(PointSetKind::Uniform, 500, 1)));
    let text = s.to_string();
    for word in ["vertices", "holes", "smallest angle", "aspect ratio", "all angles", "edges at a vertex", "####"] {
        assert!(text.contains(word), "{word} in\n{text}");
    }
    assert!(text.lines().all(|l| l.chars().count() <= 80), "{text}");
    assert_eq!(Statistics::of(&IndexedMesh::default()).to_string().matches(" -").count(), 11);
}

#[test]
fn bounds_that_are_met_exactly_are_met() {
    let square = grid(&["#"]);
    let below = |degrees: f64| below_bound(&square, Angle::from_degrees(degrees));
    for met in [-1.0, 0.0, 30.0, 45.0] {
        assert!(below(met).is_empty(), "{met}");
    }
    for missed in [45.0 + 1e-12, 60.0, 61.0, 100.0, 180.0, f64::INFINITY, f64::NAN] {
        assert_eq!(below(missed), [0, 1], "{missed}");
    }
    let mut broken = square.clone();
    broken.triangles.extend([[0, 1, 9], [1, 1, 2]]);
    broken.points.push(Point::new(f64::NAN, 0.0));
    broken.triangles.push([0, 1, 4]);
    assert_eq!(below_bound(&broken, Angle::from_degrees(10.0)), [2, 3, 4]);
}

/// The drawing of a mesh: its points and some segments.
fn drawing(points: &[Point], segments: &[[u32; 2]]) -> Pslg {
    Pslg { points: points.to_vec(), segments: segments.to_vec(), ..Pslg::default() }
}

#[test]
fn input_vertices_must_be_there_bit_for_bit() {
    let mut m = grid(&["#"]);
    let input = drawing(&m.points, &[[0, 1], [0, 3], [0, 9]]);
    let said: Vec<String> = against_input(&m, &input).faults.iter().map(ToString::to_string).collect();
    assert_eq!(said, ["input segment 2 names vertex 9, but there are 4 vertices"]);
    m.points[0].x = -0.0;
    let said = against_input(&m, &input).faults[0].to_string();
    assert_eq!(said, "input vertex 0 at (0, 0) has become (-0, 0)");
    m.points.truncate(2);
    let fault = &against_input(&m, &input).faults[0];
    assert_eq!(*fault, InputFault::FewerVertices { found: 2, expected: 4 });
}

#[test]
fn segments_must_be_chains_of_edges() {
    // Vertices 0 to 5 in two rows; the diagonals of the cells run from lower left to upper right.
    let m = grid(&["##"]);
    let compare = |segments: &[[u32; 2]]| against_input(&m, &drawing(&m.points, segments));
    let fine = compare(&[[0, 2], [5, 3], [0, 4], [1, 1], [2, 0]]);
    assert_eq!(fine.faults, []);
    assert_eq!(fine.covered, [[0, 1], [0, 4], [1, 2], [3, 4], [4, 5]]);
    let missing = compare(&[[1, 3], [0, 5]]);
    let said: Vec<String> = missing.faults.iter().map(ToString::to_string).collect();
    let expected = [
        "input segment 0 from vertex 1 at (1, 0) to vertex 3 at (0, 1) is not covered by edges of the mesh: \
         it enters a triangle at vertex 1 at (1, 0)",
        "input segment 1 from vertex 0 at (0, 0) to vertex 5 at (2, 1) is not covered by edges of the mesh: \
         it enters a triangle at vertex 0 at (0, 0)",
    ];
    assert_eq!(said, expected);
}

#[test]
fn a_split_vertex_may_be_off_by_rounding_only() {
    let at = |y: f64| {
        let corners = points([[0.0, 0.0], [3.0, 1.0], [0.0, 9.0], [9.0, 0.0]]);
        let corners = [corners, vec![Point::new(1.5, y)]].concat();
        let m = mesh(corners.clone(), vec![[0, 4, 2], [4, 1, 2], [0, 3, 4], [4, 3, 1]]);
        against_input(&m, &drawing(&corners[..4], &[[0, 1]])).faults.len()
    };
    assert_eq!((at(0.5), at(0.5 + 1e-15), at(0.5 + 1e-13), at(0.5 + 1e-7)), (0, 0, 1, 1));
}

#[test]
fn a_segment_outside_the_mesh_may_be_absent() {
    // A hole in the middle: the segment across it runs outside, the one from the boundary runs in and out.
    let m = grid(&["###", "# #", "###"]);
    let across_hole = drawing(&m.points, &[[5, 10], [6, 9]]);
    assert_eq!(against_input(&m, &across_hole).faults, []);
    let through = drawing(&m.points, &[[1, 9]]);
    assert_eq!(against_input(&m, &through).faults.len(), 0, "1–5–9 is a chain along the grid");
    let through = drawing(&m.points, &[[1, 10]]);
    assert_eq!(against_input(&m, &through).faults.len(), 1, "vertex 1 looks into a triangle");
    // Duplicates are represented by the one that is used.
    let mut twice = grid(&["#"]);
    twice.points.insert(0, twice.points[0]);
    twice.triangles.iter_mut().flatten().for_each(|v| *v += 1);
    let input = drawing(&twice.points, &[[0, 2], [0, 1], [0, 4]]);
    assert_eq!(against_input(&twice, &input).faults, []);
    assert_eq!(against_input(&twice, &input).covered, [[1, 2], [1, 4]]);
    assert_eq!(against_input(&twice, &drawing(&twice.points, &[[2, 4], [0, 3]])).faults, []);
}

#[test]
fn segments_of_any_size_are_followed() {
    for s in [5e-324, 1e-300, 1.0, 1e300, 4e307] {
        let corners = points([[0.0, 0.0], [s, 0.0], [2.0 * s, 0.0], [s, s], [s, -s]]);
        let m = mesh(corners.clone(), vec![[0, 1, 3], [1, 2, 3], [0, 4, 1], [1, 4, 2]]);
        assert_eq!(check_mesh(&m), [], "{s}");
        let found = against_input(&m, &drawing(&corners, &[[0, 2], [4, 3], [3, 2]]));
        assert_eq!(found.faults, [], "{s}");
        assert_eq!(found.covered.len(), 5, "{s}");
        assert!(Statistics::of(&m).min_angle.is_some(), "{s}");
    }
}
