//! `.soup`: triangles as the coordinates of their corners, without indices.
//!
//! ```text
//! <x1> <y1> <x2> <y2> <x3> <y3>
//! ```
//! There is no header: a file that was cut off between two lines is a smaller soup. Corners of equal coordinates (0 and
//! -0 are equal) become one vertex, and vertices are in the order of their first corners. Clockwise triangles are
//! turned by exchanging their second and third corner; whether a triangle is clockwise or has no area is decided
//! exactly. The edges that one triangle only has become the subsegments. Overlaps and gaps are left to a check.
//!
//! # Source
//! The input of Sanhueza's Lepp tool (slides, `Triangles1.txt`); hence `.txt` is read as a soup, too.

use std::collections::HashMap;
use std::io::{self, Write};

use trimalla::drawing::IndexedMesh;
use trimalla::geometry::{Orientation, Point, orient2d};

use crate::columns::{Points, check_triangles};
use crate::error::IoError;
use crate::numbers::Real;
use crate::tokens::{Reader, Token};
use crate::topology::{by_edge, sorted_sides};

/// Reads a soup; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault; a triangle without area is one.
pub fn read(bytes: &[u8], name: &str) -> Result<IndexedMesh, IoError> {
    let mut reader = Reader::new(bytes, name)?;
    let mut vertices = Vertices::default();
    let mut triangles = Vec::new();
    while reader.advance() {
        let row = reader.mark();
        let corners = [corner(&mut reader, 1)?, corner(&mut reader, 2)?, corner(&mut reader, 3)?];
        let text = reader.since(row);
        reader.end_record()?;
        let mut index = |p: Point| vertices.index(p).ok_or_else(|| too_many(&reader, text));
        let [a, b, c] = [index(corners[0])?, index(corners[1])?, index(corners[2])?];
        triangles.push(match orient2d(corners[0], corners[1], corners[2]) {
            Orientation::CounterClockwise => [a, b, c],
            Orientation::Clockwise => [a, c, b],
            Orientation::Collinear => return Err(reader.value(text, "a triangle with an area")),
        });
    }
    let mesh = IndexedMesh {
        input_points: vertices.points.len(),
        points: vertices.points,
        triangles,
        ..IndexedMesh::default()
    };
    Ok(IndexedMesh { segments: boundary(&mesh), ..mesh })
}

fn corner(reader: &mut Reader<'_>, number: u8) -> Result<Point, IoError> {
    let x = reader.real(&format!("the x coordinate of corner {number}"))?;
    let y = reader.real(&format!("the y coordinate of corner {number}"))?;
    Ok(Point::new(x, y))
}

fn too_many(reader: &Reader<'_>, text: Token<'_>) -> IoError {
    reader.value(text, "no more than 4294967295 different corners")
}

/// The edges that exactly one triangle has, smaller vertex first, sorted.
fn boundary(mesh: &IndexedMesh) -> Vec<[u32; 2]> {
    let sides = sorted_sides(mesh);
    by_edge(&sides).filter(|group| group.len() == 1).map(|group| group[0].edge).collect()
}

/// Vertices by coordinates.
#[derive(Debug, Default)]
struct Vertices {
    points: Vec<Point>,
    index_of: HashMap<[u64; 2], u32>,
}

impl Vertices {
    /// The index of a point, a new one where its coordinates are new; `None` when there are no more indices.
    fn index(&mut self, point: Point) -> Option<u32> {
        // Adding zero turns -0 into 0 and leaves every other number as it is.
        let key = [point.x + 0.0, point.y + 0.0].map(f64::to_bits);
        if let Some(&index) = self.index_of.get(&key) {
            return Some(index);
        }
        let index = u32::try_from(self.points.len()).ok().filter(|&index| index < u32::MAX)?;
        self.points.push(point);
        self.index_of.insert(key, index);
        Some(index)
    }
}

/// Writes the triangles of a mesh. Vertices of no triangle, markers, attributes, subsegments and holes have no place in
/// a soup.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh) -> io::Result<()> {
    Points::of_mesh(mesh).check(0)?;
    check_triangles(mesh)?;
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|v| mesh.points[v as usize]);
        writeln!(out, "{} {} {} {} {} {}", Real(a.x), Real(a.y), Real(b.x), Real(b.y), Real(c.x), Real(c.y))?;
    }
    Ok(())
}
