//! Planar triangulation and quality mesh refinement.
pub mod constrained;
pub mod delaunay;
pub mod domain;
mod facade;
pub mod geometry;
pub mod locate;
pub mod mesh;
pub mod refine;
pub mod quality;
pub mod triangulation;

pub use facade::{DomainOptions, Error, MeshOptions, Meshed, mesh, mesh_with, triangulate};
