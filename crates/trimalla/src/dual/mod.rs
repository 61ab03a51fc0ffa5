//! The Voronoi diagram, dual of the Delaunay triangulation.
//!
//! [`Voronoi`] is the whole diagram, with unbounded cells. [`Voronoi::clipped_to`] cuts it to a domain, which may be
//! concave and have holes; the result is a [`ClippedVoronoi`], whose cells are polygons.
//!
//! | step | file |
//! |---|---|
//! | vertices, edges and cells, by exact signs | `voronoi.rs` |
//! | the part of an edge near a domain | `near.rs` |
//! | diagram and outline laid over each other | `overlay.rs` |
//! | cells as polygons | `clipped.rs` |

mod clipped;
mod error;
mod near;
mod overlay;
mod voronoi;

pub use clipped::{ClippedVoronoi, Piece};
pub use error::VoronoiError;
pub use voronoi::{CellSide, Voronoi, VoronoiEdge, VoronoiVertex};
