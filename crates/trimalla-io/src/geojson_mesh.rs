//! `.geojson`: the triangles of a mesh as features for maps and databases. Written only.
//!
//! Each triangle is a feature with a polygon whose ring runs counter-clockwise and ends where it begins. Its properties
//! are `triangle`, its number as in the other outputs of the run, and `region`, its first attribute, `null` where it
//! has none, and `name` where the region has a name. Where vertices have attributes, the first is the third coordinate.
//! Coordinates are written as they are; readers take them for degrees of longitude and latitude unless told otherwise.
//!
//! # Source
//! RFC 7946.

use std::io::{self, Write};

use trimalla::drawing::IndexedMesh;

use crate::columns::{Points, check_triangles};
use crate::names::GroupNames;
use crate::numbers::Real;
use crate::surface::place;

/// Writes a mesh whose first triangle has the number `first_index`.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh, names: &GroupNames, first_index: u32) -> io::Result<()> {
    Points::of_mesh(mesh).check(first_index)?;
    check_triangles(mesh)?;
    let has_heights = mesh.attributes_per_point > 0;
    let position = |v: u32| {
        let [x, y, z] = place(mesh, v as usize);
        if has_heights {
            format!("[{},{},{}]", Real(x), Real(y), Real(z))
        } else {
            format!("[{},{}]", Real(x), Real(y))
        }
    };
    writeln!(out, "{{\"type\":\"FeatureCollection\",\"features\":[")?;
    let width = mesh.attributes_per_triangle;
    for (t, &[a, b, c]) in mesh.triangles.iter().enumerate() {
        let region = (width > 0).then(|| mesh.triangle_attributes[t * width]);
        let shown = region.map_or_else(|| "null".to_owned(), |value| Real(value).to_string());
        let name = region.and_then(|value| names.region(value));
        let name = name.map_or_else(String::new, |name| format!(",\"name\":{}", quoted(name)));
        let ring = [a, b, c, a].map(position).join(",");
        let comma = if t + 1 < mesh.triangles.len() { "," } else { "" };
        writeln!(
            out,
            "{{\"type\":\"Feature\",\"properties\":{{\"triangle\":{},\"region\":{shown}{name}}},\"geometry\":{{\"type\":\"Polygon\",\"coordinates\":[[{ring}]]}}}}{comma}",
            t as u64 + u64::from(first_index),
        )?;
    }
    writeln!(out, "]}}")
}

/// A text as a string of JSON.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => quoted.push_str(&format!("\\u{:04x}", u32::from(c))),
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}
