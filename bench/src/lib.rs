//! What the benchmark programs share.
//!
//! * [`random`], [`workloads`]: the inputs, the same ones every time
//! * [`drawing`]: the file that all drivers read
//! * [`clock`]: time and memory of one call
//! * [`jobs`]: which program is given which input
//! * [`results`], [`report`], [`chart`]: what came of it

pub mod chart;
pub mod clock;
pub mod drawing;
pub mod jobs;
pub mod random;
pub mod report;
pub mod results;
pub mod workloads;

pub use clock::{Measured, Outcome, measure};
