//! Drawings and meshes as plain arrays: the input and output of callers and files.
//!
//! A [`Pslg`] is a drawing: points, segments between them, hole and region seeds. An [`IndexedMesh`] is a mesh.
//! Neither is checked before it is used, and neither needs a triangulation.

mod error;
#[cfg(feature = "geo-types")]
mod from_geo;
mod indexed;
mod outlines;
mod pslg;
mod rings;
mod segment_id;
mod sides;

pub use error::DrawingError;
pub use indexed::IndexedMesh;
pub use outlines::Outline;
pub use pslg::{Pslg, Region};
pub use segment_id::SegmentId;
pub(crate) use sides::{Side, Sides, is_sound};
