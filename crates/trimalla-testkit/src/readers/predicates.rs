//! Orientation signs checked by others.

use std::path::Path;

use trimalla::geometry::Point;

use super::{number, text_of};

/// Three points and the sign of their orientation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrientCase {
    /// The three points.
    pub points: [Point; 3],
    /// 1 counter-clockwise, −1 clockwise, 0 collinear.
    pub sign: i32,
}

/// Reads lines `id ax ay bx by cx cy sign`.
#[must_use]
pub fn read_orient_cases(path: &Path) -> Vec<OrientCase> {
    let case = |line: &str| {
        let tokens: Vec<&str> = line.split_whitespace().collect();
        let at = |k: usize| Point::new(number(tokens[k]), number(tokens[k + 1]));
        let sign = tokens[7].parse().unwrap_or_else(|e| panic!("{line:?} has no sign: {e}"));
        OrientCase { points: [at(1), at(3), at(5)], sign }
    };
    text_of(path).lines().filter(|l| !l.trim().is_empty()).map(case).collect()
}
