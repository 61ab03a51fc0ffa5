//! A mesh laid out as Triangle's files and arrays have it.

use trimalla::triangulation::{MeshFault, check_mesh, check_mesh_delaunay};
use trimalla::{IndexedMesh, Point};

use crate::edges::{self, Edges};
use crate::error::TriangleError;
use crate::jettison::jettisoned;
use crate::made::Made;
use crate::switches::Switches;
use crate::triangulate::{Bare, Given};

/// The mesh with all that the switches ask for beside it.
pub(crate) fn laid_out(bare: Bare, switches: &Switches) -> Result<Made, TriangleError> {
    let Bare { mut mesh, given, regions, report, warnings, outside_holes } = bare;
    let neighbours = mesh.neighbours();
    mark_vertices(&mut mesh, &given, &neighbours);
    // Triangles keep their numbers, so neighbours stay as they are.
    let mut mesh = if switches.jettison { jettisoned(mesh) } else { mesh };
    let lists_edges = switches.edges || switches.voronoi;
    let sides = if lists_edges || switches.six_nodes { edges::sides(&mesh.triangles, &neighbours) } else { Vec::new() };
    if mesh.segment_markers.is_empty() {
        mesh.segment_markers = vec![0; mesh.segments.len()];
    }
    let mut edges = edges::edges(&mesh, &sides);
    let faults = if switches.check { faults(&mesh, switches.conforming) } else { Vec::new() };
    let voronoi = if switches.voronoi { Some(edges::voronoi(&mesh, &sides)?) } else { None };
    let vertices = mesh.points.len();
    let middles = if switches.six_nodes { add_middles(&mut mesh, &edges, &sides) } else { Vec::new() };
    if switches.no_markers {
        mesh.point_markers.clear();
        mesh.segment_markers.clear();
        edges.markers.clear();
    }
    let boundary = neighbours.iter().flatten().filter(|beyond| beyond.is_none()).count();
    let edge_counts = [(3 * neighbours.len() + boundary) / 2, boundary];
    Ok(Made {
        mesh,
        vertices,
        middles,
        edge_counts,
        edges: lists_edges.then_some(edges),
        neighbours: switches.neighbours.then_some(neighbours),
        voronoi,
        regions,
        report,
        warnings,
        outside_holes,
        faults,
    })
}

/// Gives each vertex its own marker from the input; else that of a segment on which it lies, also of one outside the
/// domain; else 1 on the boundary and 0 inside.
fn mark_vertices(mesh: &mut IndexedMesh, given: &Given, neighbours: &[[Option<u32>; 3]]) {
    const BOUNDARY: i32 = 1;
    let mut markers = vec![0; mesh.points.len()];
    for (corners, beyond) in mesh.triangles.iter().zip(neighbours) {
        for k in (0..3).filter(|&k| beyond[k].is_none()) {
            markers[corners[(k + 1) % 3] as usize] = BOUNDARY;
            markers[corners[(k + 2) % 3] as usize] = BOUNDARY;
        }
    }
    let of_input = given.segments.iter().zip(&given.segment_markers).rev();
    let of_mesh = mesh.segments.iter().zip(&mesh.segment_markers).rev();
    // A boundary edge without a marker of its own has this one, too: every other marker goes before it.
    for (ends, &marker) in of_input.chain(of_mesh) {
        for v in ends.map(|v| v as usize) {
            let is_lesser = marker == 0 || (marker == BOUNDARY && markers[v] != 0);
            markers[v] = if is_lesser { markers[v] } else { marker };
        }
    }
    for (marker, &given) in markers.iter_mut().zip(&given.point_markers) {
        *marker = if given == 0 { *marker } else { given };
    }
    mesh.point_markers = markers;
}

/// Every fault of a mesh; where it is to be conforming, segments are no excuse.
fn faults(mesh: &IndexedMesh, is_conforming: bool) -> Vec<MeshFault> {
    let mut faults = check_mesh(mesh);
    if is_conforming {
        let bare = IndexedMesh { segments: Vec::new(), segment_markers: Vec::new(), ..mesh.clone() };
        faults.extend(check_mesh_delaunay(&bare, &[]));
    } else {
        faults.extend(check_mesh_delaunay(mesh, &[]));
    }
    faults
}

/// Adds the middle of each edge as a point; returns those opposite the corners of each triangle.
fn add_middles(mesh: &mut IndexedMesh, edges: &Edges, sides: &[edges::Side]) -> Vec<[u32; 3]> {
    let mut middles = vec![[0; 3]; mesh.triangles.len()];
    let width = mesh.attributes_per_point;
    for (side, &marker) in sides.iter().zip(&edges.markers) {
        let node = mesh.points.len() as u32;
        let [a, b] = side.ends.map(|v| v as usize);
        mesh.points.push(Point::midpoint(mesh.points[a], mesh.points[b]));
        mesh.point_markers.push(marker);
        for column in 0..width {
            let [of_a, of_b] = [a, b].map(|v| mesh.point_attributes[v * width + column]);
            mesh.point_attributes.push(of_a / 2.0 + of_b / 2.0);
        }
        for triangle in [Some(side.left), side.right].into_iter().flatten() {
            let corners = mesh.triangles[triangle as usize];
            let opposite = corners.iter().position(|v| !side.ends.contains(v)).unwrap_or_default();
            middles[triangle as usize][opposite] = node;
        }
    }
    middles
}

#[cfg(test)]
mod tests {
    use crate::{Input, Switches, VoronoiEdge, triangulate};
    use trimalla::refine::NoObserver;
    use trimalla::{Point, Pslg, Region};

