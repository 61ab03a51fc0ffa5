//! Refinement in five exchangeable steps.
//!
//! ```text
//!   1 prepare ─> 2 select ─> 3 point ─> 4 insert ─> 5 recover
//!                   ^                       |
//!                   └───────────────────────┘   until no triangle is bad
//! ```
//!
//! A [`Recipe`] names one choice for each step; [`registry`] lists all. Each step is a trait ([`steps`]) with a
//! file for every choice, and [`Refinement`] is the loop that calls them:
//!
//! 1. *Prepare*: subsegments with a vertex in their protecting region are split.
//! 2. *Select*: the bad triangle of lowest priority is taken from a queue.
//! 3. *Point*: a point is proposed for it. If a subsegment is in the way of the point, or the point would encroach upon
//!    it, the subsegment is split instead and the triangle stays queued.
//! 4. *Insert*: the point is inserted; bad triangles around it are queued.
//! 5. *Recover*: segments stay edges throughout (`whole-edge`).
//!
//! Under an area bound, wide parts are first filled with a lattice of equilateral triangles ([`Fill`]), if the recipe
//! enables that. The default does so up to 30 degrees: it takes less time and fewer triangles than the loop.
//!
//! Before the loop, an [`Outlook`] estimates the size of the mesh and names the angles that are out of reach.
//!
//! # Guarantees
//! The loop ends: the number of vertices and of insertions is bounded, and so are the lengths of edges from below.
//! Every triangle that stays bad has a [`Reason`]. At angle bounds up to 26.45 degrees without protected segments only
//! the input's own angles are reasons, for `circumcenter` by proof `[MillerPavWalkington03]`, for `off-center` by
//! experience.
//!
//! # Source
//! The five steps: `[MeshSuite]`. The algorithm: `[Ruppert95]`, `[Chew93]`, `[Shewchuk02]`, `[Ungor09]`.

mod agenda;
#[cfg(any(test, feature = "conformance"))]
pub mod conformance;
mod criteria;
mod engine;
mod forecast;
mod measure;
mod recipe;
mod s1_prepare;
mod s2_select;
mod s3_point;
mod s4_insert;
mod s5_recover;
pub mod steps;
mod strategies;
#[cfg(test)]
mod tests;
mod watch;

pub use criteria::bad_triangles::UserTest;
pub use criteria::badness::Badness;
pub use criteria::reason::{Reason, StopReason};
pub use engine::Refinement;
pub(crate) use engine::recovery::make_conforming;
pub use engine::start::Start;
pub(crate) use forecast::gradation::gradation;
pub use forecast::outlook::Outlook;
pub use forecast::{Cause, Feature, Forecast, Gap, forecast};
pub use measure::lepp;
pub use measure::lepp::Lepp;
pub use measure::ruler::Ruler;
pub use recipe::options::{Attempts, Criteria, Limits, Missed, OptionError, RefineOptions};
pub use recipe::{
    Centroid, ConstrainedSecond, Encroachment, Fill, Group, Initial, Insert, LeppRule, NamedOptions, OPTIONS,
    OptionRow, PlacePoint, Prepare, PrepareWhen, Preset, Protect, Recipe, Recover, Row, Select, Terminal, UnknownKey,
    Value, Values, WrongValue, registry,
};
pub use watch::event::{Candidate, Event, InsertedKind, InsertedVertex, Name, StepOutcome};
pub use watch::observer::{Beginning, NoObserver, Observer, Overview, Progress};
pub use watch::report::{Leftover, Report};
pub use watch::stopwatch::{Clock, StepTimes};
