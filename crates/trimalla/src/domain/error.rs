//! Why a drawing has no domain, and warnings about it.

use crate::constrained::ConstraintError;
use crate::drawing::DrawingError;
use crate::geometry::Point;
use crate::half_edge::VertexId;

/// Why a domain cannot be made from a drawing.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DomainError {
    /// Points or segments are at fault.
    #[error(transparent)]
    Constraint(#[from] ConstraintError),
    /// Columns or seeds are at fault.
    #[error(transparent)]
    Drawing(#[from] DrawingError),
    /// No three points span a triangle.
    #[error("{points} points give no triangle: all lie on one line")]
    Flat {
        /// How many points there are.
        points: usize,
    },
    /// Nothing is left inside: what the outside reaches without crossing a segment, and what hole seeds reach, is all.
    #[error("the domain is empty: the outside comes in without crossing a segment{}; close the outline, or keep the convex hull", at_open_end(*.end))]
    OpenOutline {
        /// A vertex that the outside reaches, at which just one segment ends; the lowest of them.
        end: Option<OpenEnd>,
    },
    /// Nothing is left inside under the nesting rule.
    #[error("the domain is empty: no triangle lies behind an odd number of segments")]
    NothingNested,
    /// A hole seed reaches the outside.
    #[error("hole seed {seed} at {at} reaches the outside: no closed line of segments surrounds it")]
    SeedLeaks {
        /// Index of the seed.
        seed: usize,
        /// The seed.
        at: Point,
    },
    /// Hole seeds remove everything.
    #[error("the domain is empty: hole seed {seed} at {at} reaches all that was left")]
    SeedTakesAll {
        /// Index of the last seed that removed anything.
        seed: usize,
        /// The seed.
        at: Point,
    },
    /// A seed lies on a segment or vertex, so that its side is not known.
    #[error("{what} seed {seed} at {at} lies on a segment")]
    SeedOnSegment {
        /// `hole` or `region`.
        what: &'static str,
        /// Index of the seed.
        seed: usize,
        /// The seed.
        at: Point,
    },
    /// A contour has fewer than three vertices, or no area.
    #[error("contour {contour} bounds no area")]
    FlatContour {
        /// Index of the contour, the outer one first.
        contour: usize,
    },
    /// A contour runs the wrong way round.
    #[error("contour {contour} runs {found}, but {role} contours run {expected}")]
    ContourOrientation {
        /// Index of the contour, the outer one first.
        contour: usize,
        /// `outer` or `hole`.
        role: &'static str,
        /// The orientation it should have.
        expected: &'static str,
        /// The orientation it has.
        found: &'static str,
    },
    /// A hole contour removes nothing: it lies outside the outer contour or inside another hole.
    #[error("contour {contour} removes nothing: it lies outside the outer contour or in another hole")]
    IdleContour {
        /// Index of the contour, the outer one first.
        contour: usize,
    },
}

/// A vertex at which just one segment ends: where an outline may have a gap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OpenEnd {
    /// The vertex.
    pub vertex: VertexId,
    /// Where it lies.
    pub at: Point,
    /// The nearest other such vertex, and how far away it is.
    pub nearest: Option<(VertexId, f64)>,
}

fn at_open_end(end: Option<OpenEnd>) -> String {
    let Some(OpenEnd { vertex, at, nearest }) = end else { return String::new() };
    let other = nearest.map(|(other, distance)| format!(", the next at vertex {other}, {distance:e} away"));
    format!(": just one ends at vertex {vertex}, {at}{}", other.unwrap_or_default())
}

/// A vertex, or the inside of a segment, that another vertex is near to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum NearFeature {
    /// A vertex of the drawing; after those, where two segments cross.
    Vertex(u32),
    /// A segment; after those of the drawing, a side of the convex hull.
    Segment(u32),
}

