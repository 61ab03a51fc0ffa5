//! What VTK's two formats share: cells by type, and the arrays that a mesh is read from.

use crate::error::IoError;
use crate::gathered::{Gathered, NamedMesh};
use crate::text::{Text, Word};

/// VTK's number for a cell that is a line.
pub(crate) const LINE: u8 = 3;
/// VTK's number for a cell that is a triangle.
pub(crate) const TRIANGLE: u8 = 5;
const VERTEX: u8 = 1;
const VERTICES: u8 = 2;
const POLYGON: u8 = 7;
const QUADRATIC_LINE: u8 = 21;
const QUADRATIC_TRIANGLE: u8 = 22;

/// Arrays of numbers for each point or cell, by name.
pub(crate) type Arrays = Vec<(String, usize, Vec<f64>)>;

/// A file, before it is put together.
#[derive(Debug, Default)]
pub(crate) struct Cells<'a> {
    pub(crate) gathered: Gathered,
    /// The type of each cell and its vertices by index.
    pub(crate) cells: Vec<(Word<'a>, Vec<Word<'a>>)>,
    pub(crate) of_points: Arrays,
    pub(crate) of_cells: Arrays,
}

impl Cells<'_> {
    /// The mesh: cells, `region` and `marker` of the cells, `marker` and `attribute0`, … of the points.
    pub(crate) fn finish(self, text: &Text<'_>) -> Result<NamedMesh, IoError> {
        let Self { mut gathered, cells, of_points, of_cells } = self;
        let column = |names: &[&str]| {
            let found = of_cells.iter().find(|(name, width, _)| *width == 1 && names.contains(&name.as_str()));
            found.map(|(.., values)| values.as_slice()).filter(|values| values.len() == cells.len())
        };
        let regions = column(&["region", "gmsh:physical", "medit:ref"]);
        let markers = column(&["marker", "gmsh:physical", "medit:ref"]);
        for (i, (kind, vertices)) in cells.iter().enumerate() {
            let number: u8 = text.whole_of(*kind, "the type of a cell")?;
            let (needed, is_triangle) = match number {
                VERTEX | VERTICES => continue,
                LINE => (2, false),
                QUADRATIC_LINE => (3, false),
                TRIANGLE => (3, true),
                POLYGON if vertices.len() == 3 => (3, true),
                QUADRATIC_TRIANGLE => (6, true),
                _ => return Err(text.value(*kind, "a cell that is a triangle or a line (type 5, 3, 22 or 21)")),
            };
            if vertices.len() != needed {
                return Err(text.value(*kind, &format!("a cell of {needed} vertices, not of {}", vertices.len())));
            }
            gathered.is_quadratic |= matches!(number, QUADRATIC_LINE | QUADRATIC_TRIANGLE);
            let mut indices = [0; 6];
            for (index, word) in indices.iter_mut().zip(vertices) {
                *index = gathered.indexed(text, *word, 0)?;
            }
            let [a, b, c, ..] = indices;
            if is_triangle {
                let region = regions.map_or(0.0, |values| values[i]);
                gathered.has_regions |= region != 0.0;
                gathered.add_triangle(text, vertices[0], [a, b, c], region, i as u64)?;
            } else {
                let marker = markers.map_or(0, |values| values[i] as i32);
                gathered.has_markers |= marker != 0;
                gathered.add_line([a, b], marker, i as u64);
            }
        }
        let is_whole = !gathered.is_quadratic;
        let mut named = gathered.finish();
        if is_whole {
            add_point_columns(&mut named, &of_points);
        }
        Ok(named)
    }
}

/// The markers and attributes of the vertices.
fn add_point_columns(named: &mut NamedMesh, of_points: &Arrays) {
    let mesh = &mut named.mesh;
    let count = mesh.points.len();
    let column = |name: &str| {
        let found =
            of_points.iter().find(|(other, width, values)| other == name && *width == 1 && values.len() == count);
        found.map(|(.., values)| values)
    };
    if let Some(markers) = column("marker").filter(|markers| markers.iter().any(|&marker| marker != 0.0)) {
        mesh.point_markers = markers.iter().map(|&marker| marker as i32).collect();
    }
    let attributes: Vec<_> = (0..of_points.len()).map_while(|i| column(&format!("attribute{i}"))).collect();
    if !attributes.is_empty() && count > 0 {
        // Heights are the first of them.
        mesh.attributes_per_point = attributes.len();
        mesh.point_attributes = (0..count).flat_map(|i| attributes.iter().map(move |values| values[i])).collect();
    }
}
