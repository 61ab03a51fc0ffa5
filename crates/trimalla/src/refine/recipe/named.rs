//! Options with names, as recipe files, command lines and reports use them.

use super::Recipe;
use super::choices::{Preset, Protect};
use crate::geometry::Angle;
use crate::refine::recipe::options::{Attempts, Criteria, Limits, RefineOptions};

/// A recipe, with the criteria and limits that are set.
///
/// [`OPTIONS`](super::OPTIONS) lists its fields with their keys: each can be read and set by its key. An option that is
/// not set has its default, or is left to the caller.
///
/// # Examples
/// ```
/// use trimalla::refine::{NamedOptions, OPTIONS, Preset, Select, Value};
///
/// let mut options = NamedOptions::of(Preset::Circumcenter);
/// let select = OPTIONS.iter().find(|option| option.key == "select").expect("an option");
/// assert_eq!(select.get(&options), Some(Value::Key("shortest-edge")));
/// select.set(&mut options, &select.values.of_key("first").expect("a key"))?;
/// assert_eq!(options.refine_options().recipe.select, Select::First);
/// # Ok::<(), trimalla::refine::WrongValue>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NamedOptions {
    /// The name of the recipe.
    pub name: Option<String>,
    /// The preset that it started from; the steps below are complete without it.
    pub preset: Option<Preset>,
    /// The five steps.
    pub recipe: Recipe,
    /// Which segments may not be split.
    pub protect: Option<Protect>,
    /// The smallest angle allowed, in degrees.
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

impl NamedOptions {
    /// The recipe of a preset; criteria and limits are not set.
    #[must_use]
    pub fn of(preset: Preset) -> Self {
        Self { preset: Some(preset), recipe: preset.recipe(), ..Self::default() }
    }

    /// The default preset, with every criterion and limit that has a default value.
    #[must_use]
    pub fn defaults() -> Self {
        Self {
            protect: Some(Protect::default()),
            min_angle_deg: Some(Criteria::DEFAULT_MIN_ANGLE_DEG),
            max_vertices: Some(Limits::default().max_vertices),
            ..Self::of(Preset::default())
        }
    }

    /// Sets criteria, protection and limits that are not set to their default values.
    #[must_use]
    pub fn with_default_bounds(mut self) -> Self {
        let defaults = Self::defaults();
        self.protect = self.protect.or(defaults.protect);
        self.min_angle_deg = self.min_angle_deg.or(defaults.min_angle_deg);
        self.max_vertices = self.max_vertices.or(defaults.max_vertices);
        self
    }

    /// The options of a refinement; what is not set has its default. With a preset there is one run.
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
            attempts: if self.preset.is_some() { Attempts::One } else { Attempts::Several },
        }
    }

    /// Takes all steps from a preset. Clears the name, which was that of other steps.
    pub fn take_preset(&mut self, preset: Preset) {
        (self.name, self.preset, self.recipe) = (None, Some(preset), preset.recipe());
    }
}
