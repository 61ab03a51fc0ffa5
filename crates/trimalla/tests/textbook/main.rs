//! The algorithms of the lecture notes: slow oracles beside them, and two algorithms beside each other.

mod enumerate;
mod gallery;
mod interpolate;
mod lone_points;
mod optimal;
mod points;
mod polygon_cases;
mod polygon_files;
mod polygons;
mod random_rings;
mod rationals;
mod segments;
mod seidel;
mod small;
mod voronoi;
mod weight;

/// Is cancelled from the start.
struct Cancelled;

impl trimalla::trace::Trace for Cancelled {
    fn step(&mut self, _: trimalla::trace::Step) {}

    fn is_cancelled(&self) -> bool {
        true
    }
}
