//! Planar triangulation and quality mesh refinement that never crashes, hangs or moves an input vertex.
//!
//! One call takes a drawing to a mesh:
//!
//! ```
//! use trimalla::{MeshOptions, Pslg, mesh};
//!
//! let drawing = Pslg::of_ring([[0.0, 0.0], [9.0, 0.0], [9.0, 1.0], [0.0, 4.0]]);
//! let made = mesh(&drawing, &MeshOptions::default())?;
//! println!("{} triangles, no angle below {:.1} degrees", made.mesh.triangles.len(), made.report.min_angle_deg);
//! # assert!(made.report.complete());
//! # Ok::<(), trimalla::Error>(())
//! ```
//!
//! # I want to …
//!
//! | I want to … | call |
//! |---|---|
//! | make a good mesh of a drawing | [`mesh()`] |
//! | watch the refinement, cancel it, see its forecast | [`mesh_with()`] with an [`Observer`](refine::Observer) |
//! | triangulate a drawing and keep its domain, with no more vertices | [`triangulate()`] |
//! | split its segments until the triangulation is Delaunay | [`triangulate_conforming()`] |
//! | triangulate many small sets, or many polygons, fast | [`delaunay::Triangulator`], [`polygon::Triangulator`] |
//! | triangulate by any algorithm of the textbook, and hear its steps | [`triangulate_by()`] |
//! | refine a mesh that exists | [`refine_mesh()`] |
//! | make a drawing of polygons, holes and islands | [`Pslg::of_rings`] |
//! | know what is wrong with a drawing, and mend it | [`clean::find()`], [`clean::mend()`] |
//! | triangulate points, insert, remove and move them | [`Delaunay`] |
//! | triangulate points and segments, and change both | [`ConstrainedDelaunay`] |
//! | find the triangle or vertex at a place | [`Triangulation::locate`](triangulation::Triangulation::locate) |
//! | choose the angle, the area, the strategy | [`RefineOptions`], [`Preset`](refine::Preset), [`Recipe`](refine::Recipe) |
//! | bound sizes by place, small near some points and segments | [`size`], [`Start::with_size`](refine::Start::with_size) |
//! | refine step by step, and back | [`Refinement`] |
//! | write a strategy of my own | [`refine::steps`], [`Start::with_steps`](refine::Start::with_steps) |
//! | know whether a mesh is sound, Delaunay, one of its drawing | [`check_mesh`](triangulation::check_mesh), [`check_mesh_delaunay`](triangulation::check_mesh_delaunay), [`against_input`](quality::against_input) |
//! | draw the Voronoi diagram of points, clip it to a domain | [`dual::Voronoi`] |
//! | compute heights between vertices, draw contour lines | [`interpolate::interpolate`](interpolate::interpolate()), [`interpolate::Surface`] |
//! | count angles, areas, degrees | [`quality::Statistics`] |
//! | decide on which side a point lies, exactly | [`geometry::orient2d`], [`geometry::in_circle`] |
//! | read and write files | the crate `trimalla-io` |
//!
//! # The rooms, from the ground up
//! A room knows only those before it in this list.
//!
//! * [`geometry`]: points, exact predicates, rounded constructions; [`half_edge`]: half-edges without coordinates,
//!   operators, rollback; [`drawing`]: drawings and meshes as plain arrays
//! * [`trace`]: what an algorithm tells of its steps; [`clean`]: faults of drawings, found and mended
//! * [`triangulation`]: half-edges with coordinates, the invariants and their checker
//! * [`locate`]: where a point lies
//! * [`delaunay`]: incremental, divide and conquer, insertion, removal
//! * [`polygon`]: polygons with holes triangulated, visibility, guards; beside [`delaunay`]
//! * [`constrained`]: segments that must be edges, crossings, subsegments
//! * [`domain`]: outlines, holes, what is kept of a drawing; [`size`]: how large a triangle may be where
//! * [`quality`]: statistics, meshes compared with their input; [`optimal`]: triangulations that are best by a
//!   criterion
//! * [`dual`]: Voronoi diagrams, whole and clipped; [`interpolate`]: heights between vertices, contour lines
//! * [`refine`]: bad triangles made good, in five exchangeable steps
//!
//! # Features
//! None is on by default. Each only adds.
//!
//! | feature | adds |
//! |---|---|
//! | `conformance` | `refine::conformance`: the suites that prove a strategy of the caller's own |
//! | `serde` | `Serialize` and `Deserialize` for options, criteria, recipes, reports, [`Pslg`], [`IndexedMesh`], points and what they are made of; [`NamedOptions`](refine::NamedOptions) as recipe files have them |
//! | `mint` | conversions of [`Point`] and [`Vector`](geometry::Vector) from and to those of `mint` |
//! | `geo-types` | points, rings and polygons of `geo-types` as [`Point`] and [`Pslg`]; meshes as its triangles |
//!
//! # What holds everywhere
//! * Topology is decided by exact signs, never by an epsilon. Constructed points are rounded and proved again.
//! * Input vertices appear in the output first, in order, bit for bit.
//! * The same input gives the same bytes: no hash order, no clock, no unseeded randomness.
//! * Every loop is bounded. Errors are values that name indices and coordinates; nothing prints, nothing panics on
//!   input.

#[macro_use]
mod by_key;

pub mod clean;
pub mod constrained;
pub mod delaunay;
pub mod domain;
pub mod drawing;
pub mod dual;
mod facade;
pub mod geometry;
pub mod half_edge;
pub mod improve;
pub mod interpolate;
pub mod locate;
pub mod optimal;
pub mod polygon;
pub mod quality;
pub mod refine;
pub mod size;
pub mod trace;
pub mod triangulation;

pub use by_key::{Row, UnknownKey};
pub use constrained::{ConstrainedDelaunay, Crossings};
pub use delaunay::Delaunay;
pub use drawing::{IndexedMesh, Pslg, Region};
pub use facade::{
    Attempted, ByMethod, DomainOptions, DomainPolygon, Error, Improve, Improved, MeshOptions, Meshed, Method, Sizing,
    Triangulated, mesh, mesh_sized, mesh_with, refine_mesh, refine_mesh_sized, refine_mesh_with, triangulate,
    triangulate_by, triangulate_conforming, triangulate_domain, triangulate_mesh,
};

pub use geometry::Point;
pub use refine::{RefineOptions, Refinement, Report};

/// The README's example, compiled and run as a test.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
