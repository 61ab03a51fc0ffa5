//! Planar triangulation and quality mesh refinement that never crashes, hangs or moves an input vertex.
//!
//! One call takes a drawing to a mesh:
//!
//! ```
//! use trimalla::{MeshOptions, domain::Pslg, geometry::Point, mesh};
//!
//! let points = vec![Point::new(0.0, 0.0), Point::new(9.0, 0.0), Point::new(9.0, 1.0), Point::new(0.0, 4.0)];
//! let drawing = Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]], ..Pslg::default() };
//! let (mesh, report) = mesh(&drawing, &MeshOptions::default())?;
//! println!("{} triangles, no angle below {:.1} degrees", mesh.triangles.len(), report.min_angle_deg);
//! # assert!(report.complete());
//! # Ok::<(), trimalla::Error>(())
//! ```
//!
//! # The rooms, from the ground up
//! A room knows only those above it in this list.
//!
//! * [`geometry`]: points, exact predicates, rounded constructions; [`mesh`](mod@mesh): half-edges without coordinates,
//!   operators, rollback
//! * [`triangulation`]: both together, the invariants and their checker
//! * [`locate`]: where a point lies
//! * [`delaunay`]: incremental, divide and conquer, insertion, removal
//! * [`constrained`]: segments that must be edges, crossings, subsegments
//! * [`domain`]: outlines, holes, what is kept of a drawing
//! * [`quality`]: statistics, meshes held against their input
//! * [`refine`]: bad triangles made good, in five exchangeable steps
//!
//! # What holds everywhere
//! * Topology is decided by exact signs, never by an epsilon. Constructed points are rounded and proved again.
//! * Input vertices appear in the output first, in order, bit for bit.
//! * The same input gives the same bytes: no hash order, no clock, no unseeded randomness.
//! * Every loop is bounded. Errors are values that name indices and coordinates; nothing prints, nothing panics on input.

pub mod constrained;
pub mod delaunay;
pub mod domain;
mod facade;
pub mod geometry;
pub mod locate;
pub mod mesh;
pub mod quality;
pub mod refine;
pub mod triangulation;

pub use facade::{
    DomainOptions, Error, MeshOptions, Meshed, mesh, mesh_with, refine_mesh, refine_mesh_with, triangulate,
    triangulate_conforming,
};

/// The README's example, compiled and run as a test.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
