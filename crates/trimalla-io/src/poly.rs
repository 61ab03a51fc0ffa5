//! `.poly`: a planar straight-line graph.
//!
//! ```text
//! a vertex section as in `.node`; 0 vertices: they are in the `.node` file of the same stem
//! <segments> [<markers: 0 or 1>]
//! <number> <vertex> <vertex> [marker]
//! <holes>
//! <number> <x> <y>
//! [<regions>]
//! <number> <x> <y> <attribute> [<largest area>]
//! ```
//! Segments are numbered like the vertices, or otherwise where the vertices that they name leave no doubt; holes and
//! regions, to which nothing refers, from 0 or 1. Numbers behind the declared columns of a row are ignored, which a
//! [`Note`] says. The section of holes is required (a drawing that lost its holes must not pass for one that has none),
//! the one of regions is not. A largest area that is missing, zero or negative is none.

use std::io::{self, Write};

use trimalla::drawing::{IndexedMesh, Pslg, Region};
use trimalla::geometry::Point;

use crate::columns::{Points, Segments};
use crate::error::{IoError, Note};
use crate::node::{self, Nodes};
use crate::numbers::{Numbering, Real, VertexRange};
use crate::rows::Rows;
use crate::tokens::Reader;

/// A `.poly` file: its vertices and what refers to them.
#[derive(Clone, Debug, PartialEq)]
pub struct Poly {
    /// The vertices, from the file itself or from its companion.
    pub nodes: Nodes,
    /// Segments, holes and regions.
    pub sections: Sections,
}

/// The part of a `.poly` file that follows the vertices.
///
/// # Shape
/// `segment_markers` is empty or has one entry a segment.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sections {
    /// Segments as pairs of vertex indices, counted from 0.
    pub segments: Vec<[u32; 2]>,
    /// Segment markers.
    pub segment_markers: Vec<i32>,
    /// Hole seeds.
    pub holes: Vec<Point>,
    /// Region seeds.
    pub regions: Vec<Region>,
    /// The regions, by index, that have one number behind the seed instead of two. It is their attribute; Triangle
    /// takes it for the largest area, too.
    pub lone_numbers: Vec<usize>,
    /// What was ignored in the file, its vertices included.
    pub notes: Vec<Note>,
}

impl Poly {
    /// The drawing.
    #[must_use]
    pub fn into_pslg(self) -> Pslg {
        Pslg {
            segments: self.sections.segments,
            segment_markers: self.sections.segment_markers,
            holes: self.sections.holes,
            regions: self.sections.regions,
            ..self.nodes.into_pslg()
        }
    }
}

/// Reads a `.poly` file; `name` is what errors call it, and `companion` is asked for the vertices if the file has none.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault, and those of `companion`.
pub fn read(bytes: &[u8], name: &str, companion: impl FnOnce() -> Result<Nodes, IoError>) -> Result<Poly, IoError> {
    let mut reader = Reader::new(bytes, name)?;
    let mut nodes = node::read_section(&mut reader)?;
    if nodes.points.is_empty() {
        nodes = companion()?;
    }
    let sections = read_sections(&mut reader, nodes.range())?;
    Ok(Poly { nodes, sections })
}

/// Reads a `.poly` file that goes with a mesh: its vertices are those of the mesh. `None` if the file has vertices of
/// its own, for then it is a drawing that happens to have the same stem.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read_with_mesh(bytes: &[u8], name: &str, vertices: VertexRange) -> Result<Option<Sections>, IoError> {
    let mut reader = Reader::new(bytes, name)?;
    let own = node::read_section(&mut reader)?;
    if own.points.is_empty() { read_sections(&mut reader, vertices).map(Some) } else { Ok(None) }
}

/// Reads a drawing that came without a name, such as standard input: a `.poly` file, or a `.node` file if nothing
/// follows the vertices.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read_unnamed(bytes: &[u8], name: &str) -> Result<Poly, IoError> {
    let mut reader = Reader::new(bytes, name)?;
    let nodes = node::read_section(&mut reader)?;
    let mut sections = if reader.advance() { read_sections(&mut reader, nodes.range())? } else { Sections::default() };
    sections.notes.extend(reader.take_notes());
    Ok(Poly { nodes, sections })
}

fn read_sections(reader: &mut Reader<'_>, vertices: VertexRange) -> Result<Sections, IoError> {
    let (segments, segment_markers) = read_segments(reader, vertices)?;
    let holes = read_holes(reader)?;
    let (regions, lone_numbers) = if reader.advance() { read_regions(reader)? } else { Default::default() };
    reader.end_file()?;
    Ok(Sections { segments, segment_markers, holes, regions, lone_numbers, notes: reader.take_notes() })
}

