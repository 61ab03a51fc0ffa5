//! Domains: planar straight-line graphs, contours, holes, and what is kept of a triangulation.
//!
//! A [`Pslg`] is what a caller or a file says. [`build()`] triangulates it and carves away what the
//! [`DomainRule`] puts outside:
//!
//! | rule | kept |
//! |---|---|
//! | `seeds` | what cannot be reached from outside the hull or from a hole seed without crossing a segment |
//! | `nesting` | what lies behind an odd number of segments, counted from outside |
//! | `hull` | the convex hull, but what hole seeds reach |
//!
//! [`Contours`] names an outer ring and hole rings instead, by orientation.

mod attributes;
mod build;
mod carve;
mod contours;
mod crowded;
mod error;
mod flood;
mod indexed;
mod pslg;
mod regions;
#[cfg(test)]
mod tests;

pub use build::{DomainRule, build, triangulate};
pub use contours::Contours;
pub use error::{DomainError, OpenEnd, Warning};
pub use pslg::{Pslg, Region};
