//! Shapefiles: shapes of maps, and the table of their properties beside.
//!
//! Read here and not by a crate: the one there is allocates what a damaged count says.

use trimalla::geometry::{Point, Ring};

use super::sketch::{Fill, Kind, Path, Sketch, Vertex, fault_in};
use crate::error::IoError;

/// The bytes before the first record.
const HEADER: usize = 100;

/// Reads a file; `table` is the content of its `.dbf` file.
pub(super) fn read(bytes: &[u8], name: &str, table: Option<&[u8]>, property: Option<&str>) -> Result<Sketch, IoError> {
    let fault = |number, message: &str| fault_in(name, "record", number, message);
    if bytes.len() < HEADER || big(bytes, 0) != Some(9994) {
        return Err(fault_in(name, "", 0, "expected a shapefile, which begins with the number 9994"));
    }
    let column = property
        .map(|property| column(table, property).map_err(|message| fault_in(name, "", 0, message)))
        .transpose()?;
    let layer_noun = property.map_or_else(|| "record".to_owned(), |property| format!("column {property}"));
    let mut sketch = Sketch::new("record", layer_noun);
    let (mut at, mut number) = (HEADER, 0_u64);
    while at + 8 <= bytes.len() {
        number += 1;
        let length = big(bytes, at + 4).and_then(|words| usize::try_from(words).ok()).map(|words| words * 2);
        let content = length.and_then(|length| bytes.get(at + 8..(at + 8).checked_add(length)?));
        let content =
            content.ok_or_else(|| fault(number, "expected content within the file, found a length beyond its end"))?;
        at += 8 + content.len();
        let layer = match &column {
            Some(values) => values.get(number as usize - 1).cloned().unwrap_or_default(),
            None => format!("record {number}"),
        };
        add(&mut sketch, content, &layer, number as u32)
            .ok_or_else(|| fault(number, "expected content as long as its counts say, found less"))?;
    }
    Ok(sketch)
}

/// Adds a record's shape; `None` if it is too short.
fn add(sketch: &mut Sketch, content: &[u8], layer: &str, number: u32) -> Option<()> {
    let kind = little(content, 0)?;
    match kind {
        0 => sketch.skipped.add("records without a shape", number),
        1 | 11 | 21 => {
            let vertex = Vertex { z: if kind == 11 { double(content, 20)? } else { f64::NAN }, ..vertex(content, 4)? };
            let layer = sketch.layers.number(layer);
            sketch.add(Kind::Points, layer, number, vec![Path::new(vertex)]);
        }
        8 | 18 | 28 => {
            let count = count(content, 36, 16)?;
            let vertices = vertices(content, 40, count, kind == 18)?;
            let layer = sketch.layers.number(layer);
            sketch.add(Kind::Points, layer, number, Path::of(vertices, false).into_iter().collect());
        }
        3 | 13 | 23 | 5 | 15 | 25 => {
            let is_polygon = matches!(kind, 5 | 15 | 25);
            let parts = parts(content, kind / 10 == 1)?;
            let layer = sketch.layers.number(layer);
            let path = |part: Vec<Vertex>| Path::of(part, is_polygon);
            if is_polygon {
                for polygon in polygons(parts) {
                    sketch.add(
                        Kind::Area(Fill::EvenOdd),
                        layer,
                        number,
                        polygon.into_iter().filter_map(path).collect(),
                    );
                }
            } else {
                sketch.add(Kind::Lines, layer, number, parts.into_iter().filter_map(path).collect());
            }
        }
        31 => sketch.skipped.add("multipatches", number),
        _ => sketch.skipped.add("records of an unknown type", number),
    }
    Some(())
}

/// The parts of a line or polygon.
fn parts(content: &[u8], has_heights: bool) -> Option<Vec<Vec<Vertex>>> {
    let (parts, points) = (count(content, 36, 4)?, count(content, 40, 16)?);
    let first = 44 + 4 * parts;
    let vertices = vertices(content, first, points, has_heights)?;
    let starts: Option<Vec<usize>> = (0..parts).map(|i| usize::try_from(little(content, 44 + 4 * i)?).ok()).collect();
    let starts = starts?;
    let ends = starts.iter().skip(1).copied().chain([points]);
    starts.iter().zip(ends).map(|(&from, to)| vertices.get(from..to).map(<[Vertex]>::to_vec)).collect()
}

