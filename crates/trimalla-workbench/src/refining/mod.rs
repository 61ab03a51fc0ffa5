//! A refinement from its input to its outcome, as values: what is read, what is asked, what came of it.
//!
//! ```text
//!   Task { input, options, picks } ──run(watch)──> Outcome { mesh, report, before, warnings, missed bounds }
//! ```
//!
//! A program reads files into a [`Task`], shows what the [`Watch`] is told, and prints the [`Outcome`].

mod foresight;
mod missed;
mod task;

pub use missed::{MissedBounds, corners};
pub use task::{Outcome, Task, TaskError, TaskInput, Watch};
