//! `.inp`: a mesh for Abaqus, `CalculiX` and the programs that read their input. Read and written.
//!
//! | in the file | is |
//! |---|---|
//! | `*NODE` | the vertices, numbered from 1, the third coordinate 0 |
//! | `*ELEMENT, TYPE=CPS3, ELSET=…` | the triangles of a region, numbered from 1 in the order of the mesh |
//! | `*NSET, NSET=…` | the vertices of a boundary |
//! | `*SURFACE, TYPE=ELEMENT, NAME=…` | the sides of triangles along a boundary: `<triangle>, S1` is the side from its first to its second corner |
//!
//! Names are those of [`GroupNames`], with `_` for characters other than letters, digits, `_`, `-` and `.`. Who needs
//! plane strain or shells replaces CPS3 by CPE3 or S3. Vertex attributes, vertex markers and hole seeds have no place
//! in the format.
//!
//! Read are triangles of any type with three or six nodes, of which the corners are kept, and truss and beam elements
//! as lines. A triangle is in the region of the last element set that names it, sets of surfaces excepted. Lines come
//! from surfaces, or from line elements where there is no surface. What is not about the mesh is passed over; other
//! elements and included files are refused.
//!
//! # Source
//! The `CalculiX` `CrunchiX` manual, chapter 7.

mod read;

pub use read::read;

use std::collections::BTreeMap;
use std::io::{self, Write};

use trimalla::drawing::IndexedMesh;

use crate::columns::{Points, Segments, check_triangles};
use crate::names::{Group, GroupNames, Groups};
use crate::numbers::Real;

fn is_allowed(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.')
}

/// Writes a mesh.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh, names: &GroupNames) -> io::Result<()> {
    Points::of_mesh(mesh).check(0)?;
    check_triangles(mesh)?;
    Segments::of_mesh(mesh).check(mesh.points.len())?;
    let groups = Groups::of(mesh, names, is_allowed);
    writeln!(out, "*HEADING\nmesh of trimalla\n*NODE")?;
    for (i, p) in (1_u64..).zip(&mesh.points) {
        writeln!(out, "{i}, {}, {}, 0", Real(p.x), Real(p.y))?;
    }
    for Group { name, members, .. } in &groups.regions {
        writeln!(out, "*ELEMENT, TYPE=CPS3, ELSET={name}")?;
        for &t in members {
            let [a, b, c] = mesh.triangles[t as usize].map(|v| u64::from(v) + 1);
            writeln!(out, "{}, {a}, {b}, {c}", u64::from(t) + 1)?;
        }
    }
    let sides = sides(mesh);
    for Group { name, members, .. } in &groups.boundaries {
        let lines = || members.iter().map(|&i| groups.lines[i as usize]);
        let mut vertices: Vec<u32> = lines().flatten().collect();
        vertices.sort_unstable();
        vertices.dedup();
        writeln!(out, "*NSET, NSET={name}")?;
        for row in vertices.chunks(16) {
            let row: Vec<_> = row.iter().map(|&v| (u64::from(v) + 1).to_string()).collect();
            writeln!(out, "{}", row.join(", "))?;
        }
        writeln!(out, "*SURFACE, TYPE=ELEMENT, NAME={name}")?;
        for (triangle, side) in lines().filter_map(|[a, b]| sides.get(&[a.min(b), a.max(b)])) {
            writeln!(out, "{}, S{side}", *triangle as u64 + 1)?;
        }
    }
    Ok(())
}

/// The first triangle along each edge, and which of its sides that is, counted from 1.
fn sides(mesh: &IndexedMesh) -> BTreeMap<[u32; 2], (usize, usize)> {
    let mut sides = BTreeMap::new();
    for (t, corners) in mesh.triangles.iter().enumerate() {
        for side in 0..3 {
            let (a, b) = (corners[side], corners[(side + 1) % 3]);
            sides.entry([a.min(b), a.max(b)]).or_insert((t, side + 1));
        }
    }
    sides
}
