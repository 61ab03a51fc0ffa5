//! Triangulations of polygons with holes; visibility and guards.
//!
//! Every algorithm takes a [`Polygon`], and returns triangles as triples of indices, each counter-clockwise by the
//! exact test. [`PolygonMethod`] chooses one by its key.

mod adjacency;
mod angles;
mod corners;
mod diagonals;
mod ears;
mod error;
mod gallery;
mod method;
mod monotone;
mod rings;
mod seidel;
mod stack;
mod sweep;
mod triangulator;
mod visibility;
mod visible;
mod visible_pairs;
mod walks;

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
