//! How drawings of other programs are read.

/// How a drawing of another program is read.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct DrawingOptions {
    /// How far straight lines may be from the curve that they replace, in units of the drawing; by default a
    /// ten-thousandth of the diagonal of the drawing's bounding box.
    pub tolerance: Option<f64>,
    /// What rings bound; by default as the format has it: [`Rings::Each`] where it has polygons with holes, otherwise
    /// [`Rings::EvenOdd`].
    pub rings: Option<Rings>,
    /// The property of features (`GeoJSON`), or the column of the table beside (shapefile), whose values are regions.
    pub property: Option<String>,
    /// The layers that are read; empty for all.
    pub layers: Vec<String>,
}

impl DrawingOptions {
    /// Sets how far straight lines may be from the curve that they replace.
    #[must_use]
    pub fn with_tolerance(self, tolerance: f64) -> Self {
        Self { tolerance: Some(tolerance), ..self }
    }

    /// Sets what rings bound.
    #[must_use]
    pub fn with_rings(self, rings: Rings) -> Self {
        Self { rings: Some(rings), ..self }
    }

    /// Sets the property whose values are regions.
    #[must_use]
    pub fn with_property(self, property: impl Into<String>) -> Self {
        Self { property: Some(property.into()), ..self }
    }

    /// Sets the layers that are read.
    #[must_use]
    pub fn with_layers(self, layers: Vec<String>) -> Self {
        Self { layers, ..self }
    }
}

/// What the rings of a drawing bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rings {
    /// Rings nest: what lies in an odd number of shapes is the domain, what lies in an even number a hole.
    EvenOdd,
    /// What the rings wind around is the domain: a hole is a ring that runs against the one around it, and outlines
    /// that overlap are joined.
    NonZero,
    /// Each shape is part of the domain: shapes in shapes are regions, not holes. Holes are those that the format
    /// itself gives to a shape.
    Each,
}

impl Rings {
    /// Every rule.
    pub const ALL: [Self; 3] = [Self::EvenOdd, Self::NonZero, Self::Each];

    /// The key, as the program spells it.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::EvenOdd => "even-odd",
            Self::NonZero => "non-zero",
            Self::Each => "each",
        }
    }

    /// One line on what it keeps.
    #[must_use]
    pub const fn summary(self) -> &'static str {
        match self {
            Self::EvenOdd => "rings nest: a ring in a ring is a hole, a ring in that an island",
            Self::NonZero => "overlapping outlines are joined; a ring that runs against the one around it is a hole",
            Self::Each => "each shape belongs to the domain: a shape in a shape is a region",
        }
    }
}
