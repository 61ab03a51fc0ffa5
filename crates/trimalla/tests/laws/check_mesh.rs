//! The checker of meshes from anywhere: silent on sound ones, right about broken ones, never a panic.

use crate::common::meshes::{delaunay_mesh, mesh, points};
use trimalla::drawing::IndexedMesh;
use trimalla::geometry::{Orientation, Point, SegmentContact};
use trimalla::triangulation::{MeshFault, check_mesh, check_mesh_delaunay};
use trimalla_testkit::generators::{PointSetKind, SplitMix64, point_set};
use trimalla_testkit::oracles::{DelaunayRule, check_indexed_with};

/// A square of two triangles.
fn square() -> IndexedMesh {
    let corners = points([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    mesh(corners, vec![[0, 1, 2], [0, 2, 3]])
}

/// Triangles of their own vertices.
fn apart<const N: usize>(triangles: [[[f64; 2]; 3]; N]) -> IndexedMesh {
    let corners = triangles.into_iter().flatten().map(Point::from).collect();
    mesh(corners, (0..N as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect())
}

/// The only fault of a mesh.
fn only_fault(mesh: &IndexedMesh) -> MeshFault {
    let mut faults = check_mesh(mesh);
    assert_eq!(faults.len(), 1, "{faults:?}");
    faults.remove(0)
}

#[test]
fn triangulations_of_every_kind_of_points_are_sound() {
    for kind in PointSetKind::ALL {
        for size in [0, 3, 40, 300] {
            let mesh = delaunay_mesh(&point_set(kind, size, 9));
            assert_eq!(check_mesh(&mesh), [], "{kind:?}, {size}");
            assert_eq!(check_mesh_delaunay(&mesh, &[]), [], "{kind:?}, {size}");
        }
    }
}

#[test]
fn wrong_indices_and_columns_are_named() {
    let mut wrong = square();
    wrong.triangles.push([0, 1, 9]);
    let said = "triangle 2 names vertex 9, but there are 4 vertices";
    assert_eq!(only_fault(&wrong).to_string(), said);
    let mut wrong = square();
    wrong.triangles.push([3, 1, 3]);
    assert_eq!(only_fault(&wrong).to_string(), "triangle 2 names vertex 3 at (0, 1) twice");
    let mut wrong = square();
    wrong.segments = vec![[0, 1], [1, 3], [2, 7]];
    let said: Vec<String> = check_mesh(&wrong).iter().map(ToString::to_string).collect();
    let expected = [
        "segment 1 from vertex 1 at (1, 0) to vertex 3 at (0, 1) is not an edge of the mesh",
        "segment 2 names vertex 7, but there are 4 vertices",
    ];
    assert_eq!(said, expected);
    let mut wrong = square();
    wrong.point_markers = vec![1];
    wrong.attributes_per_point = usize::MAX;
    wrong.point_attributes = vec![0.0];
    wrong.input_points = 5;
    assert_eq!(check_mesh(&wrong).len(), 3);
}

#[test]
fn wrong_triangles_are_named() {
    let mut wrong = square();
    wrong.triangles[1] = [0, 3, 2];
    assert!(
        check_mesh(&wrong).iter().any(|f| matches!(
            f,
            MeshFault::NotCounterClockwise { triangle: 1, orientation: Orientation::Clockwise, .. }
        ))
    );
    let flat = mesh(points([[0.0, 0.0], [0.1, 0.1], [0.3, 0.3]]), vec![[0, 1, 2]]);
    assert!(only_fault(&flat).to_string().ends_with("(0.3, 0.3) is flat"), "{}", only_fault(&flat));
    let mut wrong = square();
    wrong.triangles.push([1, 2, 0]);
    assert_eq!(check_mesh(&wrong).len(), 3, "each side of triangle 0 is used twice");
    let mut wrong = square();
    wrong.points[2].x = f64::NAN;
    assert_eq!(only_fault(&wrong).to_string(), "vertex 2 at (NaN, 1) is not finite");
}

#[test]
fn a_vertex_may_be_pinched_but_not_closed_and_more() {
    let far = [[0.0, 0.0], [2.0, -1.0], [2.0, 1.0], [-2.0, 1.0], [-2.0, -1.0]];
    let bow_tie = mesh(points(far), vec![[0, 1, 2], [0, 3, 4]]);
    assert_eq!(check_mesh(&bow_tie), []);
    let hexagon = [[0.0, 0.0], [2.0, 0.0], [-1.0, 2.0], [-1.0, -2.0], [5.0, 5.0], [4.0, 6.0]];
    let fan = vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [0, 4, 5]];
    let fault = only_fault(&mesh(points(hexagon), fan));
    assert!(matches!(fault, MeshFault::Star { triangles: [_, 3], .. }), "{fault}");
}

#[test]
fn overlaps_are_found_wherever_they_hide() {
    let big = [[0.0, 0.0], [9.0, 0.0], [0.0, 9.0]];
    let inside = [[1.0, 1.0], [2.0, 1.0], [1.0, 2.0]];
    let across = [[5.0, 5.0], [5.5, 6.0], [1.0, 1.0]];
    let hanging = [[3.0, 0.0], [4.0, -1.0], [4.0, -0.5]];
    let below = [[3.0, 0.0], [2.0, -1.0], [6.0, -1.0]];
    let beside = [[9.0, 0.5], [12.0, 0.5], [12.0, 3.0]];
    let on_side = [[2.0, 0.0], [3.0, -3.0], [4.0, 0.0]];
    let contact = |f: &MeshFault| match f {
        MeshFault::BoundaryContact { contact, .. } => Some(*contact),
        _ => None,
    };
    assert!(matches!(only_fault(&apart([big, inside])), MeshFault::Overlap { .. }));
    assert!(matches!(only_fault(&apart([inside, big])), MeshFault::Overlap { .. }));
    assert_eq!(contact(&only_fault(&apart([big, across]))), Some(SegmentContact::Crossing));
    for not_edge_to_edge in [hanging, below, on_side] {
        let fault = only_fault(&apart([not_edge_to_edge, big]));
        assert!(contact(&fault).is_some(), "{fault}");
    }
    let half_a_side = [[0.0, 0.0], [4.0, -1.0], [4.0, 0.0]];
    let mut sharing = apart([big, half_a_side]);
    sharing.triangles[1][0] = 0;
    assert_eq!(contact(&only_fault(&sharing)), Some(SegmentContact::Overlapping));
    assert_eq!(check_mesh(&apart([big, beside])), []);
    let on_top = apart([big, big]);
    assert_eq!(check_mesh(&on_top).len(), 3, "three pairs of equal vertices, both used");
}

#[test]
fn a_fan_that_winds_twice_overlaps() {
    // Eight triangles of 90 degrees around vertex 0, on two sheets, every edge used properly.
    let ring = |r: f64| [[r, 0.0], [0.0, r], [-r, 0.0], [0.0, -r]];
    let mut corners = vec![Point::default()];
    corners.extend(ring(1.0).into_iter().chain(ring(2.0)).map(Point::from));
    let closed: Vec<[u32; 3]> = (0..8).map(|k| [0, 1 + k, 1 + (k + 1) % 8]).collect();
    assert_ne!(check_mesh(&mesh(corners.clone(), closed.clone())), []);
    let open = closed[..7].to_vec();
    assert_ne!(check_mesh(&mesh(corners, open)), []);
}

#[test]
fn an_edge_that_is_not_delaunay_is_named_unless_constrained() {
    let kite = points([[0.0, 0.0], [4.0, -1.0], [8.0, 0.0], [4.0, 1.0]]);
    let mut long = mesh(kite, vec![[0, 1, 2], [0, 2, 3]]);
    assert_eq!(check_mesh(&long), []);
    let fault = &check_mesh_delaunay(&long, &[])[0];
    let said = "edge 0 at (0, 0) – 2 at (8, 0) between triangles 1 and 0 is not Delaunay: \
                vertex 1 at (4, -1) lies inside the circle of triangle 1";
    assert_eq!(fault.to_string(), said);
    assert_eq!(check_mesh_delaunay(&long, &[[2, 0]]), []);
    long.segments = vec![[0, 2]];
    assert_eq!(check_mesh_delaunay(&long, &[]), []);
    assert_eq!(check_mesh_delaunay(&square(), &[]), [], "four cocircular corners pass");
}

/// One random change to a mesh.
fn damaged(mesh: &IndexedMesh, random: &mut SplitMix64) -> IndexedMesh {
    let mut m = mesh.clone();
    let t = random.below(m.triangles.len());
    let (k, v) = (random.below(3), random.below(m.points.len()));
    let index = u32::try_from(v).expect("few points");
    match random.below(9) {
        0 => m.triangles[t][k] = index,
        1 => m.triangles[t].swap(0, 1),
        2 => drop(m.triangles.remove(t)),
        3 => m.triangles.push([index, m.triangles[t][k], m.triangles[t][(k + 1) % 3]]),
        4 => m.points[v] = m.points[random.below(mesh.points.len())],
        5 => m.points[v] = Point::midpoint(m.points[v], m.points[random.below(mesh.points.len())]),
        6 => m.triangles[t][k] = u32::MAX - index % 3,
        7 => m.points[v].y = [f64::NAN, f64::INFINITY, f64::MAX, -f64::MAX][random.below(4)],
        _ => m.segments.push([index, m.triangles[t][k]]),
    }
    m
}

/// The slow checker of the testkit compares all pairs of triangles and shares no line with ours.
#[test]
fn damaged_meshes_are_judged_as_by_the_slow_checker() {
    let kinds = [
        PointSetKind::Uniform,
        PointSetKind::IntegerGrid,
        PointSetKind::TenthGrid,
        PointSetKind::RoundedCircle,
        PointSetKind::ModerateExponents,
        PointSetKind::MixedExponents,
    ];
    let mut random = SplitMix64::new(11);
    let mut broken = 0;
    for round in 0..6000 {
        let mut mesh = delaunay_mesh(&point_set(kinds[round % kinds.len()], 4 + round % 23, random.next_u64()));
        for _ in 0..1 + random.below(2) {
            if !mesh.triangles.is_empty() {
                mesh = damaged(&mesh, &mut random);
            }
        }
        let ours = [check_mesh(&mesh), check_mesh_delaunay(&mesh, &[])].concat();
        let theirs = check_indexed_with(&mesh, None, DelaunayRule::Delaunay);
        // The slow checker lets triangles meet other than edge to edge, and vertices coincide.
        let strict = |f: &MeshFault| {
            matches!(f, MeshFault::DuplicateVertices(_))
                || matches!(f, MeshFault::BoundaryContact { contact, .. } if *contact != SegmentContact::Crossing)
        };
        if theirs.is_empty() {
            assert!(ours.iter().all(strict), "round {round}: {ours:?} of {mesh:?}");
        } else {
            assert!(!ours.is_empty(), "round {round}: {theirs:?} of {mesh:?}");
            broken += 1;
        }
    }
    assert!(broken > 3000, "only {broken} of 6000 were broken");
}
