//! `.mesh`: a mesh or a drawing for Medit, `FreeFem`, Mmg and MFEM, as plain text. Read and written.
//!
//! Sections are vertices, triangles and edges, each with the number of rows and, at the end of each row, a *reference*:
//! the marker of a vertex or a subsegment, the first attribute of a triangle if it is a whole number of 32 bits. Where
//! attributes are others, regions are numbered by the rule of [`GroupNames`]. References are 0 where
//! a mesh has no markers or attributes, those of edges 1. Names, vertex attributes and hole seeds have no place in the
//! format.
//!
//! Read are files of two or three dimensions; sections that are not about triangles, edges or vertices are passed over,
//! and quadrilaterals and solids are refused. A section whose references are all 0 has no markers or attributes.
//! `MeshSuite`'s files, which begin with a number, may have the same ending: [`is_medit`] tells them apart.
//!
//! # Source
//! P. J. Frey, *MEDIT: An interactive mesh visualization software*, INRIA RT-0253, 2001, appendix.

use std::io::{self, Write};

use trimalla::drawing::{IndexedMesh, Pslg};

use crate::columns::{Points, Segments, check_triangles, invalid};
use crate::error::IoError;
use crate::gathered::{Gathered, NamedMesh};
use crate::names::{GroupNames, Groups};
use crate::rows::Rows;
use crate::text::{Text, Word};

/// Whether a file begins as Medit's do: with a word, behind comments.
#[must_use]
pub fn is_medit(bytes: &[u8]) -> bool {
    let Ok(mut text) = Text::new(bytes, "") else { return false };
    next(&mut text).is_some_and(|word| word.is("MeshVersionFormatted"))
}

/// Writes a mesh.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh) -> io::Result<()> {
    check_triangles(mesh)?;
    write_vertices(out, &Points::of_mesh(mesh))?;
    Segments::of_mesh(mesh).check(mesh.points.len())?;
    writeln!(out, "Triangles\n{}", mesh.triangles.len())?;
    let mut rows = Rows::to(out);
    for (corners, reference) in mesh.triangles.iter().zip(references(mesh)) {
        rows.one_based(corners).integer(reference).end()?;
    }
    rows.finish()?;
    write_edges(out, &Segments::of_mesh(mesh))
}

/// Writes a drawing.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex, a number is not
/// finite, or the drawing has seeds of holes or regions, for which there is no place.
pub fn write_pslg(out: &mut dyn Write, pslg: &Pslg) -> io::Result<()> {
    if !pslg.holes.is_empty() || !pslg.regions.is_empty() {
        let what = "Medit's format has no place for the seeds of holes and regions: write .poly or .meshsuite";
        return Err(invalid(what.to_owned()));
    }
    Segments::of_pslg(pslg).check(pslg.points.len())?;
    write_vertices(out, &Points::of_pslg(pslg))?;
    write_edges(out, &Segments::of_pslg(pslg))
}

fn write_vertices(out: &mut dyn Write, points: &Points<'_>) -> io::Result<()> {
    points.check(0)?;
    writeln!(out, "MeshVersionFormatted 2\n\nDimension 2\n\nVertices\n{}", points.points.len())?;
    let mut rows = Rows::to(out);
    for (i, p) in points.points.iter().enumerate() {
        rows.real(p.x).real(p.y).integer(points.markers.get(i).copied().unwrap_or(0)).end()?;
    }
    rows.finish()
}

fn write_edges(out: &mut dyn Write, segments: &Segments<'_>) -> io::Result<()> {
    writeln!(out, "Edges\n{}", segments.segments.len())?;
    let mut rows = Rows::to(out);
    for (i, ends) in segments.segments.iter().enumerate() {
        rows.one_based(ends).integer(segments.markers.get(i).copied().unwrap_or(1)).end()?;
    }
    rows.finish()?;
    writeln!(out, "End")
}

/// The references of the triangles.
fn references(mesh: &IndexedMesh) -> Vec<i32> {
    let width = mesh.attributes_per_triangle;
    if width == 0 {
        return vec![0; mesh.triangles.len()];
    }
    let firsts = || mesh.triangle_attributes.iter().step_by(width);
    if firsts().all(|&value| f64::from(value as i32) == value) {
        return firsts().map(|&value| value as i32).collect();
    }
    Groups::of(mesh, &GroupNames::default(), |_| true).region_tags(mesh.triangles.len())
}

/// The next word that is not in a comment.
fn next<'a>(text: &mut Text<'a>) -> Option<Word<'a>> {
    loop {
        let word = text.word()?;
        if !word.text.starts_with(b"#") {
            return Some(word);
        }
        text.skip_line();
    }
}

/// Reads a file; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read(bytes: &[u8], name: &str) -> Result<NamedMesh, IoError> {
    let mut reader = Reader::new(bytes, name)?;
    reader.sections()?;
    if !reader.has_triangles {
        return Err(reader.text.ended("the section Triangles"));
    }
    Ok(reader.finish())
}

