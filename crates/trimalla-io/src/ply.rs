//! `.ply`: a surface for programs of computer graphics and laser scanning, Stanford's format as plain text. Read and
//! written.
//!
//! Vertices have their height as third coordinate: the first attribute, or 0. Faces are the triangles; where triangles
//! have attributes, each has the first of them as `region`. Subsegments, markers, further attributes and hole seeds are
//! left out.
//!
//! Read are the properties `x`, `y` and `z` of vertices, and `vertex_indices` or `vertex_index` and `region` of faces
//! with three corners; other properties and elements are passed over. Binary files are refused. The edges that one
//! triangle only has become the subsegments.
//!
//! # Source
//! G. Turk, *The PLY Polygon File Format*, 1994.

use std::io::{self, Write};

use trimalla::drawing::IndexedMesh;

use crate::columns::{Points, check_triangles};
use crate::error::IoError;
use crate::gathered::{Gathered, NamedMesh};
use crate::rows::Rows;
use crate::surface::places;
use crate::text::{Text, Word};
use crate::vtu::region_of;

/// Writes a mesh.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh) -> io::Result<()> {
    Points::of_mesh(mesh).check(0)?;
    check_triangles(mesh)?;
    let has_regions = mesh.attributes_per_triangle > 0;
    writeln!(out, "ply\nformat ascii 1.0\ncomment mesh of trimalla\nelement vertex {}", mesh.points.len())?;
    writeln!(out, "property double x\nproperty double y\nproperty double z\nelement face {}", mesh.triangles.len())?;
    writeln!(out, "property list uchar int vertex_indices")?;
    if has_regions {
        writeln!(out, "property double region")?;
    }
    writeln!(out, "end_header")?;
    let mut rows = Rows::to(out);
    for place in places(mesh) {
        rows.reals(&place).end()?;
    }
    for (t, &[a, b, c]) in mesh.triangles.iter().enumerate() {
        rows.integer(3).integer(a).integer(b).integer(c);
        if has_regions {
            rows.real(region_of(mesh, t));
        }
        rows.end()?;
    }
    rows.finish()
}

/// A kind of record: how many there are, and its properties in order.
#[derive(Debug)]
struct Element<'a> {
    name: Word<'a>,
    count: u32,
    /// Whether each property is a list, and its name.
    properties: Vec<(bool, Word<'a>)>,
}

/// Reads a file; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read(bytes: &[u8], name: &str) -> Result<NamedMesh, IoError> {
    let mut text = Text::new(bytes, name)?;
    let elements = read_header(&mut text)?;
    let mut gathered = Gathered::default();
    for element in &elements {
        for _ in 0..element.count {
            if element.name.is("vertex") {
                read_vertex(&mut text, element, &mut gathered)?;
            } else if element.name.is("face") {
                read_face(&mut text, element, &mut gathered)?;
            } else {
                for (is_list, _) in &element.properties {
                    read_values(&mut text, *is_list)?;
                }
            }
        }
    }
    match text.word() {
        Some(extra) => Err(text.syntax(extra, "the end of the file")),
        None => Ok(gathered.finish()),
    }
}

fn read_header<'a>(text: &mut Text<'a>) -> Result<Vec<Element<'a>>, IoError> {
    let first = text.line().ok_or_else(|| text.ended("ply"))?;
    if first.text != b"ply" {
        return Err(text.syntax(first, "ply"));
    }
    let mut elements: Vec<Element<'a>> = Vec::new();
    loop {
        let line = text.line().ok_or_else(|| text.ended("end_header"))?;
        let words: Vec<_> = line.words().collect();
        match (words[0].text, &words[1..], elements.last_mut()) {
            (b"format", [kind, _], _) if kind.is("ascii") => {}
            (b"format", ..) => return Err(text.value(line, "format ascii 1.0: binary files are not read")),
            (b"comment" | b"obj_info", ..) => {}
            (b"element", [name, count], _) => {
                let count = text.whole_of(*count, "how many elements there are")?;
                elements.push(Element { name: *name, count, properties: Vec::new() });
            }
            (b"property", [_, name], Some(element)) => element.properties.push((false, *name)),
            (b"property", [_, _, _, name], Some(element)) => element.properties.push((true, *name)),
            (b"end_header", [], _) => break,
            _ => return Err(text.syntax(line, "an element or a property")),
        }
    }
    // Records without properties would be none, and could be many.
    match elements.iter().find(|element| element.properties.is_empty() && element.count > 0) {
        Some(element) => Err(text.value(element.name, "an element with properties")),
        None => Ok(elements),
    }
}

/// The values of a property.
fn read_values<'a>(text: &mut Text<'a>, is_list: bool) -> Result<Vec<Word<'a>>, IoError> {
    let count = if is_list { text.whole::<u32>("the length of a list")? } else { 1 };
    let mut values = Vec::new();
    for _ in 0..count {
        values.push(text.expect("a number")?);
    }
    Ok(values)
}

fn read_vertex(text: &mut Text<'_>, element: &Element<'_>, gathered: &mut Gathered) -> Result<(), IoError> {
    let mut place = [0.0; 3];
    let first = text.peek().ok_or_else(|| text.ended("a vertex"))?;
    for (is_list, name) in &element.properties {
        let values = read_values(text, *is_list)?;
        let axis = [&b"x"[..], b"y", b"z"].iter().position(|axis| *axis == name.text);
        if let (Some(axis), [value]) = (axis, &values[..]) {
            place[axis] = text.real_of(*value, "a coordinate")?;
        }
    }
    gathered.add_point(text, first, place)
}

fn read_face(text: &mut Text<'_>, element: &Element<'_>, gathered: &mut Gathered) -> Result<(), IoError> {
    let first = text.peek().ok_or_else(|| text.ended("a face"))?;
    let (mut corners, mut region) = (None, 0.0);
    for (is_list, name) in &element.properties {
        let values = read_values(text, *is_list)?;
        if *is_list && (name.is("vertex_indices") || name.is("vertex_index")) {
            let [a, b, c] = values[..] else { return Err(text.value(first, "a face with three corners")) };
            corners =
                Some([gathered.indexed(text, a, 0)?, gathered.indexed(text, b, 0)?, gathered.indexed(text, c, 0)?]);
        } else if !*is_list && name.is("region") {
            region = text.real_of(values[0], "a region")?;
            gathered.has_regions = true;
        }
    }
    let corners = corners.ok_or_else(|| text.value(element.name, "faces with the property vertex_indices"))?;
    let key = gathered.counts().0 as u64;
    gathered.add_triangle(text, first, corners, region, key)
}
