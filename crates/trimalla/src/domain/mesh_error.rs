//! Why a mesh cannot be taken up again.

use super::error::DomainError;
use crate::geometry::Point;
use crate::triangulation::MeshFault;

/// Why a mesh cannot be taken up again to be refined.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// It is not a sound mesh: every fault, with triangles, vertices and coordinates.
    #[error("{}", first_few(.0))]
    Faults(Vec<MeshFault>),
    /// There is nothing to refine.
    #[error("the mesh has no triangles")]
    NoTriangles,
    /// More triangles than 32-bit half-edges can serve.
    #[error("{triangles} triangles are more than the {max} that fit", max = Self::MAX_TRIANGLES)]
    TooManyTriangles {
        /// How many there are.
        triangles: usize,
    },
    /// Area bounds are not one a triangle.
    #[error("there are {found} area bounds for {expected} triangles")]
    AreaCount {
        /// How many bounds there are.
        found: usize,
        /// How many triangles.
        expected: usize,
    },
    /// An area bound is not positive and finite.
    #[error("the area bound of triangle {triangle} must be positive and finite, not {bound}")]
    AreaBound {
        /// The triangle.
        triangle: usize,
        /// Its bound.
        bound: f64,
    },
    /// The drawing has vertices that the mesh lacks.
    #[error("the mesh has {found} vertices, fewer than the {expected} of the drawing")]
    FewerVertices {
        /// Vertices of the mesh.
        found: usize,
        /// Vertices of the drawing.
        expected: usize,
    },
    /// A vertex of the drawing lies elsewhere in the mesh; the first that does.
    #[error("vertex {vertex} of the drawing lies at {was}, but at {is} in the mesh")]
    VertexChanged {
        /// Its index.
        vertex: usize,
        /// Where the drawing has it.
        was: Point,
        /// Where the mesh has it.
        is: Point,
    },
    /// The drawing itself is at fault.
    #[error(transparent)]
    Drawing(#[from] DomainError),
}

impl MeshError {
    /// Each may need three ghosts, each face has three half-edges, and 32 bits name them; the rest is room to grow.
    pub const MAX_TRIANGLES: usize = 1 << 28;
}

/// The first faults in words; the list itself holds all.
fn first_few(faults: &[MeshFault]) -> String {
    const SHOWN: usize = 20;
    let mut words: Vec<String> = faults.iter().take(SHOWN).map(ToString::to_string).collect();
    if faults.len() > SHOWN {
        words.push(format!("and {} more faults", faults.len() - SHOWN));
    }
    words.join("; ")
}
