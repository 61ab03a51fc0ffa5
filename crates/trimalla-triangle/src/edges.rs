//! Edges, each from the first triangle that has it, and their duals.

use trimalla::IndexedMesh;
use trimalla::geometry::{Point, Triangle};

use crate::error::TriangleError;
use crate::made::Voronoi;

/// The edges of a mesh.
///
/// # Shape
/// `markers` has one entry an edge, or none under `-B`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Edges {
    /// The ends of each edge: a triangle lies on the left.
    pub ends: Vec<[u32; 2]>,
    /// The marker of the subsegment; else 1 on the boundary, 0 inside.
    pub markers: Vec<i32>,
}

/// An edge of a Voronoi diagram.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum VoronoiEdge {
    /// Between the vertices of the triangles left and right of an edge of the mesh.
    Between([u32; 2]),
    /// From the vertex of a triangle in this direction, without end.
    Ray {
        /// The triangle.
        from: u32,
        /// As long as the edge of the mesh, and at right angles to it.
        direction: [f64; 2],
    },
}

/// An edge as a side of the first triangle that has it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Side {
    pub(crate) ends: [u32; 2],
    pub(crate) left: u32,
    pub(crate) right: Option<u32>,
}

/// Every edge once, in the order of triangles and of their sides.
pub(crate) fn sides(triangles: &[[u32; 3]], neighbours: &[[Option<u32>; 3]]) -> Vec<Side> {
    let mut sides = Vec::with_capacity(triangles.len() + triangles.len() / 2);
    for (left, (corners, beyond)) in (0..).zip(triangles.iter().zip(neighbours)) {
        for start in 0..3 {
            // The side from this corner to the next lies opposite the one after that.
            let right = beyond[(start + 2) % 3];
            if right.is_none_or(|right| left < right) {
                sides.push(Side { ends: [corners[start], corners[(start + 1) % 3]], left, right });
            }
        }
    }
    sides
}

/// The edges with their markers.
pub(crate) fn edges(mesh: &IndexedMesh, sides: &[Side]) -> Edges {
    let key = |[a, b]: [u32; 2]| [a.min(b), a.max(b)];
    let marked = mesh.segments.iter().zip(&mesh.segment_markers);
    let mut marked: Vec<([u32; 2], i32)> = marked.map(|(&ends, &marker)| (key(ends), marker)).collect();
    marked.sort_unstable();
    let marker = |side: &Side| match marked.binary_search_by_key(&key(side.ends), |&(ends, _)| ends) {
        Ok(place) => marked[place].1,
        Err(_) => i32::from(side.right.is_none()),
    };
    Edges { ends: sides.iter().map(|side| side.ends).collect(), markers: sides.iter().map(marker).collect() }
}

/// The Voronoi diagram as the dual of a mesh.
pub(crate) fn voronoi(mesh: &IndexedMesh, sides: &[Side]) -> Result<Voronoi, TriangleError> {
    let mut vertices = IndexedMesh { attributes_per_point: mesh.attributes_per_point, ..IndexedMesh::default() };
    for (triangle, corners) in mesh.triangles.iter().enumerate() {
        let [a, b, c] = corners.map(|v| mesh.points[v as usize]);
        let center = Triangle::new(a, b, c).circumcenter().filter(|center| center.is_finite());
        let center = center.ok_or(TriangleError::NoVoronoi { triangle })?;
        vertices.points.push(center);
        let width = mesh.attributes_per_point;
        let row = |v: u32| mesh.point_attributes.get(v as usize * width..(v as usize + 1) * width).unwrap_or_default();
        let [of_a, of_b, of_c] = corners.map(row);
        let [along_b, along_c] = shares(center, [a, b, c]);
        let values = of_a.iter().zip(of_b.iter().zip(of_c));
        let value = |(&a, (&b, &c)): (&f64, (&f64, &f64))| a + along_b * (b - a) + along_c * (c - a);
        vertices.point_attributes.extend(values.map(value));
    }
    if !vertices.point_attributes.iter().all(|value| value.is_finite()) {
        let width = mesh.attributes_per_point.max(1);
        let place = vertices.point_attributes.iter().position(|value| !value.is_finite()).unwrap_or_default();
        return Err(TriangleError::NoVoronoi { triangle: place / width });
    }
    Ok(Voronoi { vertices, edges: sides.iter().map(|side| dual(mesh, side)).collect() })
}

fn dual(mesh: &IndexedMesh, side: &Side) -> VoronoiEdge {
    match side.right {
        Some(right) => VoronoiEdge::Between([side.left, right]),
        None => {
            let [a, b] = side.ends.map(|v| mesh.points[v as usize]);
            VoronoiEdge::Ray { from: side.left, direction: [b.y - a.y, a.x - b.x] }
        }
    }
}

/// The coordinates of a point along the sides of a triangle from its first corner to the two others.
fn shares(at: Point, [a, b, c]: [Point; 3]) -> [f64; 2] {
    let (to_b, to_c, to_p) = (b - a, c - a, at - a);
    let whole = to_b.cross(to_c);
    [to_p.cross(to_c) / whole, to_b.cross(to_p) / whole]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A unit square with a diagonal, and an attribute that is x + 2 y.
    fn square() -> IndexedMesh {
        IndexedMesh {
            points: [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from).to_vec(),
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            segments: vec![[1, 0], [2, 0]],
            segment_markers: vec![7, 5],
            attributes_per_point: 1,
            point_attributes: vec![0.0, 1.0, 3.0, 2.0],
            ..IndexedMesh::default()
        }
    }

    #[test]
    fn edges_have_a_triangle_on_the_left() {
        let mesh = square();
        let sides = sides(&mesh.triangles, &mesh.neighbours());
        let edges = edges(&mesh, &sides);
        assert_eq!(edges.ends, [[0, 1], [1, 2], [2, 0], [2, 3], [3, 0]]);
        assert_eq!(edges.markers, [7, 1, 5, 1, 1]);
    }

    #[test]
    fn rays_lead_away_from_the_domain() {
        let mesh = square();
        let sides = sides(&mesh.triangles, &mesh.neighbours());
        let voronoi = voronoi(&mesh, &sides).unwrap();
        assert_eq!(voronoi.vertices.points, vec![Point::new(0.5, 0.5); 2]);
        assert_eq!(voronoi.vertices.point_attributes, [1.5, 1.5]);
        assert_eq!(voronoi.edges[0], VoronoiEdge::Ray { from: 0, direction: [0.0, -1.0] });
        assert_eq!(voronoi.edges[2], VoronoiEdge::Between([0, 1]));
    }
}
