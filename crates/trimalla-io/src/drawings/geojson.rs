//! `GeoJSON`: features with geometries, as RFC 7946 describes them.

use std::fmt;

use serde::Deserialize;
use serde::de::{Deserializer, Error as _, IgnoredAny, SeqAccess, Visitor};
use serde_json::value::RawValue;
use trimalla::geometry::Point;

use super::sketch::{Fill, Kind, Path, Sketch, Vertex, fault_at, fault_in};
use crate::error::IoError;

/// Any object of a file; which of its members count depends on its type.
#[derive(Deserialize)]
struct Object<'a> {
    #[serde(rename = "type", default)]
    kind: Option<String>,
    #[serde(default)]
    coordinates: Option<Coordinates>,
    #[serde(borrow, default)]
    geometries: Option<Vec<Self>>,
    #[serde(borrow, default)]
    geometry: Option<Box<Self>>,
    #[serde(borrow, default)]
    features: Option<Vec<Self>>,
    #[serde(borrow, default)]
    properties: Option<&'a RawValue>,
}

/// Nested lists of positions.
enum Coordinates {
    Position(Vertex),
    List(Vec<Self>),
}

impl<'de> Deserialize<'de> for Coordinates {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(CoordinatesVisitor)
    }
}

/// An entry of a list: a number, or a list in it.
enum Entry {
    Number(f64),
    Inner(Coordinates),
}

impl<'de> Deserialize<'de> for Entry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(EntryVisitor)
    }
}

struct EntryVisitor;

