//! Lines `x y`.

use std::path::Path;

use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

use super::{number, text_of};

/// Reads a point a line, blank lines skipped.
#[must_use]
pub fn read_xy(path: &Path) -> Pslg {
    let point = |line: &str| {
        let mut tokens = line.split_whitespace().map(number);
        Some(Point::new(tokens.next()?, tokens.next()?))
    };
    Pslg { points: text_of(path).lines().filter_map(point).collect(), ..Pslg::default() }
}
