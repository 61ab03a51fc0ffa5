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

/// Triangles that can be compared: each from its smallest index on, sorted.
fn in_order(mut triangles: Vec<[u32; 3]>) -> Vec<[u32; 3]> {
    for t in &mut triangles {
        let first = (0..3).min_by_key(|&k| t[k]).unwrap_or(0);
        t.rotate_left(first);
    }
    triangles.sort_unstable();
    triangles
}
