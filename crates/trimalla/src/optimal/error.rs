//! Why nothing is triangulated.

use crate::geometry::Point;

/// What is wrong with the input of an algorithm.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OptimalError {
    /// A coordinate or a height is NaN or infinite.
    #[error("point {index} at {point} is not finite")]
    NotFinite {
        /// The point.
        index: u32,
        /// Its coordinates.
        point: Point,
    },
    /// More points than indices, or the memory of the algorithm, can take.
    #[error("{count} points are more than {limit}")]
    TooMany {
        /// The number of points.
        count: usize,
        /// The most that are possible.
        limit: usize,
    },
    /// Somebody has cancelled.
    #[error("cancelled")]
    Cancelled,
}
