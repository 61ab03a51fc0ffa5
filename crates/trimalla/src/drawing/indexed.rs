//! A mesh as plain arrays: what goes into files and comes out of them.

use super::sides::{Side, Sides};
use crate::geometry::Point;

/// A triangle mesh as plain arrays, the form in which meshes are written, read and handed over.
///
/// # Shape
/// Optional columns are either empty or have one entry (or `attributes_per_…` entries) an element.
/// Input vertices come first, in the caller's order, bit for bit; Steiner points follow.
#[doc(alias = "triangle mesh")]
#[doc(alias = "malla")]
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default))]
pub struct IndexedMesh {
    /// Vertex coordinates.
    pub points: Vec<Point>,
    /// Boundary marker a vertex; empty or `points.len()` entries.
    pub point_markers: Vec<i32>,
    /// Number of attributes a vertex carries.
    pub attributes_per_point: usize,
    /// Vertex attributes, row after row; `points.len() * attributes_per_point` entries.
    pub point_attributes: Vec<f64>,
    /// Vertex indices of each triangle, counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
    /// Number of attributes a triangle carries.
    pub attributes_per_triangle: usize,
    /// Triangle attributes, row after row.
    pub triangle_attributes: Vec<f64>,
    /// Subsegments: the constrained edges of the mesh, boundary edges of the domain included.
    pub segments: Vec<[u32; 2]>,
    /// Marker a subsegment; empty or `segments.len()` entries.
    pub segment_markers: Vec<i32>,
    /// Seeds of the holes of the domain, carried along so that the mesh can be read back as a domain.
    pub holes: Vec<Point>,
    /// How many of the points are input vertices.
    pub input_points: usize,
}

/// Edges and neighbours.
///
/// Triangles with an index out of range, or one twice, are passed over.
impl IndexedMesh {
    /// Each edge of a triangle once, lower vertex first, sorted.
    ///
    /// # Complexity
    /// Linear, and n log n in the degree of each vertex.
    #[must_use]
    pub fn edges(&self) -> Vec<[u32; 2]> {
        let sides = Sides::of(self);
        let mut edges: Vec<[u32; 2]> = sides.edges().map(|s| [s.origin.min(s.dest), s.origin.max(s.dest)]).collect();
        edges.sort_unstable();
        edges
    }

    /// The sides of triangles that no other triangle adjoins, each with its triangle on the left, sorted.
    ///
    /// # Complexity
    /// Linear, and n log n in the degree of each vertex.
    #[must_use]
    pub fn boundary_edges(&self) -> Vec<[u32; 2]> {
        Sides::of(self).boundary().map(|s| [s.origin, s.dest]).collect()
    }

    /// The neighbours of each triangle: the first lies opposite its first corner, and so on; `None` at the boundary,
    /// and where more than two triangles share an edge.
    ///
    /// # Complexity
    /// Linear, and n log n in the degree of each vertex.
    #[must_use]
    pub fn neighbours(&self) -> Vec<[Option<u32>; 3]> {
        let sides = Sides::of(self);
        let mut neighbours = vec![[None; 3]; self.triangles.len()];
        for side in sides.iter() {
            let alone = |from, to| sides.only(from, to);
            if alone(side.origin, side.dest).is_some() {
                let corner = self.triangles[side.triangle].iter().position(|&v| v == side.apex).unwrap_or(0);
                let across = alone(side.dest, side.origin);
                neighbours[side.triangle][corner] =
                    across.and_then(|Side { triangle, .. }| u32::try_from(*triangle).ok());
            }
        }
        neighbours
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_triangles_share_an_edge() {
        let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from).to_vec();
        let mesh = IndexedMesh { points, triangles: vec![[0, 1, 2], [0, 2, 3], [0, 9, 1]], ..IndexedMesh::default() };
        assert_eq!(mesh.edges(), [[0, 1], [0, 2], [0, 3], [1, 2], [2, 3]]);
        assert_eq!(mesh.boundary_edges(), [[0, 1], [1, 2], [2, 3], [3, 0]]);
        assert_eq!(mesh.neighbours(), [[None, Some(1), None], [None, None, Some(0)], [None; 3]]);
    }
}
