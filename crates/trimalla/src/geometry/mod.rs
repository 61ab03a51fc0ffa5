//! Coordinates without half-edges.
mod point;
pub use point::Point;
