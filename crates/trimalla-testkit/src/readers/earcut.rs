//! Earcut JSON: a list of rings, the first the outline, the others holes; a one-point hole is a
//! Steiner point.

use std::path::Path;

use serde_json::Value;
use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

use super::json_points::{json_of, point_of};
use super::rings::push_ring;

/// The rings as listed, closing points too.
#[must_use]
pub fn earcut_rings(path: &Path) -> Vec<Vec<Point>> {
    let list = |v: &Value| v.as_array().unwrap_or_else(|| panic!("{v} is no list")).clone();
    list(&json_of(path)).iter().map(|ring| list(ring).iter().map(point_of).collect()).collect()
}

/// All rings as segments.
#[must_use]
pub fn read_earcut(path: &Path) -> Pslg {
    let mut pslg = Pslg::default();
    for ring in earcut_rings(path) {
        push_ring(&mut pslg, &ring);
    }
    pslg
}
