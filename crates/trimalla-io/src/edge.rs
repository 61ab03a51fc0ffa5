//! `.edge`: edges.
//!
//! ```text
//! <edges> [<markers: 0 or 1>]
//! <number> <vertex> <vertex> [marker]
//! ```
//! Written are the edges of all triangles and all subsegments, each once, sorted by vertices. The marker is that of the
//! subsegment; on other edges 1 where only one triangle has the edge, else 0.

use std::io::{self, Write};

use trimalla::drawing::IndexedMesh;

use crate::columns::{Points, Segments, check_triangles};
use crate::error::IoError;
use crate::numbers::{Numbering, VertexRange};
use crate::rows::Rows;
use crate::tokens::Reader;
use crate::topology::{by_edge, sorted_sides};

/// The edges of an `.edge` file.
///
/// # Shape
/// `markers` is empty or has one entry an edge.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Edges {
    /// Edges as pairs of vertex indices, counted from 0.
    pub edges: Vec<[u32; 2]>,
    /// Boundary markers.
    pub markers: Vec<i32>,
}

/// Reads an `.edge` file for the given vertices; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read(bytes: &[u8], name: &str, vertices: VertexRange) -> Result<Edges, IoError> {
    let mut reader = Reader::new(bytes, name)?;
    reader.record(|| "the number of edges".to_owned())?;
    let count = reader.count("the number of edges")?;
    let has_markers = reader.one_of_or("0 or 1 markers an edge", 0, &[0, 1])? == 1;
    reader.end_record()?;
    let mut found = Edges::default();
    let mut rows = Numbering::new("edge", count, (vertices.count > 0).then_some(vertices.first_index));
    while rows.next(&mut reader)? {
        found.edges.push([reader.vertex(vertices)?, reader.vertex(vertices)?]);
        if has_markers {
            found.markers.push(reader.marker()?);
        }
        reader.end_record()?;
    }
    reader.end_file()?;
    Ok(found)
}

/// The edges of a mesh with their markers, each once, sorted by vertices.
///
/// # Errors
/// Kind `InvalidInput` where columns have wrong lengths or an index has no vertex.
pub fn edges_of(mesh: &IndexedMesh) -> io::Result<Edges> {
    check_triangles(mesh)?;
    Segments::of_mesh(mesh).check(mesh.points.len())?;
    let sides = sorted_sides(mesh);
    let mut marked: Vec<([u32; 2], i32)> = subsegments(mesh).collect();
    marked.extend(by_edge(&sides).map(|group| (group[0].edge, i32::from(group.len() == 1))));
    // Stable, so that the entry of a subsegment stays before the entry of the same edge as a side, and is kept.
    marked.sort_by_key(|(edge, _)| *edge);
    marked.dedup_by_key(|(edge, _)| *edge);
    let (edges, markers) = marked.into_iter().unzip();
    Ok(Edges { edges, markers })
}

/// The subsegments, smaller vertex first, with their markers; 1 where the mesh has no markers.
fn subsegments(mesh: &IndexedMesh) -> impl Iterator<Item = ([u32; 2], i32)> {
    mesh.segments.iter().enumerate().map(|(i, &[a, b])| {
        let marker = mesh.segment_markers.get(i).copied().unwrap_or(1);
        ([a.min(b), a.max(b)], marker)
    })
}

/// Writes the edges of a mesh.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths or an index has no vertex.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh, first_index: u32) -> io::Result<()> {
    Points::of_mesh(mesh).check(first_index)?;
    let Edges { edges, markers } = edges_of(mesh)?;
    let base = u64::from(first_index);
    writeln!(out, "{} 1", edges.len())?;
    let mut rows = Rows::to(out);
    for (i, (edge, &marker)) in edges.iter().zip(&markers).enumerate() {
        let [a, b] = edge.map(|v| u64::from(v) + base);
        rows.integer(i as u64 + base).integer(a).integer(b).integer(marker).end()?;
    }
    rows.finish()
}
