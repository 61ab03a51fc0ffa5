//! A bound on areas, which cannot be taken for a length.

/// The largest area that a triangle may have, or none.
///
/// # Units
/// Made from an area in squared coordinate units, or from the length of an edge in coordinate units.
///
/// # Examples
/// ```
/// use trimalla::size::AreaBound;
///
/// assert_eq!(AreaBound::of_area(0.5).area(), 0.5);
/// assert!((AreaBound::of_edge(2.0).area() - 3f64.sqrt()).abs() < 1e-15);
/// assert_eq!(AreaBound::NONE.least(AreaBound::of_area(3.0)), AreaBound::of_area(3.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct AreaBound {
    /// Twice the area, which is what a cross product gives; infinite where there is no bound.
    doubled: f64,
}

impl AreaBound {
    /// No bound.
    pub const NONE: Self = Self { doubled: f64::INFINITY };
    /// The bound that every triangle is above.
    pub const ZERO: Self = Self { doubled: 0.0 };

    /// This area at most; what is not a number bounds nothing.
    #[must_use]
    #[inline]
    pub const fn of_area(area: f64) -> Self {
        if area.is_nan() { Self::NONE } else { Self { doubled: 2.0 * area } }
    }

    /// [`of_area`](Self::of_area) where there is one.
    #[must_use]
    #[inline]
    pub(crate) fn of_max_area(max_area: Option<f64>) -> Self {
        max_area.map_or(Self::NONE, Self::of_area)
    }

    /// The area of an equilateral triangle with edges of this length.
    #[must_use]
    pub fn of_edge(length: f64) -> Self {
        Self::of_area(0.25 * 3f64.sqrt() * length * length)
    }

    /// The area in squared coordinate units, infinite where there is no bound.
    #[must_use]
    pub const fn area(self) -> f64 {
        0.5 * self.doubled
    }

    /// Twice the area.
    #[must_use]
    #[inline]
    pub(crate) const fn doubled(self) -> f64 {
        self.doubled
    }

    /// The length of the edges of an equilateral triangle with this area, infinite where there is no bound.
    #[must_use]
    pub fn edge(self) -> f64 {
        (self.area() * (4.0 / 3f64.sqrt())).sqrt()
    }

    /// The bound on the area times a factor, which must be positive.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        Self { doubled: self.doubled * factor }
    }

    /// Whether there is no bound.
    #[must_use]
    #[inline]
    pub const fn is_none(self) -> bool {
        self.doubled == f64::INFINITY
    }

    /// The stricter one of two bounds.
    #[must_use]
    #[inline]
    pub const fn least(self, other: Self) -> Self {
        Self { doubled: self.doubled.min(other.doubled) }
    }

    /// Whether a triangle with this doubled area keeps the bound.
    #[must_use]
    #[inline]
    pub(crate) fn admits(self, doubled_area: f64) -> bool {
        doubled_area <= self.doubled
    }
}
