//! A mesh as plain arrays: what goes into files and comes out of them.

use crate::geometry::Point;

/// A triangle mesh as plain arrays, the form in which meshes are written, read and handed over.
///
/// # Shape
/// Optional columns are either empty or have one entry (or `attributes_per_…` entries) an element.
/// Input vertices come first, in the caller's order, bit for bit; Steiner points follow.
#[derive(Clone, Debug, Default, PartialEq)]
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
