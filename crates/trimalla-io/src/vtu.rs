//! `.vtu`: a mesh for ParaView, a VTK unstructured grid as XML with numbers in plain text. Read and written.
//!
//! Cells are the triangles, then the subsegments as lines, so that both can be shown and selected in one file.
//!
//! | array | of | on triangles | on lines |
//! |---|---|---|---|
//! | `region` | cells | the first attribute, 0 where there is none | -1 |
//! | `min_angle` | cells | the smallest angle in degrees | -1 |
//! | `marker` | cells | 0 | the marker, 0 where there is none |
//! | `marker` | points | the marker, 0 where there is none | |
//! | `attribute0`, … | points | the attributes | |
//!
//! All arrays but the attributes are always there, so that a state saved for one mesh fits the next. The third
//! coordinate is the first attribute of the vertex, its height; 0 where there is none. Hole seeds and further triangle
//! attributes are left out.
//!
//! Read are files of one piece whose arrays are plain text, with cells that are triangles or lines, also quadratic
//! ones, of which the corners are kept. Other arrays than those of the table are passed over; arrays of `region` or
//! `marker` that are all 0 stand for none. Files in which data is compressed or in base64 are refused.

use std::fmt::Display;
use std::io::{self, Write};

use trimalla::drawing::IndexedMesh;
use trimalla::geometry::Triangle;

use crate::cells::{LINE, TRIANGLE};
use crate::columns::{Points, Segments, check_triangles};
use crate::numbers::Real;
use crate::surface::places;

mod read;

pub use read::read;

/// Writes a mesh.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh) -> io::Result<()> {
    Points::of_mesh(mesh).check(0)?;
    check_triangles(mesh)?;
    Segments::of_mesh(mesh).check(mesh.points.len())?;
    let cells = mesh.triangles.len() + mesh.segments.len();
    writeln!(out, "<?xml version=\"1.0\"?>")?;
    writeln!(out, "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">")?;
    writeln!(out, "<UnstructuredGrid>")?;
    writeln!(out, "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{cells}\">", mesh.points.len())?;
    write_points(out, mesh)?;
    write_cells(out, mesh)?;
    write_point_data(out, mesh)?;
    write_cell_data(out, mesh)?;
    writeln!(out, "</Piece>\n</UnstructuredGrid>\n</VTKFile>")
}

fn write_points(out: &mut dyn Write, mesh: &IndexedMesh) -> io::Result<()> {
    writeln!(out, "<Points>")?;
    let rows = places(mesh).map(|[x, y, z]| format!("{} {} {}", Real(x), Real(y), Real(z)));
    write_array(out, "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", rows)?;
    writeln!(out, "</Points>")
}

fn write_cells(out: &mut dyn Write, mesh: &IndexedMesh) -> io::Result<()> {
    writeln!(out, "<Cells>")?;
    let triangles = mesh.triangles.iter().map(|[a, b, c]| format!("{a} {b} {c}"));
    let lines = mesh.segments.iter().map(|[a, b]| format!("{a} {b}"));
    write_array(out, "type=\"Int64\" Name=\"connectivity\"", triangles.chain(lines))?;
    let corners = 3 * mesh.triangles.len() as u64;
    let after_triangles = (1..=mesh.triangles.len() as u64).map(|i| 3 * i);
    let after_lines = (1..=mesh.segments.len() as u64).map(|i| corners + 2 * i);
    write_array(out, "type=\"Int64\" Name=\"offsets\"", after_triangles.chain(after_lines))?;
    write_array(out, "type=\"UInt8\" Name=\"types\"", per_cell(mesh, |_| TRIANGLE, |_| LINE))?;
    writeln!(out, "</Cells>")
}

fn write_point_data(out: &mut dyn Write, mesh: &IndexedMesh) -> io::Result<()> {
    writeln!(out, "<PointData>")?;
    let marker = |i: usize| mesh.point_markers.get(i).copied().unwrap_or(0);
    write_array(out, "type=\"Int32\" Name=\"marker\"", (0..mesh.points.len()).map(marker))?;
    // A column of a mesh without vertices would have any width.
    let width = if mesh.points.is_empty() { 0 } else { mesh.attributes_per_point };
    for column in 0..width {
        let values = mesh.point_attributes.iter().skip(column).step_by(width).map(|&value| Real(value));
        write_array(out, &format!("type=\"Float64\" Name=\"attribute{column}\""), values)?;
    }
    writeln!(out, "</PointData>")
}

fn write_cell_data(out: &mut dyn Write, mesh: &IndexedMesh) -> io::Result<()> {
    let marker = |s: usize| mesh.segment_markers.get(s).copied().unwrap_or(0);
    writeln!(out, "<CellData>")?;
    write_array(out, "type=\"Float64\" Name=\"region\"", per_cell(mesh, |t| Real(region_of(mesh, t)), |_| Real(-1.0)))?;
    write_array(
        out,
        "type=\"Float64\" Name=\"min_angle\"",
        per_cell(mesh, |t| Real(min_angle_deg(mesh, t)), |_| Real(-1.0)),
    )?;
    write_array(out, "type=\"Int32\" Name=\"marker\"", per_cell(mesh, |_| 0, marker))?;
    writeln!(out, "</CellData>")
}

/// The first attribute of a triangle, or 0.
pub(crate) fn region_of(mesh: &IndexedMesh, t: usize) -> f64 {
    match mesh.attributes_per_triangle {
        0 => 0.0,
        width => mesh.triangle_attributes[t * width],
    }
}

/// The smallest angle of a triangle.
pub(crate) fn min_angle_deg(mesh: &IndexedMesh, t: usize) -> f64 {
    let [a, b, c] = mesh.triangles[t].map(|v| mesh.points[v as usize]);
    Triangle::new(a, b, c).min_angle().degrees()
}

/// The values of all cells, given those of triangles and of subsegments by index.
pub(crate) fn per_cell<T>(
    mesh: &IndexedMesh,
    of_triangle: impl Fn(usize) -> T,
    of_segment: impl Fn(usize) -> T,
) -> impl Iterator<Item = T> {
    (0..mesh.triangles.len()).map(of_triangle).chain((0..mesh.segments.len()).map(of_segment))
}

/// One array, a line each entry.
fn write_array(out: &mut dyn Write, head: &str, rows: impl Iterator<Item = impl Display>) -> io::Result<()> {
    writeln!(out, "<DataArray {head} format=\"ascii\">")?;
    for row in rows {
        writeln!(out, "{row}")?;
    }
    writeln!(out, "</DataArray>")
}
