//! Triangulations of polygons with holes; visibility and guards.
//!
//! Every algorithm takes a [`Polygon`], and returns triangles as triples of indices, each counter-clockwise by the
//! exact test. [`PolygonMethod`] chooses one by its key.

mod angles;
mod corners;
mod diagonals;
mod ears;
mod error;
mod method;
mod monotone;
mod rings;
mod seidel;
mod stack;
mod sweep;
mod triangulator;
mod walks;

pub use ears::ears;
mod visible_pairs;

pub use diagonals::diagonals;
pub use error::PolygonError;
pub use method::PolygonMethod;
pub use monotone::{
    Diagonal, MonotonePieces, Monotonicity, chain_monotonicity, monotone, monotone_pieces, ring_monotonicity,
    triangulate_monotone,
};
pub use rings::Polygon;
pub use seidel::{Chord, Trapezoid, TrapezoidMap, seidel};
pub use sweep::{Cause, VertexKind};
pub use triangulator::Triangulator;
pub use visible_pairs::{visible_pairs, visible_pairs_of_graph};
