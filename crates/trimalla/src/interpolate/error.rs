//! Why no values are computed.

use crate::delaunay::BuildError;
use crate::geometry::Point;
use crate::half_edge::VertexId;

/// What is wrong with the heights, the levels or the points.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InterpolateError {
    /// There is not one height for each vertex.
    #[error("{heights} heights are given for {vertices} vertices")]
    Count {
        /// The number of heights.
        heights: usize,
        /// The number of vertices.
        vertices: usize,
    },
    /// A height is NaN or infinite.
    #[error("the height {height} of vertex {vertex} at {at} is not finite")]
    Height {
        /// The vertex.
        vertex: VertexId,
        /// Where it lies.
        at: Point,
        /// The height.
        height: f64,
    },
    /// The points cannot be triangulated.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// A level is NaN or infinite.
    #[error("the level {0} is not finite")]
    Level(f64),
    /// The step between levels is not a positive number.
    #[error("the step {0} between levels is not positive and finite")]
    Step(f64),
    /// More levels than are drawn.
    #[error("the step {step} between levels gives more than {limit} of them from {low} to {high}")]
    TooManyLevels {
        /// The step.
        step: f64,
        /// The lowest height.
        low: f64,
        /// The highest height.
        high: f64,
        /// The most levels that are possible.
        limit: usize,
    },
    /// Somebody has cancelled.
    #[error("cancelled")]
    Cancelled,
}
