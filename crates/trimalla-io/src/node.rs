//! `.node`: vertices.
//!
//! ```text
//! <vertices> [2 [<attributes a vertex> [<markers: 0 or 1>]]]
//! <number> <x> <y> [attributes] [marker]
//! ```
//! Numbers are consecutive and start at 0 or 1, as the first one says; every other file of the group follows it.
//! Numbers behind the declared columns of a row are ignored, which a [`Note`] says.

use std::io::{self, Write};

use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Point;

use crate::columns::Points;
use crate::error::{IoError, Note};
use crate::numbers::{Numbering, VertexRange};
use crate::rows::Rows;
use crate::tokens::Reader;

/// The vertices of a `.node` file, or of the first part of a `.poly` file.
///
/// # Shape
/// `markers` is empty or has one entry a vertex; `attributes` has `attributes_per_point` entries a vertex.
#[derive(Clone, Debug, PartialEq)]
pub struct Nodes {
    /// The number of the first vertex in the file: 0 or 1 (1 where there is no vertex).
    pub first_index: u32,
    /// Coordinates.
    pub points: Vec<Point>,
    /// Boundary markers.
    pub markers: Vec<i32>,
    /// Number of attributes a vertex carries.
    pub attributes_per_point: usize,
    /// Attributes, row after row.
    pub attributes: Vec<f64>,
    /// What was ignored.
    pub notes: Vec<Note>,
}

impl Nodes {
    /// The indices that other files may use for these vertices.
    #[must_use]
    pub fn range(&self) -> VertexRange {
        // A section never holds more records than its header, a u32, allows.
        VertexRange { first_index: self.first_index, count: self.points.len() as u32 }
    }

    /// The drawing that consists of these vertices alone.
    #[must_use]
    pub fn into_pslg(self) -> Pslg {
        Pslg {
            points: self.points,
            point_markers: self.markers,
            attributes_per_point: self.attributes_per_point,
            point_attributes: self.attributes,
            ..Pslg::default()
        }
    }

    /// The mesh that consists of these vertices alone.
    #[must_use]
    pub fn into_mesh(self) -> IndexedMesh {
        IndexedMesh {
            input_points: self.points.len(),
            points: self.points,
            point_markers: self.markers,
            attributes_per_point: self.attributes_per_point,
            point_attributes: self.attributes,
            ..IndexedMesh::default()
        }
    }
}

/// Reads a `.node` file; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read(bytes: &[u8], name: &str) -> Result<Nodes, IoError> {
    let mut reader = Reader::new(bytes, name)?;
    let nodes = read_section(&mut reader)?;
    reader.end_file()?;
    Ok(Nodes { notes: reader.take_notes(), ..nodes })
}

/// Reads the header and the rows of a vertex section and leaves what follows. What was ignored, `reader` notes.
pub(crate) fn read_section(reader: &mut Reader<'_>) -> Result<Nodes, IoError> {
    reader.record(|| "the number of vertices".to_owned())?;
    let count = reader.count("the number of vertices")?;
    reader.one_of_or("the dimension 2", 2, &[2])?;
    let attributes_per_point = reader.count_or("the number of attributes a vertex", 0, u32::MAX)? as usize;
    let has_markers = reader.one_of_or("0 or 1 markers a vertex", 0, &[0, 1])? == 1;
    reader.end_record()?;

    let mut nodes = Nodes {
        first_index: 1,
        points: Vec::new(),
        markers: Vec::new(),
        attributes_per_point,
        attributes: Vec::new(),
        notes: Vec::new(),
    };
    nodes.points.reserve((count as usize).min(reader.remaining() / SHORTEST_ROW));
    let mut rows = Numbering::new("vertex", count, None);
    while rows.next(reader)? {
        let (x, y) = (reader.real("an x coordinate")?, reader.real("a y coordinate")?);
        nodes.points.push(Point::new(x, y));
        for _ in 0..attributes_per_point {
            nodes.attributes.push(reader.real("an attribute")?);
        }
        if has_markers {
            nodes.markers.push(reader.marker()?);
        }
        rows.end_record(reader)?;
    }
    rows.note_extra(reader);
    nodes.first_index = rows.first_index();
    Ok(nodes)
}

/// Bytes of the shortest row, `1 0 0` and the end of its line.
const SHORTEST_ROW: usize = 6;

/// Writes the vertices of a mesh.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths or a number is not finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh, first_index: u32) -> io::Result<()> {
    write_points(out, &Points::of_mesh(mesh), first_index)
}

pub(crate) fn write_points(out: &mut dyn Write, points: &Points<'_>, first_index: u32) -> io::Result<()> {
    points.check(first_index)?;
    let width = points.attributes_per_point;
    writeln!(out, "{} 2 {width} {}", points.points.len(), u8::from(!points.markers.is_empty()))?;
    let mut rows = Rows::to(out);
    for (i, point) in points.points.iter().enumerate() {
        rows.integer(i as u64 + u64::from(first_index)).real(point.x).real(point.y);
        rows.reals(&points.attributes[i * width..(i + 1) * width]);
        if let Some(&marker) = points.markers.get(i) {
            rows.integer(marker);
        }
        rows.end()?;
    }
    rows.finish()
}
