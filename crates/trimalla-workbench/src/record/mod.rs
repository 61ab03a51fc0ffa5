//! Runs as values: a step as a line of a trace and as a picture, and a whole run as a page that plays it.
//!
//! Nothing here writes a file: a program puts these texts where its user wants them.

mod algorithm;
mod construction;
mod frame;
mod player;
mod present;
mod trace;

pub use construction::ConstructionError;
pub use frame::Frame;
pub use player::{Player, TooLarge};
pub use trace::trace_line;