/// Reads a drawing, whose triangles are left out; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read_pslg(bytes: &[u8], name: &str) -> Result<Pslg, IoError> {
    let mut reader = Reader::new(bytes, name)?;
    reader.sections()?;
    let NamedMesh { mesh, .. } = reader.finish();
    Ok(Pslg {
        points: mesh.points,
        point_markers: mesh.point_markers,
        attributes_per_point: mesh.attributes_per_point,
        point_attributes: mesh.point_attributes,
        segments: mesh.segments,
        segment_markers: mesh.segment_markers,
        ..Pslg::default()
    })
}

struct Reader<'a> {
    text: Text<'a>,
    gathered: Gathered,
    dimension: u8,
    markers: Vec<i32>,
    has_triangles: bool,
}

impl<'a> Reader<'a> {
    fn new(bytes: &'a [u8], name: &'a str) -> Result<Self, IoError> {
        let mut text = Text::new(bytes, name)?;
        let word = next(&mut text).ok_or_else(|| text.ended("MeshVersionFormatted"))?;
        if !word.is("MeshVersionFormatted") {
            return Err(text.syntax(word, "MeshVersionFormatted"));
        }
        let mut reader =
            Self { text, gathered: Gathered::default(), dimension: 0, markers: vec![], has_triangles: false };
        reader.whole::<u8>("the version of the format")?;
        Ok(reader)
    }

    fn whole<T: std::str::FromStr>(&mut self, what: &str) -> Result<T, IoError> {
        let word = self.expect(what)?;
        self.text.whole_of(word, what)
    }

    fn expect(&mut self, what: &str) -> Result<Word<'a>, IoError> {
        next(&mut self.text).ok_or_else(|| self.text.ended(what))
    }

    fn sections(&mut self) -> Result<(), IoError> {
        while let Some(word) = next(&mut self.text) {
            match word.text {
                b"Dimension" => self.dimension = self.whole("2 or 3, the dimension")?,
                b"Vertices" => self.vertices(word)?,
                b"Triangles" => self.triangles()?,
                b"Edges" => self.edges()?,
                b"End" => return Ok(()),
                b"Quadrilaterals" | b"Tetrahedra" | b"Hexahedra" | b"Prisms" | b"Pyramids" => {
                    if self.whole::<u32>("the number of elements")? > 0 {
                        return Err(self.text.value(word, "triangles and edges: other elements are not read"));
                    }
                }
                text if text.first().is_some_and(u8::is_ascii_alphabetic) => {} // Of no concern, and so its numbers.
                _ if word.parse::<f64>().is_some() => {}
                _ => return Err(self.text.syntax(word, "the name of a section")),
            }
        }
        Ok(())
    }

    fn vertices(&mut self, section: Word<'a>) -> Result<(), IoError> {
        if !matches!(self.dimension, 2 | 3) {
            return Err(self.text.syntax(section, "Dimension 2 or 3 before the vertices"));
        }
        for _ in 0..self.whole::<u32>("the number of vertices")? {
            let first = self.expect("an x coordinate")?;
            let x = self.text.real_of(first, "an x coordinate")?;
            let y = self.real("a y coordinate")?;
            let z = if self.dimension == 3 { self.real("a z coordinate")? } else { 0.0 };
            self.gathered.add_point(&self.text, first, [x, y, z])?;
            let marker = self.whole("a reference")?;
            self.markers.push(marker);
        }
        Ok(())
    }

    fn real(&mut self, what: &str) -> Result<f64, IoError> {
        let word = self.expect(what)?;
        self.text.real_of(word, what)
    }

    fn vertex(&mut self) -> Result<u32, IoError> {
        let word = self.expect("the index of a vertex")?;
        self.gathered.indexed(&self.text, word, 1)
    }

    fn triangles(&mut self) -> Result<(), IoError> {
        self.has_triangles = true;
        for _ in 0..self.whole::<u32>("the number of triangles")? {
            let first = self.expect("the index of a vertex")?;
            let corners = [self.gathered.indexed(&self.text, first, 1)?, self.vertex()?, self.vertex()?];
            let reference: i32 = self.whole("a reference")?;
            self.gathered.has_regions |= reference != 0;
            let key = self.gathered.counts().0 as u64;
            self.gathered.add_triangle(&self.text, first, corners, f64::from(reference), key)?;
        }
        Ok(())
    }

    fn edges(&mut self) -> Result<(), IoError> {
        for _ in 0..self.whole::<u32>("the number of edges")? {
            let ends = [self.vertex()?, self.vertex()?];
            let reference: i32 = self.whole("a reference")?;
            self.gathered.has_markers |= reference != 0;
            let key = self.gathered.counts().1 as u64;
            self.gathered.add_line(ends, reference, key);
        }
        Ok(())
    }

    fn finish(self) -> NamedMesh {
        let mut named = self.gathered.finish();
        if self.markers.iter().any(|&marker| marker != 0) {
            named.mesh.point_markers = self.markers;
        }
        named
    }
}
