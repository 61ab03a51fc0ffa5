//! `.stl`: triangles for printers and programs of computer graphics, as plain text. Read and written.
//!
//! Each region is a solid with a name by the rule of [`GroupNames`]; each triangle has the coordinates of its corners,
//! the third of which is the height: the first attribute of the vertex, or 0. Normals are unit vectors that point up.
//! Everything else about a mesh has no place in the format.
//!
//! Read is plain text: corners of equal coordinates become one vertex, vertices are in the order of their first
//! corners, and the edges that one triangle only has become the subsegments. Normals are passed over. Binary files are
//! refused.
//!
//! # Source
//! *Stereolithography Interface Specification*, 3D Systems, 1989.

use std::collections::HashMap;
use std::io::{self, Write};

use trimalla::drawing::IndexedMesh;

use crate::columns::{Points, check_triangles};
use crate::error::IoError;
use crate::gathered::{Gathered, NamedMesh};
use crate::names::{Group, GroupNames, Groups, attribute_of, numbers};
use crate::numbers::Real;
use crate::surface::place;
use crate::text::{Text, Word};

/// Writes a mesh.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh, names: &GroupNames) -> io::Result<()> {
    Points::of_mesh(mesh).check(0)?;
    check_triangles(mesh)?;
    let groups = Groups::of(mesh, names, |c| !c.is_whitespace());
    for Group { name, members, .. } in &groups.regions {
        writeln!(out, "solid {name}")?;
        for &t in members {
            let corners = mesh.triangles[t as usize].map(|v| place(mesh, v as usize));
            let [x, y, z] = normal(corners).map(Real);
            writeln!(out, "facet normal {x} {y} {z}\nouter loop")?;
            for [x, y, z] in corners {
                writeln!(out, "vertex {} {} {}", Real(x), Real(y), Real(z))?;
            }
            writeln!(out, "endloop\nendfacet")?;
        }
        writeln!(out, "endsolid {name}")?;
    }
    Ok(())
}

/// The direction that is square to a triangle, of length 1; straight up where rounding leaves none.
fn normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let from_a = |p: [f64; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
    let (u, v) = (from_a(b), from_a(c));
    let size = u.iter().chain(&v).fold(0.0_f64, |size, x| size.max(x.abs()));
    let (u, v) = (u.map(|x| x / size), v.map(|x| x / size));
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
    let unit = n.map(|x| x / length);
    if unit.iter().all(|x| x.is_finite()) { unit } else { [0.0, 0.0, 1.0] }
}

/// Reads a file; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read(bytes: &[u8], name: &str) -> Result<NamedMesh, IoError> {
    let mut text = Text::new(bytes, name)?;
    let mut gathered = Gathered::default();
    let mut corners = Corners::default();
    let mut solids: Vec<String> = Vec::new();
    let mut triangles: Vec<(Word<'_>, [u32; 3], usize)> = Vec::new();
    while let Some(line) = text.line() {
        let mut words = line.words();
        let key = words.next().unwrap_or(line);
        if key.is("solid") {
            solids.push(words.next().map_or_else(String::new, |word| String::from_utf8_lossy(word.text).into_owned()));
        } else if key.is("facet") && !solids.is_empty() {
            triangles.push((line, read_facet(&mut text, &mut gathered, &mut corners)?, solids.len() - 1));
        } else if !key.is("endsolid") {
            return Err(text.syntax(line, if solids.is_empty() { "solid" } else { "facet or endsolid" }));
        }
    }
    if solids.is_empty() {
        return Err(text.ended("solid"));
    }
    let own = |name: &str| attribute_of(name).map(|value| value as i32).filter(|&value| value > 0);
    let tags = numbers(solids.iter().map(String::as_str), own);
    for (key, (line, corners, solid)) in (0..).zip(triangles) {
        // A lone solid of no name, or of a name that is none of ours, is no region.
        let name = solids[solid].as_str();
        let is_region = solids.len() > 1 || attribute_of(name).is_some();
        let region = if is_region { gathered.region(tags[solid], Some(name)) } else { 0.0 };
        gathered.add_triangle(&text, line, corners, region, key)?;
    }
    Ok(gathered.finish())
}

/// A triangle, behind its first line.
fn read_facet(text: &mut Text<'_>, gathered: &mut Gathered, corners: &mut Corners) -> Result<[u32; 3], IoError> {
    expect(text, &["outer", "loop"])?;
    let mut vertices = [0; 3];
    for vertex in &mut vertices {
        let word = expect(text, &["vertex"])?;
        let place = [text.real("an x coordinate")?, text.real("a y coordinate")?, text.real("a z coordinate")?];
        *vertex = corners.index(text, word, gathered, place)?;
    }
    expect(text, &["endloop", "endfacet"])?;
    Ok(vertices)
}

/// Passes over these words; the last of them.
fn expect<'a>(text: &mut Text<'a>, expected: &[&str]) -> Result<Word<'a>, IoError> {
    let mut last = None;
    for &expected in expected {
        let word = text.expect(expected)?;
        if !word.is(expected) {
            return Err(text.syntax(word, expected));
        }
        last = Some(word);
    }
    last.ok_or_else(|| text.ended("a word"))
}

/// Vertices by coordinates.
#[derive(Debug, Default)]
struct Corners {
    index_of: HashMap<[u64; 3], u32>,
}

impl Corners {
    /// The vertex of these coordinates, a new one where they are new.
    fn index(
        &mut self,
        text: &Text<'_>,
        word: Word<'_>,
        gathered: &mut Gathered,
        place: [f64; 3],
    ) -> Result<u32, IoError> {
        // Adding zero turns -0 into 0 and leaves every other number as it is.
        let key = place.map(|x| (x + 0.0).to_bits());
        if let Some(&index) = self.index_of.get(&key) {
            return Ok(index);
        }
        let index = gathered.vertices() as u32;
        gathered.add_point(text, word, place)?;
        self.index_of.insert(key, index);
        Ok(index)
    }
}
