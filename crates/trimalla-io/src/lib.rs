//! File formats of trimalla: [Triangle]'s text formats, `MeshSuite`'s and triangle soups in and out,
//! the formats of Gmsh, Abaqus, Medit, SU2, ParaView and computer graphics in and out, pictures out.
//!
//! # What is where
//!
//! | you have, you want | call |
//! |---|---|
//! | a path to a drawing (`.poly`, `.node`, `.mesh`, `.meshsuite`) | [`read_pslg`], or [`read_pslg_numbered`] to keep its numbering |
//! | a path to a drawing of another program (`GeoJSON`, DXF, SVG, …) | [`read_pslg`], or [`read_pslg_with`] with options |
//! | a path to a mesh (`.ele`, `.msh`, `.inp`, `.vtu`, …) | [`read_mesh`], or [`read_mesh_numbered`] |
//! | the area bounds beside a mesh | [`read_areas`] |
//! | a mesh, and a path | [`write_mesh`]; [`files_of_mesh`] says which files it replaces |
//! | a drawing, and a path | [`write_pslg`] |
//! | a mesh or drawing, and a stream | [`write_mesh_to`], [`write_pslg_to`] |
//! | several outputs, all of them or none | [`Outputs`]; [`Draft`] and [`Pictures`] for what is written piece by piece |
//! | a directory in which a process was killed while writing | [`recover`] |
//! | files in memory, where there is no disk | [`Files`], [`Memory`] |
//! | any other text file, within bounds | [`read_bytes`] |
//! | area bounds, and bytes or a stream | [`area::read`], [`area::write`] |
//! | measurements, and a chart of them | [`chart::draw`] |
//! | what came of a refinement, and bar charts of it | [`bars::of_report`] |
//! | a recipe of refinement | [`recipe::read_file`], [`recipe::read`], [`recipe::write`] |
//! | the bytes of a mesh in one file | [`read_mesh_bytes`] |
//! | bytes | [`node::read`], [`ele::read`], [`poly::read`], [`edge::read`], [`neigh::read`], [`meshsuite::read`], [`soup::read`] |
//!
//! | format | holds | module |
//! |---|---|---|
//! | `.node` | vertices, their attributes and markers | [`node`] |
//! | `.ele` | triangles and their attributes | [`ele`] |
//! | `.poly` | vertices or a reference to them, segments, holes, regions | [`poly`] |
//! | `.edge` | the edges of a mesh | [`edge`] |
//! | `.neigh` | which triangles share an edge | [`neigh`] |
//! | `.area` | the largest area that each triangle may have | [`area`] |
//! | `.meshsuite` | `MeshSuite`: vertices, segments, holes, triangles | [`meshsuite`] |
//! | `.soup` | triangles by the coordinates of their corners | [`soup`] |
//! | `.msh`, `.msh2` | Gmsh, versions 4.1 and 2.2: triangles, subsegments, names of regions and boundaries | [`msh`] |
//! | `.inp` | Abaqus: triangles by element sets, boundaries as node sets and surfaces | [`abaqus`] |
//! | `.mesh` | Medit: vertices, triangles and subsegments with references | [`medit`] |
//! | `.su2` | SU2: triangles, boundaries by name | [`su2`] |
//! | `.vtu`, `.vtk` | ParaView: triangles, subsegments, angles, markers | [`vtu`], [`vtk`] |
//! | `.obj`, `.ply`, `.stl`, `.off` | computer graphics: vertices with heights, triangles | [`obj`], [`ply`], [`stl`], [`off`] |
//! | `.geojson` | maps: triangles as features | [`geojson_mesh`] |
//! | `.svg` | a picture, a chart | [`svg`], [`chart`] |
//! | `.png` | a picture in pixels | [`png`] |
//! | `.toml` | a recipe of refinement | [`recipe`] |
//! | `.geojson`, `.dxf`, `.svg`, `.wkt`, `.shp`, `.csv`, `.xyz`, `.las` | drawings of other programs, which are read | [`drawings`] |
//!
//! # What all text formats of Triangle and `MeshSuite` that are read share
//!
//! * One record a line; blank lines and comments (`#` to the end of the line) anywhere; LF, CR LF or a lone CR; a byte
//!   order mark is skipped.
//! * Records (those of a soup excepted) are numbered consecutively, from 0 or 1 as the first one says. In memory,
//!   indices count from 0.
//! * A comma between two columns separates like a blank. Lines with commas must have exactly the declared columns, so
//!   that a decimal comma is refused.
//! * Every fault is an error that names file, line and column, what was expected and what was found:
//!   `A.poly:12:7: expected a vertex index between 1 and 29, found '31'`. Nothing is guessed, and nothing is skipped in
//!   silence: numbers behind the declared columns of `.node`, `.poly` and `.ele` are ignored, and a [`Note`] says how
//!   many rows have such; so are row numbers of segments and triangles that start otherwise than those of the vertices.
//!   A record too many is a fault as much as one too few.
//! * What a header promises is never allocated before the bytes are there. Memory stays below 64 MiB + 64 times the
//!   size of the files.
//! * Numbers are written with the fewest digits that read back to the same bits.
//! * What grows while it is read, has no end, or delivers nothing for ten seconds is an error, not endless work.
//! * Files are written whole or not at all, and those of a mesh together.
//!
//! # Example
//!
//! ```
//! # fn main() -> Result<(), trimalla_io::IoError> {
//! use trimalla_io::node;
//!
//! let nodes = node::read(b"2 2 0 0   # two points\n0 0.5 1\n1 2 -3e4\n", "pair.node")?;
//! assert_eq!((nodes.points.len(), nodes.first_index), (2, 0));
//!
//! let fault = node::read(b"2 2 0 0\n0 0.5 1\n1 2 abc\n", "pair.node").unwrap_err();
//! assert_eq!(fault.to_string(), "pair.node:3:5: expected a y coordinate, found 'abc'");
//! # Ok(())
//! # }
//! ```
//!
//! [Triangle]: https://www.cs.cmu.edu/~quake/triangle.html

pub mod abaqus;
pub mod area;
mod atomic;
pub mod bars;
mod bytes;
mod cells;
pub mod chart;
mod columns;
mod cursor;
pub mod drawings;
pub mod edge;
pub mod ele;
mod error;
mod files;
mod format;
mod gathered;
pub mod geojson_mesh;
pub mod medit;
pub mod meshsuite;
pub mod msh;
mod names;
pub mod neigh;
pub mod node;
mod numbers;
pub mod obj;
pub mod off;
mod picture;
pub mod ply;
pub mod png;
pub mod poly;
mod read;
pub mod recipe;
mod rows;
mod single;
pub mod soup;
pub mod stl;
pub mod su2;
mod surface;
pub mod svg;
mod text;
mod tokens;
mod topology;
pub mod vtk;
pub mod vtu;
mod write;

pub use atomic::{Draft, Pictures, Recovered, recover};
pub use bytes::read_bytes;
pub use error::{Fault, Ignored, IoError, Note, Place};
pub use files::{Files, Memory};
pub use format::Format;
pub use gathered::NamedMesh;
pub use names::GroupNames;
pub use numbers::VertexRange;
pub use picture::{Overlay, PictureOptions};
pub use read::{
    Numbered, read_areas, read_mesh, read_mesh_bytes, read_mesh_numbered, read_pslg, read_pslg_numbered, read_pslg_with,
};
pub use single::Precision;
pub use write::{
    MESH_ENDINGS, Outputs, WriteOptions, files_of_mesh, write_mesh, write_mesh_to, write_pslg, write_pslg_to,
};

/// The README's example, compiled as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
