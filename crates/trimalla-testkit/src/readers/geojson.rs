//! `GeoJSON`: every geometry of a file together, all rings as segments.

use std::path::Path;

use serde_json::Value;
use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

use super::json_points::{json_of, point_of};
use super::rings::{push_chain, push_ring};

/// Reads a `FeatureCollection`, a `Feature` or a geometry; says whether all segments belong to
/// polygons.
#[must_use]
pub fn read_geojson(path: &Path) -> (Pslg, bool) {
    let mut reader = Reader::default();
    reader.add(&json_of(path));
    let areas = reader.polygons > 0 && reader.lines == 0;
    (reader.pslg, areas)
}

/// What was read so far.
#[derive(Default)]
struct Reader {
    /// Points and segments.
    pslg: Pslg,
    /// Number of polygons.
    polygons: usize,
    /// Number of open lines.
    lines: usize,
}

impl Reader {
    /// Adds an object of any type.
    fn add(&mut self, object: &Value) {
        let coordinates = &object["coordinates"];
        match object["type"].as_str() {
            Some("FeatureCollection") => items(&object["features"]).for_each(|f| self.add(f)),
            Some("GeometryCollection") => items(&object["geometries"]).for_each(|g| self.add(g)),
            Some("Feature") => self.add(&object["geometry"]),
            Some("Point") => self.pslg.points.push(point_of(coordinates)),
            Some("MultiPoint") => self.pslg.points.extend(items(coordinates).map(point_of)),
            Some("LineString") => self.add_line(coordinates),
            Some("MultiLineString") => items(coordinates).for_each(|l| self.add_line(l)),
            Some("Polygon") => self.add_polygon(coordinates),
            Some("MultiPolygon") => items(coordinates).for_each(|p| self.add_polygon(p)),
            _ if object.is_null() => {}
            other => panic!("unknown GeoJSON type {other:?}"),
        }
    }

    /// Adds an open line.
    fn add_line(&mut self, line: &Value) {
        let chain: Vec<Point> = items(line).map(point_of).collect();
        push_chain(&mut self.pslg, &chain);
        self.lines += 1;
    }

    /// Adds all rings of a polygon.
    fn add_polygon(&mut self, polygon: &Value) {
        for ring in items(polygon) {
            let ring: Vec<Point> = items(ring).map(point_of).collect();
            push_ring(&mut self.pslg, &ring);
        }
        self.polygons += 1;
    }
}

/// The items of a list.
fn items(list: &Value) -> impl Iterator<Item = &Value> {
    list.as_array().unwrap_or_else(|| panic!("{list} is no list")).iter()
}
