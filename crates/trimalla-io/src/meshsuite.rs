//! `.mesh`: the single file of `MeshSuite`, a drawing and, where there is one, its triangulation.
//!
//! ```text
//! <vertices>
//! <number> <x> <y>
//! <segments>
//! <number> <vertex> <vertex> <type>
//! <holes>
//! <number> <x> <y>
//! [<triangles>
//! <number> <vertex> <vertex> <vertex>]
//! ```
//! Vertices are numbered from 0 or 1, segments and triangles like them, holes from 0 or 1. A file may end after the
//! vertices or after the holes and is a drawing then, which `MeshSuite` triangulates when it loads it. The type of a
//! segment is its marker; 1 is written where there are none. The format has no place for attributes, vertex markers and
//! regions.
//!
//! Medit's files have the same ending; they start with a word, which is refused where the number of vertices should
//! stand.
//!
//! # Source
//! `MeshSuite`, section 3.6.1. It says that segments may be missing, not which sections go together; that holes are
//! required after segments is ours, as in [`poly`](crate::poly).

use std::io::{self, Write};

use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Point;

use crate::columns::{Points, Segments, check_triangles};
use crate::error::IoError;
use crate::numbers::{Numbering, Real, VertexRange};
use crate::tokens::Reader;

/// A `.mesh` file.
///
/// # Shape
/// `segment_types` has one entry a segment.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshSuite {
    /// The number of the first vertex in the file: 0 or 1 (1 where there is no vertex).
    pub first_index: u32,
    /// Coordinates.
    pub points: Vec<Point>,
    /// Segments as pairs of vertex indices, counted from 0.
    pub segments: Vec<[u32; 2]>,
    /// Segment types.
    pub segment_types: Vec<i32>,
    /// Hole seeds.
    pub holes: Vec<Point>,
    /// Triangles as vertex indices, counted from 0; `None` where the file has no such section.
    pub triangles: Option<Vec<[u32; 3]>>,
}

impl MeshSuite {
    /// The drawing, without triangles.
    #[must_use]
    pub fn into_pslg(self) -> Pslg {
        Pslg {
            points: self.points,
            segments: self.segments,
            segment_markers: self.segment_types,
            holes: self.holes,
            ..Pslg::default()
        }
    }

    /// The mesh, without triangles where the file has none.
    #[must_use]
    pub fn into_mesh(self) -> IndexedMesh {
        IndexedMesh {
            input_points: self.points.len(),
            points: self.points,
            triangles: self.triangles.unwrap_or_default(),
            segments: self.segments,
            segment_markers: self.segment_types,
            holes: self.holes,
            ..IndexedMesh::default()
        }
    }
}

/// Reads a `.mesh` file with or without triangles; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read(bytes: &[u8], name: &str) -> Result<MeshSuite, IoError> {
    let mut reader = Reader::new(bytes, name)?;
    let file = read_drawing(&mut reader)?;
    let triangles = if reader.advance() { Some(read_triangles(&mut reader, file.range())?) } else { None };
    reader.end_file()?;
    Ok(MeshSuite { triangles, ..file })
}

/// Reads a `.mesh` file that must have triangles; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read_mesh(bytes: &[u8], name: &str) -> Result<MeshSuite, IoError> {
    let mut reader = Reader::new(bytes, name)?;
    let file = read_drawing(&mut reader)?;
    let triangles = read_triangles(&mut reader, file.range())?;
    reader.end_file()?;
    Ok(MeshSuite { triangles: Some(triangles), ..file })
}

impl MeshSuite {
    fn range(&self) -> VertexRange {
        // A section never holds more records than its header, a u32, allows.
        VertexRange { first_index: self.first_index, count: self.points.len() as u32 }
    }
}

/// Everything but the triangles.
fn read_drawing(reader: &mut Reader<'_>) -> Result<MeshSuite, IoError> {
    let (points, first_index) = read_places(reader, "vertex", "the number of vertices")?;
    let mut file =
        MeshSuite { first_index, points, segments: vec![], segment_types: vec![], holes: vec![], triangles: None };
    if reader.advance() {
        (file.segments, file.segment_types) = read_segments(reader, file.range())?;
        (file.holes, _) = read_places(reader, "hole", "the number of holes (0 where there are none)")?;
    }
    Ok(file)
}

