//! `.vtk`: a mesh for ParaView and others, in VTK's legacy format as plain text. Read and written.
//!
//! The arrays are those of [`vtu`](crate::vtu), and so is the third coordinate. Written is version 3.0, which all
//! programs read. Read are unstructured grids of versions up to 5.1.
//!
//! # Source
//! *VTK File Formats*, "Simple Legacy Formats", Kitware.

use std::fmt::Display;
use std::io::{self, Write};

use trimalla::drawing::IndexedMesh;

use crate::cells::{Arrays, Cells, LINE, TRIANGLE};
use crate::columns::{Points, Segments, check_triangles};
use crate::error::IoError;
use crate::gathered::NamedMesh;
use crate::numbers::Real;
use crate::rows::Rows;
use crate::surface::places;
use crate::text::{Text, Word};
use crate::vtu::{min_angle_deg, per_cell, region_of};

/// Writes a mesh.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh) -> io::Result<()> {
    Points::of_mesh(mesh).check(0)?;
    check_triangles(mesh)?;
    Segments::of_mesh(mesh).check(mesh.points.len())?;
    writeln!(out, "# vtk DataFile Version 3.0\nmesh of trimalla\nASCII\nDATASET UNSTRUCTURED_GRID")?;
    writeln!(out, "POINTS {} double", mesh.points.len())?;
    let mut rows = Rows::to(out);
    for place in places(mesh) {
        rows.reals(&place).end()?;
    }
    rows.finish()?;
    let (triangles, lines) = (mesh.triangles.len(), mesh.segments.len());
    writeln!(out, "CELLS {} {}", triangles + lines, 4 * triangles + 3 * lines)?;
    let mut rows = Rows::to(out);
    for &[a, b, c] in &mesh.triangles {
        rows.integer(3).integer(a).integer(b).integer(c).end()?;
    }
    for &[a, b] in &mesh.segments {
        rows.integer(2).integer(a).integer(b).end()?;
    }
    rows.finish()?;
    writeln!(out, "CELL_TYPES {}", triangles + lines)?;
    write_rows(out, per_cell(mesh, |_| TRIANGLE, |_| LINE))?;
    write_cell_data(out, mesh)?;
    write_point_data(out, mesh)
}

fn write_cell_data(out: &mut dyn Write, mesh: &IndexedMesh) -> io::Result<()> {
    let marker = |s: usize| mesh.segment_markers.get(s).copied().unwrap_or(0);
    writeln!(out, "CELL_DATA {}", mesh.triangles.len() + mesh.segments.len())?;
    head(out, "region", "double")?;
    write_rows(out, per_cell(mesh, |t| Real(region_of(mesh, t)), |_| Real(-1.0)))?;
    head(out, "min_angle", "double")?;
    write_rows(out, per_cell(mesh, |t| Real(min_angle_deg(mesh, t)), |_| Real(-1.0)))?;
    head(out, "marker", "int")?;
    write_rows(out, per_cell(mesh, |_| 0, marker))
}

fn write_point_data(out: &mut dyn Write, mesh: &IndexedMesh) -> io::Result<()> {
    writeln!(out, "POINT_DATA {}", mesh.points.len())?;
    head(out, "marker", "int")?;
    write_rows(out, (0..mesh.points.len()).map(|i| mesh.point_markers.get(i).copied().unwrap_or(0)))?;
    let width = if mesh.points.is_empty() { 0 } else { mesh.attributes_per_point };
    for column in 0..width {
        head(out, &format!("attribute{column}"), "double")?;
        write_rows(out, mesh.point_attributes.iter().skip(column).step_by(width).map(|&value| Real(value)))?;
    }
    Ok(())
}

fn head(out: &mut dyn Write, name: &str, kind: &str) -> io::Result<()> {
    writeln!(out, "SCALARS {name} {kind} 1\nLOOKUP_TABLE default")
}

fn write_rows(out: &mut dyn Write, mut rows: impl Iterator<Item = impl Display>) -> io::Result<()> {
    rows.try_for_each(|row| writeln!(out, "{row}"))
}

/// Reads a file; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read(bytes: &[u8], name: &str) -> Result<NamedMesh, IoError> {
    let mut text = Text::new(bytes, name)?;
    let version = read_head(&mut text)?;
    let mut cells = Cells::default();
    let mut counts = (0_u32, 0_u32);
    let mut is_of_cells = false;
    let (mut connectivity, mut ends, mut kinds) = (Vec::new(), Vec::new(), Vec::new());
    while let Some(word) = text.word() {
        match word.text {
            b"POINTS" => {
                counts.0 = text.whole("the number of points")?;
                text.expect("the type of the coordinates")?;
                for _ in 0..counts.0 {
                    let first = text.peek().ok_or_else(|| text.ended("an x coordinate"))?;
                    let place =
                        [text.real("an x coordinate")?, text.real("a y coordinate")?, text.real("a z coordinate")?];
                    cells.gathered.add_point(&text, first, place)?;
                }
            }
            b"CELLS" if version < 5 => {
                counts.1 = text.whole("the number of cells")?;
                text.whole::<u32>("the numbers of all cells together")?;
                for _ in 0..counts.1 {
                    let length: u32 = text.whole("the number of vertices of a cell")?;
                    for _ in 0..length {
                        connectivity.push(text.expect("the index of a vertex")?);
                    }
                    ends.push(connectivity.len());
                }
            }
            b"CELLS" => {
                counts.1 = read_offsets(&mut text, &mut connectivity, &mut ends)?;
            }
            b"CELL_TYPES" => {
                for _ in 0..text.whole::<u32>("the number of cells")? {
                    kinds.push(text.expect("the type of a cell")?);
                }
            }
            b"CELL_DATA" | b"POINT_DATA" => {
                is_of_cells = word.text == b"CELL_DATA";
                text.whole::<u32>("the number of entries")?;
            }
            b"SCALARS" | b"FIELD" => {
                let (arrays, count) =
                    if is_of_cells { (&mut cells.of_cells, counts.1) } else { (&mut cells.of_points, counts.0) };
                if word.text == b"SCALARS" {
                    read_scalars(&mut text, arrays, count as usize)?;
                } else {
                    read_field(&mut text, arrays)?;
                }
            }
            _ => {} // Of no concern: vectors, metadata, lookup tables, and their numbers.
        }
    }
    let Some(&last) = kinds.last() else { return Err(text.ended("the section CELL_TYPES")) };
    if kinds.len() != ends.len() {
        return Err(text.value(last, &format!("the types of {} cells, not of {}", ends.len(), kinds.len())));
    }
    let mut from = 0;
    for (kind, to) in kinds.into_iter().zip(ends) {
        let vertices = connectivity.get(from..to).ok_or_else(|| text.value(kind, "a cell with vertices"))?;
        cells.cells.push((kind, vertices.to_vec()));
        from = to;
    }
    cells.finish(&text)
}

