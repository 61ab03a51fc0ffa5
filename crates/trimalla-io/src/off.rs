//! `.off`: a mesh for viewers and programs of geometry, in the Object File Format of Geomview as plain text. Read and
//! written.
//!
//! The word `OFF`; a line with the numbers of vertices, faces and edges; a line for each vertex with three coordinates,
//! the third its height: the first attribute, or 0; a line for each triangle with the number 3 and its corners, counted
//! from 0 whatever the caller's numbering. Readers ignore the number of edges, which is written as 0. Subsegments,
//! markers, further attributes and hole seeds have no place in the format and are left out.
//!
//! Read are faces with three corners, and colours behind them passed over. The edges that one triangle only has become
//! the subsegments. `#` starts a comment.

use std::io::{self, Write};

use trimalla::drawing::IndexedMesh;

use crate::columns::{Points, check_triangles};
use crate::error::IoError;
use crate::gathered::{Gathered, NamedMesh};
use crate::numbers::Real;
use crate::surface::places;
use crate::text::{Text, Word};

/// Writes a mesh.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh) -> io::Result<()> {
    Points::of_mesh(mesh).check(0)?;
    check_triangles(mesh)?;
    writeln!(out, "OFF\n{} {} 0", mesh.points.len(), mesh.triangles.len())?;
    for [x, y, z] in places(mesh) {
        writeln!(out, "{} {} {}", Real(x), Real(y), Real(z))?;
    }
    for [a, b, c] in &mesh.triangles {
        writeln!(out, "3 {a} {b} {c}")?;
    }
    Ok(())
}

/// The next line that is not only a comment, without its comment.
fn line<'a>(text: &mut Text<'a>, expected: &str) -> Result<Word<'a>, IoError> {
    loop {
        let line = text.line().ok_or_else(|| text.ended(expected))?;
        if let Some(kept) = line.split(b'#').next().filter(|kept| !kept.text.is_empty()) {
            return Ok(kept);
        }
    }
}

/// Reads a file; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read(bytes: &[u8], name: &str) -> Result<NamedMesh, IoError> {
    let mut text = Text::new(bytes, name)?;
    let first = line(&mut text, "OFF")?;
    if !first.text.starts_with(b"OFF") {
        return Err(text.syntax(first, "OFF"));
    }
    // The counts may stand behind the word.
    let behind = first.part(3, first.text.len());
    let counts = if behind.text.is_empty() { line(&mut text, "the numbers of vertices and faces")? } else { behind };
    let mut words = counts.words();
    let (Some(points), Some(faces)) = (words.next(), words.next()) else {
        return Err(text.syntax(counts, "the numbers of vertices and faces"));
    };
    let points: u32 = text.whole_of(points, "the number of vertices")?;
    let faces: u32 = text.whole_of(faces, "the number of faces")?;
    let mut gathered = Gathered::default();
    for _ in 0..points {
        let line = line(&mut text, "a vertex")?;
        let words: Vec<_> = line.words().take(3).collect();
        let [x, y, z] = words[..] else { return Err(text.syntax(line, "three coordinates")) };
        let real = |word| text.real_of(word, "a coordinate");
        gathered.add_point(&text, line, [real(x)?, real(y)?, real(z)?])?;
    }
    for key in 0..u64::from(faces) {
        let line = line(&mut text, "a face")?;
        let words: Vec<_> = line.words().take(4).collect();
        let [count, a, b, c] = words[..] else { return Err(text.syntax(line, "3 and the corners of a triangle")) };
        if text.whole_of::<u32>(count, "3, the number of corners")? != 3 {
            return Err(text.value(count, "3, the number of corners: other faces are not read"));
        }
        let corners = [gathered.indexed(&text, a, 0)?, gathered.indexed(&text, b, 0)?, gathered.indexed(&text, c, 0)?];
        gathered.add_triangle(&text, line, corners, 0.0, key)?;
    }
    Ok(gathered.finish())
}
