//! Triangulations of points and polygons that are best by some criterion, and greedy ones.
//!
//! [`OptimalMethod`] chooses an algorithm by its key.

mod error;
mod method;

pub use error::OptimalError;
pub use method::OptimalMethod;
