//! The options of a refinement: criteria, limits and recipe.

pub(in crate::refine) use super::Protect;
use super::{Fill, Preset, Recipe};
use crate::geometry::{Angle, Triangle, math, triangle_angles_at_least};
use crate::quality::aspect_ratio;

/// What makes a triangle bad.
///
/// A test of the caller's own goes to [`Start::with_test`](crate::refine::Start::with_test).
#[doc(alias = "quality")]
#[doc(alias = "bad triangle")]
#[doc(alias = "calidad")]
#[doc(alias = "triángulo malo")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default))]
pub struct Criteria {
    /// The smallest angle a triangle may have; 0 for no bound.
    pub min_angle: Angle,
    /// The largest area a triangle may have, in squared coordinate units.
    pub max_area: Option<f64>,
    /// The largest aspect ratio a triangle may have: circumradius over twice the inradius, 1 for equilateral triangles.
    pub max_aspect_ratio: Option<f64>,
}

impl Default for Criteria {
    fn default() -> Self {
        let min_angle = Angle::from_degrees(Self::DEFAULT_MIN_ANGLE_DEG);
        Self { min_angle, max_area: None, max_aspect_ratio: None }
    }
}

impl Criteria {
    /// The default smallest angle, in degrees.
    pub const DEFAULT_MIN_ANGLE_DEG: f64 = 30.0;

    /// The smallest angle of good triangles by all criteria: placement and protecting regions are computed for it.
    ///
    /// With s the sine of half the smallest angle, R/2r is least where the two other angles are equal, and then
    /// 1 / (4 s (1 − s)): a bound on it bounds s.
    #[must_use]
    pub fn effective_min_angle(&self) -> Angle {
        let of_ratio = self.max_aspect_ratio.map_or(0.0, |ratio| {
            let half_sine = (1.0 - (1.0 - 1.0 / ratio).max(0.0).sqrt()) / 2.0;
            2.0 * math::asin(half_sine)
        });
        if of_ratio > self.min_angle.radians() { Angle::from_radians(of_ratio) } else { self.min_angle }
    }
}

/// Which bounds a triangle misses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default))]
pub struct Missed {
    /// An angle is below the bound.
    pub angle: bool,
    /// The area is above the bound.
    pub area: bool,
    /// The aspect ratio is above the bound.
    pub aspect_ratio: bool,
}

impl Criteria {
    /// Which of these bounds a triangle, counter-clockwise, misses; angles are certified exactly.
    #[must_use]
    pub fn missed_by(&self, triangle: &Triangle) -> Missed {
        let [a, b, c] = triangle.corners;
        let is_bounded = self.min_angle.radians() > 0.0;
        Missed {
            angle: is_bounded && !triangle_angles_at_least(a, b, c, self.min_angle.cos_sq()),
            area: self.max_area.is_some_and(|area| (b - a).cross(c - a) > 2.0 * area),
            aspect_ratio: self.max_aspect_ratio.is_some_and(|ratio| aspect_ratio(triangle) > ratio),
        }
    }
}

/// Where a refinement stops although triangles are still bad.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default))]
pub struct Limits {
    /// No more vertices than this, the input's included.
    pub max_vertices: usize,
    /// The shortest distance of a new vertex from others; `None` for a floor that depends on the coordinates: 256 units
    /// in the last place of the largest.
    pub length_floor: Option<f64>,
}

impl Default for Limits {
    fn default() -> Self {
        Self { max_vertices: 5_000_000, length_floor: None }
    }
}

/// How many runs [`mesh`](crate::mesh()) and [`refine_mesh`](crate::refine_mesh()) make where the bound on angles may
/// be out of reach: above 33 degrees, with the default recipe.
///
/// A [`Refinement`](crate::refine::Refinement) is one run, whatever this says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Attempts {
    /// One run of the recipe, to the bound that is asked.
    One,
    /// Runs of several recipes and, if none of them ends, to lower bounds. The mesh with the highest bound that is met
    /// is returned, and [`Meshed::attempted`](crate::Meshed::attempted) names its run. Its smallest angle is at least
    /// that of a run at 30 degrees.
    #[default]
    Several,
}

/// The options of a refinement.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default))]
pub struct RefineOptions {
    /// The five steps.
    pub recipe: Recipe,
    /// What makes a triangle bad.
    pub criteria: Criteria,
    /// Which segments may not be split.
    pub protect: Protect,
    /// Where to stop.
    pub limits: Limits,
    /// How many runs are made where the bound on angles may be out of reach.
    pub attempts: Attempts,
}

impl RefineOptions {
    /// Bounds on angles up to this one, in degrees, are met in practice by the default recipe.
    pub const PRACTICE_DEG: f64 = 33.0;

    /// The options of a preset with everything else at its default, for one run.
    #[must_use]
    pub fn of(preset: Preset) -> Self {
        Self { recipe: preset.recipe(), attempts: Attempts::One, ..Self::default() }
    }

