//! What is asked of a refinement, and where it stops.

use super::recipe::{Preset, Recipe};
use crate::geometry::Angle;

/// What makes a triangle bad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Criteria {
    /// The smallest angle a triangle may have; 0 asks for none.
    pub min_angle: Angle,
    /// The largest area a triangle may have, in squared coordinate units.
    pub max_area: Option<f64>,
}

impl Default for Criteria {
    fn default() -> Self {
        Self { min_angle: Angle::from_degrees(30.0), max_area: None }
    }
}

/// Which segments may not be split.
///
/// Protected segments keep the guarantee from holding: triangles beside them may stay bad, and are then listed with
/// the reason `protected segment`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Protect {
    /// All may be split.
    #[default]
    None,
    /// Those on the border of the domain are kept whole.
    Boundary,
    /// All are kept whole.
    All,
}

impl Protect {
    /// Every choice.
    pub const ALL: [Self; 3] = [Self::None, Self::Boundary, Self::All];

    /// Its key.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Boundary => "boundary",
            Self::All => "all",
        }
    }
}

/// Where a refinement stops although triangles are still bad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// No more vertices than this, the input's included.
    pub max_vertices: usize,
    /// No two vertices are brought closer together than this; `None` for a floor that depends on the coordinates:
    /// 256 units in the last place of the largest.
    pub length_floor: Option<f64>,
}

impl Default for Limits {
    fn default() -> Self {
        Self { max_vertices: 5_000_000, length_floor: None }
    }
}

/// Everything a refinement is asked.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RefineOptions {
    /// The five steps.
    pub recipe: Recipe,
    /// What makes a triangle bad.
    pub criteria: Criteria,
    /// Which segments may not be split.
    pub protect: Protect,
    /// Where to stop.
    pub limits: Limits,
}

impl RefineOptions {
    /// The options of a preset with everything else at its default.
    #[must_use]
    pub fn of(preset: Preset) -> Self {
        Self { recipe: preset.recipe(), ..Self::default() }
    }

    /// Asks for this smallest angle, in degrees.
    #[must_use]
    pub fn with_min_angle_deg(mut self, degrees: f64) -> Self {
        self.criteria.min_angle = Angle::from_degrees(degrees);
        self
    }

    /// Asks for triangles no larger than this.
    #[must_use]
    pub fn with_max_area(mut self, area: f64) -> Self {
        self.criteria.max_area = Some(area);
        self
    }

    /// Stops at this many vertices.
    #[must_use]
    pub fn with_max_vertices(mut self, vertices: usize) -> Self {
        self.limits.max_vertices = vertices;
        self
    }

    /// Keeps these segments whole.
    #[must_use]
    pub fn with_protect(mut self, protect: Protect) -> Self {
        self.protect = protect;
        self
    }

    /// Refuses what cannot be meant.
    ///
    /// # Errors
    /// [`OptionError`] names the option and its value.
    pub fn validate(&self) -> Result<(), OptionError> {
        let degrees = self.criteria.min_angle.degrees();
        if !(0.0..=60.0).contains(&degrees) {
            return Err(OptionError::MinAngle(degrees));
        }
        match self.criteria.max_area {
            Some(a) if !(a > 0.0 && a.is_finite()) => return Err(OptionError::MaxArea(a)),
            _ => {}
        }
        match self.limits.length_floor {
            Some(l) if !(l >= 0.0 && l.is_finite()) => Err(OptionError::LengthFloor(l)),
            _ => Ok(()),
        }
    }
}

/// An option outside its range.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OptionError {
    /// No triangle's smallest angle exceeds 60 degrees.
    #[error("the minimum angle must lie between 0 and 60 degrees, not {0}")]
    MinAngle(f64),
    /// Areas are positive.
    #[error("the maximum area must be positive and finite, not {0}")]
    MaxArea(f64),
    /// Lengths are not negative.
    #[error("the length floor must not be negative or infinite, not {0}")]
    LengthFloor(f64),
}
