//! Planar triangulation and quality mesh refinement.
pub mod delaunay;
pub mod domain;
pub mod geometry;
pub mod locate;
pub mod mesh;
pub mod quality;
pub mod triangulation;