    /// Sets how many runs are made where the bound on angles may be out of reach.
    #[must_use]
    pub fn with_attempts(mut self, attempts: Attempts) -> Self {
        self.attempts = attempts;
        self
    }

    /// Whether several runs are made: if [`attempts`](Self::attempts) says so, the recipe is the default, and the bound
    /// on angles is above [`PRACTICE_DEG`](Self::PRACTICE_DEG).
    #[must_use]
    pub fn make_several_attempts(&self) -> bool {
        let is_unproved = self.criteria.min_angle.degrees() > Self::PRACTICE_DEG;
        self.attempts == Attempts::Several && self.recipe == Recipe::default() && is_unproved
    }

    /// Sets the smallest angle, in degrees.
    #[must_use]
    pub fn with_min_angle_deg(mut self, degrees: f64) -> Self {
        self.criteria.min_angle = Angle::from_degrees(degrees);
        self
    }

    /// Sets the largest area of triangles.
    #[must_use]
    pub fn with_max_area(mut self, area: f64) -> Self {
        self.criteria.max_area = Some(area);
        self
    }

    /// Sets the largest aspect ratio: circumradius over twice the inradius.
    #[must_use]
    pub fn with_max_aspect_ratio(mut self, ratio: f64) -> Self {
        self.criteria.max_aspect_ratio = Some(ratio);
        self
    }

    /// Sets the vertex budget.
    #[must_use]
    pub fn with_max_vertices(mut self, vertices: usize) -> Self {
        self.limits.max_vertices = vertices;
        self
    }

    /// Sets the segments that may not be split.
    #[must_use]
    pub fn with_protect(mut self, protect: Protect) -> Self {
        self.protect = protect;
        self
    }

    /// Whether wide parts are filled with a lattice, if there is an area bound and the mesh is Delaunay: not above 30
    /// degrees. A vertex inside a triangle of the lattice leaves an angle of 30 degrees or less wherever it lies; after
    /// the first such vertex the loop would replace the whole lattice.
    pub(in crate::refine) fn asks_for_lattice(&self) -> bool {
        let is_lasting = self.criteria.effective_min_angle().radians() <= Angle::from_degrees(30.0).radians();
        self.recipe.fill == Fill::Lattice && is_lasting
    }

    /// Checks that the options are in range.
    ///
    /// # Errors
    /// [`OptionError`] names the option and its value.
    pub fn validate(&self) -> Result<(), OptionError> {
        let degrees = self.criteria.min_angle.degrees();
        let refused = |value: Option<f64>, is_allowed: fn(f64) -> bool| value.filter(|&value| !is_allowed(value));
        if !is_angle_deg(degrees) {
            Err(OptionError::MinAngle(degrees))
        } else if let Some(area) = refused(self.criteria.max_area, is_area) {
            Err(OptionError::MaxArea(area))
        } else if let Some(ratio) = refused(self.criteria.max_aspect_ratio, is_aspect_ratio) {
            Err(OptionError::MaxAspectRatio(ratio))
        } else if let Some(length) = refused(self.limits.length_floor, is_length) {
            Err(OptionError::LengthFloor(length))
        } else {
            Ok(())
        }
    }
}

/// Whether an angle in degrees is a valid bound: the smallest angle of no triangle exceeds 60.
pub(in crate::refine) fn is_angle_deg(degrees: f64) -> bool {
    (0.0..=60.0).contains(&degrees)
}

/// Whether an area is a valid bound.
pub(in crate::refine) fn is_area(area: f64) -> bool {
    area > 0.0 && area.is_finite()
}

/// Whether a ratio is a valid bound on the aspect ratio.
pub(in crate::refine) fn is_aspect_ratio(ratio: f64) -> bool {
    ratio >= 1.0 && ratio.is_finite()
}

/// Whether a length is a valid length floor.
pub(in crate::refine) fn is_length(length: f64) -> bool {
    length >= 0.0 && length.is_finite()
}

/// An option outside its range, or a triangulation without triangles.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OptionError {
    /// No triangle's smallest angle exceeds 60 degrees.
    #[error("the minimum angle must lie between 0 and 60 degrees, not {0}")]
    MinAngle(f64),
    /// Areas are positive.
    #[error("the maximum area must be positive and finite, not {0}")]
    MaxArea(f64),
    /// An equilateral triangle has aspect ratio 1, every other one more.
    #[error("the maximum aspect ratio must be at least 1 and finite, not {0}")]
    MaxAspectRatio(f64),
    /// Lengths are not negative.
    #[error("the length floor must not be negative or infinite, not {0}")]
    LengthFloor(f64),
    /// Fewer than three points, or all on one line.
    #[error("there is no triangle to refine")]
    NoTriangles,
}