/// A section of points: them and the number of the first.
fn read_places(reader: &mut Reader<'_>, noun: &'static str, header: &str) -> Result<(Vec<Point>, u32), IoError> {
    let count = read_header(reader, header)?;
    let mut points = Vec::with_capacity((count as usize).min(reader.remaining() / SHORTEST_ROW));
    let mut rows = Numbering::new(noun, count, None);
    while rows.next(reader)? {
        points.push(Point::new(reader.real("an x coordinate")?, reader.real("a y coordinate")?));
        reader.end_record()?;
    }
    Ok((points, rows.first_index()))
}

fn read_segments(reader: &mut Reader<'_>, vertices: VertexRange) -> Result<(Vec<[u32; 2]>, Vec<i32>), IoError> {
    let count = read_header(reader, "the number of segments")?;
    let (mut segments, mut types) = (Vec::new(), Vec::new());
    let mut rows = Numbering::new("segment", count, (vertices.count > 0).then_some(vertices.first_index));
    while rows.next(reader)? {
        segments.push([reader.vertex(vertices)?, reader.vertex(vertices)?]);
        types.push(reader.marker()?);
        reader.end_record()?;
    }
    Ok((segments, types))
}

fn read_triangles(reader: &mut Reader<'_>, vertices: VertexRange) -> Result<Vec<[u32; 3]>, IoError> {
    let count = read_header(reader, "the number of triangles")?;
    let mut triangles = Vec::with_capacity((count as usize).min(reader.remaining() / SHORTEST_ROW));
    let mut rows = Numbering::new("triangle", count, (vertices.count > 0).then_some(vertices.first_index));
    while rows.next(reader)? {
        triangles.push([reader.vertex(vertices)?, reader.vertex(vertices)?, reader.vertex(vertices)?]);
        reader.end_record()?;
    }
    Ok(triangles)
}

fn read_header(reader: &mut Reader<'_>, what: &str) -> Result<u32, IoError> {
    reader.record(|| what.to_owned())?;
    let count = reader.count(what)?;
    reader.end_record()?;
    Ok(count)
}

/// Bytes of the shortest row, `1 0 0` and the end of its line.
const SHORTEST_ROW: usize = 6;

/// Writes a mesh, all four sections.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh, first_index: u32) -> io::Result<()> {
    check_triangles(mesh)?;
    write_drawing(out, &Points::of_mesh(mesh), &Segments::of_mesh(mesh), first_index)?;
    let base = u64::from(first_index);
    writeln!(out, "{}", mesh.triangles.len())?;
    for (i, triangle) in mesh.triangles.iter().enumerate() {
        let [a, b, c] = triangle.map(|v| u64::from(v) + base);
        writeln!(out, "{} {a} {b} {c}", i as u64 + base)?;
    }
    Ok(())
}

/// Writes a drawing: no section of triangles.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write_pslg(out: &mut dyn Write, pslg: &Pslg, first_index: u32) -> io::Result<()> {
    write_drawing(out, &Points::of_pslg(pslg), &Segments::of_pslg(pslg), first_index)
}

fn write_drawing(
    out: &mut dyn Write,
    points: &Points<'_>,
    segments: &Segments<'_>,
    first_index: u32,
) -> io::Result<()> {
    points.check(first_index)?;
    segments.check(points.points.len())?;
    let base = u64::from(first_index);
    write_places(out, points.points, base)?;
    writeln!(out, "{}", segments.segments.len())?;
    for (i, segment) in segments.segments.iter().enumerate() {
        let [a, b] = segment.map(|v| u64::from(v) + base);
        writeln!(out, "{} {a} {b} {}", i as u64 + base, segments.markers.get(i).copied().unwrap_or(1))?;
    }
    write_places(out, segments.holes, base)
}

fn write_places(out: &mut dyn Write, points: &[Point], base: u64) -> io::Result<()> {
    writeln!(out, "{}", points.len())?;
    for (i, point) in points.iter().enumerate() {
        writeln!(out, "{} {} {}", i as u64 + base, Real(point.x), Real(point.y))?;
    }
    Ok(())
}
