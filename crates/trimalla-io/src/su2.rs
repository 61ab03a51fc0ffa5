//! `.su2`: a mesh for SU2. Read and written.
//!
//! The file has two dimensions, the triangles, the vertices, and a marker for each boundary, with its name by the rule
//! of [`GroupNames`] (blanks become `_`) and the edges along it. Markers are the boundary of the domain, as SU2 wants
//! them: each edge of it is in one, and runs with the domain on its left; subsegments inside are left out. Vertices and
//! triangles are numbered from 0. Regions, attributes, vertex markers and hole seeds have no place in the format.
//!
//! Read are files of two dimensions with triangles; other elements are refused. `%` starts a comment.
//!
//! # Source
//! The SU2 documentation, "Mesh File".

use std::collections::BTreeMap;
use std::io::{self, Write};

use trimalla::drawing::IndexedMesh;

use crate::columns::{Points, Segments, check_triangles};
use crate::error::IoError;
use crate::gathered::{Gathered, NamedMesh};
use crate::names::{Group, GroupNames, Groups, marker_of, numbers};
use crate::rows::Rows;
use crate::text::{Text, Word};

const LINE: u8 = 3;
const TRIANGLE: u8 = 5;
/// The marker of boundary edges that are no subsegments.
const UNMARKED: &str = "boundary";

/// Writes a mesh.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh, names: &GroupNames) -> io::Result<()> {
    Points::of_mesh(mesh).check(0)?;
    check_triangles(mesh)?;
    Segments::of_mesh(mesh).check(mesh.points.len())?;
    writeln!(out, "NDIME= 2\nNELEM= {}", mesh.triangles.len())?;
    let mut rows = Rows::to(out);
    for (i, &[a, b, c]) in (0_u64..).zip(&mesh.triangles) {
        rows.integer(TRIANGLE).integer(a).integer(b).integer(c).integer(i).end()?;
    }
    rows.finish()?;
    writeln!(out, "NPOIN= {}", mesh.points.len())?;
    let mut rows = Rows::to(out);
    for (i, p) in (0_u64..).zip(&mesh.points) {
        rows.real(p.x).real(p.y).integer(i).end()?;
    }
    rows.finish()?;
    write_markers(out, mesh, names)
}

fn write_markers(out: &mut dyn Write, mesh: &IndexedMesh, names: &GroupNames) -> io::Result<()> {
    let groups = Groups::of(mesh, names, |c| !c.is_whitespace() && c != '%' && c != '=');
    let mut group_of = BTreeMap::new();
    for (g, Group { members, .. }) in groups.boundaries.iter().enumerate() {
        for [a, b] in members.iter().map(|&i| groups.lines[i as usize]) {
            group_of.entry([a.min(b), a.max(b)]).or_insert(g);
        }
    }
    let unmarked = groups.boundaries.len();
    let mut edges = vec![Vec::new(); unmarked + 1];
    for [a, b] in mesh.boundary_edges() {
        edges[*group_of.get(&[a.min(b), a.max(b)]).unwrap_or(&unmarked)].push([a, b]);
    }
    let names = groups.boundaries.iter().map(|group| group.name.as_str()).chain([UNMARKED]);
    let markers: Vec<_> = names.zip(edges).filter(|(_, edges)| !edges.is_empty()).collect();
    writeln!(out, "NMARK= {}", markers.len())?;
    for (name, edges) in markers {
        writeln!(out, "MARKER_TAG= {name}\nMARKER_ELEMS= {}", edges.len())?;
        for [a, b] in edges {
            writeln!(out, "{LINE} {a} {b}")?;
        }
    }
    Ok(())
}

/// A line of a file: a keyword and its value, or numbers.
struct Lines<'a> {
    text: Text<'a>,
}

impl<'a> Lines<'a> {
    /// The next line that is not only a comment, without its comment.
    fn next(&mut self) -> Option<Word<'a>> {
        loop {
            let line = self.text.line()?;
            let kept = line.split(b'%').next().filter(|kept| !kept.text.is_empty());
            if kept.is_some() {
                return kept;
            }
        }
    }

    /// The next line, which must be there.
    fn expect(&mut self, what: &str) -> Result<Word<'a>, IoError> {
        self.next().ok_or_else(|| self.text.ended(what))
    }

    /// The first column of a line as a number.
    fn number(&self, line: Word<'a>, what: &str) -> Result<u32, IoError> {
        let word = line.words().next().ok_or_else(|| self.text.syntax(line, what))?;
        self.text.whole_of(word, what)
    }

    /// The vertices of an element line, which begins with its type; a number may follow them.
    fn element<const N: usize>(&self, line: Word<'a>, kind: u8, what: &str) -> Result<[Word<'a>; N], IoError> {
        let mut words = line.words();
        let first = words.next().ok_or_else(|| self.text.syntax(line, what))?;
        if self.text.whole_of::<u32>(first, what)? != u32::from(kind) {
            return Err(self.text.value(first, what));
        }
        let vertices: Vec<_> = words.take(N).collect();
        vertices.try_into().map_err(|_| self.text.syntax(line, what))
    }
}

