//! Refinement in five exchangeable steps.
//!
//! ```text
//!   1 prepare ─> 2 select ─> 3 point ─> 4 insert ─> 5 recover
//!                   ^                       |
//!                   └───────────────────────┘   until no triangle is bad
//! ```

mod options;
mod recipe;
mod refinement;
mod report;

pub use options::{Criteria, Limits, OptionError, Protect, RefineOptions};
pub use recipe::{Encroachment, Insert, PlacePoint, Prepare, Preset, Recipe, Recover, Row, Select, UnknownKey, registry};
pub use refinement::Refinement;
pub use report::{Leftover, NoObserver, Observer, Progress, Reason, Report, StopReason};
