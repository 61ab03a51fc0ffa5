//! Planar triangulation and quality mesh refinement.
pub mod domain;
pub mod geometry;
pub mod mesh;
pub mod triangulation;
