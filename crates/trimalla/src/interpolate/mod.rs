//! Values at points of a triangulation, from values at its vertices.