    /// The square with a square hole of Triangle's instructions, hull edges missing, counted from 0.
    fn square_with_hole() -> Pslg {
        let xy = [[0., 0.], [0., 3.], [3., 0.], [3., 3.], [1., 1.], [1., 2.], [2., 1.], [2., 2.]];
        Pslg {
            points: xy.map(Point::from).to_vec(),
            point_markers: vec![0, 0, 0, 33, 0, 0, 0, 0],
            segments: vec![[0, 1], [4, 6], [6, 7], [7, 5], [5, 4]],
            segment_markers: vec![5, 0, 0, 10, 0],
            holes: vec![Point::new(1.5, 1.5)],
            ..Pslg::default()
        }
    }

    fn made(drawing: &Pslg, switches: &str) -> crate::Made {
        triangulate(&Input::Drawing(drawing), &Switches::parse(switches).unwrap(), &mut NoObserver).unwrap()
    }

    #[test]
    fn markers_are_those_of_the_instructions() {
        let box_ = made(&square_with_hole(), "pqcC");
        assert_eq!((box_.vertices, box_.mesh.triangles.len(), box_.edge_counts), (12, 12, [24, 12]));
        assert_eq!(box_.mesh.point_markers[..8], [5, 5, 1, 33, 1, 10, 1, 10]);
        let mut added = box_.mesh.point_markers[8..].to_vec();
        added.sort_unstable();
        assert_eq!(added, [1, 1, 1, 5]);
        assert_eq!(box_.mesh.segments.len(), 12);
        let mut markers = box_.mesh.segment_markers.clone();
        markers.sort_unstable();
        assert_eq!(markers, [1, 1, 1, 1, 1, 1, 1, 1, 1, 5, 5, 10]);
        assert_eq!(box_.faults, []);
    }

    #[test]
    fn six_nodes_lie_in_the_middle_of_edges() {
        let quadratic = made(&square_with_hole(), "pco2");
        let mesh = &quadratic.mesh;
        assert_eq!(mesh.points.len(), quadratic.vertices + quadratic.edge_counts[0]);
        for (corners, middles) in mesh.triangles.iter().zip(&quadratic.middles) {
            for opposite in 0..3 {
                let [a, b] = [1, 2].map(|step| mesh.points[corners[(opposite + step) % 3] as usize]);
                assert_eq!(mesh.points[middles[opposite] as usize], Point::midpoint(a, b));
            }
        }
        assert_eq!(mesh.point_markers.len(), mesh.points.len());
        assert!(made(&square_with_hole(), "pco2B").mesh.point_markers.is_empty());
    }

    #[test]
    fn attributes_and_areas_count_where_asked() {
        let mut drawing = square_with_hole();
        drawing.regions.push(Region { seed: Point::new(0.5, 0.5), attribute: 7.0, max_area: Some(0.1) });
        let plain = made(&drawing, "pc");
        assert_eq!((plain.mesh.attributes_per_triangle, plain.regions.len()), (0, 0));
        let with = made(&drawing, "pcA");
        assert_eq!(with.mesh.triangle_attributes, vec![7.0; with.mesh.triangles.len()]);
        let small = made(&drawing, "pca");
        assert_eq!(small.mesh.attributes_per_triangle, 0);
        assert!(small.mesh.triangles.len() > 80, "{}", small.mesh.triangles.len());
        let none = made(&square_with_hole(), "pcA");
        assert_eq!(none.mesh.triangle_attributes, vec![0.0; none.mesh.triangles.len()]);
    }

    #[test]
    fn a_hole_outside_is_let_be() {
        let mut drawing = Pslg::of_ring([[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]]);
        drawing.holes = vec![Point::new(3.0, 0.9), Point::new(9.0, 9.0)];
        let made = made(&drawing, "p");
        assert_eq!((made.mesh.triangles.len(), made.outside_holes.len()), (2, 1));
        assert_eq!(made.mesh.holes, drawing.holes);
    }

    #[test]
    fn a_segment_that_is_eaten_marks_its_ends() {
        let made = made(&square_with_hole(), "pO");
        assert_eq!((made.mesh.triangles.len(), made.mesh.segments.len()), (2, 4));
        assert_eq!(made.mesh.point_markers, [5, 5, 0, 33, 1, 10, 1, 10]);
        assert_eq!(made.mesh.holes.len(), 1);
    }

    #[test]
    fn conforming_is_delaunay_without_segments() {
        let mut drawing = square_with_hole();
        drawing.points.push(Point::new(1.5, 0.2));
        drawing.point_markers.push(0);
        for switches in ["pcDC", "pcqDC", "pcqa0.1DC"] {
            assert_eq!(made(&drawing, switches).faults, [], "{switches}");
        }
    }

    #[test]
    fn voronoi_is_the_dual_of_the_edges() {
        let points = Pslg { points: square_with_hole().points, ..Pslg::default() };
        let made = made(&points, "ven");
        let (edges, voronoi) = (made.edges.unwrap(), made.voronoi.unwrap());
        assert_eq!((edges.ends.len(), voronoi.edges.len(), voronoi.vertices.points.len()), (17, 17, 10));
        let rays = voronoi.edges.iter().filter(|edge| matches!(edge, VoronoiEdge::Ray { .. })).count();
        assert_eq!(rays, 4);
        assert_eq!(made.mesh.point_markers, [1, 1, 1, 1, 0, 0, 0, 0]);
    }

    #[test]
    fn no_vertex_more_than_allowed_is_added() {
        let drawing = square_with_hole();
        assert_eq!(made(&drawing, "pcqa0.01S9").vertices, 17);
        assert_eq!(made(&drawing, "pcqa0.01S").vertices, 8);
        let whole = made(&drawing, "pcqa0.05YY");
        assert_eq!(whole.mesh.segments.len(), 8);
    }
}
