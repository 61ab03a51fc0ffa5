//! How large a triangle may be where.
//!
//! A [`SizeField`] answers for one triangle at a time. These are there, and a caller may bring more:
//!
//! | field | the bound is |
//! |---|---|
//! | [`Uniform`] | the same for all triangles |
//! | [`ByRegion`] | that of the region in which a triangle lies |
//! | [`ByTriangle`] | that of the triangle of a given mesh in which the middle of a triangle lies |
//! | [`Graded`] | small near chosen points and segments, growing with the distance from them |
//! | [`Scaled`] | that of other fields, times a factor |
//! | [`ByFunction`] | what a function of the caller's says |
//!
//! A refinement holds the least of several fields, [`SizeBounds`], and asks them only where two numbers do not decide:
//! the bound below which no triangle is too large, wherever it lies, and the one above which every triangle is.
//!
//! # Examples
//! ```
//! use trimalla::refine::{NoObserver, RefineOptions, Refinement, Start};
//! use trimalla::size::{Graded, SizeSource};
//! # use trimalla::{Pslg, constrained::Crossings, delaunay::AlgorithmKey, domain::{DomainRule, build}};
//!
//! let drawing = Pslg::of_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
//! // Edges of 0.02 at the first vertex; they grow by a third of the distance from it.
//! let field = Graded::new(&[SizeSource::at(drawing.points[0], 0.02)], 1.0 / 3.0)?;
//! let (cdt, _) = build(&drawing, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default())?;
//! let mut refinement = Refinement::new(Start::from(cdt).with_size(field), RefineOptions::default())?;
//! refinement.run(&mut NoObserver);
//! # let (cdt, report) = refinement.finish();
//! # assert!(report.complete() && (100..10_000).contains(&cdt.face_count()), "{}", cdt.face_count());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bound;
mod bounds;
mod by_function;
mod by_region;
mod by_triangle;
mod field;
mod graded;
mod scaled;
mod source_tree;
#[cfg(test)]
mod tests;
mod triangle_in_region;
mod uniform;

pub use bound::AreaBound;
pub use bounds::SizeBounds;
pub use by_function::ByFunction;
pub use by_region::ByRegion;
pub use by_triangle::ByTriangle;
pub use field::SizeField;
pub use graded::{Graded, SizeError, SizeSource};
pub use scaled::Scaled;
pub use triangle_in_region::TriangleInRegion;
pub use uniform::Uniform;
