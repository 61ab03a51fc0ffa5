//! Why segments cannot be constraints.

use std::fmt;

use crate::delaunay::BuildError;
use crate::geometry::Point;
use crate::half_edge::VertexId;

/// Two input segments that cross in a point inside both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrossingPair {
    /// Indices of the segments, the lower one first.
    pub segments: [usize; 2],
    /// The point where they cross, rounded.
    pub at: Point,
}

impl fmt::Display for CrossingPair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "segments {} and {} cross near {}", self.segments[0], self.segments[1], self.at)
    }
}

/// Why a constrained triangulation cannot be built or a segment not inserted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ConstraintError {
    /// The points themselves are at fault.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// A segment names a vertex that is not there.
    #[error("segment {segment} ends at vertex {vertex}, which does not exist: there are {points} points")]
    NoSuchVertex {
        /// The segment.
        segment: usize,
        /// The vertex named.
        vertex: VertexId,
        /// How many points there are.
        points: usize,
    },
    /// More segments than 31-bit marks of edges can name.
    #[error("{0} segments are more than the {max} that fit", max = Self::MAX_SEGMENTS)]
    TooManySegments(usize),
    /// A segment ends at a vertex that is not part of the triangulation.
    #[error("segment {segment} ends at vertex {vertex}, which is not used")]
    UnusedVertex {
        /// The segment.
        segment: usize,
        /// The vertex.
        vertex: VertexId,
    },
    /// Segments cross; every pair is listed.
    #[error("{} cross: {}", pairs(.0.len()), first_few(.0))]
    Crossing(Vec<CrossingPair>),
    /// A segment would leave the domain.
    #[error("segment {segment} from {from} to {to} leaves the domain")]
    LeavesDomain {
        /// The segment.
        segment: usize,
        /// Its start.
        from: Point,
        /// Its end.
        to: Point,
    },
    /// Splitting crossings did not come to an end within its bound, or two segments run so close to one another that no
    /// point with coordinates lies on both, within rounding.
    #[error("splitting the crossing of segments {} and {} near {} found no place after {steps} steps", .pair.segments[0], .pair.segments[1], .pair.at)]
    CrossingsExhausted {
        /// The pair that was being split then.
        pair: CrossingPair,
        /// Steps by then.
        steps: u64,
    },
}

impl ConstraintError {
    /// Half of the marks of edges name segments, the other half where segments overlap; some are left for lists of
    /// several.
    pub const MAX_SEGMENTS: usize = 1_000_000_000;
}

fn pairs(n: usize) -> String {
    if n == 1 { "1 pair of segments".into() } else { format!("{n} pairs of segments") }
}

/// The first pairs in words; the list itself holds all.
fn first_few(list: &[CrossingPair]) -> String {
    const SHOWN: usize = 20;
    let mut words: Vec<String> = list.iter().take(SHOWN).map(ToString::to_string).collect();
    if list.len() > SHOWN {
        words.push(format!("and {} more", list.len() - SHOWN));
    }
    words.join(", ")
}
