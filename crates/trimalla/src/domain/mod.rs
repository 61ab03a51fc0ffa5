//! Domains: planar straight-line graphs, contours, holes, and what is kept of a triangulation.
//!
//! A [`Pslg`](crate::drawing::Pslg) is an unchecked drawing. [`build()`] triangulates it and carves away what
//! the [`DomainRule`] puts outside:
//!
//! | rule | kept |
//! |---|---|
//! | `seeds` | what cannot be reached from outside the hull or from a hole seed without crossing a segment |
//! | `nesting` | what lies behind an odd number of segments, counted from outside, without what hole seeds reach |
//! | `hull` | the convex hull, without what hole seeds reach |
//!
//! [`from_mesh()`] takes up a mesh that exists, triangle by triangle, and finds its segments again.
//!
//! [`Contours`] names an outer ring and hole rings instead, by orientation.

mod attributes;
mod build;
mod chains;
mod contours;
mod course;
mod error;
mod flood;
mod from_mesh;
mod given;
mod indexed;
mod left_out;
mod mesh_error;
mod near_misses;
mod parity;
mod regions;
mod seeds;
mod shells;
#[cfg(test)]
mod tests;

pub(crate) use build::build_conforming;
pub use build::{DomainRule, build, build_exactly, carve_exactly, triangulate};
pub use contours::{ContourOrder, Contours};
pub(crate) use course::{Adjacency, Course, Courses, Leg};
pub use error::{DomainError, NearFeature, OpenEnd, Warning};
pub use from_mesh::{FromMesh, from_mesh};
pub use given::{Given, GivenAreas};
pub use mesh_error::MeshError;
