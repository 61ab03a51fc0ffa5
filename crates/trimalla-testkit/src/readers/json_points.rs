//! JSON points: `[[x, y], …]`, and what other JSON readers share.

use std::path::Path;

use serde_json::Value;
use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

use super::text_of;

/// Reads `[[x, y], …]`.
#[must_use]
pub fn read_json_points(path: &Path) -> Pslg {
    let json = json_of(path);
    let list = json.as_array().unwrap_or_else(|| panic!("{} is no list", path.display()));
    Pslg { points: list.iter().map(point_of).collect(), ..Pslg::default() }
}

/// The whole file as JSON.
pub(super) fn json_of(path: &Path) -> Value {
    serde_json::from_str(&text_of(path)).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// `[x, y, …]` as a point; further coordinates are dropped.
pub(super) fn point_of(pair: &Value) -> Point {
    let at = |k: usize| pair[k].as_f64().unwrap_or_else(|| panic!("{pair} is no point"));
    Point::new(at(0), at(1))
}
