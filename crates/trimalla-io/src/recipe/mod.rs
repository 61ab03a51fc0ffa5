//! `.toml`: recipes of refinement, saved, loaded and compared.
//!
//! ```toml
//! name = "centroids, worst first"
//! preset = "lepp-centroid"          # the base; the keys below change it
//! select = "smallest-angle"
//! until-destroyed = true
//! protect = "none"
//!
//! [criteria]
//! min-angle = 33
//! max-area = 0.5
//! max-aspect-ratio = 2.0
//!
//! [limits]
//! max-vertices = 100000
//! length-floor = 0.001
//! ```
//!
//! Every key may be left out. A step that is not named is that of `preset`, and without one that of the default preset;
//! what is not said about criteria, limits and protection is left to whoever refines. Unknown keys and values are
//! errors that name the place and the keys or values that would do.

mod read;
mod write;

pub use read::{read, read_file, read_in};
pub use write::write;

#[cfg(test)]
mod tests;
