//! Drawings of other programs: maps, CAD, vector graphics and clouds of points become vertices, segments and seeds.
//!
//! | format | areas | lines | regions come from |
//! |---|---|---|---|
//! | `GeoJSON` | polygons | line strings | features, or a property |
//! | WKT | polygons | line strings | geometries |
//! | shapefile | polygons | lines | records, or a column of the `.dbf` file beside |
//! | DXF | closed entities, and lines and arcs that close | all others | layers |
//! | SVG | filled shapes, closed outlines | open outlines | colours |
//! | CSV, XYZ, LAS | – | – | – |
//!
//! What is the same for all:
//!
//! * **Vertices** with equal coordinates are one vertex, and segments with the same ends one segment: neighbours that
//!   share a boundary share its segments. Coordinates keep their bits; those on curves are computed.
//! * **Curves** become straight lines that are within a tolerance of them, which is part of the report.
//! * **Rings** bound the domain by a rule of [`Rings`]; each part that they leave out gets a hole seed, and where there
//!   are two layers or more, each part that they cover a region seed, with the number of the layer of the smallest
//!   shape around it, or the number that the property has. The marker of a segment is the number of its layer, counted
//!   from 1.
//! * **Lines in a cloud of points**, which bound nothing, get the convex hull of all points as their outline.
//! * **Heights** become the first attribute of the vertices, unless all are zero.
//! * What is passed over is told in a [`Note`], with its number and the place of the first.

mod affine;
mod assemble;
mod curve;
mod dxf;
mod faces;
mod format;
mod geojson;
mod join;
mod las;
mod options;
mod shapefile;
mod sketch;
mod spline;
mod svg;
mod table;
mod wkt;

use trimalla::drawing::Pslg;

pub use format::DrawingFormat;
pub use options::{DrawingOptions, Rings};

use self::assemble::{Assembly, assemble};
use self::sketch::{Kind, Sketch, fault_at};
use crate::error::{Ignored, IoError, Note, Place};

/// More layers than this are not named one by one.
const MOST_LAYERS: usize = 12;

/// A drawing of another program.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Drawn {
    /// The drawing.
    pub pslg: Pslg,
    /// What was passed over.
    pub notes: Vec<Note>,
    /// What was read and how: lines of a report.
    pub told: Vec<String>,
    /// For each segment the number of the line, feature or record that it comes from.
    pub origins: Vec<u32>,
    /// What these numbers count: `line`, `feature` or `record`.
    pub noun: &'static str,
}

/// Reads the bytes of a drawing; `name` is what errors call the file. `table` is the `.dbf` file beside a shapefile.
///
/// # Errors
/// [`IoError::Syntax`] with line and column, or [`IoError::Content`] with the number of the feature or record.
pub fn read(
    bytes: &[u8],
    format: DrawingFormat,
    name: &str,
    table: Option<&[u8]>,
    options: &DrawingOptions,
) -> Result<Drawn, IoError> {
    let property = options.property.as_deref();
    let mut sketch = match format {
        DrawingFormat::GeoJson => geojson::read(bytes, name, property),
        DrawingFormat::Wkt => wkt::read(bytes, name),
        DrawingFormat::Shapefile => shapefile::read(bytes, name, table, property),
        DrawingFormat::Dxf => dxf::read(bytes, name),
        DrawingFormat::Svg => svg::read(bytes, name),
        DrawingFormat::Csv | DrawingFormat::Xyz => table::read(bytes, name),
        DrawingFormat::Las => las::read(bytes, name),
    }?;
    select_layers(&mut sketch, name, &options.layers)?;
    if sketch.shapes.is_empty() {
        return Err(fault_at(name, 1, 1, "points, lines or areas", nothing(&sketch)));
    }
    let has_areas = sketch.shapes.iter().any(|shape| matches!(shape.kind, Kind::Area(_)));
    let mixes_lines = matches!(format, DrawingFormat::Dxf | DrawingFormat::Svg);
    let mut made = assemble(&mut sketch, name, options.tolerance, mixes_lines || !has_areas)?;
    let rings = options.rings.unwrap_or(if mixes_lines || !has_areas { Rings::EvenOdd } else { Rings::Each });
    // By the layers of what is used: those of points and texts part no regions.
    let mut used = sketch.shapes.iter().filter(|shape| shape.kind != Kind::Points).map(|shape| shape.layer);
    let first = used.next();
    let has_layers = first.is_some() && (property.is_some() || used.any(|layer| Some(layer) != first));
    let values = has_layers.then(|| attributes(sketch.layers.names()));
    let gets_hull = if made.areas.is_empty() {
        faces::add_hull(&mut made)
    } else {
        faces::add_seeds(&mut made, rings, mixes_lines || !has_areas, values.as_deref());
        false
    };
    if has_layers {
        made.pslg.segment_markers = made.layers.iter().map(|&layer| layer as i32 + 1).collect();
    }
    let mut told = told(&sketch, &made, format, rings, values.as_deref());
    if gets_hull {
        told.push("no outline: the convex hull is the domain".to_owned());
    }
    let notes = notes(&sketch, &made, name);
    Ok(Drawn { pslg: made.pslg, notes, told, origins: made.origins, noun: sketch.noun })
}

