//! The five steps as traits.
//!
//! To add a strategy, implement one of these traits in a file of its own, and add a row to `recipe/choices.rs`. A
//! caller puts a strategy from outside the library into [`Steps`]; `examples/own_steps.rs` shows one for each step.

use std::fmt;
use std::sync::Arc;

mod insert;
mod point;
mod prepare;
mod proposal;
mod recover;
mod select;
mod step_edit;
mod view;

pub use insert::{InsertStep, InsertTraits, Plan};
pub use point::{PointStep, PointTraits};
pub use prepare::PrepareStep;
pub use proposal::{Places, Proposal};
pub use recover::{RecoverStep, RecoverTraits};
pub use select::{SelectStep, SelectTraits};
pub use step_edit::{Bring, StepEdit};
pub use view::View;

/// The five steps of a refinement.
///
/// # Examples
/// ```
/// use std::sync::Arc;
/// use trimalla::geometry::Triangle;
/// use trimalla::half_edge::FaceId;
/// use trimalla::refine::RefineOptions;
/// use trimalla::refine::steps::{Places, PointStep, Proposal, Steps, View};
///
/// /// The middle of the triangle.
/// struct Barycenter;
///
/// impl PointStep for Barycenter {
///     fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places) {
///         let [a, b, c] = view.cdt.corners(face);
///         places.extend(Proposal::towards(view, face, Triangle::new(a, b, c).centroid()));
///     }
/// }
///
/// let steps = Steps { point: Arc::new(Barycenter), ..Steps::of(&RefineOptions::default()) };
/// ```
#[derive(Clone)]
pub struct Steps {
    /// Step 1.
    pub prepare: Arc<dyn PrepareStep + Send + Sync>,
    /// Step 2.
    pub select: Arc<dyn SelectStep + Send + Sync>,
    /// Step 3.
    pub point: Arc<dyn PointStep + Send + Sync>,
    /// Step 4.
    pub insert: Arc<dyn InsertStep + Send + Sync>,
    /// Step 5.
    pub recover: Arc<dyn RecoverStep + Send + Sync>,
}

impl fmt::Debug for Steps {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Steps").finish_non_exhaustive()
    }
}

/// The traits of steps 2 to 4: the loop needs them for each triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct StepTraits {
    pub(super) select: SelectTraits,
    pub(super) point: PointTraits,
    pub(super) insert: InsertTraits,
}

impl StepTraits {
    pub(super) fn of(steps: &Steps) -> Self {
        Self { select: steps.select.traits(), point: steps.point.traits(), insert: steps.insert.traits() }
    }
}
