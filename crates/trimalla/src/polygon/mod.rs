//! Triangulations of polygons with holes; visibility and guards.
//!
//! Every algorithm takes a [`Polygon`], and returns triangles as triples of indices, each counter-clockwise by the
//! exact test. [`PolygonMethod`] chooses one by its key; [`Triangulator`] is the fastest way, for one polygon and for
//! many.
//!
//! Every algorithm proves the polygon valid first: sides that cross or overlap, and holes that are not inside the
//! outline, are refused with the place. Rings may touch others and themselves in points. A hole of one point, as some
//! formats write points inside, is a corner of triangles for [`PolygonMethod`] and [`Triangulator`]; the functions of
//! single algorithms refuse it as flat. A hole of two points is refused by all.
//!
//! Chazelle's algorithm (`[Chazelle91]`) needs linear time. It is not built: as the notes say, it is too complicated to
//! be of use, and O(n log n) is near enough.

mod adjacency;
mod angles;
mod constrained_delaunay;
mod corners;
mod diagonals;
mod ears;
mod easy;
mod error;
mod few;
mod gallery;
mod lone_points;
mod loops;
mod method;
mod monotone;
mod proving_ears;
mod rings;
mod seidel;
mod stack;
mod sweep;
mod triangulator;
mod visibility;
mod visible;
mod visible_pairs;

pub use constrained_delaunay::constrained_delaunay;
pub use diagonals::diagonals;
pub use ears::ears;
pub use error::PolygonError;
pub use gallery::{Gallery, art_gallery};
pub use method::PolygonMethod;
pub use monotone::{
    Diagonal, MonotonePieces, Monotonicity, chain_monotonicity, monotone, monotone_pieces, ring_monotonicity,
    triangulate_monotone,
};
pub use rings::Polygon;
pub use seidel::{Chord, Trapezoid, TrapezoidMap, seidel};
pub use sweep::{Cause, VertexKind};
pub use triangulator::Triangulator;
pub use visibility::{SeenCorner, Visibility};
pub use visible::visible;
pub use visible_pairs::{visible_pairs, visible_pairs_of_graph};
