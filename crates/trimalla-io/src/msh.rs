//! `.msh`: a mesh for Gmsh and the solvers that read its format, versions 4.1 and 2.2, as plain text. Read and written.
//!
//! Regions are physical groups of dimension 2, boundaries physical groups of dimension 1 with line elements, by the
//! rule of [`GroupNames`](crate::GroupNames). The third coordinate is 0, as solvers of plane problems expect; vertex
//! attributes, vertex markers and hole seeds have no place in the format. Vertices are numbered from 1 in their order,
//! lines after them and then triangles in theirs, so that a mesh comes back in its order.
//!
//! Read are points (passed over), lines and triangles, also quadratic ones, of which the corners are kept. Other
//! elements are refused, and so are binary files. An entity in several physical groups counts for the first.
//!
//! # Source
//! The Gmsh Reference Manual, "MSH file format" and "Legacy formats".

mod read;
mod read2;
mod read4;
mod write;

pub use read::read;
pub use write::{write, write_version_2};

/// Gmsh's numbers for kinds of elements.
mod kind {
    pub(super) const LINE: u32 = 1;
    pub(super) const TRIANGLE: u32 = 2;
    pub(super) const QUADRATIC_LINE: u32 = 8;
    pub(super) const QUADRATIC_TRIANGLE: u32 = 9;
    pub(super) const POINT: u32 = 15;
}

/// Whether a character may stand in a name between quotation marks.
fn is_allowed(c: char) -> bool {
    c != '"'
}
