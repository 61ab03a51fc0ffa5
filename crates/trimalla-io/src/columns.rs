//! Borrowed views of meshes and drawings for the writers, checked once before the first byte is written.
//!
//! The fields of [`IndexedMesh`] and [`Pslg`] are public, so their columns may have any length and their indices any
//! value. What cannot be written so that it reads back is refused here, with its number, as an error of kind
//! `InvalidInput`.

use std::io;

use trimalla::drawing::{IndexedMesh, Pslg, Region};
use trimalla::geometry::Point;

/// Vertices and their columns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Points<'a> {
    pub(crate) points: &'a [Point],
    pub(crate) markers: &'a [i32],
    pub(crate) attributes_per_point: usize,
    pub(crate) attributes: &'a [f64],
}

/// Segments, their markers, and the seeds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Segments<'a> {
    pub(crate) segments: &'a [[u32; 2]],
    pub(crate) markers: &'a [i32],
    pub(crate) holes: &'a [Point],
    pub(crate) regions: &'a [Region],
}

impl<'a> Points<'a> {
    pub(crate) fn of_mesh(mesh: &'a IndexedMesh) -> Self {
        Self {
            points: &mesh.points,
            markers: &mesh.point_markers,
            attributes_per_point: mesh.attributes_per_point,
            attributes: &mesh.point_attributes,
        }
    }

    pub(crate) fn of_pslg(pslg: &'a Pslg) -> Self {
        Self {
            points: &pslg.points,
            markers: &pslg.point_markers,
            attributes_per_point: pslg.attributes_per_point,
            attributes: &pslg.point_attributes,
        }
    }

    pub(crate) fn check(&self, first_index: u32) -> io::Result<()> {
        if first_index > 1 {
            return Err(invalid(format!("numbering must start at 0 or 1, not at {first_index}")));
        }
        check_optional("vertex markers", self.markers.len(), self.points.len())?;
        check_rows("vertex attributes", self.attributes.len(), self.points.len(), self.attributes_per_point)?;
        check_points("vertex", self.points)?;
        check_reals("vertex attribute", self.attributes)
    }
}

impl<'a> Segments<'a> {
    pub(crate) fn of_mesh(mesh: &'a IndexedMesh) -> Self {
        Self { segments: &mesh.segments, markers: &mesh.segment_markers, holes: &mesh.holes, regions: &[] }
    }

    pub(crate) fn of_pslg(pslg: &'a Pslg) -> Self {
        Self { segments: &pslg.segments, markers: &pslg.segment_markers, holes: &pslg.holes, regions: &pslg.regions }
    }

    pub(crate) fn check(&self, vertices: usize) -> io::Result<()> {
        check_optional("segment markers", self.markers.len(), self.segments.len())?;
        check_indices("segment", self.segments, vertices)?;
        check_points("hole", self.holes)?;
        for (i, region) in self.regions.iter().enumerate() {
            let numbers = [region.seed.x, region.seed.y, region.attribute, region.max_area.unwrap_or(0.0)];
            check_finite("region", i, &numbers)?;
        }
        Ok(())
    }
}

/// Checks the triangles of a mesh and their attributes.
pub(crate) fn check_triangles(mesh: &IndexedMesh) -> io::Result<()> {
    check_rows(
        "triangle attributes",
        mesh.triangle_attributes.len(),
        mesh.triangles.len(),
        mesh.attributes_per_triangle,
    )?;
    check_indices("triangle", &mesh.triangles, mesh.points.len())?;
    check_reals("triangle attribute", &mesh.triangle_attributes)
}

/// An error about what is to be written, not about where.
pub(crate) fn invalid(what: String) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, what)
}

fn check_optional(column: &str, found: usize, rows: usize) -> io::Result<()> {
    if found == 0 || found == rows { Ok(()) } else { Err(invalid(format!("{found} {column} for {rows} rows"))) }
}

fn check_rows(column: &str, found: usize, rows: usize, width: usize) -> io::Result<()> {
    if rows.checked_mul(width) == Some(found) {
        Ok(())
    } else {
        Err(invalid(format!("{found} {column} for {rows} rows of {width}")))
    }
}

fn check_indices<const N: usize>(noun: &str, rows: &[[u32; N]], vertices: usize) -> io::Result<()> {
    for (i, row) in rows.iter().enumerate() {
        if let Some(vertex) = row.iter().find(|&&v| v as usize >= vertices) {
            return Err(invalid(format!("{noun} {i} names vertex {vertex}, but there are {vertices} vertices")));
        }
    }
    Ok(())
}

fn check_points(noun: &str, points: &[Point]) -> io::Result<()> {
    points.iter().enumerate().try_for_each(|(i, p)| check_finite(noun, i, &[p.x, p.y]))
}

fn check_reals(noun: &str, numbers: &[f64]) -> io::Result<()> {
    numbers.iter().enumerate().try_for_each(|(i, n)| check_finite(noun, i, &[*n]))
}

fn check_finite(noun: &str, index: usize, numbers: &[f64]) -> io::Result<()> {
    match numbers.iter().find(|n| !n.is_finite()) {
        None => Ok(()),
        Some(n) => Err(invalid(format!("{noun} {index} has the value {n}, which is not finite"))),
    }
}
