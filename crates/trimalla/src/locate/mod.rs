//! Point location: the remembering visibility walk.
//!
//! From a face the walk crosses the first edge that has the point strictly on its other side, and never goes back over
//! the edge by which it came. On a Delaunay triangulation it ends `[DevillersPionTeillaud02]`; on others it might
//! circle, so after a while it draws the edge that it tests first from a fixed sequence, and after a bounded number of
//! steps it tests every face: it always ends, with the right answer. The steps are taken in floating-point arithmetic,
//! and the last face is proved. Where the proof fails, since the point lies on an edge or too near to one, the exact
//! walk goes on from there.

mod float_walk;
mod walk;

pub use walk::{Locus, Walk};
