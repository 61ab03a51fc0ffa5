//! Strategies of mesh refinement compared on equal terms: drawings × contenders × angles, each a run of its own, and
//! tables and charts of what came of them.
//!
//! ```text
//!   Experiment ──> run ──────────> sheets ──> markdown · records · figures
//!                  │ ▲               ▲
//!                Journal          Baseline
//! ```
//! | module | holds |
//! |---|---|
//! | `experiment`, `contender` | what is run: drawings, recipes or strategies of the caller's own, angles, limits |
//! | `runs`, `outcome` | a queue of runs and the threads that empty it; what came of a run |
//! | `journal` | outcomes so far, on disk, so that an experiment can go on after a stop |
//! | `peer` | Triangle, run in processes of its own |
//! | `baseline` | published tables to stand beside ours |
//! | `sheet` | one drawing's columns, those that were run and the published ones |
//! | [`markdown`], [`records`], [`figures`] | sheets as tables, as CSV and JSON, as charts |
//!
//! # What every run gets
//! The same drawing, the same triangulation, the same test for bad triangles, the same limits in vertices and in
//! seconds. What a strategy proposes is proved and judged by the same loop, whether it is the library's or the
//! caller's.
//!
//! # Examples
//! ```
//! use trimalla::{drawing::Pslg, geometry::Point, refine::Preset};
//! use trimalla_compare::{Contender, Experiment, NoWatch, markdown};
//!
//! let points = [[0.0, 0.0], [9.0, 0.0], [9.0, 1.0], [0.0, 4.0]].map(Point::from).to_vec();
//! let wedge = Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]], ..Pslg::default() };
//! let mut experiment = Experiment::new([20.0, 25.0, 30.0]);
//! experiment.add_drawing("wedge", wedge)?;
//! for preset in [Preset::OffCenter, Preset::LeppCentroid] {
//!     experiment.add_contender(Contender::of(preset))?;
//! }
//! let outcomes = experiment.run(2, None, &NoWatch)?;
//! let table = markdown::text(&experiment, &experiment.sheets(&outcomes, None));
//! assert!(table.contains("| vertices | off-center | lepp-centroid |"));
//! # Ok::<(), trimalla_compare::CompareError>(())
//! ```
//!
//! A strategy from outside stands beside them with [`Contender::with_steps`]; the architecture guide and
//! `examples/own_strategy.rs` show one.

mod baseline;
mod contender;
mod error;
mod experiment;
pub mod figures;
mod journal;
pub mod markdown;
mod outcome;
mod peer;
pub mod records;
mod runs;
mod sheet;

pub use baseline::Baseline;
pub use contender::Contender;
pub use error::CompareError;
pub use experiment::{Drawing, Experiment, Task, angles, facts};
pub use journal::Journal;
pub use outcome::{End, Outcome};
pub use peer::{NoPeer, Peer};
pub use runs::{NoWatch, Outcomes, Watch};
pub use sheet::{Cell, Column, Quantity, Sheet, Times};

/// The architecture guide's example, compiled and run as a test.
#[cfg(doctest)]
#[doc = include_str!("../../../ARCHITECTURE.md")]
struct Architecture;
