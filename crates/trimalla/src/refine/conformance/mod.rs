//! The laws that every strategy must keep: one suite for each of the five steps, for the library's own strategies and
//! for others.
//!
//! | suite | requires of the step itself | and of refinement with it |
//! |---|---|---|
//! | [`prepare()`] | the same answer for both sides of a subsegment | no subsegment that needs a split is left |
//! | [`select()`] | priority is a number and does not depend on slots | the lowest priority is treated first; the triangle exists, and is bad |
//! | [`point()`] | places lie at their locus, and do not depend on slots | |
//! | [`insert()`] | the vertex lies at its place, and rollback restores everything | with the circle test kept: the mesh of Lawson's flips |
//! | [`recover()`] | | segments are locked as its traits say; missing ones are reported |
//!
//! Each of them ends with the [laws of refinement](laws()): sound after every step, bounded, deterministic, reversible.
//!
//! # Examples
//! ```
//! use std::sync::Arc;
//! use trimalla::geometry::Triangle;
//! use trimalla::half_edge::FaceId;
//! use trimalla::refine::conformance::{self, Subject};
//! use trimalla::refine::steps::{Places, PointStep, Proposal, View};
//!
//! struct Barycenter;
//!
//! impl PointStep for Barycenter {
//!     fn propose(&self, view: View<'_>, face: FaceId, places: &mut Places) {
//!         let [a, b, c] = view.cdt.corners(face);
//!         places.extend(Proposal::towards(view, face, Triangle::new(a, b, c).centroid()));
//!     }
//! }
//!
//! let subject = Subject::default().with_steps(|_, steps| steps.point = Arc::new(Barycenter));
//! conformance::point(&subject)?;
//! # Ok::<(), conformance::Breach>(())
//! ```

mod drawings;
mod insert;
mod laws;
mod point;
mod prepare;
mod recover;
mod select;

use std::fmt;
use std::sync::Arc;

use super::engine::Refinement;
use super::engine::start::Start;
use super::measure::ruler::Ruler;
use super::recipe::options::RefineOptions;
use super::recipe::{Recipe, Select};
use super::steps::{Steps, View};
use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, Crossings};
use crate::delaunay::AlgorithmKey;
use crate::domain::{DomainRule, build};
use crate::drawing::Pslg;
use crate::half_edge::FaceId;
use crate::size::SizeBounds;

pub use insert::insert;
pub use laws::laws;
pub use point::point;
pub use prepare::prepare;
pub use recover::recover;
pub use select::select;

/// Vertices that a run of a suite may have.
const MOST_VERTICES: usize = 80;
/// The largest number of steps of such a run.
const MOST_STEPS: usize = 20_000;
/// The angle bound of the suites, in degrees: above what is proved, so that limits are met too.
const BOUND_DEG: f64 = 28.0;

/// A law that a strategy breaks, in words, with the drawing and the step that show it.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct Breach(pub String);

/// Replaces steps of the recipe by the caller's own.
type Change = dyn Fn(&RefineOptions, &mut Steps) + Send + Sync;

/// The subject of a suite: a recipe, perhaps with steps from outside.
#[derive(Clone, Default)]
pub struct Subject {
    recipe: Recipe,
    change: Option<Arc<Change>>,
}

impl Subject {
    /// The steps of a recipe.
    #[must_use]
    pub fn of(recipe: Recipe) -> Self {
        Self { recipe, change: None }
    }

    /// Adds steps of the caller's own: `change` replaces those of the recipe.
    #[must_use]
    pub fn with_steps(mut self, change: impl Fn(&RefineOptions, &mut Steps) + Send + Sync + 'static) -> Self {
        self.change = Some(Arc::new(change));
        self
    }

    fn options(&self) -> RefineOptions {
        let options = RefineOptions { recipe: self.recipe, ..RefineOptions::default() };
        options.with_min_angle_deg(BOUND_DEG).with_max_vertices(MOST_VERTICES)
    }

    fn steps(&self) -> Steps {
        let options = self.options();
        let mut steps = Steps::of(&options);
        if let Some(change) = &self.change {
            change(&options, &mut steps);
        }
        steps
    }

    /// A refinement that has not made a step; where the order is manual, every triangle is picked.
    fn begin(&self, drawing: &Pslg, algorithm: AlgorithmKey) -> Result<Refinement, Breach> {
        let cdt = carved(drawing, algorithm)?;
        let begun = Refinement::new(Start::from(cdt).with_steps(self.steps()), self.options());
        let mut refinement = begun.map_err(|error| Breach(error.to_string()))?;
        if self.recipe.select == Select::Manual {
            let faces: Vec<FaceId> = by_key(refinement.triangulation());
            ensure(faces.into_iter().all(|f| refinement.pick(f)), || "a triangle cannot be picked".to_owned())?;
        }
        Ok(refinement)
    }
}

impl fmt::Debug for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Subject").field("recipe", &self.recipe).field("is_own", &self.change.is_some()).finish()
    }
}

fn carved(drawing: &Pslg, algorithm: AlgorithmKey) -> Result<ConstrainedDelaunay, Breach> {
    let built = build(drawing, DomainRule::Seeds, Crossings::Refuse, algorithm);
    built.map(|(cdt, _)| cdt).map_err(|error| Breach(error.to_string()))
}

fn ensure(holds: bool, breach: impl FnOnce() -> String) -> Result<(), Breach> {
    if holds { Ok(()) } else { Err(Breach(breach())) }
}

/// The triangles in the order of their keys.
fn by_key(cdt: &ConstrainedTriangulation) -> Vec<FaceId> {
    let mut faces: Vec<FaceId> = cdt.real_faces().collect();
    faces.sort_unstable_by_key(|&f| cdt.face_key(f));
    faces
}

/// The options of the suites bound no size, and their drawings have no regions.
static NO_SIZE_BOUNDS: SizeBounds = SizeBounds::NONE;

/// The view that a step gets.
fn view<'a>(cdt: &'a ConstrainedTriangulation, options: &'a RefineOptions) -> View<'a> {
    let ruler = Ruler::for_box(cdt.bounding_box());
    View { cdt, criteria: &options.criteria, size: &NO_SIZE_BOUNDS, ruler, longest_walk: usize::MAX }
}

/// Makes a test of each named strategy, and a test that no strategy is missing.
#[cfg(test)]
macro_rules! conforms {
    ($suite:ident, $field:ident: $kind:ty { $($test:ident => $variant:ident,)* }) => {
        #[cfg(test)]
        mod conformance {
            use crate::refine::conformance::{Subject, $suite};
            use crate::refine::recipe::*;

            $(
                #[test]
                fn $test() {
                    let recipe = Recipe { $field: <$kind>::$variant, ..Recipe::default() };
                    $suite(&Subject::of(recipe)).unwrap();
                }
            )*

            #[test]
            fn every_row_of_the_registry_is_put_through_the_suite() {
                let keys = [$((<$kind>::$variant.key(), stringify!($test).replace('_', "-"))),*];
                assert!(keys.iter().all(|(key, test)| key == test), "{keys:?}");
                assert_eq!(keys.len(), <$kind>::ALL.len());
                assert!(<$kind>::ALL.iter().all(|row| keys.iter().any(|(key, _)| *key == row.key())), "{keys:?}");
            }
        }
    };
}
#[cfg(test)]
pub(crate) use conforms;

#[cfg(test)]
mod tests;
