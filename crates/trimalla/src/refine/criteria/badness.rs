//! What is wrong with a bad triangle.

/// What is wrong with a bad triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Badness {
    /// An angle is below the bound.
    Angle,
    /// The aspect ratio is above the bound.
    AspectRatio,
    /// The area is above the bound.
    Area,
    /// The caller's own test refuses the triangle.
    UserTest,
}

impl Badness {
    /// Whether the triangle is bad for its shape: splitting it into smaller ones of that shape is no help.
    #[must_use]
    pub const fn is_of_shape(self) -> bool {
        matches!(self, Self::Angle | Self::AspectRatio)
    }

    /// In words.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Angle => "angle",
            Self::AspectRatio => "aspect ratio",
            Self::Area => "area",
            Self::UserTest => "user test",
        }
    }
}