/// Something unusual in a drawing that did not keep it from being meshed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// Points that lie exactly on earlier ones; they stay unused.
    Duplicates {
        /// How many.
        count: usize,
        /// The first of them and the one it lies on.
        first: [u32; 2],
    },
    /// Segments from a vertex to itself (or its duplicate); dropped.
    ZeroLength {
        /// How many.
        count: usize,
        /// Index of the first.
        first: usize,
    },
    /// Input vertices outside the domain: no triangle has them as a corner. They keep their places in the output.
    VerticesOutside {
        /// How many, duplicates not among them.
        count: usize,
        /// The first of them, at most [`Warning::NAMED`].
        first: Vec<u32>,
    },
    /// Segments outside the domain: no edge of the mesh is part of them.
    SegmentsOutside {
        /// How many.
        count: usize,
        /// The first of them, at most [`Warning::NAMED`].
        first: Vec<u32>,
    },
    /// Two features that nearly touch across what is outside the domain, nearer than a millionth of the drawing, and
    /// the nearest of that kind: perhaps parts that were meant to share a vertex or a side.
    NearlyTouching {
        /// A vertex.
        vertex: u32,
        /// What it is near to.
        other: NearFeature,
        /// How far it is from that.
        distance: f64,
        /// The vertex.
        at: Point,
    },
    /// Segments that overlap earlier ones with another marker, which counts there.
    MarkersHidden {
        /// How many.
        count: usize,
        /// The first of them and the one whose marker counts.
        first: [u32; 2],
    },
    /// Segments that could not be split until all were edges of the Delaunay triangulation: pieces of them were put in
    /// whole.
    NotConforming {
        /// How many pieces.
        pieces: usize,
    },
    /// What lies inside a polygon of which only the corners are triangulated.
    InsideLeftOut {
        /// How many points.
        points: usize,
        /// How many subsegments.
        segments: usize,
    },
    /// A hole seed outside the convex hull, or in a part that another seed removed; of no effect.
    IdleHole {
        /// Index of the seed.
        seed: usize,
        /// The seed.
        at: Point,
    },
    /// A region seed outside the domain; of no effect.
    IdleRegion {
        /// Index of the seed.
        seed: usize,
        /// The seed.
        at: Point,
    },
    /// Two region seeds in one region; the first counts.
    RegionTwice {
        /// Indices of the seeds.
        seeds: [usize; 2],
    },
    /// Segments crossed and were split.
    Crossings {
        /// How many crossing vertices were made.
        vertices: usize,
    },
    /// Subsegments of a mesh were joined into chains, as no drawing says what they are pieces of.
    Rejoined {
        /// How many chains of two subsegments or more were made.
        chains: usize,
        /// How many subsegments they have.
        subsegments: usize,
    },
    /// Subsegments inside a mesh that lie on no segment of its drawing; they are kept.
    NotInDrawing {
        /// How many.
        subsegments: usize,
    },
    /// Edges of a mesh between triangles with different attributes that it does not list as segments; they are kept as
    /// such.
    RegionBoundaries {
        /// How many.
        edges: usize,
    },
    /// A mesh falls into pieces that share no edge.
    Pieces {
        /// How many.
        pieces: usize,
    },
    /// A mesh was not Delaunay, and edges were flipped until it was.
    Flipped {
        /// How many flips there were.
        flips: u64,
    },
}

impl Warning {
    /// No more vertices or segments than this are named one by one.
    pub const NAMED: usize = 5;
}

/// Numbers in a list, which goes on where there are more.
fn listed(count: usize, first: &[u32]) -> String {
    let numbers: Vec<String> = first.iter().map(ToString::to_string).collect();
    format!("{}{}", numbers.join(", "), if first.len() < count { ", …" } else { "" })
}

impl std::fmt::Display for Warning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Duplicates { count, first: [a, b] } => {
                write!(f, "{count} points lie exactly on others and stay unused; the first is {a}, on {b}")
            }
            Self::ZeroLength { count, first } => {
                write!(f, "{count} segments have no length and were dropped; the first is {first}")
            }
            Self::VerticesOutside { count, first } => {
                write!(f, "{count} vertices lie outside the domain and are in no triangle: {}", listed(*count, first))
            }
            Self::SegmentsOutside { count, first } => {
                write!(f, "{count} segments lie outside the domain and are in no mesh: {}", listed(*count, first))
            }
            Self::NearlyTouching { vertex, other, distance, at } => {
                let (what, number) = match other {
                    NearFeature::Vertex(v) => ("vertex", v),
                    NearFeature::Segment(s) => ("segment", s),
                };
                write!(
                    f,
                    "vertex {vertex} at {at} is {distance:e} from {what} {number}, across what is outside the domain"
                )
            }
            Self::MarkersHidden { count, first: [hidden, shown] } => {
                write!(
                    f,
                    "{count} segments overlap earlier ones with another marker, which counts there; the first is {hidden}, on {shown}"
                )
            }
            Self::NotConforming { pieces } => {
                write!(f, "{pieces} pieces of segments were put in whole, as the limits left no room to split them")
            }
            Self::InsideLeftOut { points, segments } => {
                write!(
                    f,
                    "the corners of the domain are triangulated alone: {points} points and {segments} subsegments \
                     inside are left out"
                )
            }
            Self::IdleHole { seed, at } => {
                write!(f, "hole seed {seed} at {at} has no effect: it lies outside, or in another hole")
            }
            Self::IdleRegion { seed, at } => {
                write!(f, "region seed {seed} at {at} has no effect: it lies outside the domain")
            }
            Self::RegionTwice { seeds: [a, b] } => {
                write!(f, "region seeds {a} and {b} lie in one region; the first counts")
            }
            Self::Crossings { vertices } => write!(f, "crossing segments were split at {vertices} new vertices"),
            Self::Rejoined { chains, subsegments } => {
                write!(
                    f,
                    "{subsegments} subsegments go straight on and were joined into {chains} chains; the drawing would tell which belong together"
                )
            }
            Self::NotInDrawing { subsegments } => {
                write!(f, "{subsegments} subsegments inside the mesh lie on no segment of the drawing; they are kept")
            }
            Self::RegionBoundaries { edges } => {
                write!(
                    f,
                    "{edges} edges part triangles with different attributes and are kept, though they are not listed as segments"
                )
            }
            Self::Pieces { pieces } => write!(f, "the mesh falls into {pieces} pieces that share no edge"),
            Self::Flipped { flips } => {
                write!(f, "the mesh was not constrained Delaunay: it took {flips} flips to make it so")
            }
        }
    }
}
