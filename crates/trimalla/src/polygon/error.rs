//! Why a polygon is not triangulated.

use crate::geometry::Point;

/// What is wrong with a polygon, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PolygonError {
    /// More points than indices can name.
    #[error("{count} points are more than {limit}")]
    TooMany {
        /// The number of points.
        count: usize,
        /// The most that are possible.
        limit: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("point {index} at {point} is not finite")]
    NotFinite {
        /// The point.
        index: u32,
        /// Its coordinates.
        point: Point,
    },
    /// A ring ends before it begins, or after the last point.
    #[error("ring {ring} ends at point {end}, which is out of order")]
    RingEnd {
        /// The ring.
        ring: usize,
        /// Where it ends.
        end: u32,
    },
    /// A ring bounds no area.
    #[error("ring {ring}, from point {first} on, bounds no area")]
    Flat {
        /// The ring.
        ring: usize,
        /// Its first point.
        first: u32,
    },
    /// Two sides cross or overlap.
    #[error("the sides from {0} to {1} and from {2} to {3} cross near {at}", .sides[0][0], .sides[0][1], .sides[1][0], .sides[1][1])]
    Crossing {
        /// The two sides, by the indices of their points.
        sides: [[u32; 2]; 2],
        /// A point near the crossing, rounded.
        at: Point,
    },
    /// A hole that is not inside the outline, or that is inside another hole.
    #[error(
        "hole {ring}, whose leftmost point is {vertex} at {at}, is not inside the outline, or is inside another hole"
    )]
    Nesting {
        /// The ring; 0 if the outline is inside a hole.
        ring: usize,
        /// Its leftmost point.
        vertex: u32,
        /// The coordinates of that point.
        at: Point,
    },
    /// A hole is not inside of the outline, or is inside of another hole; or a ring passes through itself at a vertex.
    #[error("ring {ring} near {at} has the inside of the polygon on the wrong side")]
    Misplaced {
        /// The ring.
        ring: usize,
        /// A point of it.
        at: Point,
    },
    /// A segment ends at a point that does not exist.
    #[error("segment {segment} ends at point {vertex}, which does not exist")]
    SegmentEnd {
        /// The segment.
        segment: usize,
        /// The index that is too large.
        vertex: u32,
    },
    /// The method does not take holes.
    #[error("'{method}' triangulates polygons without holes, and this one has {holes}")]
    Holes {
        /// The key of the method.
        method: &'static str,
        /// The number of holes.
        holes: usize,
    },
    /// A ring that should be monotone turns back.
    #[error("the ring is not monotone: it turns back at point {vertex} at {at}")]
    NotMonotone {
        /// The point.
        vertex: u32,
        /// Its coordinates.
        at: Point,
    },
    /// Somebody has cancelled.
    #[error("cancelled")]
    Cancelled,
}

impl PolygonError {
    /// The same fault, its vertices and rings named by other numbers.
    pub(super) fn renumbered(self, number: impl Fn(u32) -> u32, of_ring: impl Fn(usize) -> usize) -> Self {
        match self {
            Self::Flat { ring, first } => Self::Flat { ring: of_ring(ring), first: number(first) },
            Self::Crossing { sides, at } => Self::Crossing { sides: sides.map(|side| side.map(&number)), at },
            Self::Nesting { ring, vertex, at } => Self::Nesting { ring: of_ring(ring), vertex: number(vertex), at },
            Self::Misplaced { ring, at } => Self::Misplaced { ring: of_ring(ring), at },
            Self::NotMonotone { vertex, at } => Self::NotMonotone { vertex: number(vertex), at },
            other => other,
        }
    }
}
