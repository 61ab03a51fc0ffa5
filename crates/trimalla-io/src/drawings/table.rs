//! Points in columns: comma-separated values and `.xyz`.

use trimalla::geometry::Point;

use super::sketch::{Kind, Path, Sketch, Vertex, fault_at};
use crate::error::{IoError, quote};

/// Where x, y and the height stand in a row, counted from 0.
#[derive(Clone, Copy)]
struct Columns {
    x: usize,
    y: usize,
    z: Option<usize>,
}

/// Reads a file: a point a row, x and y and, where there is one, a height; further columns are left out.
///
/// Columns are separated by commas, semicolons, tabs or blanks, whichever the first row has; a row of names before the
/// numbers may say which columns are meant.
pub(super) fn read(bytes: &[u8], name: &str) -> Result<Sketch, IoError> {
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let mut sketch = Sketch::new("line", "file");
    let layer = sketch.layers.number("points");
    let mut separator = None;
    let mut columns = None;
    let mut points = Vec::new();
    for (index, row) in text.split(|&b| b == b'\n').enumerate() {
        let line = index as u64 + 1;
        let row = row.strip_suffix(b"\r").unwrap_or(row);
        let first = row.iter().position(|b| !b.is_ascii_whitespace());
        let Some(first) = first.filter(|&at| row[at] != b'#' && !row[at..].starts_with(b"//")) else { continue };
        let separator = *separator.get_or_insert_with(|| separator_of(&row[first..]));
        let fields = fields(row, separator);
        let known = match columns {
            Some(known) => known,
            None => match named(&fields) {
                Some(found) => {
                    columns = Some(found);
                    continue;
                }
                None => *columns.insert(Columns { x: 0, y: 1, z: (fields.len() > 2).then_some(2) }),
            },
        };
        let number = |column: usize, expected: &str| {
            let (offset, field) = fields.get(column).copied().unwrap_or((row.len(), b""));
            let value = std::str::from_utf8(field).ok().and_then(|t| t.parse::<f64>().ok()).filter(|v| v.is_finite());
            value.ok_or_else(|| {
                let found = if field.is_empty() { "nothing".to_owned() } else { quote(field) };
                fault_at(name, line, offset as u64 + 1, expected, found)
            })
        };
        let at = Point::new(number(known.x, "an x coordinate")?, number(known.y, "a y coordinate")?);
        let z = known.z.map_or(Ok(f64::NAN), |column| number(column, "a height"))?;
        points.push(Vertex { at, z });
    }
    let paths = Path::of(points, false).into_iter().collect();
    sketch.add(Kind::Points, layer, 1, paths);
    Ok(sketch)
}

/// The byte that separates columns; `None` for blanks.
fn separator_of(row: &[u8]) -> Option<u8> {
    b";\t,".iter().copied().find(|separator| row.contains(separator))
}

/// The fields of a row, with their offsets, without blanks and quotes around them.
fn fields(row: &[u8], separator: Option<u8>) -> Vec<(usize, &[u8])> {
    let is_end = |b: &u8| separator.map_or(b.is_ascii_whitespace(), |separator| *b == separator);
    let mut at = 0;
    let mut fields = Vec::new();
    for field in row.split(is_end) {
        let start = at;
        at += field.len() + 1;
        if field.is_empty() && separator.is_none() {
            continue;
        }
        let lead = field.iter().take_while(|b| b.is_ascii_whitespace() || **b == b'"').count();
        let tail = field[lead..].iter().rev().take_while(|b| b.is_ascii_whitespace() || **b == b'"').count();
        fields.push((start + lead, &field[lead..field.len() - tail]));
    }
    fields
}

/// The columns by the names of the first row; `None` where that holds numbers.
fn named(fields: &[(usize, &[u8])]) -> Option<Columns> {
    let is_number = |field: &[u8]| std::str::from_utf8(field).is_ok_and(|text| text.parse::<f64>().is_ok());
    if fields.iter().take(2).all(|(_, field)| is_number(field)) {
        return None;
    }
    let find = |names: &[&str]| {
        let is_one = |field: &[u8]| names.iter().any(|name| field.eq_ignore_ascii_case(name.as_bytes()));
        fields.iter().position(|(_, field)| is_one(field))
    };
    let x = find(&["x", "lon", "long", "lng", "longitude", "easting", "east", "e"]);
    let y = find(&["y", "lat", "latitude", "northing", "north", "n"]);
    let z = find(&["z", "h", "height", "elevation", "elev", "altitude", "alt"]);
    match (x, y) {
        (Some(x), Some(y)) => Some(Columns { x, y, z }),
        // Names that say nothing: the first columns, as without names.
        _ => Some(Columns { x: 0, y: 1, z: (fields.len() > 2).then_some(2) }),
    }
}
