//! Runs as values: a step as a line of a trace and as a picture.
//!
//! Nothing here writes a file: a program puts these texts where its user wants them.

mod frame;
mod trace;

pub use frame::Frame;
pub use trace::trace_line;
