//! Why nothing is triangulated.

use crate::geometry::Point;
use crate::triangulation::MeshFault;

/// What is wrong with the input of an algorithm.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OptimalError {
    /// A coordinate or a height is NaN or infinite.
    #[error("point {index} at {point}, or its height, is not finite")]
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
    /// More pairs of points than the memory of the algorithm can take: many see each other, and no other points are
    /// near.
    #[error("{count} pairs of points, or more, may be edges: more than {limit}")]
    TooManyPairs {
        /// How many were counted.
        count: usize,
        /// The most that are possible.
        limit: usize,
    },
    /// The algorithm needs heights, and there are none.
    #[error("'{method}' needs a height for each point")]
    NoHeights {
        /// The key of the algorithm.
        method: &'static str,
    },
    /// Not one height a point.
    #[error("{heights} heights are given for {points} points")]
    HeightCount {
        /// The number of heights.
        heights: usize,
        /// The number of points.
        points: usize,
    },
    /// The domain has other points than the input.
    #[error("the domain has {count} points which are not the {expected} of the input")]
    OtherPoints {
        /// The points of the domain.
        count: usize,
        /// The points of the input.
        expected: usize,
    },
    /// The triangles of the domain, or of a mesh to be flipped, have these faults.
    #[error("the triangles of the domain are at fault: {}", .0.first().map(ToString::to_string).unwrap_or_default())]
    Domain(Vec<MeshFault>),
    /// A part of the domain has a hole or a vertex inside.
    #[error("'{method}' needs parts without holes and without vertices inside; that at vertex {vertex} has some")]
    NotOneWalk {
        /// The key of the algorithm.
        method: &'static str,
        /// A vertex of the part.
        vertex: u32,
    },
    /// The algorithm takes points only.
    #[error("'{method}' triangulates points, and no domain")]
    PointsOnly {
        /// The key of the algorithm.
        method: &'static str,
    },
    /// The algorithm takes a domain only.
    #[error("'{method}' triangulates a domain, and there is none")]
    DomainOnly {
        /// The key of the algorithm.
        method: &'static str,
    },
    /// Somebody has cancelled.
    #[error("cancelled")]
    Cancelled,
}
