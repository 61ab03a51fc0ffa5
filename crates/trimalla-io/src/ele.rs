//! `.ele`: triangles.
//!
//! ```text
//! <triangles> [<nodes a triangle: 3 or 6> [<attributes a triangle>]]
//! <number> <vertex> <vertex> <vertex> [three nodes on the edges] [attributes]
//! ```
//! Rows are numbered like the vertices, or otherwise where the vertices that they name leave no doubt. Numbers behind
//! the declared columns are ignored, which a [`Note`] says. Of six-node triangles the corners are kept. Orientation and
//! shape are taken as they are; a check tests them.

use std::io::{self, Write};

use trimalla::drawing::IndexedMesh;

use crate::columns::{Points, check_triangles};
use crate::error::{IoError, Note};
use crate::numbers::{Numbering, VertexRange};
use crate::rows::Rows;
use crate::tokens::Reader;

/// The triangles of an `.ele` file.
///
/// # Shape
/// `attributes` has `attributes_per_triangle` entries a triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct Elements {
    /// Vertex indices, counted from 0.
    pub triangles: Vec<[u32; 3]>,
    /// Number of attributes a triangle carries.
    pub attributes_per_triangle: usize,
    /// Attributes, row after row.
    pub attributes: Vec<f64>,
    /// What was ignored.
    pub notes: Vec<Note>,
}

/// Reads an `.ele` file for the given vertices; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read(bytes: &[u8], name: &str, vertices: VertexRange) -> Result<Elements, IoError> {
    let mut reader = Reader::new(bytes, name)?;
    reader.record(|| "the number of triangles".to_owned())?;
    let count = reader.count("the number of triangles")?;
    let nodes = reader.one_of_or("3 or 6 nodes a triangle", 3, &[3, 6])?;
    let attributes_per_triangle = reader.count_or("the number of attributes a triangle", 0, u32::MAX)? as usize;
    reader.end_record()?;

    let mut elements =
        Elements { triangles: Vec::new(), attributes_per_triangle, attributes: Vec::new(), notes: Vec::new() };
    elements.triangles.reserve((count as usize).min(reader.remaining() / SHORTEST_ROW));
    let mut rows = Numbering::new("triangle", count, None);
    while rows.next(&mut reader)? {
        let corners = [reader.vertex(vertices)?, reader.vertex(vertices)?, reader.vertex(vertices)?];
        elements.triangles.push(corners);
        for _ in 3..nodes {
            reader.vertex(vertices)?;
        }
        for _ in 0..attributes_per_triangle {
            elements.attributes.push(reader.real("an attribute")?);
        }
        rows.end_record(&mut reader)?;
    }
    reader.end_file()?;
    rows.check_base(&mut reader, vertices, elements.triangles.iter().flatten().copied())?;
    rows.note_extra(&mut reader);
    Ok(Elements { notes: reader.take_notes(), ..elements })
}

/// Bytes of the shortest row, `1 1 2 3` and the end of its line.
const SHORTEST_ROW: usize = 8;

/// Writes the triangles of a mesh.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh, first_index: u32) -> io::Result<()> {
    Points::of_mesh(mesh).check(first_index)?;
    check_triangles(mesh)?;
    let base = u64::from(first_index);
    let width = mesh.attributes_per_triangle;
    writeln!(out, "{} 3 {width}", mesh.triangles.len())?;
    let mut rows = Rows::to(out);
    for (i, triangle) in mesh.triangles.iter().enumerate() {
        let [a, b, c] = triangle.map(|v| u64::from(v) + base);
        rows.integer(i as u64 + base).integer(a).integer(b).integer(c);
        rows.reals(&mesh.triangle_attributes[i * width..(i + 1) * width]);
        rows.end()?;
    }
    rows.finish()
}
