//! The common parts of the benchmark programs.
//!
//! * [`random`], [`workloads`]: the inputs, from fixed seeds
//! * [`drawing`]: the file that all drivers read
//! * [`clock`]: time and memory of one call
//! * [`jobs`]: which program gets which input
//! * [`results`], [`report`], [`chart`]: the results, as a table and a chart

pub mod chart;
pub mod clock;
pub mod drawing;
pub mod jobs;
pub mod random;
pub mod report;
pub mod results;
pub mod workloads;

pub use clock::{Measured, Outcome, cpu_seconds, measure};
