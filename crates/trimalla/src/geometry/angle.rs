//! Angles.

use super::math;
use core::f64::consts::PI;
use core::fmt;

/// An angle, kept in radians; prints in degrees.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Angle(f64);

impl Angle {
    /// An angle of so many radians.
    #[must_use]
    #[inline]
    pub const fn from_radians(radians: f64) -> Self {
        Self(radians)
    }

    /// An angle of so many degrees.
    #[must_use]
    #[inline]
    pub const fn from_degrees(degrees: f64) -> Self {
        Self(degrees * (PI / 180.0))
    }

    /// The angle in radians.
    #[must_use]
    #[inline]
    pub const fn radians(self) -> f64 {
        self.0
    }

    /// The angle in degrees.
    #[must_use]
    #[inline]
    pub const fn degrees(self) -> f64 {
        self.0 * (180.0 / PI)
    }

    /// The sine, the same on every platform.
    #[must_use]
    #[inline]
    pub fn sin(self) -> f64 {
        math::sin(self.0)
    }

    /// The cosine, the same on every platform.
    #[must_use]
    #[inline]
    pub fn cos(self) -> f64 {
        math::cos(self.0)
    }

    /// The tangent, the same on every platform.
    #[must_use]
    #[inline]
    pub fn tan(self) -> f64 {
        math::tan(self.0)
    }

    /// The squared cosine, the form in which [`angle_at_least`](super::angle_at_least) takes a bound.
    ///
    /// # Guarantees
    /// Exactly 1, 0.75, 0.5 and 0 for 0, 30, 45 and 90 degrees: computed as `(1 + cos 2a) / 2`, which hides the
    /// rounding of the angle.
    #[must_use]
    #[inline]
    pub fn cos_sq(self) -> f64 {
        0.5 * (1.0 + math::cos(2.0 * self.0))
    }
}

impl fmt::Display for Angle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.degrees(), f)?;
        f.write_str("°")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_degrees_have_exact_squared_cosines() {
        for (degrees, cos_sq) in [(0.0, 1.0), (30.0, 0.75), (45.0, 0.5), (90.0, 0.0)] {
            assert_eq!(Angle::from_degrees(degrees).cos_sq(), cos_sq, "{degrees}");
        }
    }

    #[test]
    fn degrees_come_back_and_print() {
        let angle = Angle::from_degrees(20.7);
        assert!((angle.degrees() - 20.7).abs() < 1e-14);
        assert_eq!(format!("{angle:.1}"), "20.7°");
    }
}