/// Leaves out what is not on one of the given layers.
fn select_layers(sketch: &mut Sketch, name: &str, layers: &[String]) -> Result<(), IoError> {
    if layers.is_empty() {
        return Ok(());
    }
    let names = sketch.layers.names();
    if let Some(missing) = layers.iter().find(|layer| !names.contains(layer)) {
        let known: Vec<String> =
            names.iter().take(MOST_LAYERS).map(|name| format!("'{}'", name.escape_debug())).collect();
        let more = if names.len() > MOST_LAYERS { ", …" } else { "" };
        let expected = format!("a layer named '{}'", missing.escape_debug());
        return Err(fault_at(name, 1, 1, expected, format!("{}{more}", known.join(", "))));
    }
    let wanted: Vec<bool> = names.iter().map(|name| layers.contains(name)).collect();
    sketch.shapes.retain(|shape| wanted[shape.layer as usize]);
    Ok(())
}

/// The attributes of layers: the numbers that are their names where all of them are numbers, or else 1, 2, 3, …
fn attributes(names: &[String]) -> Vec<f64> {
    let numbers: Option<Vec<f64>> =
        names.iter().map(|name| name.trim().parse().ok().filter(|v: &f64| v.is_finite())).collect();
    numbers.unwrap_or_else(|| (1..=names.len()).map(|number| number as f64).collect())
}

/// What there is where nothing can be used.
fn nothing(sketch: &Sketch) -> String {
    let rows: Vec<String> = sketch.skipped.rows().map(|(what, count, _)| format!("{count} {what}")).collect();
    if rows.is_empty() { "none".to_owned() } else { format!("only {}", rows.join(", ")) }
}

/// The report's lines about a drawing.
fn told(sketch: &Sketch, made: &Assembly, format: DrawingFormat, rings: Rings, values: Option<&[f64]>) -> Vec<String> {
    let count = |is: fn(&Kind) -> bool| {
        sketch.shapes.iter().filter(move |shape| is(&shape.kind)).flat_map(|shape| &shape.paths)
    };
    let points: usize = count(|k| *k == Kind::Points).map(|path| path.pieces.len() + 1).sum();
    let parts = [
        (count(|k| matches!(k, Kind::Area(_))).count(), "ring", "rings"),
        (count(|k| *k == Kind::Lines).count(), "line", "lines"),
        (points, "point", "points"),
    ];
    let parts: Vec<String> = parts
        .iter()
        .filter(|p| p.0 > 0)
        .map(|(n, one, many)| format!("{n} {}", if *n == 1 { one } else { many }))
        .collect();
    let mut told = vec![format!("read as {}: {}", format.title(), parts.join(", "))];
    told.extend(sketch.told.iter().cloned());
    if made.curves > 0 {
        told.push(format!(
            "{} curves as straight lines, at most {:.3e} away (tolerance {:.3e})",
            made.curves, made.off, made.tolerance
        ));
    }
    if made.joined > 0 {
        told.push(format!(
            "{} computed ends of curves put on the ends that they meet, within {:.1e}",
            made.joined,
            made.tolerance / 100.0
        ));
    }
    if !made.areas.is_empty() {
        told.push(format!("rings {}: {}", rings.key(), rings.summary()));
    }
    if let Some(values) = values {
        let rows = sketch.layers.names().iter().zip(values).enumerate();
        let rows = rows.map(|(i, (name, value))| {
            let region = if *value == i as f64 + 1.0 { String::new() } else { format!(" (region {value})") };
            format!("{} {}{region}", i + 1, shortened(name))
        });
        let more = if sketch.layers.names().len() > MOST_LAYERS { ", …" } else { "" };
        let rows: Vec<String> = rows.take(MOST_LAYERS).collect();
        told.push(format!("by {}: {}{more}", sketch.layer_noun.escape_debug(), rows.join(", ")));
    }
    told
}

/// A name in a line of a report.
fn shortened(name: &str) -> String {
    let text: String = name.chars().take(40).collect();
    format!("'{}'", text.escape_debug())
}

/// What was passed over, and what is unusual.
fn notes(sketch: &Sketch, made: &Assembly, name: &str) -> Vec<Note> {
    let note = |what| Note { place: Place { file: name.to_owned(), line: 1, column: 1 }, what };
    let skipped = sketch.skipped.rows().map(|(what, count, first)| {
        note(Ignored::Shapes { what: what.to_owned(), count, noun: sketch.noun, first: u64::from(first) })
    });
    let mut notes: Vec<Note> = skipped.collect();
    let unusual = [
        (made.repeated, "are drawn a second time, and were left out", "rings"),
        (made.without_height, "have no height, and got 0", "vertices"),
        (made.other_heights, "lie on earlier ones with another height, which counts there", "vertices"),
    ];
    for (count, text, noun) in unusual.into_iter().filter(|row| row.0 > 0) {
        notes.push(note(Ignored::Unusual(format!("{count} {noun} {text}"))));
    }
    notes
}
