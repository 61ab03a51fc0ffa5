//! Measures of triangles, and their smallest, mean and largest value.

use crate::geometry::{Angle, Triangle};

/// The circumradius over twice the inradius: 1 for the equilateral triangle, larger for every other.
///
/// # Guarantees
/// Independent of scale, without overflow; infinite for degenerate triangles.
///
/// # Source
/// Computed as `1 / (8 sin(A/2) sin(B/2) sin(C/2))`, which equals the ratio of the radii.
#[doc(alias = "quality")]
#[doc(alias = "calidad")]
#[must_use]
pub fn aspect_ratio(triangle: &Triangle) -> f64 {
    let half_sines = triangle.angles().map(|a| Angle::from_radians(0.5 * a.radians()).sin());
    1.0 / (8.0 * half_sines[0] * half_sines[1] * half_sines[2])
}

/// The smallest, mean and largest of some values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// The smallest value.
    pub min: f64,
    /// The arithmetic mean, rounded.
    pub mean: f64,
    /// The largest value.
    pub max: f64,
}

impl Spread {
    /// The spread of some values; `None` of no values.
    ///
    /// # Guarantees
    /// The mean of finite values is finite: it is carried along, not divided at the end. Where a value is infinite, so
    /// is the mean.
    #[must_use]
    pub fn of(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut values = values.into_iter();
        let first = values.next()?;
        let start = Self { min: first, mean: first, max: first };
        Some(values.zip(2_u64..).fold(start, |s, (v, n)| Self {
            min: s.min.min(v),
            mean: if v.is_infinite() || s.mean.is_infinite() {
                v + s.mean
            } else {
                s.mean + (v / n as f64 - s.mean / n as f64)
            },
            max: s.max.max(v),
        }))
    }
}
