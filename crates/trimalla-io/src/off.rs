//! `.off`: a mesh for viewers and programs of geometry, in the Object File Format of Geomview as plain text. Written
//! only.
//!
//! The word `OFF`; a line with the numbers of vertices, faces and edges; a line for each vertex with three coordinates,
//! the third 0; a line for each triangle with the number 3 and its corners, counted from 0 whatever the caller's
//! numbering. Readers ignore the number of edges, which is written as 0. Subsegments, markers, attributes and hole
//! seeds have no place in the format and are left out.

use std::io::{self, Write};

use trimalla::drawing::IndexedMesh;

use crate::columns::{Points, check_triangles};
use crate::numbers::Real;

/// Writes a mesh.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh) -> io::Result<()> {
    Points::of_mesh(mesh).check(0)?;
    check_triangles(mesh)?;
    writeln!(out, "OFF\n{} {} 0", mesh.points.len(), mesh.triangles.len())?;
    for p in &mesh.points {
        writeln!(out, "{} {} 0", Real(p.x), Real(p.y))?;
    }
    for [a, b, c] in &mesh.triangles {
        writeln!(out, "3 {a} {b} {c}")?;
    }
    Ok(())
}
