//! The algorithms of the lecture notes: slow oracles beside them, and two algorithms beside each other.

mod enumerate;
mod gallery;
mod interpolate;
mod optimal;
mod points;
mod polygon_cases;
mod polygon_files;
mod polygons;
mod segments;
mod seidel;
mod small;
mod voronoi;
mod weight;
