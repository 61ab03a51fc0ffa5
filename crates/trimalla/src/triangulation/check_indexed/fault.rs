//! Faults of a mesh from any source, in words.

use std::fmt;

use crate::geometry::{Orientation, Point, SegmentContact};

/// A vertex of a mesh and where it lies: what a message needs to say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshVertex {
    /// Its index.
    pub index: u32,
    /// Its coordinates.
    pub point: Point,
}

impl fmt::Display for MeshVertex {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} at {}", self.index, self.point)
    }
}

/// Something wrong with a mesh, with the elements concerned and their coordinates.
///
/// Triangles, segments and vertices are named by their indices, which start at 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshFault {
    /// A column of attributes or markers is neither empty nor as long as its elements need.
    #[error("column '{column}' has {found} entries instead of {expected}")]
    ColumnLength {
        /// Name of the field of [`IndexedMesh`](crate::drawing::IndexedMesh).
        column: &'static str,
        /// Its length.
        found: usize,
        /// The length it should have.
        expected: usize,
    },
    /// The mesh claims more input vertices than it has vertices.
    #[error("{claimed} of {vertices} vertices cannot be input vertices")]
    InputCount {
        /// How many are claimed.
        claimed: usize,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A coordinate is infinite or not a number.
    #[error("vertex {0} is not finite")]
    NotFinite(MeshVertex),
    /// A triangle names a vertex that is not there.
    #[error("triangle {triangle} names vertex {vertex}, but there are {vertices} vertices")]
    IndexOutOfRange {
        /// The triangle.
        triangle: usize,
        /// The index.
        vertex: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A triangle names a vertex twice.
    #[error("triangle {triangle} names vertex {vertex} twice")]
    RepeatedVertex {
        /// The triangle.
        triangle: usize,
        /// The vertex.
        vertex: MeshVertex,
    },
    /// A triangle is clockwise or flat, by the exact test.
    #[error("triangle {triangle} with vertices {}, {} and {} is {}", .corners[0], .corners[1], .corners[2], turn(*.orientation))]
    NotCounterClockwise {
        /// The triangle.
        triangle: usize,
        /// Its corners.
        corners: [MeshVertex; 3],
        /// How they turn.
        orientation: Orientation,
    },
    /// Two triangles lie on the same side of an edge.
    #[error("triangles {} and {} both lie left of the edge from vertex {} to vertex {}", .triangles[0], .triangles[1], .edge[0], .edge[1])]
    EdgeUsedTwice {
        /// The directed edge.
        edge: [MeshVertex; 2],
        /// Both triangles.
        triangles: [usize; 2],
    },
    /// A closed fan of triangles about a vertex is not alone there; open ones may meet.
    #[error("triangle {} and others close around vertex {vertex}, but triangle {} at it is not one of them", .triangles[0], .triangles[1])]
    Star {
        /// The vertex.
        vertex: MeshVertex,
        /// A triangle of a closed fan and one outside it.
        triangles: [usize; 2],
    },
    /// Two used vertices lie on the same place.
    #[error("vertices {} and {} lie on the same place and are both used", .0[0], .0[1])]
    DuplicateVertices([MeshVertex; 2]),
    /// A subsegment names a vertex that is not there.
    #[error("segment {segment} names vertex {vertex}, but there are {vertices} vertices")]
    SegmentOutOfRange {
        /// The subsegment.
        segment: usize,
        /// The index.
        vertex: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A subsegment is not an edge of any triangle.
    #[error("segment {segment} from vertex {} to vertex {} is not an edge of the mesh", .ends[0], .ends[1])]
    SegmentNotAnEdge {
        /// The subsegment.
        segment: usize,
        /// Its ends.
        ends: [MeshVertex; 2],
    },
    /// Two boundary edges have more in common than an end: triangles overlap or do not meet edge to edge.
    #[error("boundary edges {} – {} of triangle {} and {} – {} of triangle {} {}", .edges[0][0], .edges[0][1], .triangles[0], .edges[1][0], .edges[1][1], .triangles[1], meeting(*.contact))]
    BoundaryContact {
        /// Both edges.
        edges: [[MeshVertex; 2]; 2],
        /// Their triangles.
        triangles: [usize; 2],
        /// What they have in common.
        contact: SegmentContact,
    },
    /// Triangles lie on one another: the boundary winds more than once around the place beside an edge.
    #[error("triangle {triangle} at its boundary edge {} – {} lies on other triangles", .edge[0], .edge[1])]
    Overlap {
        /// A triangle that others lie on, or that lies on others.
        triangle: usize,
        /// Its side on the boundary of the mesh.
        edge: [MeshVertex; 2],
    },
    /// An edge that is not constrained has a vertex strictly inside the circle of the triangle beyond.
    #[error("edge {} – {} between triangles {} and {} is not Delaunay: vertex {} lies inside the circle of triangle {}", .edge[0], .edge[1], .triangles[0], .triangles[1], .inside, .triangles[0])]
    NotDelaunay {
        /// The edge.
        edge: [MeshVertex; 2],
        /// The triangles left and right of it.
        triangles: [usize; 2],
        /// The corner of the second triangle that lies inside the circle of the first.
        inside: MeshVertex,
    },
}

/// How the corners of a faulty triangle turn.
fn turn(orientation: Orientation) -> &'static str {
    match orientation {
        Orientation::Clockwise => "clockwise",
        Orientation::Collinear => "flat",
        Orientation::CounterClockwise => "counter-clockwise",
    }
}

/// What two edges do, as a verb.
fn meeting(contact: SegmentContact) -> &'static str {
    match contact {
        SegmentContact::Crossing => "cross",
        SegmentContact::Touching => "touch without sharing a vertex",
        SegmentContact::Overlapping => "overlap",
        SegmentContact::Apart => "are apart",
    }
}
