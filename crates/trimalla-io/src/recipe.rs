//! `.toml`: recipes of refinement, saved, loaded and compared.
//!
//! ```toml
//! name = "centroids, worst first"
//! preset = "lepp-centroid"          # the base; the keys below change it
//! select = "smallest-angle"
//! until-destroyed = true
//! protect = "none"
//!
//! [criteria]
//! min-angle = 33
//! max-area = 0.5
//! max-aspect-ratio = 2.0
//!
//! [limits]
//! max-vertices = 100000
//! length-floor = 0.001
//! ```
//!
//! Every key may be left out. A step that is not named is that of `preset`, and without one that of the default preset;
//! what is not said about criteria, limits and protection is left to whoever refines. Unknown keys and values are
//! errors that name the place and the keys or values that would do.

mod read;
mod write;

use trimalla::geometry::Angle;
use trimalla::refine::{Criteria, Limits, Preset, Protect, Recipe, RefineOptions};

pub use read::{read, read_file};
pub use write::write;

/// What a recipe file holds: the five steps, and whatever it says about criteria and limits.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RecipeFile {
    /// What the recipe is called.
    pub name: Option<String>,
    /// The preset that it started from; the steps below are complete without it.
    pub preset: Option<Preset>,
    /// The five steps.
    pub recipe: Recipe,
    /// Which segments may not be split.
    pub protect: Option<Protect>,
    /// The smallest angle asked for, in degrees.
    pub min_angle_deg: Option<f64>,
    /// The largest area allowed, in squared coordinate units.
    pub max_area: Option<f64>,
    /// The largest aspect ratio allowed: circumradius over twice the inradius.
    pub max_aspect_ratio: Option<f64>,
    /// The vertex budget.
    pub max_vertices: Option<usize>,
    /// The shortest distance allowed between vertices, in coordinate units.
    pub length_floor: Option<f64>,
}

impl RecipeFile {
    /// The recipe of a preset; nothing is said about criteria and limits.
    #[must_use]
    pub fn of(preset: Preset) -> Self {
        Self { preset: Some(preset), recipe: preset.recipe(), ..Self::default() }
    }

    /// What a refinement is asked by it; what the file does not say is at its default.
    #[must_use]
    pub fn refine_options(&self) -> RefineOptions {
        let (criteria, limits) = (Criteria::default(), Limits::default());
        RefineOptions {
            recipe: self.recipe,
            criteria: Criteria {
                min_angle: self.min_angle_deg.map_or(criteria.min_angle, Angle::from_degrees),
                max_area: self.max_area,
                max_aspect_ratio: self.max_aspect_ratio,
            },
            protect: self.protect.unwrap_or_default(),
            limits: Limits {
                max_vertices: self.max_vertices.unwrap_or(limits.max_vertices),
                length_floor: self.length_floor,
            },
        }
    }
}

/// The keys of the file itself.
const KEYS: [&str; 19] = [
    "name",
    "preset",
    "initial",
    "fill",
    "prepare",
    "prepare-when",
    "encroachment",
    "select",
    "until-destroyed",
    "point",
    "lepp-stop",
    "centroid",
    "constrained-second",
    "terminal",
    "insert",
    "recover",
    "protect",
    "criteria",
    "limits",
];
const CRITERIA: [&str; 3] = ["min-angle", "max-area", "max-aspect-ratio"];
const LIMITS: [&str; 2] = ["max-vertices", "length-floor"];

#[cfg(test)]
mod tests;
