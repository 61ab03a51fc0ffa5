//! Oracles: slow, obvious, exact answers to compare with those of the library.
//!
//! Everything is decided by signs of exact numbers. Where the answer would otherwise not be unique,
//! the tie rule of the library applies: a symbolic perturbation raises the lifted height of each
//! point, of lexicographically smaller points dominantly, so that of four cocircular points the
//! smallest is never on the diagonal.
//!
//! Triangulations are compared in **canonical form**: each triangle rotated so that its smallest
//! vertex id comes first, the list sorted ([`canonical`]).

mod area;
mod chains;
mod check;
mod constrained;
mod contacts;
mod delaunay;
mod euler;
mod exact;
mod hull;
mod sound;

pub use area::{RBig, covers_hull, doubled_area, doubled_ring_area};
pub use chains::chain_faults;
pub use check::{DelaunayRule, check_indexed, check_indexed_with};
pub use constrained::brute_force_cdt;
pub use contacts::{Contacts, contacts, crossing_pairs};
pub use delaunay::{brute_force_delaunay, canonical, in_circle_perturbed, representatives};
pub use euler::{Euler, euler};
pub use exact::{
    in_circle, in_circle_rational, in_circle_scaled, lexicographic, on_open_segment, orient, orient_rational,
    orient_scaled,
};
pub use hull::{convex_hull, convex_hull_size, delaunay_triangle_count};
pub use sound::{BESIDE_ULPS, Flaw, first_flaw};
