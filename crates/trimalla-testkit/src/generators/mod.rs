//! Hostile inputs made from a seed: the same kind, size and seed give the same bits on every
//! platform.
//!
//! [`point_set`] and [`pslg`] make one input of a kind; [`PointSetKind::ALL`] and [`PslgKind::ALL`]
//! list the kinds. The numbers in the descriptions (A07, B18, …) are those of the catalogue of
//! nasty inputs in the shared `reliability.md`. [`rotated`], [`moved`], [`noisy`], [`resampled`]
//! make further inputs from given ones.

mod points;
mod polygons;
mod pslgs;
mod rng;
mod soups;
mod transform;

pub use points::{PointSetKind, next_down, next_up, point_set};
pub use pslgs::{PslgKind, pslg};
pub use rng::SplitMix64;
pub use transform::{moved, moved_to_utm, noisy, permuted, resampled, rotated, scaled};
