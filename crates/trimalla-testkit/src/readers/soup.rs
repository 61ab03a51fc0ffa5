//! Triangle soup: `x1 y1 x2 y2 x3 y3` a line (seed 002).

use std::path::Path;

use trimalla::geometry::Point;

use super::{number, text_of};

/// Reads the corners of each triangle as listed; nothing is joined.
#[must_use]
pub fn read_triangle_soup(path: &Path) -> Vec<[Point; 3]> {
    let triangle = |line: &str| {
        let v: Vec<f64> = line.split_whitespace().map(number).collect();
        assert!(v.len() == 6, "{line:?} is no triangle");
        [0, 2, 4].map(|k| Point::new(v[k], v[k + 1]))
    };
    text_of(path).lines().filter(|l| !l.trim().is_empty()).map(triangle).collect()
}
