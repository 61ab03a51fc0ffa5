//! Why there is no diagram.

use crate::constrained::ConstraintError;

/// Why a Voronoi diagram is not made, or not clipped.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum VoronoiError {
    /// The diagram and the outline of the domain cannot be laid over each other: two lines run within rounding of one
    /// another, or there are too many points.
    #[error("the diagram cannot be clipped: {0}")]
    Overlay(#[from] ConstraintError),
    /// Somebody has cancelled.
    #[error("cancelled")]
    Cancelled,
}
