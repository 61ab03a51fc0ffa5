//! `.neigh`: the neighbours of each triangle.
//!
//! ```text
//! <triangles> [3]
//! <number> <triangle> <triangle> <triangle>
//! ```
//! The first neighbour lies opposite the first corner of the triangle, and so on; -1 is none. An edge that more than
//! two triangles have separates them all.

use std::io::{self, Write};

use trimalla::drawing::IndexedMesh;

use crate::columns::{Points, check_triangles};
use crate::error::IoError;
use crate::numbers::Numbering;
use crate::rows::Rows;
use crate::tokens::Reader;
use crate::topology::{by_edge, sorted_sides};

/// The neighbours of one triangle, opposite its corners; indices count from 0.
pub type Neighbours = [Option<u32>; 3];

/// Reads a `.neigh` file; `name` is what errors call it. Its own first record says whether numbers start at 0 or 1.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read(bytes: &[u8], name: &str) -> Result<Vec<Neighbours>, IoError> {
    let mut reader = Reader::new(bytes, name)?;
    reader.record(|| "the number of triangles".to_owned())?;
    let count = reader.count("the number of triangles")?;
    reader.one_of_or("3 neighbours a triangle", 3, &[3])?;
    reader.end_record()?;
    let mut all = Vec::new();
    let mut rows = Numbering::new("triangle", count, None);
    while rows.next(&mut reader)? {
        let first = rows.first_index();
        all.push([reader.neighbour(first, count)?, reader.neighbour(first, count)?, reader.neighbour(first, count)?]);
        reader.end_record()?;
    }
    reader.end_file()?;
    Ok(all)
}

/// The neighbours of the triangles of a mesh.
///
/// # Errors
/// Kind `InvalidInput` where columns have wrong lengths or an index has no vertex.
pub fn neighbours_of(mesh: &IndexedMesh) -> io::Result<Vec<Neighbours>> {
    check_triangles(mesh)?;
    let mut all = vec![[None; 3]; mesh.triangles.len()];
    for group in by_edge(&sorted_sides(mesh)) {
        if let [one, other] = group {
            all[one.triangle][one.corner] = u32::try_from(other.triangle).ok();
            all[other.triangle][other.corner] = u32::try_from(one.triangle).ok();
        }
    }
    Ok(all)
}

/// Writes the neighbours of the triangles of a mesh.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths or an index has no vertex.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh, first_index: u32) -> io::Result<()> {
    Points::of_mesh(mesh).check(first_index)?;
    let neighbours = neighbours_of(mesh)?;
    let base = i64::from(first_index);
    writeln!(out, "{} 3", neighbours.len())?;
    let mut rows = Rows::to(out);
    for (i, sides) in neighbours.iter().enumerate() {
        let [a, b, c] = sides.map(|side| side.map_or(-1, |t| i64::from(t) + base));
        rows.integer(i as i64 + base).integer(a).integer(b).integer(c).end()?;
    }
    rows.finish()
}
