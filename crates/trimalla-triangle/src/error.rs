//! What can go wrong between a word of switches and a mesh.

/// A word of switches that cannot be followed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SwitchError {
    /// No switch has this letter.
    #[error("there is no switch -{letter} (in '{word}')")]
    Unknown {
        /// The letter.
        letter: char,
        /// The word in which it stands.
        word: String,
    },
    /// The switch exists, and cannot be followed here.
    #[error("the switch -{letter} is not supported: {instead}")]
    Unsupported {
        /// The letter.
        letter: char,
        /// What to use instead.
        instead: &'static str,
    },
    /// The number at a switch is not what the switch takes.
    #[error("-{letter} takes {expected}, not '{found}'")]
    Number {
        /// The letter.
        letter: char,
        /// What would do.
        expected: &'static str,
        /// What stands behind the letter.
        found: String,
    },
    /// Two switches exclude each other.
    #[error("the switches -{0} and -{1} exclude each other: {2}")]
    Conflict(char, char, &'static str),
}

/// Why there is no mesh.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TriangleError {
    /// The drawing, the mesh or an option is at fault.
    #[error(transparent)]
    Mesh(#[from] trimalla::Error),
    /// A Voronoi vertex is too far away for finite coordinates.
    #[error("the circumcenter of triangle {triangle} is too far away for finite coordinates: leave out -v")]
    NoVoronoi {
        /// The triangle, counted from 0.
        triangle: usize,
    },
}

impl From<trimalla::domain::DomainError> for TriangleError {
    fn from(error: trimalla::domain::DomainError) -> Self {
        Self::Mesh(error.into())
    }
}
