//! The Voronoi diagram, dual of the Delaunay triangulation.
