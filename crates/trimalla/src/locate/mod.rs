//! Point location: the remembering visibility walk.
//!
//! From a face the walk crosses the first edge that has the point strictly on its other side,
//! and never looks back at the edge it came in by. On a Delaunay triangulation it ends `[DevillersPionTeillaud02]`.
//! The way is found by sight, in rounded arithmetic; only the face at its end is proved. Where that cannot be done,
//! since the point lies on an edge or too near to one, the walk goes on from there, exact.
//! On others it might circle, so after a while the edge it looks at first is drawn by a
//! fixed sequence, and after a bounded number of steps every face is looked at: a walk always ends,
//! and with the right answer.

mod by_sight;
mod walk;

pub use walk::{Locus, Walk};