/// Reads a `.su2` file; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read(bytes: &[u8], name: &str) -> Result<NamedMesh, IoError> {
    let mut lines = Lines { text: Text::new(bytes, name)? };
    let mut gathered = Gathered::default();
    // Elements may come before the vertices that they name.
    let mut triangles = Vec::new();
    let mut markers: Vec<(Word<'_>, Vec<[Word<'_>; 2]>)> = Vec::new();
    let mut has_points = false;
    while let Some(line) = lines.next() {
        let mut sides = line.split(b'=');
        let key = sides.next().unwrap_or(line);
        let value = sides.next().ok_or_else(|| lines.text.syntax(line, "a keyword and '='"))?;
        match key.text {
            b"NDIME" if lines.number(value, "2, the number of dimensions")? != 2 => {
                return Err(lines.text.value(value, "2, the number of dimensions"));
            }
            b"NZONE" if lines.number(value, "1, the number of zones")? != 1 => {
                return Err(lines.text.value(value, "1, the number of zones: several are not read"));
            }
            b"NELEM" => {
                for _ in 0..lines.number(value, "the number of elements")? {
                    let line = lines.expect("an element")?;
                    let corners: [_; 3] =
                        lines.element(line, TRIANGLE, "5 and three vertices: other elements are not read")?;
                    triangles.push((line, corners));
                }
            }
            b"NPOIN" => {
                has_points = true;
                for _ in 0..lines.number(value, "the number of vertices")? {
                    let line = lines.expect("a vertex")?;
                    let mut words = line.words();
                    let (Some(x), Some(y)) = (words.next(), words.next()) else {
                        return Err(lines.text.syntax(line, "two coordinates"));
                    };
                    let place =
                        [lines.text.real_of(x, "an x coordinate")?, lines.text.real_of(y, "a y coordinate")?, 0.0];
                    gathered.add_point(&lines.text, line, place)?;
                }
            }
            b"MARKER_TAG" => markers.push((value, Vec::new())),
            b"MARKER_ELEMS" => {
                let Some((_, edges)) = markers.last_mut() else {
                    return Err(lines.text.syntax(line, "MARKER_TAG="));
                };
                for _ in 0..lines.number(value, "the number of edges")? {
                    let line = lines.expect("an edge")?;
                    edges.push(lines.element(line, LINE, "3 and two vertices")?);
                }
            }
            _ => {}
        }
    }
    if !has_points {
        return Err(lines.text.ended("NPOIN="));
    }
    finish(&lines.text, gathered, triangles, &markers)
}

fn finish(
    text: &Text<'_>,
    mut gathered: Gathered,
    triangles: Vec<(Word<'_>, [Word<'_>; 3])>,
    markers: &[(Word<'_>, Vec<[Word<'_>; 2]>)],
) -> Result<NamedMesh, IoError> {
    for (key, (line, [a, b, c])) in (0..).zip(triangles) {
        let corners = [gathered.indexed(text, a, 0)?, gathered.indexed(text, b, 0)?, gathered.indexed(text, c, 0)?];
        gathered.add_triangle(text, line, corners, 0.0, key)?;
    }
    let names: Vec<_> = markers.iter().map(|(name, _)| String::from_utf8_lossy(name.text)).collect();
    let own = |name: &str| marker_of(name).filter(|&marker| marker > 0);
    let tags = numbers(names.iter().map(AsRef::as_ref), own);
    for (((_, edges), name), tag) in markers.iter().zip(&names).zip(tags) {
        for &[a, b] in edges {
            let ends = [gathered.indexed(text, a, 0)?, gathered.indexed(text, b, 0)?];
            let marker = gathered.boundary(tag, Some(name));
            let key = gathered.counts().1 as u64;
            gathered.add_line(ends, marker, key);
        }
    }
    Ok(gathered.finish())
}