impl<'de> Visitor<'de> for EntryVisitor {
    type Value = Entry;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a coordinate or a list of positions")
    }

    fn visit_f64<E>(self, value: f64) -> Result<Entry, E> {
        Ok(Entry::Number(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Entry, E> {
        Ok(Entry::Number(value as f64))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Entry, E> {
        Ok(Entry::Number(value as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Entry, A::Error> {
        CoordinatesVisitor.visit_seq(list).map(Entry::Inner)
    }
}

struct CoordinatesVisitor;

impl<'de> Visitor<'de> for CoordinatesVisitor {
    type Value = Coordinates;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of positions")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Coordinates, A::Error> {
        let Some(first) = list.next_element()? else { return Ok(Coordinates::List(Vec::new())) };
        match first {
            Entry::Number(x) => {
                let Some(y) = list.next_element::<f64>()? else {
                    return Err(A::Error::custom("expected a y coordinate, found the end of the position"));
                };
                let z = list.next_element::<f64>()?.unwrap_or(f64::NAN);
                while list.next_element::<IgnoredAny>()?.is_some() {}
                Ok(Coordinates::Position(Vertex { at: Point::new(x, y), z }))
            }
            Entry::Inner(first) => {
                let mut entries = vec![first];
                while let Some(next) = list.next_element()? {
                    entries.push(next);
                }
                Ok(Coordinates::List(entries))
            }
        }
    }
}

/// Reads a file.
pub(super) fn read(bytes: &[u8], name: &str, property: Option<&str>) -> Result<Sketch, IoError> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let object: Object<'_> = serde_json::from_slice(bytes).map_err(|error| {
        let text = error.to_string();
        let cause = text.split(" at line ").next().unwrap_or_default().to_owned();
        fault_at(name, error.line() as u64, error.column() as u64, "GeoJSON", cause)
    })?;
    let layer_noun = property.map_or_else(|| "feature".to_owned(), |property| format!("property {property}"));
    let mut reader = Reader { sketch: Sketch::new("feature", layer_noun), name, property, number: 0 };
    reader.any(&object)?;
    Ok(reader.sketch)
}

struct Reader<'a> {
    sketch: Sketch,
    name: &'a str,
    property: Option<&'a str>,
    /// The number of the feature, counted from 1.
    number: u32,
}

impl Reader<'_> {
    fn any(&mut self, object: &Object<'_>) -> Result<(), IoError> {
        match object.kind.as_deref() {
            Some("FeatureCollection") => {
                let features =
                    object.features.as_deref().ok_or_else(|| self.fault("expected a list of features, found none"))?;
                features.iter().try_for_each(|feature| self.feature(feature))
            }
            _ => self.feature(object),
        }
    }

    fn feature(&mut self, object: &Object<'_>) -> Result<(), IoError> {
        self.number += 1;
        let layer = match self.property {
            Some(property) => value_of(object.properties, property),
            None => format!("feature {}", self.number),
        };
        match (object.kind.as_deref(), &object.geometry) {
            (Some("Feature"), Some(geometry)) => self.geometry(geometry, &layer),
            (Some("Feature"), None) => {
                self.sketch.skipped.add("features without a geometry", self.number);
                Ok(())
            }
            _ => self.geometry(object, &layer),
        }
    }

    fn geometry(&mut self, object: &Object<'_>, layer: &str) -> Result<(), IoError> {
        let kind = object.kind.as_deref().unwrap_or_default();
        if kind == "GeometryCollection" {
            let all = object.geometries.as_deref().unwrap_or_default();
            return all.iter().try_for_each(|geometry| self.geometry(geometry, layer));
        }
        let Some(given) = &object.coordinates else {
            return Err(
                self.fault(format!("expected coordinates of a geometry, found none in '{}'", kind.escape_default()))
            );
        };
        let closed = |rings: Vec<Vec<Vertex>>, is_closed| {
            rings.into_iter().filter_map(|ring| Path::of(ring, is_closed)).collect::<Vec<_>>()
        };
        let (kind, shapes) = match kind {
            "Point" => (Kind::Points, vec![closed(vec![self.point(given)?], false)]),
            "MultiPoint" => (Kind::Points, vec![closed(vec![self.positions(given)?], false)]),
            "LineString" => (Kind::Lines, vec![closed(vec![self.positions(given)?], false)]),
            "MultiLineString" => (Kind::Lines, vec![closed(self.rings(given)?, false)]),
            "Polygon" => (Kind::Area(Fill::EvenOdd), vec![closed(self.rings(given)?, true)]),
            "MultiPolygon" => {
                let polygons = self.entries(given)?.iter().map(|polygon| Ok(closed(self.rings(polygon)?, true)));
                (Kind::Area(Fill::EvenOdd), polygons.collect::<Result<Vec<_>, IoError>>()?)
            }
            other => {
                return Err(self.fault(format!(
                    "expected the type of a geometry, such as Polygon, found '{}'",
                    other.escape_default()
                )));
            }
        };
        let layer = self.sketch.layers.number(layer);
        shapes.into_iter().for_each(|paths| self.sketch.add(kind, layer, self.number, paths));
        Ok(())
    }

    /// The entries of a list.
    fn entries<'c>(&self, given: &'c Coordinates) -> Result<&'c [Coordinates], IoError> {
        match given {
            Coordinates::List(entries) => Ok(entries),
            Coordinates::Position(at) => {
                Err(self.fault(format!("expected a list of positions, found the position {}", at.at)))
            }
        }
    }

    fn rings(&self, given: &Coordinates) -> Result<Vec<Vec<Vertex>>, IoError> {
        self.entries(given)?.iter().map(|ring| self.positions(ring)).collect()
    }

    fn positions(&self, given: &Coordinates) -> Result<Vec<Vertex>, IoError> {
        let position = |entry: &Coordinates| match entry {
            Coordinates::Position(vertex) => Ok(*vertex),
            Coordinates::List(_) => {
                Err(self.fault("expected a position of two or three numbers, found a list in a list"))
            }
        };
        self.entries(given)?.iter().map(position).collect()
    }

    /// One position, or none where the list is empty.
    fn point(&self, given: &Coordinates) -> Result<Vec<Vertex>, IoError> {
        match given {
            Coordinates::Position(vertex) => Ok(vec![*vertex]),
            Coordinates::List(entries) if entries.is_empty() => Ok(Vec::new()),
            Coordinates::List(_) => Err(self.fault("expected one position, found a list of them")),
        }
    }

    fn fault(&self, message: impl Into<String>) -> IoError {
        fault_in(self.name, "feature", u64::from(self.number), message)
    }
}

/// The value of a property as text; empty where there is none.
fn value_of(properties: Option<&RawValue>, property: &str) -> String {
    let parsed = properties.and_then(|raw| serde_json::from_str::<serde_json::Map<_, _>>(raw.get()).ok());
    match parsed.as_ref().and_then(|map| map.get(property)) {
        Some(serde_json::Value::String(text)) => text.clone(),
        Some(serde_json::Value::Null) | None => String::new(),
        Some(other) => other.to_string(),
    }
}
