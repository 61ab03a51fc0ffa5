//! Domains: planar straight-line graphs, contours, holes and what is kept of them.
mod pslg;
pub use pslg::{Pslg, Region};
