//! What can be said of a refinement before it begins.

use super::forecast::{Forecast, forecast};
use super::options::{Protect, RefineOptions};
use super::recipe::Preset;
use crate::constrained::ConstrainedDelaunay;
use crate::geometry::Angle;
use crate::quality::{AngleCeiling, InputAngle, angle_ceiling, shell_floor, smallest_input_angle};

/// The largest bound for which the angle floor is proved, in degrees.
///
/// # Source
/// `[MillerPavWalkington03]`.
const PROVED_DEG: f64 = 26.45;

/// What can be said of a refinement before it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outlook {
    /// How large the mesh will be.
    pub forecast: Forecast,
    /// The angle that no mesh can pass; none of a triangulation without triangles.
    pub angle_ceiling: Option<AngleCeiling>,
    /// The smallest angle between two segments.
    pub smallest_input_angle: Option<InputAngle>,
}

impl Outlook {
    /// Looks at a carved triangulation.
    ///
    /// # Complexity
    /// That of the [`forecast()`].
    #[must_use]
    pub fn of(cdt: &ConstrainedDelaunay, options: &RefineOptions) -> Self {
        Self {
            forecast: forecast(cdt, options),
            angle_ceiling: angle_ceiling(cdt),
            smallest_input_angle: smallest_input_angle(cdt),
        }
    }

    /// The angle below which no angle of the finished mesh need be, the [`shell_floor`], where its argument holds: for the preset `circumcenter`
    /// at bounds of up to 26.45 degrees, without an area bound, length floor or protected segments.
    ///
    /// # Source
    /// `[MillerPavWalkington03]`.
    #[must_use]
    pub fn angle_floor(&self, options: &RefineOptions) -> Option<Angle> {
        let is_proved = options.recipe == Preset::Circumcenter.recipe()
            && options.criteria.min_angle.degrees() <= PROVED_DEG
            && options.criteria.max_area.is_none()
            && options.limits.length_floor.is_none()
            && options.protect == Protect::None;
        self.smallest_input_angle.filter(|_| is_proved).map(|input| shell_floor(input.angle))
    }
}
