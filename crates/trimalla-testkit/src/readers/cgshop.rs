//! CG:SHOP 2025 instances: integer points, an outline by indices, constraints inside.

use std::path::Path;

use serde_json::Value;
use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

use super::json_points::json_of;

/// Reads an instance: the outline's segments first, then the constraints.
#[must_use]
pub fn read_cgshop(path: &Path) -> Pslg {
    let json = json_of(path);
    let list = |key: &str| json[key].as_array().unwrap_or_else(|| panic!("{} has no {key}", path.display()));
    let number = |v: &Value| v.as_f64().unwrap_or_else(|| panic!("{v} is no number"));
    let index = |v: &Value| v.as_u64().and_then(|i| u32::try_from(i).ok()).unwrap_or_else(|| panic!("{v} is no index"));
    let pairs = list("points_x").iter().zip(list("points_y"));
    let points = pairs.map(|(x, y)| Point::new(number(x), number(y))).collect();
    let outline: Vec<u32> = list("region_boundary").iter().map(index).collect();
    let next = outline.iter().cycle().skip(1);
    let sides = outline.iter().zip(next).map(|(&a, &b)| [a, b]);
    let inner = list("additional_constraints").iter().map(|s| [index(&s[0]), index(&s[1])]);
    Pslg { points, segments: sides.chain(inner).collect(), ..Pslg::default() }
}