/// The four lines at the beginning; the version of the format without what is behind the point.
fn read_head(text: &mut Text<'_>) -> Result<u32, IoError> {
    const HEAD: &str = "# vtk DataFile Version";
    let line = text.line().ok_or_else(|| text.ended(HEAD))?;
    let version = Some(line).filter(|line| line.text.starts_with(HEAD.as_bytes()));
    let version = version.and_then(|line| line.part(HEAD.len(), line.text.len()).split(b'.').next()?.parse());
    let version = version.ok_or_else(|| text.syntax(line, HEAD))?;
    let line = text.line().ok_or_else(|| text.ended("ASCII"))?;
    if !line.is("ASCII") {
        // The title; it may be blank.
        let kind = text.line().ok_or_else(|| text.ended("ASCII"))?;
        if !kind.is("ASCII") {
            return Err(text.value(kind, "ASCII: binary files are not read"));
        }
    }
    for expected in ["DATASET", "UNSTRUCTURED_GRID"] {
        let word = text.expect(expected)?;
        if !word.is(expected) {
            return Err(text.value(word, expected));
        }
    }
    Ok(version)
}

/// The cells of version 5: where each ends, and the vertices of all; how many cells there are.
fn read_offsets<'a>(
    text: &mut Text<'a>,
    connectivity: &mut Vec<Word<'a>>,
    ends: &mut Vec<usize>,
) -> Result<u32, IoError> {
    let offsets: u32 = text.whole("the number of offsets")?;
    let length: u32 = text.whole("the numbers of all cells together")?;
    for (expected, count) in [("OFFSETS", offsets), ("CONNECTIVITY", length)] {
        let word = text.expect(expected)?;
        if !word.is(expected) {
            return Err(text.syntax(word, expected));
        }
        text.expect("the type of the numbers")?;
        for i in 0..count {
            let word = text.expect("a number")?;
            match (expected, i) {
                ("OFFSETS", 0) => {}
                ("OFFSETS", _) => ends.push(text.whole_of(word, "an offset")?),
                _ => connectivity.push(word),
            }
        }
    }
    Ok(offsets.saturating_sub(1))
}

/// `SCALARS <name> <type> [<width>]`, a lookup table, and numbers.
fn read_scalars(text: &mut Text<'_>, arrays: &mut Arrays, count: usize) -> Result<(), IoError> {
    let name = text.expect("the name of an array")?;
    text.expect("the type of an array")?;
    let mut width = 1;
    if let Some(word) = text.peek().filter(|word| !word.is("LOOKUP_TABLE")) {
        if let Some(found) = word.parse::<usize>().filter(|found| (1..=4).contains(found)) {
            width = found;
            text.word();
        }
    }
    if text.peek().is_some_and(|word| word.is("LOOKUP_TABLE")) {
        text.word();
        text.expect("the name of a lookup table")?;
    }
    read_array(text, arrays, name, width, count)
}

/// `FIELD <name> <arrays>`, and for each array its name, width, length, type and numbers.
fn read_field(text: &mut Text<'_>, arrays: &mut Arrays) -> Result<(), IoError> {
    text.expect("the name of a field")?;
    for _ in 0..text.whole::<u32>("the number of arrays")? {
        let name = text.expect("the name of an array")?;
        if name.is("METADATA") {
            return Ok(()); // What follows is passed over with all that is of no concern.
        }
        let width = text.whole("the width of an array")?;
        let count = text.whole("the length of an array")?;
        let kind = text.expect("the type of an array")?;
        if kind.is("string") {
            return Ok(()); // Its words are passed over, too.
        }
        read_array(text, arrays, name, width, count)?;
    }
    Ok(())
}

fn read_array(
    text: &mut Text<'_>,
    arrays: &mut Arrays,
    name: Word<'_>,
    width: usize,
    count: usize,
) -> Result<(), IoError> {
    let total = width.saturating_mul(count);
    if total > text.remaining() {
        return Err(text.value(name, "an array no longer than the file"));
    }
    let mut values = Vec::with_capacity(total);
    for _ in 0..total {
        values.push(text.real("a number")?);
    }
    arrays.push((String::from_utf8_lossy(name.text).into_owned(), width, values));
    Ok(())
}