/// The polygons of a record: lists of rings. Holes, which run counter-clockwise, go with all outer rings of the record;
/// with which of them does not matter, as they do not overlap.
fn polygons(parts: Vec<Vec<Vertex>>) -> Vec<Vec<Vec<Vertex>>> {
    let is_hole = |part: &[Vertex]| {
        let corners: Vec<Point> = part.iter().map(|v| v.at).collect();
        Ring::new(&corners).signed_area() > 0.0
    };
    let (holes, outer): (Vec<_>, Vec<_>) = parts.into_iter().partition(|part| is_hole(part));
    if holes.is_empty() {
        outer.into_iter().map(|ring| vec![ring]).collect()
    } else {
        vec![outer.into_iter().chain(holes).collect()]
    }
}

/// Points from a place on, and their heights after them.
fn vertices(content: &[u8], first: usize, count: usize, has_heights: bool) -> Option<Vec<Vertex>> {
    let heights = first + 16 * count + 16;
    let one = |i: usize| {
        let z = if has_heights { double(content, heights + 8 * i)? } else { f64::NAN };
        Some(Vertex { z, ..vertex(content, first + 16 * i)? })
    };
    content.get(first..first.checked_add(16 * count)?)?;
    (0..count).map(one).collect()
}

/// A count, no larger than entries of so many bytes leave room for.
fn count(content: &[u8], at: usize, bytes_each: usize) -> Option<usize> {
    usize::try_from(little(content, at)?).ok().filter(|count| *count <= content.len() / bytes_each)
}

fn vertex(bytes: &[u8], at: usize) -> Option<Vertex> {
    Some(Vertex::flat(double(bytes, at)?, double(bytes, at + 8)?))
}

fn big(bytes: &[u8], at: usize) -> Option<i32> {
    Some(i32::from_be_bytes(bytes.get(at..at + 4)?.try_into().ok()?))
}

fn little(bytes: &[u8], at: usize) -> Option<i32> {
    Some(i32::from_le_bytes(bytes.get(at..at + 4)?.try_into().ok()?))
}

pub(super) fn double(bytes: &[u8], at: usize) -> Option<f64> {
    Some(f64::from_le_bytes(bytes.get(at..at.checked_add(8)?)?.try_into().ok()?))
}

/// The values of a column of a table, a text for each record.
fn column(table: Option<&[u8]>, property: &str) -> Result<Vec<String>, String> {
    let table = table.ok_or("expected a .dbf file beside it, for the property")?;
    let short = "the .dbf file beside is shorter than its header says";
    let number = |at: usize| table.get(at..at + 2).map(|b| usize::from(u16::from_le_bytes([b[0], b[1]]))).ok_or(short);
    let (start, width) = (number(8)?, number(10)?);
    let mut offset = 1;
    let mut names = Vec::new();
    let mut found = None;
    for field in table.get(32..start).ok_or(short)?.chunks_exact(32) {
        if field[0] == 0x0d {
            break;
        }
        let name = field[..11].split(|b| *b == 0).next().unwrap_or_default();
        let length = usize::from(field[16]);
        if name.eq_ignore_ascii_case(property.as_bytes()) && found.is_none() {
            found = Some((offset, length));
        }
        names.push(String::from_utf8_lossy(name).into_owned());
        offset += length;
    }
    let Some((offset, length)) = found else {
        return Err(format!(
            "expected a column '{}' of the .dbf file beside, found {}",
            property.escape_debug(),
            names.join(", ").escape_debug()
        ));
    };
    let rows = table.get(start..).ok_or(short)?.chunks_exact(width.max(1));
    let value = |row: &[u8]| row.get(offset..offset + length).map(|v| String::from_utf8_lossy(v).trim().to_owned());
    rows.map(|row| value(row).ok_or_else(|| short.to_owned())).collect()
}
