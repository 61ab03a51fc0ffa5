//! `.area`: the largest area that each triangle of a mesh may have when the mesh is refined.
//!
//! ```text
//! <triangles>
//! <number> <largest area>
//! ```
//! Numbers are consecutive and start at 0 or 1, as the first one says. A largest area that is zero or negative is none.
//! Bounds are no part of an [`IndexedMesh`](trimalla::drawing::IndexedMesh): [`read_areas`](crate::read_areas) finds
//! them beside a mesh.

use std::io::{self, Write};

use crate::columns::invalid;
use crate::error::{Fault, IoError, Place};
use crate::numbers::{Numbering, Real};
use crate::tokens::Reader;

/// Area bounds, one a triangle, in the order of the triangles.
///
/// # Units
/// Squared coordinate units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Areas(pub Vec<Option<f64>>);

/// Reads an `.area` file; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read(bytes: &[u8], name: &str) -> Result<Areas, IoError> {
    let mut reader = Reader::new(bytes, name)?;
    reader.record(|| "the number of triangles".to_owned())?;
    let count = reader.count("the number of triangles")?;
    reader.end_record()?;
    let mut bounds = Vec::with_capacity((count as usize).min(reader.remaining() / SHORTEST_ROW));
    let mut rows = Numbering::new("triangle", count, None);
    while rows.next(&mut reader)? {
        let bound = reader.real("the largest area")?;
        bounds.push(Some(bound).filter(|&area| area > 0.0));
        reader.end_record()?;
    }
    reader.end_file()?;
    Ok(Areas(bounds))
}

/// The fault of a file whose bounds are not one a triangle of its mesh; the count stands in its first record.
pub(crate) fn miscounted(name: &str, found: usize, triangles: usize) -> IoError {
    IoError::Value(Box::new(Fault {
        place: Place { file: name.to_owned(), line: 1, column: 1 },
        expected: format!("area bounds for the {triangles} triangles of the mesh"),
        found: format!("{found}"),
    }))
}

/// Bytes of the shortest row, `1 1` and the end of its line.
const SHORTEST_ROW: usize = 4;

/// Writes area bounds, -1 where there is none.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where a bound is not positive and finite, as it would read back as none.
pub fn write(out: &mut dyn Write, areas: &Areas, first_index: u32) -> io::Result<()> {
    if first_index > 1 {
        return Err(invalid(format!("numbering must start at 0 or 1, not at {first_index}")));
    }
    let refused = |bound: f64| !(bound.is_finite() && bound > 0.0);
    for (i, bound) in areas.0.iter().enumerate() {
        if let Some(bound) = bound.filter(|&bound| refused(bound)) {
            return Err(invalid(format!("triangle {i} has the area bound {bound}, which is not positive and finite")));
        }
    }
    writeln!(out, "{}", areas.0.len())?;
    for (i, bound) in areas.0.iter().enumerate() {
        writeln!(out, "{} {}", i as u64 + u64::from(first_index), Real(bound.unwrap_or(-1.0)))?;
    }
    Ok(())
}
