//! Triangle's command-line switches as calls of `trimalla`.
//!
//! Programs and scripts ask [Triangle] for a mesh by a word such as `-pq30a0.1`. This crate reads such a word, makes
//! the mesh, and lays it out as Triangle's files and arrays have it: markers, attributes, edges, neighbours, nodes in
//! the middle of edges, Voronoi vertices. It knows no file: the program `trimalla` reads and writes files, the C
//! library arrays.
//!
//! | you have, you want | call |
//! |---|---|
//! | a word of switches | [`Switches::parse`], [`Switches::add`] |
//! | a drawing or a mesh, and switches | [`triangulate()`] |
//! | what each switch does here | [`ROWS`] |
//!
//! What switches mean is taken from Triangle's published instructions, its output was compared with theirs, and its
//! source was not read. What cannot be done is refused by the name of the switch, with what to use instead.
//!
//! # Examples
//! ```
//! use trimalla::Pslg;
//! use trimalla::refine::NoObserver;
//! use trimalla_triangle::{Input, Switches, triangulate};
//!
//! let drawing = Pslg::of_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [0.0, 3.0]]);
//! let switches = Switches::parse("pq30a0.5en")?;
//! let made = triangulate(&Input::Drawing(&drawing), &switches, &mut NoObserver)?;
//! assert_eq!(made.mesh.points[..4], drawing.points);
//! assert_eq!(made.neighbours.map(|all| all.len()), Some(made.mesh.triangles.len()));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [Triangle]: https://www.cs.cmu.edu/~quake/triangle.html

mod edges;
mod error;
mod extras;
mod jettison;
mod made;
mod options;
mod switches;
mod table;
mod triangulate;

pub use edges::{Edges, VoronoiEdge};
pub use error::{SwitchError, TriangleError};
pub use made::{Made, Voronoi};
pub use switches::Switches;
pub use table::{ROWS, Row, Verdict};
pub use triangulate::{Input, triangulate};