fn read_segments(reader: &mut Reader<'_>, vertices: VertexRange) -> Result<(Vec<[u32; 2]>, Vec<i32>), IoError> {
    reader.record(|| "the number of segments".to_owned())?;
    let count = reader.count("the number of segments")?;
    let has_markers = reader.one_of_or("0 or 1 markers a segment", 0, &[0, 1])? == 1;
    reader.end_record()?;
    let (mut segments, mut markers) = (Vec::new(), Vec::new());
    let mut rows = Numbering::new("segment", count, None);
    while rows.next(reader)? {
        segments.push([reader.vertex(vertices)?, reader.vertex(vertices)?]);
        if has_markers {
            markers.push(reader.marker()?);
        }
        rows.end_record(reader)?;
    }
    rows.check_base(reader, vertices, segments.iter().flatten().copied())?;
    rows.note_extra(reader);
    Ok((segments, markers))
}

fn read_holes(reader: &mut Reader<'_>) -> Result<Vec<Point>, IoError> {
    reader.record(|| "the number of holes (0 where there are none)".to_owned())?;
    let count = reader.count("the number of holes")?;
    reader.end_record()?;
    let mut holes = Vec::new();
    let mut rows = Numbering::new("hole", count, None);
    while rows.next(reader)? {
        holes.push(Point::new(reader.real("an x coordinate")?, reader.real("a y coordinate")?));
        rows.end_record(reader)?;
    }
    rows.note_extra(reader);
    Ok(holes)
}

fn read_regions(reader: &mut Reader<'_>) -> Result<(Vec<Region>, Vec<usize>), IoError> {
    let count = reader.count("the number of regions")?;
    reader.end_record()?;
    let (mut regions, mut lone_numbers) = (Vec::new(), Vec::new());
    let mut rows = Numbering::new("region", count, None);
    while rows.next(reader)? {
        let seed = Point::new(reader.real("an x coordinate")?, reader.real("a y coordinate")?);
        let attribute = reader.real("the attribute of the region")?;
        let max_area = match reader.field() {
            None => {
                lone_numbers.push(regions.len());
                None
            }
            Some(token) => {
                // It may be missing, so that the number of columns does not tell commas between columns from decimal
                // ones.
                reader.refuse_decimal_commas()?;
                Some(reader.real_of(token, "the largest area")?).filter(|&area| area > 0.0)
            }
        };
        rows.end_record(reader)?;
        regions.push(Region { seed, attribute, max_area });
    }
    rows.note_extra(reader);
    Ok((regions, lone_numbers))
}

/// Writes a drawing with its vertices.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write_pslg(out: &mut dyn Write, pslg: &Pslg, first_index: u32) -> io::Result<()> {
    write_whole(out, &Points::of_pslg(pslg), &Segments::of_pslg(pslg), first_index)
}

/// Writes the vertices, subsegments and holes of a mesh as a drawing.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh, first_index: u32) -> io::Result<()> {
    write_whole(out, &Points::of_mesh(mesh), &Segments::of_mesh(mesh), first_index)
}

/// Writes the subsegments and holes of a mesh whose vertices are in the `.node` file of the same stem.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write_beside_node(out: &mut dyn Write, mesh: &IndexedMesh, first_index: u32) -> io::Result<()> {
    let (points, segments) = (Points::of_mesh(mesh), Segments::of_mesh(mesh));
    points.check(first_index)?;
    segments.check(points.points.len())?;
    writeln!(out, "0 2 {} {}", points.attributes_per_point, u8::from(!points.markers.is_empty()))?;
    write_sections(out, &segments, first_index)
}

fn write_whole(out: &mut dyn Write, points: &Points<'_>, segments: &Segments<'_>, first_index: u32) -> io::Result<()> {
    segments.check(points.points.len())?;
    node::write_points(out, points, first_index)?;
    write_sections(out, segments, first_index)
}

fn write_sections(out: &mut dyn Write, sections: &Segments<'_>, first_index: u32) -> io::Result<()> {
    let base = u64::from(first_index);
    writeln!(out, "{} {}", sections.segments.len(), u8::from(!sections.markers.is_empty()))?;
    let mut rows = Rows::to(out);
    for (i, segment) in sections.segments.iter().enumerate() {
        let [a, b] = segment.map(|v| u64::from(v) + base);
        rows.integer(i as u64 + base).integer(a).integer(b);
        if let Some(&marker) = sections.markers.get(i) {
            rows.integer(marker);
        }
        rows.end()?;
    }
    rows.finish()?;
    writeln!(out, "{}", sections.holes.len())?;
    for (i, hole) in sections.holes.iter().enumerate() {
        writeln!(out, "{} {} {}", i as u64 + base, Real(hole.x), Real(hole.y))?;
    }
    if !sections.regions.is_empty() {
        write_regions(out, sections.regions, base)?;
    }
    Ok(())
}

fn write_regions(out: &mut dyn Write, regions: &[Region], base: u64) -> io::Result<()> {
    writeln!(out, "{}", regions.len())?;
    for (i, region) in regions.iter().enumerate() {
        let (seed, number) = (region.seed, i as u64 + base);
        write!(out, "{number} {} {} {}", Real(seed.x), Real(seed.y), Real(region.attribute))?;
        match region.max_area {
            // Other readers take a missing area for the attribute, so "none" is written out.
            None => writeln!(out, " -1")?,
            Some(area) => writeln!(out, " {}", Real(area))?,
        }
    }
    Ok(())
}
