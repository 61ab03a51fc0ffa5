//! What is wrong with a drawing by itself.

use crate::geometry::Point;

/// What is wrong with the columns or seeds of a drawing.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DrawingError {
    /// A column has the wrong length.
    #[error("{what} has {found} entries where {expected} are needed")]
    Column {
        /// The column.
        what: &'static str,
        /// Its length.
        found: usize,
        /// The length needed.
        expected: usize,
    },
    /// A seed is not finite.
    #[error("{what} seed {seed} is not finite: {at}")]
    SeedNotFinite {
        /// `hole` or `region`.
        what: &'static str,
        /// Index of the seed.
        seed: usize,
        /// The seed.
        at: Point,
    },
}
